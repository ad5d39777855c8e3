// SPDX-License-Identifier: Apache-2.0
// Makes a table of sums of rows, in parallel; the same bits for any number of threads.
#pragma once

#include <algorithm>
#include <vector>

#include <solidsubdiv/far/internal/row_sum.h>
#include <solidsubdiv/far/internal/rows.h>
#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Far::Internal {

/// What a thread needs. Aligned, so that no two threads share a cache line.
struct alignas(64) Worker {
    RowSum sum;
    RowBuffer<double> row;
};

/// Makes rows a chunk at a time: row(i, worker) adds to worker.sum what row i is the sum of. Fresh memory is what this
/// costs most, so chunks are made in waves of small buffers that are used again, and the table is reserved at once for
/// about what a sample of the rows takes.
template <class Real>
class RowMaker {
  public:
    RowMaker(Index n, Index n_control) : n_(n), n_threads_(Sdc::ThreadCount()) {
        rows_.n_sources = n_control;
        rows_.offsets.resize(static_cast<std::size_t>(n) + 1);
        rows_.offsets[0] = 0;
        workers_.assign(static_cast<std::size_t>(n_threads_), Worker{RowSum(n_control), {}});
        parts_.resize(static_cast<std::size_t>(kChunksAThread * n_threads_));
    }

    template <class RowFunction>
    StencilRows<Real> Make(RowFunction&& row) {
        Reserve(row);
        const Offset wave = kChunk * static_cast<Offset>(parts_.size());
        for (Offset first = 0; first < n_; first += wave) {
            const Offset n_chunks = (std::min(wave, n_ - first) + kChunk - 1) / kChunk;
            ForChunks(n_chunks, [&](Offset c, Worker& worker) { Sum(first + c * kChunk, parts_[c], worker, row); });
            Offset end = static_cast<Offset>(rows_.indices.size());
            for (Offset c = 0; c < n_chunks; ++c) {
                parts_[c].start = end;
                end += static_cast<Offset>(parts_[c].indices.size());
            }
            rows_.indices.resize(static_cast<std::size_t>(end));
            rows_.weights.resize(static_cast<std::size_t>(end));
            ForChunks(n_chunks, [&](Offset c, Worker&) { Join(first + c * kChunk, parts_[c]); });
        }
        return std::move(rows_);
    }

  private:
    static constexpr Offset kChunk = 256, kChunksAThread = 16;
    struct alignas(64) Part {
        std::vector<Index> indices;
        std::vector<Real> weights;
        Offset start = 0;
    };

    template <class Body>
    void ForChunks(Offset n_chunks, Body&& body) {
        Sdc::ParallelFor(n_threads_, 1, [&](Offset begin, Offset end) {
            for (Offset thread = begin; thread < end; ++thread) {
                for (Offset c = thread; c < n_chunks; c += n_threads_) body(c, workers_[thread]);
            }
        });
    }

    template <class RowFunction>
    void Sum(Offset first, Part& part, Worker& worker, RowFunction&& row) {
        part.indices.clear();
        part.weights.clear();
        for (Offset i = first; i < std::min<Offset>(first + kChunk, n_); ++i) {
            row(static_cast<Index>(i), worker);
            worker.sum.Flush(part.indices, part.weights);
            rows_.offsets[i + 1] = static_cast<Offset>(part.indices.size());  // within the chunk, for now
        }
    }

    void Join(Offset first, const Part& part) {
        for (Offset i = first; i < std::min<Offset>(first + kChunk, n_); ++i) rows_.offsets[i + 1] += part.start;
        std::copy(part.indices.begin(), part.indices.end(), rows_.indices.begin() + part.start);
        std::copy(part.weights.begin(), part.weights.end(), rows_.weights.begin() + part.start);
    }

    template <class RowFunction>
    void Reserve(RowFunction&& row) {
        constexpr Offset kStep = 101;  // one row in so many; prime, so that it follows no pattern of the mesh
        Part sample;
        Offset n_rows = 0;
        for (Offset i = 0; i < n_; i += kStep, ++n_rows) {
            row(static_cast<Index>(i), workers_[0]);
            workers_[0].sum.Flush(sample.indices, sample.weights);
        }
        const double mean =
            static_cast<double>(sample.indices.size()) / static_cast<double>(std::max<Offset>(n_rows, 1));
        const std::size_t room = static_cast<std::size_t>(1.02 * mean * static_cast<double>(n_));
        rows_.indices.reserve(room);
        rows_.weights.reserve(room);
    }

    Offset n_, n_threads_;
    StencilRows<Real> rows_;
    std::vector<Worker> workers_;  // one a thread
    std::vector<Part> parts_;
};

}  // namespace SolidSubdiv::Far::Internal

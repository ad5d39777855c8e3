// SPDX-License-Identifier: Apache-2.0
// Makes a table of rows whose lengths show when they are made, in parallel; the same bits for any number of threads.
#pragma once

#include <algorithm>
#include <vector>

#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Far::Internal {

/// Rows that follow one another while they are made. Aligned, so that no two threads share a cache line.
template <class Real>
struct alignas(64) RowPart {
    Array<Index> indices;
    Array<Real> weights;
    Offset start = 0;  ///< of the part in the table
};

/// Makes rows a chunk at a time. Fresh memory is what this costs most,
/// so chunks are made in waves of small buffers that are used again, and the table is reserved at once for about what a
/// sample of the rows takes.
template <class Real, class Worker>
class RowMaker {
  public:
    /// Makes rows [0, n). @param worker what a thread works with: each gets a copy
    RowMaker(Index n, Index n_sources, const Worker& worker) : n_(n), n_threads_(Sdc::ThreadCount()) {
        rows_.n_sources = n_sources;
        rows_.offsets.resize(static_cast<std::size_t>(n) + 1);
        rows_.offsets[0] = 0;
        workers_.assign(static_cast<std::size_t>(n_threads_), {worker});
        parts_.resize(static_cast<std::size_t>(kChunksAThread * n_threads_));
    }

    /// row(i, worker, part) appends row i to the part.
    template <class RowFunction>
    StencilRows<Real> Make(RowFunction&& row) {
        return MakeChunks([&](Offset first, Offset end, Worker& worker, Part& part) {
            part.indices.clear();
            part.weights.clear();
            for (Offset i = first; i < end; ++i) {
                row(static_cast<Index>(i), worker, part);
                rows_.offsets[i + 1] = static_cast<Offset>(part.indices.size());
            }
        });
    }
    /// fill(i, worker, indices, weights) writes row i and returns its length, at most max_length(i).
    template <class MaxLength, class Fill>
    StencilRows<Real> Make(MaxLength&& max_length, Fill&& fill) {
        return MakeChunks([&](Offset first, Offset end, Worker& worker, Part& part) {
            std::size_t room = 0, n = 0;
            for (Offset i = first; i < end; ++i) room += max_length(static_cast<Index>(i));
            part.indices.resize(room);
            part.weights.resize(room);
            for (Offset i = first; i < end; ++i) {
                n += fill(static_cast<Index>(i), worker, part.indices.data() + n, part.weights.data() + n);
                rows_.offsets[i + 1] = static_cast<Offset>(n);
            }
            part.indices.resize(n);
            part.weights.resize(n);
        });
    }

  private:
    static constexpr Offset kChunk = 256, kChunksAThread = 16;
    using Part = RowPart<Real>;

    /// chunk(first, end, worker, part) makes rows [first, end) in the part, and their ends in it.
    template <class ChunkFunction>
    StencilRows<Real> MakeChunks(ChunkFunction&& chunk) {
        Reserve(chunk);
        const Offset wave = kChunk * static_cast<Offset>(parts_.size());
        for (Offset first = 0; first < n_; first += wave) {
            const Offset n_chunks = (std::min(wave, n_ - first) + kChunk - 1) / kChunk;
            ForChunks(n_chunks, [&](Offset c, Worker& worker) {
                chunk(first + c * kChunk, ChunkEnd(first + c * kChunk), worker, parts_[c]);
            });
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

    Offset ChunkEnd(Offset first) const { return std::min<Offset>(first + kChunk, n_); }

    template <class Body>
    void ForChunks(Offset n_chunks, Body&& body) {
        Sdc::ParallelFor(n_threads_, 1, [&](Offset begin, Offset end) {
            for (Offset thread = begin; thread < end; ++thread) {
                for (Offset c = thread; c < n_chunks; c += n_threads_) body(c, workers_[thread].worker);
            }
        });
    }

    void Join(Offset first, const Part& part) {
        for (Offset i = first; i < ChunkEnd(first); ++i) rows_.offsets[i + 1] += part.start;
        std::copy(part.indices.begin(), part.indices.end(), rows_.indices.begin() + part.start);
        std::copy(part.weights.begin(), part.weights.end(), rows_.weights.begin() + part.start);
    }

    template <class ChunkFunction>
    void Reserve(ChunkFunction&& chunk) {
        constexpr Offset kStep = 101;  // one row in so many
        std::size_t n_weights = 0;
        Offset n_rows = 0;
        for (Offset first = 0; first < n_; first += kStep, ++n_rows) {
            // Which of them changes: a fixed step may be the width of a block.
            const Offset i = std::min(first + n_rows * n_rows % kStep, n_ - 1);
            chunk(i, i + 1, workers_[0].worker, parts_[0]);
            n_weights += parts_[0].indices.size();
        }
        const double mean = static_cast<double>(n_weights) / static_cast<double>(std::max<Offset>(n_rows, 1));
        const std::size_t room = static_cast<std::size_t>(1.02 * mean * static_cast<double>(n_));
        rows_.indices.reserve(room);
        rows_.weights.reserve(room);
    }

    Offset n_, n_threads_;
    StencilRows<Real> rows_;
    struct alignas(64) Slot {
        Worker worker;
    };
    std::vector<Slot> workers_;  // one a thread
    std::vector<Part> parts_;
};

}  // namespace SolidSubdiv::Far::Internal

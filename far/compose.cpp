// SPDX-License-Identifier: Apache-2.0
// Products of rows: marked backwards from the requests, multiplied forwards level by level.
#include <solidsubdiv/far/internal/compose.h>

#include <algorithm>
#include <string>

#include <solidsubdiv/far/internal/row_sum.h>
#include <solidsubdiv/far/internal/rows.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Far::Internal {

namespace {

/// What a thread needs. Aligned, so that no two threads share a cache line.
struct alignas(64) Worker {
    RowSum sum;
    RowBuffer<double> row;
};

/// Composite rows of some vertices of one level.
struct PartialLevel {
    bool is_whole = false;     ///< all vertices, in their order: `vertices` and `places` are empty
    Array<Index> vertices;     ///< whose rows these are, ascending
    Array<Index> places;       ///< of each vertex of the level: its row, or kNoIndex
    StencilRows<double> rows;  ///< level 0 has none: a vertex is itself

    Index Place(Index v) const { return is_whole ? v : places[v]; }
};

/// Vertices of one level in the order in which their rows are wanted.
struct Wanted {
    Index n;
    const Index* vertices;  ///< null: all, in their order
    Index operator[](Index i) const { return vertices ? vertices[i] : i; }
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

class Composer {
  public:
    Composer(const TopologyRefiner& refiner, const Sdc::Scheme& scheme, std::span<const CompositeRows> requests,
             const Progress& progress)
        : refiner_(refiner), scheme_(scheme), requests_(requests), progress_(progress) {
        for (const CompositeRows& r : requests) last_ = std::max(last_, r.level);
        levels_.resize(static_cast<std::size_t>(last_) + 1);
        levels_[0].is_whole = true;
    }

    template <class Real>
    StencilRows<Real> Make() {
        for (const CompositeRows& r : requests_) Check(r);
        // One request, the usual case, is a table as it is; more are gathered from the rows of their levels.
        const bool is_direct = requests_.size() == 1 && last_ > 0;
        Mark(is_direct);
        for (int l = 1; l <= last_; ++l) {
            Report(progress_, "composite stencils", static_cast<double>(l - 1) / last_);
            if (l == last_ && is_direct) {
                StencilRows<Real> rows = Multiply<Real>(l, WantedOf(requests_[0]));
                Report(progress_, "composite stencils", 1.0);
                return rows;
            }
            PartialLevel& level = levels_[l];
            level.rows = Multiply<double>(
                l, level.is_whole ? Wanted{NVertices(l), nullptr}
                                  : Wanted{static_cast<Index>(level.vertices.size()), level.vertices.data()});
            // The level below is done with, unless a request names it.
            if (std::none_of(requests_.begin(), requests_.end(), [&](const auto& r) { return r.level == l - 1; })) {
                levels_[l - 1] = {};
            }
        }
        StencilRows<Real> rows = Gather<Real>();
        Report(progress_, "composite stencils", 1.0);
        return rows;
    }

  private:
    Index NVertices(int level) const { return refiner_.level(level).n_vertices; }
    Index NControl() const { return NVertices(0); }
    Wanted WantedOf(const CompositeRows& r) const {
        return r.vertices.empty() ? Wanted{NVertices(r.level), nullptr}
                                  : Wanted{static_cast<Index>(r.vertices.size()), r.vertices.data()};
    }

    /// Calls body with the rows of level l over level l - 1.
    template <class Body>
    void WithRows(int l, Body&& body) const {
        std::visit([&](const auto& s) { body(Rows<std::decay_t<decltype(s)>>(refiner_.level(l - 1), s)); }, scheme_);
    }

    void Check(const CompositeRows& r) const {
        for (Index v : r.vertices) {
            if (v >= 0 && v < NVertices(r.level)) continue;
            throw InvalidInput("composite row of vertex " + std::to_string(v) + " is asked for; level " +
                               std::to_string(r.level) + " has " + std::to_string(NVertices(r.level)) + " vertices");
        }
    }

    /// Finds the vertices whose rows are needed: of the requests, and of what those stand on.
    void Mark(bool is_direct) {
        for (int l = last_; l >= 1; --l) {
            PartialLevel& level = levels_[l];
            const bool is_result = l == last_ && is_direct;
            std::vector<Wanted> wanted;
            for (const CompositeRows& r : requests_) {
                if (r.level != l) continue;
                wanted.push_back(WantedOf(r));
                level.is_whole = level.is_whole || r.vertices.empty();
            }
            if (!level.is_whole) {
                if (level.places.empty()) level.places.assign(NVertices(l), kNoIndex);
                for (const Wanted& w : wanted) {
                    for (Index i = 0; i < w.n; ++i) level.places[w[i]] = 0;
                }
                for (Index v = 0; v < NVertices(l); ++v) {
                    if (level.places[v] == kNoIndex) continue;
                    level.places[v] = static_cast<Index>(level.vertices.size());
                    level.vertices.push_back(v);
                }
            }
            if (l > 1) MarkSources(l, levels_[l - 1]);
            if (is_result) level = {};
        }
    }

    void MarkSources(int l, PartialLevel& below) const {
        const PartialLevel& level = levels_[l];
        // Every vertex is a source of its own child.
        below.is_whole = below.is_whole || level.is_whole;
        if (below.is_whole) return;
        below.places.assign(NVertices(l - 1), kNoIndex);
        WithRows(l, [&](const auto& rows) {
            RowBuffer<double> row;
            for (Index v : level.vertices) {
                row.Read(rows, v);
                for (Index source : row.Indices()) below.places[source] = 0;
            }
        });
    }

    /// Composite rows of the wanted vertices of level l.
    template <class Real>
    StencilRows<Real> Multiply(int l, const Wanted& wanted) const {
        StencilRows<Real> result;
        const PartialLevel& below = levels_[l - 1];
        WithRows(l, [&](const auto& rows) {
            RowMaker<Real> maker(wanted.n, NControl());
            result = maker.Make([&](Index i, Worker& worker) {
                auto& [sum, row] = worker;
                row.Read(rows, wanted[i]);
                if (l == 1) {
                    sum.Add(1.0, row.Indices(), row.Weights());
                    return;
                }
                for (std::size_t k = 0; k < row.n; ++k) {
                    const Index source = below.Place(row.indices[k]);
                    sum.Add(row.weights[k], below.rows.Indices(source), below.rows.Weights(source));
                }
            });
        });
        return result;
    }

    /// The rows that the requests name, one after another, from the rows of their levels.
    template <class Real>
    StencilRows<Real> Gather() const {
        StencilRows<Real> result;
        result.n_sources = NControl();
        for (const CompositeRows& r : requests_) {
            const PartialLevel& level = levels_[r.level];
            const Wanted wanted = WantedOf(r);
            for (Index i = 0; i < wanted.n; ++i) {
                if (r.level == 0) {
                    result.indices.push_back(wanted[i]);
                    result.weights.push_back(1);
                } else {
                    const Index place = level.Place(wanted[i]);
                    const auto indices = level.rows.Indices(place);
                    result.indices.insert(result.indices.end(), indices.begin(), indices.end());
                    for (double w : level.rows.Weights(place)) result.weights.push_back(static_cast<Real>(w));
                }
                result.offsets.push_back(static_cast<Offset>(result.indices.size()));
            }
        }
        return result;
    }

    const TopologyRefiner& refiner_;
    const Sdc::Scheme& scheme_;
    std::span<const CompositeRows> requests_;
    const Progress& progress_;
    int last_ = 0;  // the highest level named
    std::vector<PartialLevel> levels_;
};

}  // namespace

template <class Real>
StencilRows<Real> Compose(const TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                          std::span<const CompositeRows> requests, const Progress& progress) {
    return Composer(refiner, scheme, requests, progress).Make<Real>();
}

template StencilRows<double> Compose(const TopologyRefiner&, const Sdc::Scheme&, std::span<const CompositeRows>,
                                     const Progress&);
template StencilRows<float> Compose(const TopologyRefiner&, const Sdc::Scheme&, std::span<const CompositeRows>,
                                    const Progress&);

}  // namespace SolidSubdiv::Far::Internal

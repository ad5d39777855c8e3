// SPDX-License-Identifier: Apache-2.0
// Products of cascaded tables: marked backwards from the requests, multiplied forwards level by level.
#include <solidsubdiv/far/internal/compose.h>

#include <algorithm>
#include <string>

#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Far::Internal {

namespace {

/// Composite rows of some vertices of one level: vertex v's row is place[v].
struct PartialLevel {
    Array<Index> place;  ///< kNoIndex: not needed
    StencilRows<double> rows;
};

/// One row being summed: a short list of (control vertex, weight), found again through a table of places.
class Accumulator {
  public:
    explicit Accumulator(Index n_control) : place_(n_control, kNoIndex) {}

    void Add(Index i, double weight) {
        Index& place = place_[i];
        if (place == kNoIndex) {
            place = static_cast<Index>(entries_.size());
            entries_.push_back({i, weight});
        } else {
            entries_[place].weight += weight;
        }
    }

    /// Appends the row with ascending indices and starts anew.
    void Flush(std::vector<Index>& indices, std::vector<double>& weights) {
        std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.index < b.index; });
        for (const Entry& e : entries_) {
            indices.push_back(e.index);
            weights.push_back(e.weight);
            place_[e.index] = kNoIndex;
        }
        entries_.clear();
    }

  private:
    struct Entry {
        Index index;
        double weight;
    };
    std::vector<Index> place_;
    std::vector<Entry> entries_;
};

/// Computes n rows, row(i, accumulator) adding row i's entries, and joins them. Fresh memory is what this costs most,
/// so rows are made in waves of small buffers that are used again, and the table is reserved by what the first wave
/// took.
template <class Real, class RowFunction>
StencilRows<Real> MakeRows(Index n, Index n_control, RowFunction&& row) {
    constexpr Offset kChunk = 1024, kChunksAThread = 16;
    const Offset n_threads = Sdc::ThreadCount(), wave = kChunk * kChunksAThread * n_threads;
    struct Part {
        std::vector<Index> indices;
        std::vector<double> weights;
    };
    std::vector<Part> parts(static_cast<std::size_t>(kChunksAThread * n_threads));
    std::vector<Accumulator> accumulators(static_cast<std::size_t>(n_threads), Accumulator(n_control));
    StencilRows<Real> rows;
    rows.n_sources = n_control;
    rows.offsets.resize(static_cast<std::size_t>(n) + 1);
    rows.offsets[0] = 0;
    for (Offset first = 0; first < n; first += wave) {
        const Offset n_chunks = (std::min<Offset>(wave, n - first) + kChunk - 1) / kChunk;
        Sdc::ParallelFor(n_threads, 1, [&](Offset begin, Offset end) {
            for (Offset thread = begin; thread < end; ++thread) {
                for (Offset c = thread; c < n_chunks; c += n_threads) {
                    Part& part = parts[static_cast<std::size_t>(c)];
                    part.indices.clear();
                    part.weights.clear();
                    const Offset from = first + c * kChunk;
                    for (Offset i = from; i < std::min<Offset>(from + kChunk, n); ++i) {
                        row(static_cast<Index>(i), accumulators[static_cast<std::size_t>(thread)]);
                        accumulators[static_cast<std::size_t>(thread)].Flush(part.indices, part.weights);
                        rows.offsets[i + 1] = static_cast<Offset>(part.indices.size());  // within the chunk, for now
                    }
                }
            }
        });
        for (Offset c = 0; c < n_chunks; ++c) {
            const Part& part = parts[static_cast<std::size_t>(c)];
            const Offset from = first + c * kChunk, start = static_cast<Offset>(rows.indices.size());
            for (Offset i = from; i < std::min<Offset>(from + kChunk, n); ++i) rows.offsets[i + 1] += start;
            rows.indices.insert(rows.indices.end(), part.indices.begin(), part.indices.end());
            rows.weights.insert(rows.weights.end(), part.weights.begin(), part.weights.end());
        }
        if (first == 0 && n > wave) {
            const double share = 1.1 * static_cast<double>(n) / static_cast<double>(wave);
            rows.indices.reserve(static_cast<std::size_t>(share * static_cast<double>(rows.indices.size())));
            rows.weights.reserve(static_cast<std::size_t>(share * static_cast<double>(rows.weights.size())));
        }
    }
    return rows;
}

/// The rows that requests name, one after another.
template <class Real, class NVertices>
StencilRows<Real> Gather(std::span<const CompositeRows> requests, const std::vector<PartialLevel>& levels, Index n_rows,
                         Index n_control, NVertices&& n_vertices) {
    struct Named {
        int level;
        Index vertex;
    };
    std::vector<Named> named;
    named.reserve(n_rows);
    for (const CompositeRows& r : requests) {
        const Index n = r.vertices.empty() ? n_vertices(r.level) : static_cast<Index>(r.vertices.size());
        for (Index i = 0; i < n; ++i) named.push_back({r.level, r.vertices.empty() ? i : r.vertices[i]});
    }
    StencilRows<Real> result;
    result.n_sources = n_control;
    result.offsets.resize(named.size() + 1);
    const auto row_of = [&](const Named& v) { return levels[v.level].place[v.vertex]; };
    for (std::size_t i = 0; i < named.size(); ++i) {
        const Named& v = named[i];
        result.offsets[i] = v.level == 0 ? 1 : static_cast<Offset>(levels[v.level].rows.Indices(row_of(v)).size());
    }
    const std::size_t n_weights = static_cast<std::size_t>(Sdc::ScanLengths(result.offsets));
    result.indices.resize(n_weights);
    result.weights.resize(n_weights);
    for (std::size_t i = 0; i < named.size(); ++i) {
        const Named& v = named[i];
        Index* const indices = result.indices.data() + result.offsets[i];
        Real* const weights = result.weights.data() + result.offsets[i];
        if (v.level == 0) {
            *indices = v.vertex;
            *weights = 1;
            continue;
        }
        const auto from = levels[v.level].rows.Indices(row_of(v));
        const auto factors = levels[v.level].rows.Weights(row_of(v));
        std::copy(from.begin(), from.end(), indices);
        for (std::size_t k = 0; k < factors.size(); ++k) weights[k] = static_cast<Real>(factors[k]);
    }
    return result;
}

}  // namespace

template <class Real>
StencilRows<Real> Compose(const StencilTableReal<double>& cascaded, std::span<const CompositeRows> requests,
                          const Progress& progress) {
    const int n_levels = cascaded.n_levels();
    const Index n_control = cascaded.n_control_vertices();
    std::vector<PartialLevel> levels(static_cast<std::size_t>(n_levels) + 1);

    // Mark what the requests name, then, from the last level down, what marked rows stand on.
    const auto n_vertices = [&](int l) { return l == 0 ? n_control : cascaded.level(l).n_rows(); };
    for (int l = 0; l <= n_levels; ++l) levels[l].place.assign(n_vertices(l), kNoIndex);
    Index n_rows = 0;
    for (const CompositeRows& r : requests) {
        if (r.vertices.empty()) {
            std::fill(levels[r.level].place.begin(), levels[r.level].place.end(), 0);
            n_rows += n_vertices(r.level);
        }
        for (Index v : r.vertices) {
            if (v < 0 || v >= n_vertices(r.level)) {
                throw InvalidInput("composite row of vertex " + std::to_string(v) + " is asked for; level " +
                                   std::to_string(r.level) + " has " + std::to_string(n_vertices(r.level)) +
                                   " vertices");
            }
            levels[r.level].place[v] = 0;
        }
        n_rows += static_cast<Index>(r.vertices.size());
    }
    for (int l = n_levels; l > 1; --l) {
        const auto& table = cascaded.level(l);
        for (Index v = 0; v < table.n_rows(); ++v) {
            if (levels[l].place[v] == kNoIndex) continue;
            for (Index source : table.Indices(v)) levels[l - 1].place[source] = 0;
        }
    }

    for (int l = 1; l <= n_levels; ++l) {
        Report(progress, "composite stencils", static_cast<double>(l - 1) / n_levels);
        std::vector<Index> needed;
        for (Index v = 0; v < n_vertices(l); ++v) {
            if (levels[l].place[v] == kNoIndex) continue;
            levels[l].place[v] = static_cast<Index>(needed.size());
            needed.push_back(v);
        }
        const auto& table = cascaded.level(l);
        const PartialLevel& below = levels[l - 1];
        const auto make_row = [&](Index i, Accumulator& sum) {
            const auto sources = table.Indices(needed[i]);
            const auto weights = table.Weights(needed[i]);
            for (std::size_t k = 0; k < sources.size(); ++k) {
                if (l == 1) {
                    sum.Add(sources[k], weights[k]);
                    continue;
                }
                const Index row = below.place[sources[k]];
                const auto indices = below.rows.Indices(row);
                const auto factors = below.rows.Weights(row);
                for (std::size_t j = 0; j < indices.size(); ++j) sum.Add(indices[j], weights[k] * factors[j]);
            }
        };
        // One request for the whole last level, the usual case, is that level's table.
        if (l == n_levels && requests.size() == 1 && requests[0].vertices.empty()) {
            auto result = MakeRows<Real>(static_cast<Index>(needed.size()), n_control, make_row);
            Report(progress, "composite stencils", 1.0);
            return result;
        }
        levels[l].rows = MakeRows<double>(static_cast<Index>(needed.size()), n_control, make_row);
        // A level below that no request names is done with.
        const bool named =
            std::any_of(requests.begin(), requests.end(), [&](const auto& r) { return r.level == l - 1; });
        if (!named) levels[l - 1] = {};
    }

    StencilRows<Real> result = Gather<Real>(requests, levels, n_rows, n_control, n_vertices);
    Report(progress, "composite stencils", 1.0);
    return result;
}

template StencilRows<double> Compose(const StencilTableReal<double>&, std::span<const CompositeRows>, const Progress&);
template StencilRows<float> Compose(const StencilTableReal<double>&, std::span<const CompositeRows>, const Progress&);

}  // namespace SolidSubdiv::Far::Internal

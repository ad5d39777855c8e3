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

/// Sums of weights by control vertex, with the list of those touched; reused from row to row.
class Accumulator {
  public:
    explicit Accumulator(Index n) : sums_(n, 0.0), is_touched_(n, 0) {}

    void Add(Index i, double weight) {
        if (!is_touched_[i]) {
            is_touched_[i] = 1;
            touched_.push_back(i);
        }
        sums_[i] += weight;
    }

    /// Appends the row with ascending indices and starts anew.
    void Flush(std::vector<Index>& indices, std::vector<double>& weights) {
        std::sort(touched_.begin(), touched_.end());
        for (Index i : touched_) {
            indices.push_back(i);
            weights.push_back(sums_[i]);
            sums_[i] = 0;
            is_touched_[i] = 0;
        }
        touched_.clear();
    }

  private:
    std::vector<double> sums_;
    std::vector<std::uint8_t> is_touched_;
    std::vector<Index> touched_;
};

/// Computes n rows in fixed chunks, each by itself, and joins them: row(i, accumulator) adds row i's entries.
template <class RowFunction>
StencilRows<double> MakeRows(Index n, Index n_control, RowFunction&& row) {
    constexpr Offset kChunk = 2048;
    const Offset n_chunks = (n + kChunk - 1) / kChunk;
    struct Part {
        std::vector<Index> indices;
        std::vector<double> weights;
    };
    std::vector<Part> parts(static_cast<std::size_t>(n_chunks));
    StencilRows<double> rows;
    rows.n_sources = n_control;
    rows.offsets.resize(static_cast<std::size_t>(n) + 1);
    Sdc::ParallelFor(n_chunks, 1, [&](Offset begin, Offset end) {
        Accumulator accumulator(n_control);
        for (Offset c = begin; c < end; ++c) {
            Part& part = parts[static_cast<std::size_t>(c)];
            for (Offset i = c * kChunk; i < std::min<Offset>((c + 1) * kChunk, n); ++i) {
                const std::size_t before = part.indices.size();
                row(static_cast<Index>(i), accumulator);
                accumulator.Flush(part.indices, part.weights);
                rows.offsets[i] = static_cast<Offset>(part.indices.size() - before);
            }
        }
    });
    const Offset n_weights = Sdc::ScanLengths(rows.offsets);
    rows.indices.resize(static_cast<std::size_t>(n_weights));
    rows.weights.resize(static_cast<std::size_t>(n_weights));
    Sdc::ParallelFor(n_chunks, 1, [&](Offset begin, Offset end) {
        for (Offset c = begin; c < end; ++c) {
            Part& part = parts[static_cast<std::size_t>(c)];
            std::copy(part.indices.begin(), part.indices.end(), rows.indices.begin() + rows.offsets[c * kChunk]);
            std::copy(part.weights.begin(), part.weights.end(), rows.weights.begin() + rows.offsets[c * kChunk]);
            part = {};
        }
    });
    return rows;
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
        levels[l].rows = MakeRows(static_cast<Index>(needed.size()), n_control, [&](Index i, Accumulator& sum) {
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
        });
        // A level below that no request names is done with.
        const bool named =
            std::any_of(requests.begin(), requests.end(), [&](const auto& r) { return r.level == l - 1; });
        if (!named) levels[l - 1] = {};
    }

    StencilRows<Real> result;
    result.n_sources = n_control;
    result.offsets.assign(1, 0);
    result.offsets.reserve(static_cast<std::size_t>(n_rows) + 1);
    const auto append = [&](int l, Index v) {
        if (l == 0) {
            result.indices.push_back(v);
            result.weights.push_back(Real{1});
        } else {
            const auto& rows = levels[l].rows;
            const Index row = levels[l].place[v];
            for (Index i : rows.Indices(row)) result.indices.push_back(i);
            for (double w : rows.Weights(row)) result.weights.push_back(static_cast<Real>(w));
        }
        result.offsets.push_back(static_cast<Offset>(result.indices.size()));
    };
    for (const CompositeRows& r : requests) {
        if (r.vertices.empty()) {
            for (Index v = 0; v < n_vertices(r.level); ++v) append(r.level, v);
        }
        for (Index v : r.vertices) append(r.level, v);
    }
    Report(progress, "composite stencils", 1.0);
    return result;
}

template StencilRows<double> Compose(const StencilTableReal<double>&, std::span<const CompositeRows>, const Progress&);
template StencilRows<float> Compose(const StencilTableReal<double>&, std::span<const CompositeRows>, const Progress&);

}  // namespace SolidSubdiv::Far::Internal

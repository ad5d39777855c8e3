// SPDX-License-Identifier: Apache-2.0
// Products of rows: marked backwards from the requests, multiplied forwards level by level.
#include <solidsubdiv/far/internal/compose.h>

#include <algorithm>
#include <string>

#include <solidsubdiv/far/internal/row_buffer.h>
#include <solidsubdiv/far/internal/row_maker.h>
#include <solidsubdiv/far/internal/row_sum.h>
#include <solidsubdiv/far/internal/with_rows.h>

namespace SolidSubdiv::Far::Internal {

namespace {

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

/// What a thread needs.
struct Worker {
    RowSum sum;
    RowBuffer<double> row;
};

class Composer {
  public:
    Composer(const TopologyRefiner& refiner, const Sdc::Scheme& scheme, std::span<const CompositeRows> requests,
             const Progress& progress)
        : refiner_(refiner), scheme_(scheme), requests_(requests), progress_(progress) {
        for (const CompositeRows& r : requests) last_ = std::max(last_, r.level);
        levels_.resize(static_cast<std::size_t>(last_) + 1);
        sharpness_ = SharpnessOfLevels(refiner, scheme, last_);
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
    Index NVertices(int level) const { return refiner_.n_vertices(level); }
    Index NControl() const { return NVertices(0); }
    Wanted WantedOf(const CompositeRows& r) const {
        return r.vertices.empty() ? Wanted{NVertices(r.level), nullptr}
                                  : Wanted{static_cast<Index>(r.vertices.size()), r.vertices.data()};
    }

    /// Calls body with the rows of level l over level l - 1.
    template <class Body>
    void WithRows(int l, Body&& body) const {
        Internal::WithRows(refiner_, l - 1, sharpness_[l - 1], scheme_, body);
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
            RowMaker<Real, Worker> maker(wanted.n, NControl(), {RowSum(NControl()), {}});
            result = maker.Make([&](Index i, Worker& worker, RowPart<Real>& part) {
                auto& [sum, row] = worker;
                row.Read(rows, wanted[i]);
                if (l == 1) {
                    sum.Add(1.0, row.Indices(), row.Weights());
                } else {
                    for (std::size_t k = 0; k < row.n; ++k) {
                        const Index source = below.Place(row.indices[k]);
                        sum.Add(row.weights[k], below.rows.Indices(source), below.rows.Weights(source));
                    }
                }
                sum.Flush(part.indices, part.weights);
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
    std::vector<Sharpness> sharpness_;  // of the levels before the last
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

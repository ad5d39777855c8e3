// SPDX-License-Identifier: Apache-2.0
// Rows of chosen points over the control points: their rows over the patch points, taken down the cascade.
#include <solidsubdiv/apps/deform/embedding.h>
#include <solidsubdiv/apps/deform/internal/used_columns.h>

#include <algorithm>
#include <string>

namespace SolidSubdiv::Deform {

namespace {

/// A sum of weighted vertices; dense, so that it is added to and emptied fast.
class SparseSum {
  public:
    explicit SparseSum(Index n = 0) : weights_(static_cast<std::size_t>(n)), is_in_(static_cast<std::size_t>(n)) {}

    void Add(Index i, double weight) {
        weights_[static_cast<std::size_t>(i)] += weight;
        if (is_in_[static_cast<std::size_t>(i)]) return;
        is_in_[static_cast<std::size_t>(i)] = true;
        indices_.push_back(i);
    }
    /// Calls visit(i, weight), ascending, and empties the sum.
    template <class Visit>
    void Drain(Visit&& visit) {
        std::sort(indices_.begin(), indices_.end());
        for (Index i : indices_) {
            visit(i, weights_[static_cast<std::size_t>(i)]);
            weights_[static_cast<std::size_t>(i)] = 0;
            is_in_[static_cast<std::size_t>(i)] = false;
        }
        indices_.clear();
    }

  private:
    std::vector<double> weights_;
    std::vector<bool> is_in_;
    std::vector<Index> indices_;
};

/// Where each point stands: hexes first, then tets, then rows; kNoIndex: it does not move.
struct Stands {
    explicit Stands(const EmbeddingTables& t) : places(static_cast<std::size_t>(t.n_points), kNoIndex) {
        Index place = 0;
        for (const Array<Index>* points : {&t.hexes.points, &t.tets.points, &t.row_points}) {
            for (Index point : *points) places[static_cast<std::size_t>(point)] = place++;
        }
    }
    std::vector<Index> places;
};

template <int kCorners>
Index CellOf(const EmbeddedCells<kCorners>& cells, Index place) {
    return static_cast<Index>(std::upper_bound(cells.offsets.begin(), cells.offsets.end(), Offset{place}) -
                              cells.offsets.begin()) -
           1;
}

void AddPoint(const EmbeddingTables& t, Index place, double factor, SparseSum& sum) {
    const Index n_in_hexes = static_cast<Index>(t.hexes.points.size());
    const Index n_in_tets = static_cast<Index>(t.tets.points.size());
    if (place < n_in_hexes) {
        const Index* const corner = &t.hexes.corners[8 * static_cast<std::size_t>(CellOf(t.hexes, place))];
        const double* const at = &t.hexes.at[3 * static_cast<std::size_t>(place)];
        for (int i = 0; i < 8; ++i) {  // VTK's order
            const double u = i % 4 == 1 || i % 4 == 2 ? at[0] : 1 - at[0];
            const double v = i % 4 >= 2 ? at[1] : 1 - at[1], w = i >= 4 ? at[2] : 1 - at[2];
            sum.Add(corner[i], factor * u * v * w);
        }
    } else if ((place -= n_in_hexes) < n_in_tets) {
        const Index* const corner = &t.tets.corners[4 * static_cast<std::size_t>(CellOf(t.tets, place))];
        const double* const at = &t.tets.at[3 * static_cast<std::size_t>(place)];
        sum.Add(corner[0], factor * (1 - at[0] - at[1] - at[2]));
        for (int i = 0; i < 3; ++i) sum.Add(corner[i + 1], factor * at[i]);
    } else {
        place -= n_in_tets;
        for (std::size_t k = 0; k < t.rows.Indices(place).size(); ++k) {
            sum.Add(t.rows.Indices(place)[k], factor * t.rows.Weights(place)[k]);
        }
    }
}

}  // namespace

Far::StencilRows<double> Embedding::ControlRows(std::span<const Index> points) const {
    const EmbeddingTables& t = tables_;
    if (t.n_control_points > t.Bytes()) {  // sums are dense: of so many, over those that something reads
        Embedding few;
        few.tables_ = t;
        const Internal::UsedColumns used = Internal::KeepUsedControlPoints(few.tables_);
        few.tables_.n_control_points = used.size();
        Far::StencilRows<double> rows = few.ControlRows(points);
        rows.n_sources = t.n_control_points;
        for (Index& i : rows.indices) i = used[i];
        return rows;
    }
    const Stands stands(t);
    std::vector<SparseSum> sums;  // over the control points, then the rows of each level
    sums.emplace_back(t.n_control_points);
    for (const auto& level : t.cascade) sums.emplace_back(level.n_rows());

    Far::StencilRows<double> result;
    result.n_sources = t.n_control_points;
    for (Index point : points) {
        if (point < 0 || point >= t.n_points) {
            throw InvalidInput("point " + std::to_string(point) + " is not among the " + std::to_string(t.n_points));
        }
        const auto out = std::lower_bound(t.outside.begin(), t.outside.end(), point,
                                          [](const OutsidePoint& o, Index p) { return o.point < p; });
        const double factor = out != t.outside.end() && out->point == point ? out->factor : 1;
        const Index place = stands.places[static_cast<std::size_t>(point)];
        if (place != kNoIndex) AddPoint(t, place, factor, sums.back());
        for (std::size_t l = t.cascade.size(); l > 0; --l) {
            sums[l].Drain([&](Index row, double weight) {
                const auto indices = t.cascade[l - 1].Indices(row);
                const auto weights = t.cascade[l - 1].Weights(row);
                for (std::size_t k = 0; k < indices.size(); ++k) sums[l - 1].Add(indices[k], weight * weights[k]);
            });
        }
        sums[0].Drain([&](Index i, double weight) {
            result.indices.push_back(i);
            result.weights.push_back(weight);
        });
        result.offsets.push_back(static_cast<Offset>(result.indices.size()));
    }
    return result;
}

}  // namespace SolidSubdiv::Deform

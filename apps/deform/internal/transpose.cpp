// SPDX-License-Identifier: Apache-2.0
// A deformation backwards: from points to the corners of their cells, then down the cascade.
#include <solidsubdiv/apps/deform/internal/transpose.h>

#include <array>
#include <type_traits>
#include <utility>

namespace SolidSubdiv::Deform::Internal {

namespace {

/// to[i] += weight * from, triples.
void AddTriple(double weight, const double* from, Index i, std::vector<double>& to) {
    for (std::size_t axis = 0; axis < 3; ++axis) to[3 * static_cast<std::size_t>(i) + axis] += weight * from[axis];
}

std::array<double, 8> Weights(const double* at, std::integral_constant<int, 8>) {
    const double u = at[0], v = at[1], w = at[2], a = 1 - u, b = 1 - v, c = 1 - w;
    return {a * b * c, u * b * c, u * v * c, a * v * c, a * b * w, u * b * w, u * v * w, a * v * w};
}

std::array<double, 4> Weights(const double* at, std::integral_constant<int, 4>) {
    return {1 - at[0] - at[1] - at[2], at[0], at[1], at[2]};
}

template <int kCorners>
void AddCells(const EmbeddedCells<kCorners>& cells, const std::vector<double>& triples, std::vector<double>& patch) {
    for (Index cell = 0; cell < cells.n_cells(); ++cell) {
        const Index* corners = cells.corners.data() + kCorners * static_cast<std::size_t>(cell);
        for (Offset i = cells.offsets[cell]; i < cells.offsets[cell + 1]; ++i) {
            const auto weights = Weights(cells.at.data() + 3 * i, std::integral_constant<int, kCorners>{});
            const double* from = triples.data() + 3 * static_cast<std::size_t>(cells.points[i]);
            for (std::size_t k = 0; k < kCorners; ++k) AddTriple(weights[k], from, corners[k], patch);
        }
    }
}

void AddRow(const Far::StencilRows<double>& rows, Index row, const double* from, std::vector<double>& to) {
    for (Offset k = rows.offsets[row]; k < rows.offsets[row + 1]; ++k) {
        AddTriple(rows.weights[k], from, rows.indices[k], to);
    }
}

}  // namespace

std::vector<double> ApplyTransposed(const EmbeddingTables& tables, std::span<const double> triples) {
    std::vector<double> scaled(triples.begin(), triples.end());
    for (const OutsidePoint& out : tables.outside) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            scaled[3 * static_cast<std::size_t>(out.point) + axis] *= out.factor;
    }
    std::vector<double> sums(3 * static_cast<std::size_t>(tables.n_patch_points()));
    AddCells(tables.hexes, scaled, sums);
    AddCells(tables.tets, scaled, sums);
    for (Index row = 0; row < tables.rows.n_rows(); ++row) {
        AddRow(tables.rows, row, scaled.data() + 3 * static_cast<std::size_t>(tables.row_points[row]), sums);
    }
    for (auto level = tables.cascade.rbegin(); level != tables.cascade.rend(); ++level) {
        std::vector<double> coarser(3 * static_cast<std::size_t>(level->n_sources));
        for (Index row = 0; row < level->n_rows(); ++row) {
            AddRow(*level, row, sums.data() + 3 * static_cast<std::size_t>(row), coarser);
        }
        sums = std::move(coarser);
    }
    return sums;
}

}  // namespace SolidSubdiv::Deform::Internal

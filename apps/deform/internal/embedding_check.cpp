// SPDX-License-Identifier: Apache-2.0
// Offsets ascend, indices are in range, numbers are finite, every point stands in at most one place.
#include <solidsubdiv/apps/deform/internal/embedding_check.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace SolidSubdiv::Deform::Internal {

namespace {

void Require(bool is_right, const char* what) {
    if (!is_right) throw InvalidInput(std::string("its tables do not fit each other: ") + what);
}

void RequireOffsets(const Array<Offset>& offsets, std::size_t n_items, const char* what) {
    Require(!offsets.empty() && offsets.front() == 0 && offsets.back() == static_cast<Offset>(n_items) &&
                std::is_sorted(offsets.begin(), offsets.end()),
            what);
}

void RequireInRange(const Array<Index>& indices, Index n, const char* what) {
    Require(std::all_of(indices.begin(), indices.end(), [n](Index i) { return i >= 0 && i < n; }), what);
}

void RequireFinite(const Array<double>& numbers, const char* what) {
    Require(std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); }), what);
}

void RequireRows(const Far::StencilRows<double>& rows, Index n_sources, const char* what) {
    Require(rows.n_sources == n_sources && rows.indices.size() == rows.weights.size(), what);
    Require(rows.offsets.size() <= static_cast<std::size_t>(std::numeric_limits<Index>::max()), what);
    RequireOffsets(rows.offsets, rows.indices.size(), what);
    RequireInRange(rows.indices, n_sources, what);
    RequireFinite(rows.weights, what);
}

template <int kCorners>
void RequireCells(const EmbeddedCells<kCorners>& cells, Index n_patch_points, const char* what) {
    Require(cells.corners.size() <= static_cast<std::size_t>(std::numeric_limits<Index>::max()), what);
    RequireOffsets(cells.offsets, cells.points.size(), what);
    Require(cells.corners.size() == kCorners * (cells.offsets.size() - 1) && cells.at.size() == 3 * cells.points.size(),
            what);
    RequireInRange(cells.corners, n_patch_points, what);
    RequireFinite(cells.at, what);
}

}  // namespace

void CheckTables(const EmbeddingTables& t) {
    Index n_sources = t.n_control_points;
    for (const auto& level : t.cascade) {
        RequireRows(level, n_sources, "the cascade");
        n_sources = level.n_rows();
    }
    RequireCells(t.hexes, n_sources, "the hexahedra");
    RequireCells(t.tets, n_sources, "the tets");
    RequireRows(t.rows, n_sources, "the rows");
    Require(t.row_points.size() == static_cast<std::size_t>(t.rows.n_rows()), "points of the rows");

    // What moves, and what stays outside: together every point, once.
    std::size_t n_standing = t.hexes.points.size() + t.tets.points.size() + t.row_points.size();
    for (const OutsidePoint& out : t.outside) n_standing += out.factor == 0;
    Require(n_standing == static_cast<std::size_t>(t.n_points), "a point is missing or double");
    std::vector<int> times(static_cast<std::size_t>(t.n_points));
    for (const Array<Index>* points : {&t.hexes.points, &t.tets.points, &t.row_points}) {
        RequireInRange(*points, t.n_points, "points");
        for (Index point : *points) ++times[static_cast<std::size_t>(point)];
    }
    Index before = -1;
    for (const OutsidePoint& out : t.outside) {
        Require(out.point > before && out.point < t.n_points, "points outside");
        before = out.point;
        Require(out.factor >= 0 && out.factor <= 1 && out.distance >= 0, "points outside");
        for (double x : out.constant) Require(std::isfinite(x), "points outside");
        if (out.factor == 0) ++times[static_cast<std::size_t>(out.point)];
    }
    Require(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }), "a point is missing or double");
}

}  // namespace SolidSubdiv::Deform::Internal

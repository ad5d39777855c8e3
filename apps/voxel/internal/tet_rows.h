// SPDX-License-Identifier: Apache-2.0
// Which points of a regular grid a tet holds.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace SolidSubdiv::Voxel::Internal {

/// n^3 points (n <= 64), `step` apart in each direction, the first at (start, start, start).
struct PointGrid {
    int n;
    double start, step;
};

/// Points (x, y, first) to (x, y, last) of a grid, by their numbers.
struct Row {
    std::int8_t x, y, first, last;
};

using Tet = std::array<std::array<double, 3>, 4>;

/// The rows of points in a tet; one that is inverted counts as it would the other way round, a flat one holds nothing.
/// Points outside by a billionth of a voxel are held: what lies on a face is in both cells, whatever rounding does.
/// @param rows written from the first on, (n^2 places) @return how many there are
std::size_t FindRows(const Tet& tet, const PointGrid& grid, std::span<Row> rows);

}  // namespace SolidSubdiv::Voxel::Internal

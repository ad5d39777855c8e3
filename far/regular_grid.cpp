// SPDX-License-Identifier: Apache-2.0
// Regular pockets of hexahedra and of quadrilaterals, which may end at sides of the root.
#include <solidsubdiv/far/internal/regular_patch.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include <solidsubdiv/far/internal/unfolding.h>
#include <solidsubdiv/sdc/creases.h>

namespace SolidSubdiv::Far::Internal {

namespace {

using Side = std::vector<Index>;  ///< its corners

/// Squares and cubes around the root, unfolded; they stop at creases for ever.
struct Grid {
    int dimension;
    std::size_t n_corners;
    std::vector<std::vector<Index>> cells;  ///< corners in the order of axes: bit a is coordinate a
    std::vector<Point> cell_points;         ///< least corners
    Unfolding unfolding;
};

bool IsInfiniteCrease(const Pocket& pocket, Index a, Index b) {
    for (std::size_t i = 0; i < pocket.crease_sharpness.size(); ++i) {
        const Index c = pocket.crease_edges[2 * i], d = pocket.crease_edges[2 * i + 1];
        if ((c == a && d == b) || (c == b && d == a)) return Sdc::IsInfinitelySharp(pocket.crease_sharpness[i]);
    }
    return false;
}

/// Puts the root's neighbours next to it, side by side. False where that contradicts itself.
bool UnfoldGrid(const Pocket& pocket, Grid& grid) {
    const std::size_t d = static_cast<std::size_t>(grid.dimension);
    std::map<Side, std::vector<std::size_t>> sides;
    const auto side_of = [&](const std::vector<Index>& cell, std::size_t axis, std::size_t end) {
        Side side;
        for (std::size_t i = 0; i < grid.n_corners; ++i) {
            if ((i >> axis & 1) == end) side.push_back(cell[i]);
        }
        return side;
    };
    const auto sorted = [](Side side) {
        std::sort(side.begin(), side.end());
        return side;
    };
    for (std::size_t c = 0; c < grid.cells.size(); ++c) {
        for (std::size_t a = 0; a < d; ++a) {
            for (std::size_t end : {0u, 1u}) sides[sorted(side_of(grid.cells[c], a, end))].push_back(c);
        }
    }
    for (std::size_t i = 0; i < grid.n_corners; ++i) {
        const Point p{static_cast<int>(i & 1), static_cast<int>(i >> 1 & 1), static_cast<int>(i >> 2)};
        if (!grid.unfolding.Put(grid.cells[0][i], p)) return false;
    }
    std::vector<bool> is_reached(grid.cells.size(), false);
    std::vector<std::size_t> queue{0};
    is_reached[0] = true;
    for (std::size_t head = 0; head < queue.size(); ++head) {
        const std::vector<Index>& cell = grid.cells[queue[head]];
        // Far corners of a neighbour are those of this cell, reflected; its own order of corners does not count.
        for (std::size_t a = 0; a < d; ++a) {
            for (std::size_t end : {0u, 1u}) {
                const Side side = side_of(cell, a, end), inner = side_of(cell, a, 1 - end);
                if (d == 2 && IsInfiniteCrease(pocket, side[0], side[1])) continue;
                const auto& both = sides.at(sorted(side));
                if (both.size() > 2) return false;
                for (std::size_t other : both) {
                    if (other == queue[head]) continue;
                    for (std::size_t i = 0; i < side.size(); ++i) {
                        // The corner of the neighbour that an edge joins to side[i] and is not on the side.
                        const auto& corners = grid.cells[other];
                        const std::size_t at = static_cast<std::size_t>(
                            std::find(corners.begin(), corners.end(), side[i]) - corners.begin());
                        for (std::size_t b = 0; b < d; ++b) {
                            const Index beyond = corners[at ^ (std::size_t{1} << b)];
                            if (std::find(side.begin(), side.end(), beyond) != side.end()) continue;
                            const Point p =
                                grid.unfolding[side[i]] + grid.unfolding[side[i]] - grid.unfolding[inner[i]];
                            if (!grid.unfolding.Put(beyond, p)) return false;
                        }
                    }
                    if (!is_reached[other]) queue.push_back(other);
                    is_reached[other] = true;
                }
            }
        }
    }
    for (std::size_t c : queue) {
        Point least = grid.unfolding[grid.cells[c][0]];
        for (Index v : grid.cells[c]) {
            for (std::size_t a = 0; a < 3; ++a) least[a] = std::min(least[a], grid.unfolding[v][a]);
        }
        grid.cell_points.push_back(least);
    }
    return d == 2 || queue.size() == grid.cells.size();
}

/// Whether creases and corners at one of the root's vertices are those of a tensor product of curves that end, each
/// with its last point: no crease inside and on smooth sides, a crease where the mesh ends on both sides of it, a
/// corner where it ends along all axes.
bool HasTensorRule(const Pocket& pocket, const Grid& grid, const std::array<std::array<bool, 2>, 3>& ends, Index v) {
    const std::size_t d = static_cast<std::size_t>(grid.dimension);
    const Point p = grid.unfolding[v];
    std::size_t n_ends = 0, free_axis = 0;
    for (std::size_t a = 0; a < d; ++a) {
        if (ends[a][static_cast<std::size_t>(p[a])])
            ++n_ends;
        else
            free_axis = a;
    }
    // The edges at v that are creases for ever, or end a surface.
    std::vector<Index> others;
    for (std::size_t i = 0; i < pocket.crease_sharpness.size(); ++i) {
        const Index a = pocket.crease_edges[2 * i], b = pocket.crease_edges[2 * i + 1];
        if (a != v && b != v) continue;
        if (!Sdc::IsInfinitelySharp(pocket.crease_sharpness[i])) return false;
        others.push_back(a == v ? b : a);
    }
    if (d == 2) {
        std::map<Index, int> n_faces;  // of the edge to each neighbour
        for (Index f = 0; f < pocket.faces.size(); ++f) {
            const auto corners = pocket.faces[f];
            const std::size_t n = corners.size();
            for (std::size_t i = 0; i < n; ++i) {
                if (corners[i] == v) ++n_faces[corners[(i + 1) % n]], ++n_faces[corners[(i + n - 1) % n]];
            }
        }
        for (const auto& [other, n] : n_faces) {
            if (n > 2) return false;
            if (n == 1) others.push_back(other);
        }
    }
    const auto corner = std::find(pocket.corner_vertices.begin(), pocket.corner_vertices.end(), v);
    const bool is_sharp = corner != pocket.corner_vertices.end();
    if (is_sharp) {
        const auto i = static_cast<std::size_t>(corner - pocket.corner_vertices.begin());
        if (!Sdc::IsInfinitelySharp(pocket.corner_sharpness[i])) return false;
    }
    if (n_ends == d) return is_sharp || others.size() > 2;
    if (is_sharp) return false;
    if (n_ends + 1 < d) return others.empty();
    return others.size() == 2 && std::all_of(others.begin(), others.end(), [&](Index other) {
               if (!grid.unfolding.Has(other)) return false;
               const Point step = grid.unfolding[other] - p;
               return std::abs(step[free_axis]) == 1 && Dot(step, step) == 1;
           });
}

}  // namespace

std::optional<RegularPatch> RegularPatch::FindGrid(const Pocket& pocket) {
    const bool is_face = pocket.root == RootKind::Face;
    if (!pocket.edges.empty() || (!is_face && pocket.root != RootKind::Hex)) return std::nullopt;
    const std::size_t n_corners = is_face ? 4 : 8, d = is_face ? 2 : 3;
    Grid grid{static_cast<int>(d), n_corners, {}, {}, Unfolding(pocket.n_vertices())};
    if (is_face) {
        for (Index f = 0; f < pocket.faces.size(); ++f) {
            if (pocket.faces[f].size() != n_corners) return std::nullopt;
            grid.cells.push_back(InAxes(pocket.faces[f]));
        }
    } else {
        if (pocket.faces.size() > 0 || pocket.cell_offsets.size() > 1) return std::nullopt;
        for (std::size_t h = 0; h < pocket.hexes.size(); h += 8) {
            grid.cells.push_back(InAxes({pocket.hexes.data() + h, n_corners}));
        }
    }
    if (!UnfoldGrid(pocket, grid)) return std::nullopt;

    // The cells reached must fill a box around the root, one cell wide on the sides where the mesh goes on.
    RegularPatch patch;
    patch.kind_ = Kind::Grid;
    patch.dimension_ = static_cast<int>(d);
    Point low{}, high{};
    for (const Point& p : grid.cell_points) {
        for (std::size_t a = 0; a < d; ++a) {
            low[a] = std::min(low[a], p[a]);
            high[a] = std::max(high[a], p[a]);
        }
    }
    std::size_t n_cells = 1;
    for (std::size_t a = 0; a < d; ++a) {
        if (low[a] < -1 || high[a] > 1) return std::nullopt;
        patch.ends_[a] = {low[a] == 0, high[a] == 0};
        n_cells *= static_cast<std::size_t>(high[a] - low[a] + 1);
    }
    std::vector<Point> unique = grid.cell_points;
    std::sort(unique.begin(), unique.end());
    unique.erase(std::unique(unique.begin(), unique.end()), unique.end());
    if (unique.size() != n_cells || grid.cell_points.size() != n_cells) return std::nullopt;

    for (Index v = 0; v < pocket.n_root_vertices; ++v) {
        if (!HasTensorRule(pocket, grid, patch.ends_, v)) return std::nullopt;
    }
    const int depth = is_face ? 1 : 4;
    for (int k = 0; k < depth; ++k) {
        for (int j = 0; j < 4; ++j) {
            for (int i = 0; i < 4; ++i) {
                patch.points_.push_back(grid.unfolding.VertexAt({i - 1, j - 1, is_face ? 0 : k - 1}));
            }
        }
    }
    return patch;
}

}  // namespace SolidSubdiv::Far::Internal

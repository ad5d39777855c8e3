// SPDX-License-Identifier: Apache-2.0
// Points go to their cells, triangles down the octree from the least cell that has them whole; what is outside is
// reached in layers.
#include <solidsubdiv/apps/deform/internal/octree_cells.h>

#include <algorithm>
#include <cmath>

#include <solidsubdiv/apps/deform/internal/vector3.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Deform::Internal {

namespace {

constexpr Offset kTask = 1024;                 // triangles
constexpr std::uint32_t kXBits = 0x09249249u;  // of places on the curve; y and z have the bits next to them

/// Ten bits, two zeros between each and the next; and back.
std::uint32_t Spread(std::uint32_t x) {
    x = (x | x << 16) & 0x030000FFu;
    x = (x | x << 8) & 0x0300F00Fu;
    x = (x | x << 4) & 0x030C30C3u;
    return (x | x << 2) & kXBits;
}
std::uint32_t Gather(std::uint32_t x) {
    x &= kXBits;
    x = (x | x >> 2) & 0x030C30C3u;
    x = (x | x >> 4) & 0x0300F00Fu;
    x = (x | x >> 8) & 0x030000FFu;
    return (x | x >> 16) & 0x000003FFu;
}

/// One triangle on its way down.
class Descent {
  public:
    Descent(const Grid& grid, const GridPoint& tolerance, std::vector<std::uint32_t>& found)
        : grid_(grid), tolerance_(tolerance), found_(found) {}

    void Insert(const std::array<GridPoint, 3>& triangle) {
        triangle_ = triangle;
        GridPoint low, high;
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min({triangle[0][k], triangle[1][k], triangle[2][k]}) - tolerance_[k];
            high[k] = std::max({triangle[0][k], triangle[1][k], triangle[2][k]}) + tolerance_[k];
            if (high[k] < 0 || low[k] > grid_.n()) return;
        }
        first_ = grid_.CellOf(low);
        last_ = grid_.CellOf(high);
        int size = 0;  // of the least cell of the octree that has both, as a power of 2
        for (std::size_t k = 0; k < 3; ++k) {
            size = std::max(size, static_cast<int>(std::bit_width(static_cast<std::uint32_t>(first_[k] ^ last_[k]))));
        }
        Visit({first_[0] >> size, first_[1] >> size, first_[2] >> size}, size);
    }

  private:
    void Visit(const GridPlace& cell, int size) {
        GridPoint centre, half;
        for (std::size_t k = 0; k < 3; ++k) {
            const Index begin = cell[k] << size;
            if (begin > last_[k] || begin + (Index{1} << size) <= first_[k]) return;
            const double side = static_cast<double>(Index{1} << size);
            centre[k] = static_cast<double>(begin) + .5 * side;
            // The test's own rounding is 1e-15 of the triangle's size, which is at most some thousand cells.
            half[k] = (.5 + 1e-9) * side + tolerance_[k];
        }
        if (!TriangleMeetsBox(triangle_, centre, half)) return;
        if (size == 0) {
            found_.push_back(CurvePlace(cell));
            return;
        }
        for (Index child = 0; child < 8; ++child) {
            Visit({2 * cell[0] + (child & 1), 2 * cell[1] + (child >> 1 & 1), 2 * cell[2] + (child >> 2)}, size - 1);
        }
    }

    const Grid& grid_;
    GridPoint tolerance_;
    std::vector<std::uint32_t>& found_;
    std::array<GridPoint, 3> triangle_;
    GridPlace first_, last_;  // of the cells around the triangle
};

void SortUnique(std::vector<std::uint32_t>& numbers) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

std::uint32_t CurvePlace(const GridPlace& cell) {
    return Spread(static_cast<std::uint32_t>(cell[0])) | Spread(static_cast<std::uint32_t>(cell[1])) << 1 |
           Spread(static_cast<std::uint32_t>(cell[2])) << 2;
}

GridPlace CellAt(std::uint32_t place) {
    return {static_cast<Index>(Gather(place)), static_cast<Index>(Gather(place >> 1)),
            static_cast<Index>(Gather(place >> 2))};
}

GridPoint Grid::At(std::span<const double, 3> point) const {
    GridPoint t = box_.CoordinatesOf(point);
    for (std::size_t k = 0; k < 3; ++k) t[k] = t[k] / box_.lengths[k] * n_;
    return t;
}

GridPlace Grid::CellOf(const GridPoint& point) const {
    GridPlace cell;
    for (std::size_t k = 0; k < 3; ++k) cell[k] = static_cast<Index>(std::clamp(point[k], 0., n_ - 1.));
    return cell;
}

void InsertPoints(const Grid& grid, std::span<const GridPoint> points, RankedBits& cells) {
    for (const GridPoint& point : points) cells.Insert(CurvePlace(grid.CellOf(point)));
}

void InsertTriangles(const Grid& grid, std::span<const GridPoint> points, std::span<const Index> triangles,
                     const GridPoint& tolerance, RankedBits& cells) {
    constexpr std::size_t kMany = std::size_t{1} << 20;
    const Offset n = static_cast<Offset>(triangles.size() / 3), n_tasks = (n + kTask - 1) / kTask;
    std::vector<std::vector<std::uint32_t>> found(static_cast<std::size_t>(n_tasks));
    Sdc::ParallelFor(n_tasks, 1, [&](Offset begin, Offset end) {
        for (Offset task = begin; task < end; ++task) {
            std::vector<std::uint32_t>& its = found[static_cast<std::size_t>(task)];
            Descent descent(grid, tolerance, its);
            std::size_t many = kMany;
            for (Offset t = task * kTask; t < std::min((task + 1) * kTask, n); ++t) {
                std::array<GridPoint, 3> triangle;
                for (std::size_t k = 0; k < 3; ++k) {
                    triangle[k] = points[static_cast<std::size_t>(triangles[3 * static_cast<std::size_t>(t) + k])];
                }
                descent.Insert(triangle);
                if (its.size() < many) continue;  // large triangles over each other
                SortUnique(its);
                many = std::max(kMany, 2 * its.size());
            }
            SortUnique(its);
        }
    });
    for (const auto& its : found) {
        for (std::uint32_t place : its) cells.Insert(place);
    }
}

void InsertEnclosed(const Grid& grid, RankedBits& cells) {
    RankedBits closed = cells;  // with those that have been reached
    std::vector<std::uint32_t> layer, next;
    const auto reach = [&](std::uint32_t place) {
        if (closed.Has(place)) return;
        closed.Insert(place);
        next.push_back(place);
    };
    for (Index i = 0; i < grid.n(); ++i) {
        for (Index j = 0; j < grid.n(); ++j) {
            for (Index side : {0, grid.n() - 1}) {
                for (const GridPlace& cell : {GridPlace{side, i, j}, {i, side, j}, {i, j, side}}) {
                    reach(CurvePlace(cell));
                }
            }
        }
    }
    const std::uint32_t all = static_cast<std::uint32_t>(grid.n_cells() - 1);
    while (!next.empty()) {  // layers are surfaces: less waits than in a search that goes deep first
        layer.swap(next);
        next.clear();
        for (std::uint32_t place : layer) {
            for (std::uint32_t axis : {all & kXBits, all & kXBits << 1, all & kXBits << 2}) {
                const std::uint32_t at = place & axis, others = place & ~axis;
                // One step along the axis: carries and borrows run through the bits of the others.
                if (at != axis) reach(others | (((place | ~axis) + 1) & axis));
                if (at != 0) reach(others | ((at - 1) & axis));
            }
        }
    }
    for (std::uint64_t i = 0; i < grid.n_cells(); ++i) {
        if (!closed.Has(i)) cells.Insert(i);
    }
}

bool TriangleMeetsBox(const std::array<GridPoint, 3>& triangle, const GridPoint& centre, const GridPoint& half) {
    // As seen from the centre.
    const std::array<Vector3, 3> v{Minus(triangle[0], centre), Minus(triangle[1], centre), Minus(triangle[2], centre)};
    const auto parts = [&](const GridPoint& axis) {
        double least = 0, greatest = 0, reach = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double at = Dot(axis, v[i]);
            least = i == 0 ? at : std::min(least, at);
            greatest = i == 0 ? at : std::max(greatest, at);
            reach += half[i] * std::abs(axis[i]);
        }
        return least > reach || greatest < -reach;
    };
    for (std::size_t k = 0; k < 3; ++k) {
        GridPoint axis{};
        axis[k] = 1;
        if (parts(axis)) return false;
    }
    const std::array<Vector3, 3> edges{Minus(v[1], v[0]), Minus(v[2], v[1]), Minus(v[0], v[2])};
    if (parts(Cross(edges[0], edges[1]))) return false;
    for (const GridPoint& e : edges) {  // across an edge of each
        if (parts({0, -e[2], e[1]}) || parts({e[2], 0, -e[0]}) || parts({-e[1], e[0], 0})) return false;
    }
    return true;
}

}  // namespace SolidSubdiv::Deform::Internal

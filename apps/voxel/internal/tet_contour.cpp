// SPDX-License-Identifier: Apache-2.0
// Marching tetrahedra: one vertex an edge that is cut, one or two triangles a tetrahedron.
#include <solidsubdiv/apps/voxel/internal/tet_contour.h>

#include <algorithm>
#include <limits>
#include <utility>

#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Voxel::Internal {

namespace {

/// Corner `c` of a cube lies at its bits: x + 2 y + 4 z. An edge of the tetrahedra leads from a corner to one whose
/// bits hold its own: seven edges begin at each grid point.
std::array<Offset, 8> CornerSteps(const SignedGrid& grid) {
    std::array<Offset, 8> steps{};
    for (std::size_t c = 0; c < 8; ++c) {
        steps[c] = static_cast<Offset>(c & 1) +
                   grid.dims[0] * (static_cast<Offset>(c >> 1 & 1) + grid.dims[1] * static_cast<Offset>(c >> 2));
    }
    return steps;
}

/// The six tetrahedra around the diagonal from corner 0 to corner 7, all of positive volume.
constexpr std::array<std::array<std::size_t, 4>, 6> kTets = {
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

class Marching {
  public:
    explicit Marching(const SignedGrid& grid) : grid_(grid), steps_(CornerSteps(grid)) {}

    Contour Run() {
        MakeVertices();
        ForCubes([&](std::size_t at) {
            for (const auto& tet : kTets) AddTriangles(at, tet);
        });
        return std::move(made_);
    }

  private:
    template <class Visit>
    void ForCubes(Visit&& visit) const {
        for (Offset k = 0; k + 1 < grid_.dims[2]; ++k) {
            for (Offset j = 0; j + 1 < grid_.dims[1]; ++j) {
                for (Offset i = 0; i + 1 < grid_.dims[0]; ++i) visit(grid_.At(i, j, k));
            }
        }
    }

    std::size_t Corner(std::size_t at, std::size_t c) const { return at + static_cast<std::size_t>(steps_[c]); }
    bool IsCut(std::size_t at, std::size_t along) const {
        return grid_.IsInside(at) != grid_.IsInside(Corner(at, along));
    }

    /// One a cut edge, in the order of the points that edges begin at. Edges that begin at the last points of an axis
    /// leave the grid or run in its outermost layer, where nothing is cut.
    void MakeVertices() {
        first_.assign(grid_.values.size(), 0);
        for (Offset k = 0; k + 1 < grid_.dims[2]; ++k) {
            for (Offset j = 0; j + 1 < grid_.dims[1]; ++j) {
                for (Offset i = 0; i + 1 < grid_.dims[0]; ++i) {
                    const std::size_t at = grid_.At(i, j, k);
                    first_[at] = static_cast<Index>(made_.positions.size() / 3);
                    for (std::size_t along = 1; along < 8; ++along) {
                        if (!IsCut(at, along)) continue;
                        const double a = grid_.values[at], b = grid_.values[Corner(at, along)];
                        // Not at the ends: triangles keep an area where a value is 0.
                        const double t = std::clamp(a / (a - b), 0.001, 0.999);
                        made_.positions.push_back(static_cast<double>(i) + (along & 1 ? t : 0));
                        made_.positions.push_back(static_cast<double>(j) + (along & 2 ? t : 0));
                        made_.positions.push_back(static_cast<double>(k) + (along & 4 ? t : 0));
                    }
                    if (made_.positions.size() / 3 > std::numeric_limits<Index>::max() - 8) {
                        throw InvalidInput("the surface of the volume has more than 2^31 - 1 vertices");
                    }
                }
            }
        }
    }

    /// The vertex on the edge between two corners of a cube.
    Index VertexOn(std::size_t at, std::size_t a, std::size_t b) const {
        if (a > b) std::swap(a, b);  // the lower corner's bits are in the higher one's
        const std::size_t from = Corner(at, a);
        Index vertex = first_[from];
        for (std::size_t along = 1; along < (b ^ a); ++along) vertex += IsCut(from, along);
        return vertex;
    }

    void AddTriangles(std::size_t at, const std::array<std::size_t, 4>& tet) {
        // Corners inside come first; each exchange turns the tetrahedron inside out.
        std::array<std::size_t, 4> c = tet;
        std::size_t n = 0;
        bool is_turned = false;
        for (std::size_t i = 0; i < 4; ++i) {
            if (!grid_.IsInside(Corner(at, c[i]))) continue;
            if (i != n) std::swap(c[i], c[n]), is_turned = !is_turned;
            ++n;
        }
        const auto on = [&](std::size_t i, std::size_t j) { return VertexOn(at, c[i], c[j]); };
        const auto add = [&](Index p, Index q, Index r) {
            if (is_turned) std::swap(q, r);
            made_.triangles.insert(made_.triangles.end(), {p, q, r});
        };
        if (n == 1) add(on(0, 1), on(0, 2), on(0, 3));
        if (n == 3) add(on(0, 3), on(1, 3), on(2, 3));
        if (n == 2) {
            add(on(0, 2), on(0, 3), on(1, 3));
            add(on(0, 2), on(1, 3), on(1, 2));
        }
    }

    const SignedGrid& grid_;
    std::array<Offset, 8> steps_;
    std::vector<Index> first_;  ///< of each point: the vertex on the first edge cut that begins there
    Contour made_;
};

}  // namespace

Contour ContourOf(const SignedGrid& grid) { return Marching(grid).Run(); }

Pieces PiecesOf(const SignedGrid& grid) {
    Pieces pieces;
    pieces.of_point.assign(grid.values.size(), -1);
    std::vector<std::array<Offset, 3>> open;
    const auto visit = [&](Offset i, Offset j, Offset k, bool is_inside) {
        const std::size_t at = grid.At(i, j, k);
        if (pieces.of_point[at] >= 0 || grid.IsInside(at) != is_inside) return;
        pieces.of_point[at] = static_cast<std::int32_t>(pieces.sizes.size()) - 1;
        ++pieces.sizes.back();
        open.push_back({i, j, k});
    };
    for (std::size_t start = 0; start < grid.values.size(); ++start) {
        if (pieces.of_point[start] >= 0) continue;
        const auto at = static_cast<Offset>(start);
        const bool is_inside = grid.IsInside(start);
        pieces.sizes.push_back(0);
        pieces.is_inside.push_back(is_inside);
        visit(at % grid.dims[0], at / grid.dims[0] % grid.dims[1], at / grid.dims[0] / grid.dims[1], is_inside);
        while (!open.empty()) {
            const std::array<Offset, 3> p = open.back();
            open.pop_back();
            for (Offset c = 1; c < 8; ++c) {
                for (const Offset sign : {-1, 1}) {
                    const Offset i = p[0] + sign * (c & 1), j = p[1] + sign * (c >> 1 & 1), k = p[2] + sign * (c >> 2);
                    if (i < 0 || j < 0 || k < 0 || i >= grid.dims[0] || j >= grid.dims[1] || k >= grid.dims[2])
                        continue;
                    visit(i, j, k, is_inside);
                }
            }
        }
    }
    return pieces;
}

}  // namespace SolidSubdiv::Voxel::Internal

// SPDX-License-Identifier: Apache-2.0
// Cells and boundary are cut alike.
#include <solidsubdiv/apps/voxel/internal/voxel_solid.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <solidsubdiv/kit/geometry/face_cells.h>
#include <solidsubdiv/kit/geometry/tessellation_inside.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Voxel::Internal {

namespace {

/// Calls visit(vertices) for the boundary faces of a level that are faces of cells. Those in no cell (sheets) bound
/// nothing; level 0 tells which they are, and the children of its faces follow one another.
/// @param children_of how many children a boundary face of level 0 has
template <class Level, class ChildrenOf, class Visit>
void ForFacesOfCells(const Level& base, const Level& fine, ChildrenOf&& children_of, Visit&& visit) {
    Index next = 0;
    for (Index b = 0; b < base.n_boundary_faces; ++b) {
        const bool is_of_cell = Geometry::CellsOfFace(base, base.boundary_faces[b]) > 0;
        const Index end = next + children_of(b);
        for (; next < end; ++next) {
            if (is_of_cell) visit(fine.BoundaryVertices(next));
        }
    }
}

std::vector<Index> BoundaryTriangles(const Far::TopologyRefiner& refiner, int level) {
    std::vector<Index> triangles;
    const auto add = [&](std::span<const Index> face) {
        const std::size_t n = face.size();
        const auto low = static_cast<std::size_t>(std::min_element(face.begin(), face.end()) - face.begin());
        for (std::size_t k = 1; k + 1 < n; ++k) {
            triangles.insert(triangles.end(), {face[low], face[(low + k) % n], face[(low + k + 1) % n]});
        }
    };
    if (refiner.is_polyhedral()) {
        const Vtr::PolyhedralLevel& base = refiner.polyhedral_level(0);
        const auto children_of = [&](Index b) {
            return level == 0 ? 1 : base.boundary_rows.Count(b) << (2 * (level - 1));
        };
        ForFacesOfCells(base, refiner.polyhedral_level(level), children_of, add);
    } else {
        ForFacesOfCells(
            refiner.level(0), refiner.level(level), [&](Index) { return 1 << (2 * level); }, add);
    }
    return triangles;
}

using Vec = std::array<double, 3>;

Vec Minus(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double Det(const Vec& a, const Vec& b, const Vec& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// A hexahedron's weights at coordinates, in VTK's order.
std::array<double, 8> Trilinear(const Vec& at) {
    std::array<double, 8> weights;
    for (std::size_t i = 0; i < 8; ++i) {
        weights[i] = (i % 4 == 1 || i % 4 == 2 ? at[0] : 1 - at[0]) * (i % 4 >= 2 ? at[1] : 1 - at[1]) *
                     (i >= 4 ? at[2] : 1 - at[2]);
    }
    return weights;
}

/// Moves hex.at by one step of Newton's towards a point; how far. Sets the determinant there.
double StepTowards(const Vec& point, HexMap& hex, double& determinant) {
    const auto& [a, b, c, ab, ac, bc, abc] = hex.terms;
    const auto [u, v, w] = hex.at;
    Vec missing, du, dv, dw;
    for (std::size_t k = 0; k < 3; ++k) {
        du[k] = a[k] + v * ab[k] + w * (ac[k] + v * abc[k]);
        dv[k] = b[k] + u * ab[k] + w * (bc[k] + u * abc[k]);
        dw[k] = c[k] + u * ac[k] + v * (bc[k] + u * abc[k]);
        missing[k] = (point[k] - hex.origin[k]) - (u * (a[k] + v * ab[k]) + v * b[k] + w * dw[k]);
    }
    determinant = Det(du, dv, dw);
    if (determinant == 0) return 0;
    const Vec move{Det(missing, dv, dw) / determinant, Det(du, missing, dw) / determinant,
                   Det(du, dv, missing) / determinant};
    for (std::size_t k = 0; k < 3; ++k) hex.at[k] = std::clamp(hex.at[k] + move[k], -0.5, 1.5);
    return std::abs(move[0]) + std::abs(move[1]) + std::abs(move[2]);
}

/// Coordinates of the corners of a hexahedron.
constexpr std::array<std::array<double, 3>, 8> kHexCorners = {
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

}  // namespace

TetCells::TetCells(const Far::TopologyRefiner& refiner, int level, const VoxelSolid& solid)
    : refiner_(refiner), level_(level), solid_(solid) {
    if (!refiner.is_polyhedral()) {
        n_tets_ = refiner.level(level).n_tets;
        return;
    }
    const Vtr::PolyhedralLevel& l = refiner.polyhedral_level(level);
    n_hexes_ = l.n_hexes;
    // Tets of one polyhedron share their first vertex and are a face's corners less two: counted as they were cut.
    Index next = 6 * n_hexes_;
    for (Index p = 0; p < l.n_polyhedra(); ++p) {
        polyhedron_tets_.push_back(next);
        const Index apex = solid.tets[4 * static_cast<std::size_t>(next)];
        for (Offset f = l.polyhedra.offsets[p]; f < l.polyhedra.offsets[p + 1]; ++f) {
            const Offset begin = l.polyhedra.face_vertex_offsets[f], end = l.polyhedra.face_vertex_offsets[f + 1];
            const auto first = l.polyhedra.face_vertices.begin();
            if (std::find(first + begin, first + end, apex) == first + end) next += static_cast<Index>(end - begin) - 2;
        }
    }
    polyhedron_tets_.push_back(next);
}

Index TetCells::CellOf(Index tet) const {
    if (!refiner_.is_polyhedral()) return tet < n_tets_ ? tet : n_tets_ + (tet - n_tets_) / 4;
    if (tet < 6 * n_hexes_) return tet / 6;
    const auto after = std::upper_bound(polyhedron_tets_.begin(), polyhedron_tets_.end(), tet);
    return n_hexes_ + static_cast<Index>(after - polyhedron_tets_.begin()) - 1;
}

CellWeights TetCells::InTet(Index tet, const Vec& point) const {
    CellWeights result{.cell = CellOf(tet), .n = 4};
    std::array<Vec, 4> v;
    for (std::size_t k = 0; k < 4; ++k) {
        result.vertices[k] = solid_.tets[4 * static_cast<std::size_t>(tet) + k];
        const double* const p = &solid_.points[3 * static_cast<std::size_t>(result.vertices[k])];
        v[k] = {p[0] - point[0], p[1] - point[1], p[2] - point[2]};
    }
    const double det = Det(Minus(v[1], v[0]), Minus(v[2], v[0]), Minus(v[3], v[0]));
    result.weights[1] = Det(v[2], v[0], v[3]) / det;
    result.weights[2] = Det(v[1], v[3], v[0]) / det;
    result.weights[3] = Det(v[1], v[0], v[2]) / det;
    result.weights[0] = 1 - result.weights[1] - result.weights[2] - result.weights[3];
    result.jacobian = det;
    return result;
}

std::span<const Index, 8> TetCells::HexCorners(Index hex) const {
    const Array<Index>& vertices = refiner_.polyhedral_level(level_).hex_vertices;
    return std::span<const Index, 8>(&vertices[8 * static_cast<std::size_t>(hex)], 8);
}

/// The map of the cell, to begin at the tet's own coordinates, which are near.
void TetCells::Load(const CellWeights& in_tet, HexMap& hex) const {
    hex.cell = in_tet.cell;
    const auto corners = HexCorners(hex.cell);
    std::array<Vec, 8> x;
    hex.at = {};
    for (std::size_t i = 0; i < 8; ++i) {
        const double* const p = &solid_.points[3 * static_cast<std::size_t>(corners[i])];
        x[i] = {p[0], p[1], p[2]};
        for (std::size_t k = 0; k < 4; ++k) {
            if (in_tet.vertices[k] != corners[i]) continue;
            for (std::size_t c = 0; c < 3; ++c) hex.at[c] += in_tet.weights[k] * kHexCorners[i][c];
        }
    }
    hex.origin = x[0];
    for (std::size_t c = 0; c < 3; ++c) {
        auto& [a, b, w, ab, aw, bw, abw] = hex.terms;
        a[c] = x[1][c] - x[0][c];
        b[c] = x[3][c] - x[0][c];
        w[c] = x[4][c] - x[0][c];
        ab[c] = (x[2][c] - x[3][c]) - a[c];
        aw[c] = (x[5][c] - x[4][c]) - a[c];
        bw[c] = (x[7][c] - x[4][c]) - b[c];
        abw[c] = ((x[6][c] - x[7][c]) - (x[5][c] - x[4][c])) - ab[c];
    }
}

CellWeights TetCells::At(Index tet, const Vec& point, HexMap& hex) const {
    const Index cell = CellOf(tet);
    if (cell >= n_hexes_) return InTet(tet, point);
    if (hex.cell != cell) Load(InTet(tet, point), hex);
    CellWeights result{.cell = cell, .n = 8};
    for (int step = 0; step < 12; ++step) {
        // Steps square what is missing: after one this short only rounding is.
        if (StepTowards(point, hex, result.jacobian) < 1e-7) break;
    }
    const auto weights = Trilinear(hex.at);
    const auto corners = HexCorners(cell);
    for (std::size_t i = 0; i < 8; ++i) {
        result.vertices[i] = corners[i];
        result.weights[i] = weights[i];
    }
    return result;
}

VoxelSolid MakeVoxelSolid(const Far::TopologyRefiner& refiner, int level, std::span<const double> positions,
                          double voxel_size) {
    if (level < 0 || level > refiner.max_level()) {
        throw InvalidInput("there is no level " + std::to_string(level) + "; the last is " +
                           std::to_string(refiner.max_level()));
    }
    if (refiner.n_cells(level) == 0) throw InvalidInput("there are no cells to fill voxels with");
    if (positions.size() != 3 * static_cast<std::size_t>(refiner.n_vertices(level))) {
        throw InvalidInput(std::to_string(positions.size()) + " coordinates are given for the " +
                           std::to_string(refiner.n_vertices(level)) + " vertices of level " + std::to_string(level));
    }
    VoxelSolid solid;
    solid.points.reserve(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (!std::isfinite(positions[i])) {
            throw InvalidInput("vertex " + std::to_string(i / 3) + " has a coordinate that is not finite");
        }
        solid.points.push_back(positions[i] / voxel_size);
    }
    solid.tets = Geometry::CutIntoTets(refiner, level);
    solid.triangles = BoundaryTriangles(refiner, level);
    return solid;
}

}  // namespace SolidSubdiv::Voxel::Internal

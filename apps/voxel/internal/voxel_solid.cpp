// SPDX-License-Identifier: Apache-2.0
// Cells and boundary are cut alike.
#include <solidsubdiv/apps/voxel/internal/voxel_solid.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <solidsubdiv/kit/geometry/face_cells.h>
#include <solidsubdiv/kit/geometry/tessellation_inside.h>
#include <solidsubdiv/sdc/errors.h>
#include <solidsubdiv/sdc/parallel.h>

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

}  // namespace

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
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (!std::isfinite(positions[i])) {
            throw InvalidInput("vertex " + std::to_string(i / 3) + " has a coordinate that is not finite");
        }
    }
    solid.points.resize(positions.size());
    Sdc::ParallelFor(static_cast<Offset>(positions.size()), 4096, [&](Offset begin, Offset end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            solid.points[i] = positions[i] / voxel_size;
        }
    });
    solid.tets = Geometry::CutIntoTets(refiner, level);
    if (refiner.is_polyhedral()) solid.n_hexes = refiner.polyhedral_level(level).n_hexes;
    solid.triangles = BoundaryTriangles(refiner, level);
    return solid;
}

}  // namespace SolidSubdiv::Voxel::Internal

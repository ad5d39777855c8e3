// SPDX-License-Identifier: Apache-2.0
// Solids into grids of voxels: signed distances to the boundary, or how much of each voxel is filled.
//
//     const auto grids = Voxel::Voxelize(refiner, 3, positions, {.voxel_size = 0.01});
//     grids.Write("part.vdb");
//
// The sign comes from the cells themselves: a voxel is inside if a cell holds its centre. So cavities are empty, nested
// shells are right, and gaps thinner than a voxel keep their sign, where a surface alone leaves room for guesses.
// Cells are taken as they are cut into tets (Geometry::CutIntoTets): octahedra around their major diagonal, faces of
// more than three corners from their lowest vertex; the boundary is cut alike.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <solidsubdiv/apps/voxel/grids.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/sdc/progress.h>

namespace SolidSubdiv::Voxel {

enum class Kind {
    /// Grid "surface": distances to the boundary in units of the positions, negative inside; exact within half_width
    /// voxels of it, there they are active; +-half_width * voxel_size elsewhere.
    LevelSet,
    Fog,  ///< grid "density": the part of each voxel that cells fill, 0 to 1, by 64 samples at the boundary
    Both,
    None  ///< attributes alone
};

/// "level-set", "fog", "both" or "none". @throws InvalidInput
Kind KindOf(std::string_view name);

/// A material inside: a grid of this name with the values that cells give to the centres of voxels inside, interpolated
/// as their points are (trilinear in hexahedra, linear in the tets of others); active there, 0 outside.
struct Attribute {
    std::string name;
    int width = 1;                     ///< numbers a vertex: 1 (a grid of floats) or 3 (of vectors)
    std::span<const double> values{};  ///< (vertices of the level, width), row-major
};

struct VoxelizeOptions {
    double voxel_size = 0;  ///< > 0, in units of the positions
    Kind kind = Kind::LevelSet;
    double half_width = 3;  ///< [1, 100], voxels
    std::vector<Attribute> attributes{};
    /// Grid "jacobian", in cubed units: the determinant of a hexahedron's trilinear map (far/place.h), in other cells
    /// six times the volume of the tet; negative where inverted.
    bool jacobian = false;
    bool cell_id = false;   ///< grid "cell_id" of integers: the cell of the level; -1 outside
    bool level_id = false;  ///< grid "level" of integers: the level; -1 outside
    /// Refuse what would take more than so many bytes, as far as it can be told beforehand.
    Offset max_bytes = Offset{8} << 30;
    Progress progress{};

    /// @throws InvalidInput where a number is out of its range, two grids would have one name, or there would be none
    void Validate() const;
};

/// Cells of a level. Voxel (i, j, k) has its centre at voxel_size * (i, j, k).
/// Parallel; the same bits for any number of threads. Cost: the voxels near the boundary times the triangles near each.
/// @throws InvalidInput where there is no such level or no cell, a position is not finite, or there would be too many
/// voxels (says how many), Cancelled
Grids Voxelize(const Far::TopologyRefiner& refiner, int level, std::span<const double> positions,
               const VoxelizeOptions& options);

}  // namespace SolidSubdiv::Voxel

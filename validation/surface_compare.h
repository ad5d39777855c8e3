// SPDX-License-Identifier: Apache-2.0
// Holds a refiner and its tables to OpenSubdiv's Loop refinement of a surface of the mesh. Vertices are matched by the
// parent-child relations of both refiners, never by position.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/far/topology_refiner.h>

#include "findings.h"
#include "loop_oracle.h"

namespace SolidSubdiv::Validation {

/// A surface of a mesh with vertices of its own: those of the mesh that lie on it.
struct SurfaceOfMesh {
    ControlSurface surface;
    std::vector<Index> mesh_vertices;  ///< vertex of the mesh for each of the surface's
};

/// @param positions (n_vertices, 3)
SurfaceOfMesh TakeSurface(const std::vector<Triangle>& triangles, std::span<const double> positions,
                          const SurfaceTags& tags = {});

/// The mesh with creases and corners; it sees the tags, which must outlive it.
struct TaggedMesh {
    TaggedMesh(const Far::TopologyDescriptor& mesh, const SurfaceTags& tags);
    Far::TopologyDescriptor descriptor;
    std::vector<Index> crease_edges;
};

/// For each level, the refiner's vertex for each vertex of the oracle's: children of matching parents match.
using Match = std::vector<std::vector<Index>>;

/// Faults: an edge that the refiner does not have. The match ends at the level before.
Match FollowChildren(const Far::TopologyRefiner& refiner, const SurfaceOfMesh& start,
                     const std::vector<SurfaceLevel>& oracle, Findings& findings);

/// Whether the boundary of each level has just the oracle's triangles, with their orientation, under the match.
void CompareTriangles(const Far::TopologyRefiner& refiner, const std::vector<SurfaceLevel>& oracle, const Match& match,
                      Findings& findings);

/// Positions that a cascaded table gives at levels 1 and up, over the size of the shape.
/// @param positions (n_control_vertices, 3): control vertices
void ComparePositions(const Far::StencilTable& cascaded, std::span<const double> positions,
                      const std::vector<SurfaceLevel>& oracle, const Match& match, Findings& findings);

/// Composite rows of one level, row i that of the oracle's vertex i, weight by weight.
void CompareRows(const Far::StencilRows<double>& rows, int level, const SurfaceOfMesh& start,
                 const std::vector<SurfaceLevel>& oracle, Findings& findings);

struct ComparedLevels {
    int positions = 5;
    int rows = 3;

    /// In the second level rules meet what rules have made; later ones are more of the same.
    ComparedLevels AtMostTwoIf(bool is_quick) const {
        return is_quick ? ComparedLevels{std::min(positions, 2), std::min(rows, 2)} : *this;
    }
};

/// Follows, and compares triangles, positions at all the oracle's levels and composite rows up to max_row_level.
Findings CompareWithLevels(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                           std::span<const double> positions, const SurfaceOfMesh& start,
                           const std::vector<SurfaceLevel>& oracle, int max_row_level);

/// All of it for one mesh, under one scheme: refines, makes the tables, compares. The mesh gets the tags as creases and
/// corners.
/// @param tags of vertices of the mesh; creases that are edges of the triangles
/// @param oracle_tags what the scheme makes of the mesh and the tags; otherwise the tags
Findings CompareWithLoop(const Far::TopologyDescriptor& mesh, const Sdc::Scheme& scheme,
                         const std::vector<Triangle>& triangles, std::span<const double> positions,
                         const SurfaceTags& tags = {}, const ComparedLevels& levels = ComparedLevels(),
                         const std::optional<SurfaceTags>& oracle_tags = {});

}  // namespace SolidSubdiv::Validation

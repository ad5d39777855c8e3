// SPDX-License-Identifier: Apache-2.0
// The small mesh around one place, whose middle is vertex 0: all that decides how a scheme behaves there.
//
//     auto star = Analysis::StarOf(refiner, 0, vertex);           // the cells, or faces, at a vertex
//     auto report = Analysis::AnalyzeStar(star, Sdc::BoxSpline{});    // kit/analysis/place_report.h
//
// Edges and faces have points of their own one or two splits on: PointOnEdge and PointInFace make stars of those.
#pragma once

#include <vector>

#include <solidsubdiv/far/topology_refiner.h>

namespace SolidSubdiv::Analysis {

struct Star {
    Sdc::Split split = Sdc::Split::TetOct;
    int dimension = 3;  ///< 3: cells; 2: faces of a surface
    bool is_on_edge =
        false;  ///< its middle lies on an edge along which nothing changes; vertices 1 and 2 are next on it
    Index n_vertices = 0;
    std::vector<Index> tets{}, octs{}, hexes{};
    std::vector<Offset> polyhedron_offsets{0}, polyhedron_face_offsets{0};
    std::vector<Index> polyhedron_vertices{};
    std::vector<Index> triangles{}, quads{};
    std::vector<Offset> polygon_offsets{0};
    std::vector<Index> polygon_vertices{};

    Far::TopologyDescriptor View() const;
};

/// The cells at a vertex inside a solid, or, if is_on_surface, the faces of the surface at it (the boundary's where
/// there are cells). A surface of a solid follows its own rules, so its star needs no cells.
/// @pre the level is full
Star StarOf(const Far::TopologyRefiner& refiner, int level, Index vertex, bool is_on_surface);

/// The star of the point that the first split puts on an edge inside a solid.
Star PointOnEdge(const Far::TopologyRefiner& refiner, int level, Index edge);

/// Of a point inside a face: among polyhedra the one that the first split puts there; among tets and octahedra, where
/// that comes with the second, any.
Star PointInFace(const Far::TopologyRefiner& refiner, int level, Index face);

/// Of the point that the first split puts into a cell. @pre refiner.is_polyhedral()
Star PointInCell(const Far::TopologyRefiner& refiner, int level, Index cell);

/// A star among polyhedra becomes that of the next level, whose faces at the middle are quadrilaterals; others stay.
Star SplitOnce(const Star& star);

}  // namespace SolidSubdiv::Analysis

// SPDX-License-Identifier: Apache-2.0
// The places of a mesh, sorted into kinds that have the same subdivision matrix up to numbering.
//
//     const auto places = Analysis::PlacesOf(refiner, scheme);
//     for (const auto& kind : places.kinds) Analysis::AnalyzeStar(StarOf(refiner, kind), scheme);
//
// What decides is local and cheap to read off: the link of a vertex with its major diagonals, the ring of cells around
// an edge, whether the tets at a face match, the number of faces at a vertex of a surface. Places inside cells and
// inside boundary faces of three or four sides are regular and not listed.
#pragma once

#include <string>
#include <vector>

#include <solidsubdiv/kit/analysis/star.h>
#include <solidsubdiv/sdc/progress.h>
#include <solidsubdiv/sdc/schemes.h>

namespace SolidSubdiv::Analysis {

enum class PlaceType {
    InnerVertex,
    InnerEdge,    ///< a point on it, away from its ends
    InnerFace,    ///< a point in it, away from its edges
    InnerCell,    ///< among polyhedra: the point in it
    Surface,      ///< a vertex inside a surface, or on the boundary of a solid
    Border,       ///< a vertex on the border of a surface
    SurfaceFace,  ///< among polygons: the point in one that is no quadrilateral
};

struct PlaceKind {
    PlaceType type = PlaceType::InnerVertex;
    std::string what;          ///< "8 tets, 10 neighbors"
    Index count = 0;           ///< how many there are
    Index example = kNoIndex;  ///< the first: a vertex, edge, face or cell of level 0
};

struct MeshPlaces {
    std::vector<PlaceKind> kinds;  ///< by type, the most frequent first
    Index n_creased = 0;           ///< vertices with creases or sharp corners for ever, which follow curves or stay
    Index n_others = 0;  ///< vertices where parts of several dimensions meet, on curves, pinched or in nothing
};

/// Of level 0. Semi-sharp creases are gone after some levels and count as smooth. Cost: a pass over the mesh, with the
/// square of the size of each vertex's link; parallel, the same bits for any number of threads.
MeshPlaces PlacesOf(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme, const Progress& progress = {});

/// Of the example. Cost: a pass over the mesh's cells.
Star StarOf(const Far::TopologyRefiner& refiner, const PlaceKind& kind);

}  // namespace SolidSubdiv::Analysis

// SPDX-License-Identifier: Apache-2.0
// The kinds of elements in a mesh, their names and counts.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Cli {

struct KindCount {
    std::string_view plural;  ///< as in texts and in JSON
    Offset count;
};

/// Every kind, in the order of a mesh's cell data.
inline std::array<KindCount, 11> KindCounts(const Io::Topology& t) {
    return {{{"tetrahedra", t.n_tets()},
             {"octahedra", t.n_octs()},
             {"hexahedra", t.n_hexes()},
             {"wedges", t.n_wedges()},
             {"pyramids", t.n_pyramids()},
             {"polyhedra", t.n_polyhedra()},
             {"triangles", t.n_triangles()},
             {"quadrilaterals", t.n_quads()},
             {"polygons", t.n_polygons()},
             {"edges", t.n_edges()},
             {"single_vertices", t.n_point_elements()}}};
}

/// Whether all elements are of the kinds that the tet/oct split takes (single vertices are tags and do not count).
inline bool IsTetOct(const Io::Topology& t) {
    return t.n_hexes() + t.n_wedges() + t.n_pyramids() + t.n_polyhedra() + t.n_quads() + t.n_polygons() == 0;
}

}  // namespace SolidSubdiv::Cli

// SPDX-License-Identifier: Apache-2.0
// The kinds of elements in a mesh, their names and counts.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Cli {

struct KindCount {
    std::string_view singular, plural;  ///< the plural as in texts and in JSON
    int dimension;
    bool is_tet_oct;  ///< the tet/oct split takes it (single vertices are tags that every split takes)
    Offset count;
};

/// Every kind, in the order of a mesh's cell data.
inline std::array<KindCount, 11> KindCounts(const Io::Topology& t) {
    return {{{"tetrahedron", "tetrahedra", 3, true, t.n_tets()},
             {"octahedron", "octahedra", 3, true, t.n_octs()},
             {"hexahedron", "hexahedra", 3, false, t.n_hexes()},
             {"wedge", "wedges", 3, false, t.n_wedges()},
             {"pyramid", "pyramids", 3, false, t.n_pyramids()},
             {"polyhedron", "polyhedra", 3, false, t.n_polyhedra()},
             {"triangle", "triangles", 2, true, t.n_triangles()},
             {"quadrilateral", "quadrilaterals", 2, false, t.n_quads()},
             {"polygon", "polygons", 2, false, t.n_polygons()},
             {"edge", "edges", 1, true, t.n_edges()},
             {"single_vertex", "single_vertices", 0, true, t.n_point_elements()}}};
}

/// Whether the tet/oct split takes all elements.
inline bool IsTetOct(const Io::Topology& t) {
    for (const KindCount& kind : KindCounts(t)) {
        if (kind.count > 0 && !kind.is_tet_oct) return false;
    }
    return true;
}

}  // namespace SolidSubdiv::Cli

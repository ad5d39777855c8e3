// SPDX-License-Identifier: Apache-2.0
// Holes gathered from a mesh's cell data.
#include <solidsubdiv/kit/io/holes.h>

#include <string>

#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Io {

const Attribute* FindHoles(const Mesh& mesh) {
    const Attribute* const hole = mesh.FindCellData(std::string(kHole));
    return hole && hole->width == 1 ? hole : nullptr;
}

std::vector<Offset> HolesOf(const Mesh& mesh) {
    std::vector<Offset> rows;
    const Attribute* const hole = mesh.FindCellData(std::string(kHole));
    if (!hole) return rows;
    const Topology& t = mesh.topology;
    if (hole->width != 1 || static_cast<Offset>(hole->values.size()) != t.n_elements()) {
        throw InvalidInput("cell data 'hole' has " + std::to_string(hole->values.size()) + " numbers, in rows of " +
                           std::to_string(hole->width) + "; it needs one number for each of " +
                           std::to_string(t.n_elements()) + " elements");
    }
    const Offset end = t.n_cells() + t.n_triangles() + t.n_quads() + t.n_polygons();
    for (Offset row = t.n_cells(); row < end; ++row) {
        if (hole->values[static_cast<std::size_t>(row)] != 0) rows.push_back(row);
    }
    return rows;
}

}  // namespace SolidSubdiv::Io

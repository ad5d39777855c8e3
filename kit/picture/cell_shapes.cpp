// SPDX-License-Identifier: Apache-2.0
// The table of cells; see internal/cell_shapes.h.
#include <solidsubdiv/kit/picture/internal/cell_shapes.h>
#include <solidsubdiv/sdc/cells.h>
#include <solidsubdiv/sdc/errors.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace SolidSubdiv::Picture::Internal {
namespace {

template <class Cell>
CellShape FromReferenceCell(CellKind kind) {
    CellShape shape{kind, Cell::kVertices, {}};
    for (const auto& f : Cell::faces) shape.faces.push_back({f[0], f[1], f[2], -1});
    return shape;
}

}  // namespace

const std::array<CellShape, 5>& CellShapes() {
    static const std::array<CellShape, 5> shapes{
        FromReferenceCell<Sdc::Tet>(CellKind::Tet), FromReferenceCell<Sdc::Oct>(CellKind::Oct),
        CellShape{
            CellKind::Hex, 8, {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}},
        CellShape{CellKind::Wedge, 6, {{0, 1, 2, -1}, {3, 5, 4, -1}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}}},
        CellShape{CellKind::Pyramid, 5, {{0, 3, 2, 1}, {0, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {3, 0, 4, -1}}}};
    return shapes;
}

std::span<const Index> CellsOf(const Io::Topology& topology, CellKind kind) {
    switch (kind) {
        case CellKind::Tet:
            return topology.tets;
        case CellKind::Oct:
            return topology.octs;
        case CellKind::Hex:
            return topology.hexes;
        case CellKind::Wedge:
            return topology.wedges;
        case CellKind::Pyramid:
            return topology.pyramids;
    }
    return {};
}

void RefusePolyhedra(const Io::Topology& topology) {
    if (topology.n_polyhedra() > 0) {
        throw InvalidInput("picture: the mesh has " + std::to_string(topology.n_polyhedra()) +
                           " general polyhedra; only tets, octs, hexes, wedges and pyramids can be shown");
    }
}

void CheckPlane(const Plane& plane) {
    const double length = std::hypot(plane.normal[0], plane.normal[1], plane.normal[2]);
    if (!(length > 0 && std::isfinite(length))) {
        throw InvalidInput("picture: a cut plane's normal must be finite and not zero");
    }
}

std::vector<Index> UniqueEdges(std::vector<std::array<Index, 2>> edges) {
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<Index> flat;
    flat.reserve(2 * edges.size());
    for (const auto& e : edges) flat.insert(flat.end(), e.begin(), e.end());
    return flat;
}

}  // namespace SolidSubdiv::Picture::Internal

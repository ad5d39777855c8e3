// SPDX-License-Identifier: Apache-2.0
// Small complexes of polyhedra for tests, with positions.
#pragma once

#include <array>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <solidsubdiv/sdc/cells.h>
#include <solidsubdiv/vtr/polyhedral_base.h>

#include "test_shapes.h"

namespace SolidSubdiv::TestShapes {

/// A complex of polyhedra that owns its arrays.
struct PolyhedralShape {
    Index n_vertices = 0;
    std::vector<Index> hexes;
    std::vector<Offset> cell_offsets{0}, face_offsets{0};
    std::vector<Index> face_vertices;
    std::vector<Offset> polygon_offsets{0};
    std::vector<Index> polygon_vertices;
    std::vector<Index> edges;
    std::vector<double> positions;

    Vtr::PolyhedralElements Elements() const {
        return {n_vertices, hexes, cell_offsets, face_offsets, face_vertices, polygon_offsets, polygon_vertices, edges};
    }
    Index AddVertex(double x, double y, double z) {
        positions.insert(positions.end(), {x, y, z});
        return n_vertices++;
    }
    /// A cell by its faces, places in `vertices`, counterclockwise from outside.
    template <class Faces>
    void AddCell(const Faces& faces, std::span<const Index> vertices) {
        for (const auto& face : faces) {
            for (auto k : face) {
                if (k != Sdc::kNoLocal) face_vertices.push_back(vertices[k]);
            }
            face_offsets.push_back(static_cast<Offset>(face_vertices.size()));
        }
        cell_offsets.push_back(static_cast<Offset>(face_offsets.size()) - 1);
    }
    void AddPolygon(std::initializer_list<Index> vertices) {
        polygon_vertices.insert(polygon_vertices.end(), vertices);
        polygon_offsets.push_back(static_cast<Offset>(polygon_vertices.size()));
    }
};

/// nx * ny * nz unit cubes of which keep(x, y, z) says which are there.
template <class Keep>
PolyhedralShape HexBlock(int nx, int ny, int nz, Keep&& keep) {
    PolyhedralShape s;
    for (int z = 0; z <= nz; ++z) {
        for (int y = 0; y <= ny; ++y) {
            for (int x = 0; x <= nx; ++x) s.AddVertex(x, y, z);
        }
    }
    const auto id = [&](int x, int y, int z) { return x + (nx + 1) * (y + (ny + 1) * z); };
    for (int z = 0; z < nz; ++z) {
        for (int y = 0; y < ny; ++y) {
            for (int x = 0; x < nx; ++x) {
                if (!keep(x, y, z)) continue;
                s.hexes.insert(s.hexes.end(),
                               {id(x, y, z), id(x + 1, y, z), id(x + 1, y + 1, z), id(x, y + 1, z), id(x, y, z + 1),
                                id(x + 1, y, z + 1), id(x + 1, y + 1, z + 1), id(x, y + 1, z + 1)});
            }
        }
    }
    return s;
}
inline PolyhedralShape HexBlock(int n) {
    return HexBlock(n, n, n, [](int, int, int) { return true; });
}

/// A cube with a pyramid on top, a wedge beside it, a tet on the wedge and an octahedron on the pyramid.
inline PolyhedralShape MixedCells() {
    PolyhedralShape s = HexBlock(1);
    const Index apex = s.AddVertex(0.5, 0.5, 2);
    s.AddCell(Sdc::Pyramid::faces, std::array<Index, 5>{4, 5, 7, 6, apex});  // HexBlock's own order, not VTK's
    const Index low = s.AddVertex(2, 0, 0.5), high = s.AddVertex(2, 1, 0.5);
    s.AddCell(Sdc::Wedge::faces, std::array<Index, 6>{1, low, 5, 3, high, 7});
    const Index tip = s.AddVertex(1.6, -1, 0.6);
    s.AddCell(Sdc::Tet::faces, std::array<Index, 4>{1, low, 5, tip});
    const Index a = s.AddVertex(0.5, -1.5, 1.7), b = s.AddVertex(1.2, -0.7, 2.5), c = s.AddVertex(-0.2, -0.7, 2.5);
    // The face 4 5 apex of the pyramid is a face of the octahedron: opposite pairs (4, b), (5, c), (apex, a).
    s.AddCell(Sdc::Oct::faces, std::array<Index, 6>{4, b, 5, c, apex, a});
    return s;
}

/// A block with a hole through it, a cube that touches it in an edge, one that touches it in a vertex.
inline PolyhedralShape TouchingCubes() {
    return HexBlock(5, 5, 4, [](int x, int y, int z) {
        if (x < 3 && y < 3 && z < 2) return x != 1 || y != 1;
        return (x == 3 && y == 3 && z == 1) || (x == 4 && y == 4 && z == 2);
    });
}

/// A cube with sails on an edge, a roof of polygons, a rod and a loose polyline.
inline PolyhedralShape CubeWithSheets() {
    PolyhedralShape s = HexBlock(2);
    const Index far_low = s.AddVertex(-1, -1, 0), far_high = s.AddVertex(-1, -1, 1);
    s.AddPolygon({0, far_low, far_high, 9});
    const Index p = s.AddVertex(5, 0, 0), q = s.AddVertex(6, 0, 0.5), r = s.AddVertex(6.5, 1, 0),
                t = s.AddVertex(5.5, 2, 1), u = s.AddVertex(4.5, 1, 0);
    s.AddPolygon({p, q, r, t, u});
    const Index w = s.AddVertex(5.5, -1, 0);
    s.AddPolygon({q, p, w});
    const Index rod = s.AddVertex(3, 3, 3), end = s.AddVertex(4, 3, 3);
    s.edges = {26, rod, rod, end};
    return s;
}

/// One for every feature.
inline std::vector<std::pair<std::string, PolyhedralShape>> PolyhedralShapes() {
    return {
        {"block", HexBlock(3)}, {"mixed", MixedCells()}, {"touching", TouchingCubes()}, {"sheets", CubeWithSheets()}};
}

}  // namespace SolidSubdiv::TestShapes

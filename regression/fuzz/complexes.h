// SPDX-License-Identifier: Apache-2.0
// Complexes read from bytes: indices in and out of range, elements that touch in every way.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include <solidsubdiv/far/topology_descriptor.h>

#include "bytes.h"

namespace SolidSubdiv::Fuzz {

/// Tets, octahedra, triangles and edges as bytes name them, with creases and corners.
struct TetOctComplex {
    std::vector<Index> tets, octs, triangles, edges, creases, corners;
    std::vector<float> crease_sharpness, corner_sharpness;
    Index n_vertices;

    TetOctComplex(Bytes& bytes, Index its_n_vertices) : n_vertices(its_n_vertices) {
        struct Kind {
            std::vector<Index>* vertices;
            int arity;
        };
        const Kind kinds[] = {{&tets, 4}, {&octs, 6}, {&triangles, 3}, {&edges, 2}};
        while (!bytes.empty() && tets.size() + octs.size() + triangles.size() + edges.size() < 400) {
            const auto add_vertex = [&](std::vector<Index>& vertices) {
                vertices.push_back(bytes.NextVertex(n_vertices));
            };
            const int what = bytes.Next();
            if (what >= 248) {
                add_vertex(corners);
                corner_sharpness.push_back(bytes.NextSharpness());
            } else if (what >= 240) {
                add_vertex(creases);
                add_vertex(creases);
                crease_sharpness.push_back(bytes.NextSharpness());
            } else {
                for (int k = 0; k < kinds[what % 4].arity; ++k) add_vertex(*kinds[what % 4].vertices);
            }
        }
    }
    Far::TopologyDescriptor Descriptor() const {
        return {.n_vertices = n_vertices,
                .tets = tets,
                .octs = octs,
                .triangles = triangles,
                .edges = edges,
                .crease_edges = creases,
                .crease_sharpness = crease_sharpness,
                .corner_vertices = corners,
                .corner_sharpness = corner_sharpness};
    }
    bool HasSemiSharp() const {
        return std::any_of(crease_sharpness.begin(), crease_sharpness.end(), [](float s) { return s > 0 && s < 10; });
    }
};

/// Elements as bytes name them: of a kind with as many vertices as it has, polyhedra and polygons with their sizes.
struct PolyhedralComplex {
    std::vector<Index> tets, octs, hexes, wedges, pyramids, triangles, quads, edges, polyhedron_vertices,
        polygon_vertices, creases, corners;
    std::vector<Offset> polyhedron_offsets{0}, face_offsets{0}, polygon_offsets{0};
    std::vector<float> crease_sharpness, corner_sharpness;
    Index n_vertices;

    PolyhedralComplex(Bytes& bytes, Index its_n_vertices) : n_vertices(its_n_vertices) {
        struct Kind {
            std::vector<Index>* vertices;
            int arity;
        };
        const std::array<Kind, 8> kinds{{{&hexes, 8},
                                         {&wedges, 6},
                                         {&pyramids, 5},
                                         {&tets, 4},
                                         {&octs, 6},
                                         {&quads, 4},
                                         {&triangles, 3},
                                         {&edges, 2}}};
        const auto add = [&](std::vector<Index>& vertices, int n) {
            for (int k = 0; k < n; ++k) vertices.push_back(bytes.NextVertex(n_vertices));
        };
        for (int n = 0; n < 60 && !bytes.empty(); ++n) {
            const int what = bytes.Next();
            if (what >= 248) {
                add(corners, 1);
                corner_sharpness.push_back(bytes.NextSharpness());
            } else if (what >= 240) {
                add(creases, 2);
                crease_sharpness.push_back(bytes.NextSharpness());
            } else if (what >= 224) {
                add(polygon_vertices, bytes.Next() % 8);
                polygon_offsets.push_back(static_cast<Offset>(polygon_vertices.size()));
            } else if (what >= 200) {
                for (int faces = bytes.Next() % 9; faces > 0; --faces) {
                    add(polyhedron_vertices, bytes.Next() % 7);
                    face_offsets.push_back(static_cast<Offset>(polyhedron_vertices.size()));
                }
                polyhedron_offsets.push_back(static_cast<Offset>(face_offsets.size()) - 1);
            } else {
                const Kind& kind = kinds[static_cast<std::size_t>(what) % kinds.size()];
                add(*kind.vertices, kind.arity);
            }
        }
    }
    Far::TopologyDescriptor Descriptor() const {
        Far::TopologyDescriptor d{.n_vertices = n_vertices};
        d.tets = tets, d.octs = octs, d.hexes = hexes, d.wedges = wedges, d.pyramids = pyramids;
        d.polyhedron_offsets = polyhedron_offsets, d.polyhedron_face_offsets = face_offsets;
        d.polyhedron_vertices = polyhedron_vertices;
        d.triangles = triangles, d.quads = quads, d.edges = edges;
        d.polygon_offsets = polygon_offsets, d.polygon_vertices = polygon_vertices;
        d.crease_edges = creases, d.crease_sharpness = crease_sharpness;
        d.corner_vertices = corners, d.corner_sharpness = corner_sharpness;
        return d;
    }
};

}  // namespace SolidSubdiv::Fuzz

// SPDX-License-Identifier: Apache-2.0
// Fuzzes the polyhedral split with complexes read from bytes: cells and faces of every kind that touch in every way.
//
// A complex is refused with InvalidInput, or refines, cell by cell consistent, with rows that sum to one under every
// scheme that takes its kind.
#include <algorithm>
#include <array>
#include <vector>

#include <solidsubdiv/far/creases.h>
#include <solidsubdiv/far/limit_stencil_table.h>
#include <solidsubdiv/far/stencil_table.h>

#include "bytes.h"

using namespace SolidSubdiv;
using Fuzz::Require;

namespace {

/// Both sides of every face know each other, and every cell has its faces.
void CheckLevel(const Vtr::PolyhedralLevel& level) {
    for (Index c = 0; c < level.n_cells(); ++c) {
        for (Index f : level.CellFaces(c)) Require(level.FaceCells(f)[0] == c || level.FaceCells(f)[1] == c);
        for (Index v : level.CellVertices(c)) Require(v >= 0 && v < level.n_vertices);
    }
    for (Index f = 0; f < level.n_faces; ++f) {
        const auto vertices = level.FaceVertices(f);
        const auto edges = level.FaceEdges(f);
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            const Index next = vertices[k + 1 < vertices.size() ? k + 1 : 0];
            Require(level.OtherEnd(edges[k], vertices[k]) == next);
        }
        for (Index c : level.FaceCells(f)) {
            if (c == kNoIndex) continue;
            const auto faces = level.CellFaces(c);
            Require(std::find(faces.begin(), faces.end(), f) != faces.end());
        }
    }
}

/// Elements as bytes name them: of a kind with as many vertices as it has, polyhedra and polygons with their sizes.
struct Elements {
    std::vector<Index> tets, octs, hexes, wedges, pyramids, triangles, quads, edges, polyhedron_vertices,
        polygon_vertices, creases, corners;
    std::vector<Offset> polyhedron_offsets{0}, face_offsets{0}, polygon_offsets{0};
    std::vector<float> crease_sharpness, corner_sharpness;

    Elements(Fuzz::Bytes& bytes, Index n_vertices) {
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
    Far::TopologyDescriptor Descriptor(Index n_vertices) const {
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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Fuzz::Bytes bytes(data, size);
    const Index n_vertices = bytes.Next() % 28;
    const int levels = 1 + bytes.Next() % 2;
    const Elements elements(bytes, n_vertices);
    const Far::TopologyDescriptor descriptor = elements.Descriptor(n_vertices);
    // Meshes of tets, octs, triangles and edges alone are validated by the other split's rules.
    const bool is_mixed = !elements.hexes.empty() || !elements.quads.empty() || elements.polygon_offsets.size() > 1;
    const auto defects = Far::Validate(descriptor);
    const bool is_usable = defects.empty() || !defects.front().IsFatal();
    try {
        auto refiner = Far::TopologyRefiner::Create(descriptor, Sdc::Split::Polyhedral);
        Require(!is_mixed || is_usable);
        CheckLevel(refiner.polyhedral_level(0));
        refiner.RefineUniform({.max_level = levels, .full_topology_in_last_level = true});
        for (int l = 1; l <= levels; ++l) CheckLevel(refiner.polyhedral_level(l));
        Require(CountsOf(refiner.polyhedral_level(levels)) == refiner.PolyhedralCountsAt(levels));
        const bool has_cells = refiner.n_cells(0) > 0;
        Sdc::ForEachScheme([&](auto scheme) {
            if (!Sdc::Takes(scheme, Sdc::Split::Polyhedral) || (has_cells && !scheme.kSolids)) return;
            Fuzz::CheckTable(Far::StencilTable::Create(refiner, scheme));
            Far::CreasesAt(refiner, scheme, levels);
            Fuzz::CheckRows(Far::LimitStencilTable::Create(refiner, scheme, {.level = 0}).rows(), true);
        });
        const Sdc::CatmullClarkSolid chaikin{.features = Sdc::Features::Smooth,
                                             .creasing = Sdc::CreasingMethod::Chaikin};
        Fuzz::CheckTable(Far::StencilTable::CreateComposite(refiner, chaikin, {{.level = levels}}));
    } catch (const InvalidInput&) {
        Require(!is_mixed || !is_usable);
    }
    return 0;
}

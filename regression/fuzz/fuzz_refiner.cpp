// SPDX-License-Identifier: Apache-2.0
// Fuzzes the refiner with complexes read from bytes: indices in and out of range, cells that touch in every way.
//
// A complex is refused with InvalidInput, or refines with rows that sum to one under every scheme that takes its
// creases.
#include <algorithm>
#include <vector>

#include <solidsubdiv/far/choose_diagonals.h>
#include <solidsubdiv/far/creases.h>
#include <solidsubdiv/far/limit_stencil_table.h>
#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/far/stencil_table.h>

#include "bytes.h"

using namespace SolidSubdiv;

using Fuzz::CheckTable;
using Fuzz::Require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Fuzz::Bytes bytes(data, size);
    const Index n_vertices = bytes.Next() % 24;
    const int levels = bytes.Next() % 3;
    std::vector<Index> tets, octs, triangles, edges, creases, corners;
    std::vector<float> crease_sharpness, corner_sharpness;
    struct Kind {
        std::vector<Index>* vertices;
        int arity;
    };
    const Kind kinds[] = {{&tets, 4}, {&octs, 6}, {&triangles, 3}, {&edges, 2}};
    while (!bytes.empty() && tets.size() + octs.size() + triangles.size() + edges.size() < 400) {
        const auto add_vertex = [&](std::vector<Index>& vertices) { vertices.push_back(bytes.NextVertex(n_vertices)); };
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
    const Far::TopologyDescriptor descriptor{.n_vertices = n_vertices,
                                             .tets = tets,
                                             .octs = octs,
                                             .triangles = triangles,
                                             .edges = edges,
                                             .crease_edges = creases,
                                             .crease_sharpness = crease_sharpness,
                                             .corner_vertices = corners,
                                             .corner_sharpness = corner_sharpness};
    const auto is_semi_sharp = [](float s) { return s > 0 && s < 10; };
    const bool has_semi_sharp = std::any_of(crease_sharpness.begin(), crease_sharpness.end(), is_semi_sharp);

    const auto defects = Far::Validate(descriptor);
    const bool usable = defects.empty() || !defects.front().IsFatal();
    try {
        const auto choice = Far::ChooseDiagonals(descriptor, Far::DiagonalPolicy::Matched);
        Require(usable && choice.tets.size() == tets.size() && choice.octs.size() == octs.size());
        auto refiner = Far::TopologyRefiner::Create(descriptor, Sdc::Split::TetOct);
        refiner.RefineUniform({.max_level = levels, .full_topology_in_last_level = true});
        Sdc::ForEachScheme([&](auto scheme) {
            if (!Sdc::Takes(scheme, Sdc::Split::TetOct)) return;
            if (!scheme.kSolids && refiner.level(0).n_cells() > 0) return;
            try {
                CheckTable(Far::StencilTable::Create(refiner, scheme));
                CheckTable(Far::StencilTable::CreateComposite(refiner, scheme, {{.level = levels}}));
                Fuzz::CheckRows(Far::LimitStencilTable::Create(refiner, scheme).rows(), true);
                Far::CreasesAt(refiner, scheme, levels);
            } catch (const InvalidInput&) {
                Require(has_semi_sharp);
            }
        });
        if (refiner.level(0).n_cells() == 0) {
            const Sdc::Loop chaikin{.features = Sdc::Features::Sharp, .creasing = Sdc::CreasingMethod::Chaikin};
            CheckTable(Far::StencilTable::Create(refiner, chaikin));
        }
        Sdc::BoxSpline averaged;
        averaged.diagonals = Sdc::Diagonals::Averaged;
        CheckTable(Far::StencilTable::Create(refiner, averaged));
    } catch (const InvalidInput&) {
        Require(!usable);
    }
    return 0;
}

// SPDX-License-Identifier: Apache-2.0
// Fuzzes the polyhedral split with complexes read from bytes: cells and faces of every kind that touch in every way.
//
// A complex is refused with InvalidInput, or refines, cell by cell consistent, with rows that sum to one under every
// scheme that takes its kind.
#include <algorithm>

#include <solidsubdiv/far/creases.h>
#include <solidsubdiv/far/limit_stencil_table.h>
#include <solidsubdiv/far/stencil_table.h>

#include "complexes.h"

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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Fuzz::Bytes bytes(data, size);
    const Index n_vertices = bytes.Next() % 28;
    const int levels = 1 + bytes.Next() % 2;
    const Fuzz::PolyhedralComplex elements(bytes, n_vertices);
    const Far::TopologyDescriptor descriptor = elements.Descriptor();
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

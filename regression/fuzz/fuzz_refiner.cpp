// SPDX-License-Identifier: Apache-2.0
// Fuzzes the refiner with complexes read from bytes: indices in and out of range, cells that touch in every way.
//
// A complex is refused with InvalidInput, or refines with rows that sum to one under every scheme that takes its
// creases.
#include <solidsubdiv/far/choose_diagonals.h>
#include <solidsubdiv/far/creases.h>
#include <solidsubdiv/far/limit_stencil_table.h>
#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/far/stencil_table.h>

#include "complexes.h"

using namespace SolidSubdiv;

using Fuzz::CheckTable;
using Fuzz::Require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Fuzz::Bytes bytes(data, size);
    const Index n_vertices = bytes.Next() % 24;
    const int levels = bytes.Next() % 3;
    const Fuzz::TetOctComplex complex(bytes, n_vertices);
    const Far::TopologyDescriptor descriptor = complex.Descriptor();
    const bool has_semi_sharp = complex.HasSemiSharp();

    const auto defects = Far::Validate(descriptor);
    const bool usable = defects.empty() || !defects.front().IsFatal();
    try {
        const auto choice = Far::ChooseDiagonals(descriptor, Far::DiagonalPolicy::Matched);
        Require(usable && choice.tets.size() == complex.tets.size() && choice.octs.size() == complex.octs.size());
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

// SPDX-License-Identifier: Apache-2.0
// Whether a scheme can refine a mesh.
#include <solidsubdiv/far/internal/scheme_check.h>

#include <algorithm>
#include <string>

#include <solidsubdiv/sdc/creases.h>

namespace SolidSubdiv::Far::Internal {

void CheckScheme(const TopologyRefiner& refiner, const Sdc::Scheme& scheme) {
    const Level& base = refiner.level(0);
    std::visit([](const auto& s) { s.Validate(); }, scheme);
    const bool solids = std::visit([](const auto& s) { return s.kSolids; }, scheme);
    if (!solids && base.n_cells() > 0) {
        throw InvalidInput("scheme " + std::string(Sdc::NameOf(scheme)) +
                           " refines surfaces and curves; the mesh has " + std::to_string(base.n_cells()) +
                           " cells: choose a solid scheme, or give the boundary alone");
    }
    const bool is_wide = std::visit([](const auto& s) { return decltype(s.surface())::kIsWide; }, scheme);
    const auto is_semi_sharp = [](float s) { return Sdc::IsSharp(s) && !Sdc::IsInfinitelySharp(s); };
    const auto& edges = refiner.sharpness().edges;
    const auto semi_sharp = std::find_if(edges.begin(), edges.end(), is_semi_sharp);
    if (is_wide && semi_sharp != edges.end()) {
        const auto ends = base.EdgeVertices(static_cast<Index>(semi_sharp - edges.begin()));
        std::string sharpness = std::to_string(*semi_sharp);
        sharpness.erase(sharpness.find_last_not_of("0.") + 1);
        throw InvalidInput("edge (" + std::to_string(ends[0]) + " " + std::to_string(ends[1]) + ") has the sharpness " +
                           sharpness + "; scheme " + std::string(Sdc::NameOf(scheme)) +
                           " takes infinitely sharp creases (10) only");
    }
}

}  // namespace SolidSubdiv::Far::Internal

// SPDX-License-Identifier: Apache-2.0
// Whether a scheme can refine a mesh.
#include <solidsubdiv/far/internal/scheme_check.h>

#include <algorithm>
#include <string>

#include <solidsubdiv/sdc/creases.h>

namespace SolidSubdiv::Far::Internal {

namespace {

/// Butterflies look far along curves: they have no rules for creases that fade.
bool IsWide(const Sdc::Scheme& scheme) {
    return std::visit(
        [](const auto& s) {
            if constexpr (requires { s.surface(); }) return decltype(s.surface())::kIsWide;
            return false;
        },
        scheme);
}

}  // namespace

void CheckScheme(const TopologyRefiner& refiner, const Sdc::Scheme& scheme) {
    std::visit([](const auto& s) { s.Validate(); }, scheme);
    if (!Sdc::Takes(scheme, refiner.split())) {
        throw InvalidInput("scheme " + std::string(Sdc::NameOf(scheme)) +
                           (refiner.is_polyhedral()
                                ? " refines tets, octs and triangles as the tet/oct split cuts them; "
                                : " refines what the polyhedral split makes; ") +
                           "the refiner was made with the other split");
    }
    const bool solids = std::visit([](const auto& s) { return s.kSolids; }, scheme);
    if (!solids && refiner.n_cells(0) > 0) {
        throw InvalidInput("scheme " + std::string(Sdc::NameOf(scheme)) +
                           " refines surfaces and curves; the mesh has " + std::to_string(refiner.n_cells(0)) +
                           " cells: choose a solid scheme, or give the boundary alone");
    }
    const auto is_semi_sharp = [](float s) { return Sdc::IsSharp(s) && !Sdc::IsInfinitelySharp(s); };
    const auto& edges = refiner.sharpness().edges;
    const auto semi_sharp = std::find_if(edges.begin(), edges.end(), is_semi_sharp);
    if (IsWide(scheme) && semi_sharp != edges.end()) {
        const auto ends = refiner.graph(0).EdgeVertices(static_cast<Index>(semi_sharp - edges.begin()));
        std::string sharpness = std::to_string(*semi_sharp);
        sharpness.erase(sharpness.find_last_not_of("0.") + 1);
        throw InvalidInput("edge (" + std::to_string(ends[0]) + " " + std::to_string(ends[1]) + ") has the sharpness " +
                           sharpness + "; scheme " + std::string(Sdc::NameOf(scheme)) +
                           " takes infinitely sharp creases (10) only");
    }
}

}  // namespace SolidSubdiv::Far::Internal

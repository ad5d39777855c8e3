// SPDX-License-Identifier: Apache-2.0
// Whether a scheme can refine a mesh.
#include <solidsubdiv/far/internal/scheme_check.h>

#include <string>

namespace SolidSubdiv::Far::Internal {

void CheckScheme(const Vtr::Level& base, const Sdc::Scheme& scheme) {
    std::visit([](const auto& s) { s.Validate(); }, scheme);
    const bool solids = std::visit([](const auto& s) { return s.kSolids; }, scheme);
    if (!solids && base.n_cells() > 0) {
        throw InvalidInput("scheme " + std::string(Sdc::NameOf(scheme)) +
                           " refines surfaces and curves; the mesh has " + std::to_string(base.n_cells()) +
                           " cells: choose a solid scheme, or give the boundary alone");
    }
}

}  // namespace SolidSubdiv::Far::Internal

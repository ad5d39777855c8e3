// SPDX-License-Identifier: Apache-2.0
// From a scheme chosen at run time to the rows that it makes of a level.
#pragma once

#include <variant>

#include <solidsubdiv/far/internal/polyhedral_rows.h>
#include <solidsubdiv/far/internal/rows.h>

namespace SolidSubdiv::Far::Internal {

/// Calls body(scheme) with the scheme's own type, if it is one of the tet/oct split. @pre CheckScheme
template <class Body>
void WithTetOctScheme(const Sdc::Scheme& scheme, Body&& body) {
    std::visit(
        [&]<class Scheme>(const Scheme& s) {
            if constexpr (Sdc::Takes<Scheme>(Sdc::Split::TetOct)) body(s);
        },
        scheme);
}

/// The same with one of the polyhedral split.
template <class Body>
void WithPolyhedralScheme(const Sdc::Scheme& scheme, Body&& body) {
    std::visit(
        [&]<class Scheme>(const Scheme& s) {
            if constexpr (Sdc::Takes<Scheme>(Sdc::Split::Polyhedral)) body(s);
        },
        scheme);
}

/// Calls body(rows) with the rows of level i + 1 over level i. @pre CheckScheme
template <class Body>
void WithRows(const TopologyRefiner& refiner, int i, const Sharpness& sharpness, const Sdc::Scheme& scheme,
              Body&& body) {
    if (!refiner.is_polyhedral()) {
        WithTetOctScheme(scheme,
                         [&]<class Scheme>(const Scheme& s) { body(Rows<Scheme>(refiner.level(i), sharpness, s)); });
        return;
    }
    WithPolyhedralScheme(scheme, [&](const auto& s) {
        body(PolyhedralRows(refiner.polyhedral_level(i), sharpness, s.polyhedral(), CreaseOptionsOf(s).method));
    });
}

}  // namespace SolidSubdiv::Far::Internal

// SPDX-License-Identifier: Apache-2.0
// The one visible list of schemes. A new scheme is a header in schemes/ and a line here; names on the command line,
// help, dispatch and the conformance tests all read this list.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include <solidsubdiv/sdc/masks.h>
#include <solidsubdiv/sdc/schemes/box_spline.h>
#include <solidsubdiv/sdc/schemes/butterfly.h>
#include <solidsubdiv/sdc/schemes/catmull_clark.h>
#include <solidsubdiv/sdc/schemes/catmull_clark_solid.h>
#include <solidsubdiv/sdc/schemes/interpolatory.h>
#include <solidsubdiv/sdc/schemes/linear_solid.h>
#include <solidsubdiv/sdc/schemes/linear_surface.h>
#include <solidsubdiv/sdc/schemes/loop.h>
#include <solidsubdiv/sdc/schemes/mlca.h>
#include <solidsubdiv/sdc/schemes/smooth_tet.h>

/// Calls macro(Type) for every scheme.
#define SOLIDSUBDIV_FOR_EACH_SCHEME(macro)                                                                         \
    macro(BoxSpline) macro(SmoothTet) macro(Interpolatory) macro(CatmullClarkSolid) macro(Mlca) macro(LinearSolid) \
        macro(Loop) macro(Butterfly) macro(ModifiedButterfly) macro(CatmullClark) macro(LinearSurface)

namespace SolidSubdiv::Sdc {

/// Any scheme with its options, for programs that choose at run time: std::visit gives the static type back.
using Scheme = std::variant<BoxSpline, SmoothTet, Interpolatory, CatmullClarkSolid, Mlca, LinearSolid, Loop, Butterfly,
                            ModifiedButterfly, CatmullClark, LinearSurface>;

/// Whether a scheme refines what a split makes: the tet/oct split unless it says otherwise.
template <class S>
constexpr bool Takes(Split split) {
    if (split == Split::Polyhedral) {
        if constexpr (requires { S::kPolyhedral; }) return S::kPolyhedral;
        return false;
    }
    if constexpr (requires { S::kTetOct; }) return S::kTetOct;
    return true;
}
inline bool Takes(const Scheme& scheme, Split split) {
    return std::visit([&]<class S>(const S&) { return Takes<S>(split); }, scheme);
}

/// Calls function(scheme) with a default-made scheme of every type in the list.
template <class Function>
void ForEachScheme(Function&& function) {
#define SOLIDSUBDIV_CALL(Type) function(Type{});
    SOLIDSUBDIV_FOR_EACH_SCHEME(SOLIDSUBDIV_CALL)
#undef SOLIDSUBDIV_CALL
}

/// The scheme of a name, with default options. @throws InvalidInput that lists the known names
Scheme SchemeOf(std::string_view name);

/// Sets one option by the names of its table. @throws InvalidInput naming scheme, option and possible values
inline void SetOption(Scheme& scheme, std::string_view name, std::string_view value) {
    std::visit([&](auto& s) { s.SetOption(name, value); }, scheme);
}

inline std::string_view NameOf(const Scheme& scheme) {
    return std::visit([](const auto& s) { return s.kName; }, scheme);
}

}  // namespace SolidSubdiv::Sdc

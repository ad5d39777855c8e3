// SPDX-License-Identifier: Apache-2.0
// The approximating scheme for solids of any cells: on hexahedra in a regular block tricubic B-splines.
//
// Source: MacCracken and Joy 1996 (maccracken1996), as in rules.md section 4. Boundary: Catmull-Clark surfaces.
#pragma once

#include <array>
#include <string_view>

#include <solidsubdiv/sdc/common_options.h>
#include <solidsubdiv/sdc/creases.h>
#include <solidsubdiv/sdc/polyhedral_masks.h>

namespace SolidSubdiv::Sdc {

struct CatmullClarkSolid {
    Features features = Features::Sharp;
    CreasingMethod creasing = CreasingMethod::Uniform;

    static constexpr std::string_view kName = "catmull-clark-solid";
    static constexpr std::string_view kSummary = "approximating solids of any cells: tricubic on hexahedra";
    static constexpr bool kSolids = true;
    static constexpr bool kTetOct = false, kPolyhedral = true;
    static constexpr std::array<OptionInfo, 2> kOptions{kSharpSolidOption, kCreasingOption};

    void SetOption(std::string_view name, std::string_view value);
    void Validate() const {}

    PolyhedralRules polyhedral() const { return {}; }
    CreaseOptions creases() const { return SolidCreases(features, creasing); }
};

}  // namespace SolidSubdiv::Sdc

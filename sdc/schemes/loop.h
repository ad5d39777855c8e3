// SPDX-License-Identifier: Apache-2.0
// Loop surfaces on triangle meshes, with cubic B-spline curves along boundaries and for curves.
//
// Source: Loop 1987 (loop1987); rules.md section 5.
#pragma once

#include <array>
#include <string_view>

#include <solidsubdiv/sdc/common_options.h>
#include <solidsubdiv/sdc/creases.h>
#include <solidsubdiv/sdc/masks.h>

namespace SolidSubdiv::Sdc {

struct Loop {
    LoopWeights loop_weights = LoopWeights::Loop;
    Features features = Features::Smooth;
    CreasingMethod creasing = CreasingMethod::Uniform;

    static constexpr std::string_view kName = "loop";
    static constexpr std::string_view kSummary = "approximating triangle surfaces: C2 quartic box splines";
    static constexpr bool kSolids = false;
    static constexpr std::array<OptionInfo, 3> kOptions{
        {kLoopWeightsOption,
         {"features", "", "smooth|sharp", "smooth", "sharp: vertices in one triangle of an open surface stay"},
         kCreasingOption}};

    void SetOption(std::string_view name, std::string_view value);
    void Validate() const {}

    LoopSurface surface() const { return {loop_weights}; }
    CubicCurve curve() const { return {}; }
    CreaseOptions creases() const { return {creasing, features == Features::Sharp}; }
};

}  // namespace SolidSubdiv::Sdc

// SPDX-License-Identifier: Apache-2.0
// Loop surfaces on triangle meshes, with cubic B-spline curves along boundaries and for curves.
//
// Source: Loop 1987 (loop1987); rules.md section 5.
#pragma once

#include <array>
#include <string_view>

#include <solidsubdiv/sdc/masks.h>
#include <solidsubdiv/sdc/options.h>

namespace SolidSubdiv::Sdc {

struct Loop {
    LoopWeights loop_weights = LoopWeights::Loop;

    static constexpr std::string_view kName = "loop";
    static constexpr std::string_view kSummary = "approximating triangle surfaces: C2 quartic box splines";
    static constexpr bool kSolids = false;
    static constexpr std::array<OptionInfo, 1> kOptions{
        {{"loop-weights", "", "loop|warren", "loop", "weights of vertices"}}};

    void SetOption(std::string_view name, std::string_view value);
    void Validate() const {}

    LoopSurface surface() const { return {loop_weights}; }
    CubicCurve curve() const { return {}; }
};

}  // namespace SolidSubdiv::Sdc

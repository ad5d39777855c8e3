// SPDX-License-Identifier: Apache-2.0
// Meshes cut finer: vertices stay, new points are means of what they lie in.
#pragma once

#include <array>
#include <string_view>

#include <solidsubdiv/sdc/masks.h>
#include <solidsubdiv/sdc/options.h>
#include <solidsubdiv/sdc/polyhedral_masks.h>

namespace SolidSubdiv::Sdc {

struct LinearSurface {
    static constexpr std::string_view kName = "linear-surface";
    static constexpr std::string_view kSummary = "polygons cut finer: a finer mesh of the same shape";
    static constexpr bool kSolids = false;
    static constexpr bool kTetOct = true, kPolyhedral = true;
    static constexpr std::array<OptionInfo, 0> kOptions{};

    void SetOption(std::string_view name, std::string_view value);
    void Validate() const {}

    PolyhedralRules polyhedral() const { return {PolyhedralRule::Linear, PolyhedralRule::Linear}; }
    LinearRule surface() const { return {}; }
    LinearRule curve() const { return {}; }
};

}  // namespace SolidSubdiv::Sdc

// SPDX-License-Identifier: Apache-2.0
// Triangle meshes cut finer: vertices stay, new points are middles of edges.
#pragma once

#include <array>
#include <string_view>

#include <solidsubdiv/sdc/masks.h>
#include <solidsubdiv/sdc/options.h>

namespace SolidSubdiv::Sdc {

struct LinearSurface {
    static constexpr std::string_view kName = "linear-surface";
    static constexpr std::string_view kSummary = "triangles cut finer: a finer mesh of the same shape";
    static constexpr bool kSolids = false;
    static constexpr std::array<OptionInfo, 0> kOptions{};

    void SetOption(std::string_view name, std::string_view value);
    void Validate() const {}

    LinearRule surface() const { return {}; }
    LinearRule curve() const { return {}; }
};

}  // namespace SolidSubdiv::Sdc

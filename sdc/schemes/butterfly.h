// SPDX-License-Identifier: Apache-2.0
// Butterfly surfaces on triangle meshes: they pass through every vertex.
//
// Sources: Dyn, Levin, Gregory 1990 (dyn1990butterfly); Zorin, Schroeder, Sweldens 1996 (zorin1996interpolating);
// rules.md section 6.
#pragma once

#include <array>
#include <string_view>

#include <solidsubdiv/sdc/interpolating_masks.h>
#include <solidsubdiv/sdc/options.h>

namespace SolidSubdiv::Sdc {

/// The eight-point rule everywhere: not C1 at vertices of valence 3 and above 7 (docs/schemes/butterfly.md).
struct Butterfly {
    double tension = 1.0 / 16.0;  ///< w in [0, 1/8); 0: linear

    static constexpr std::string_view kName = "butterfly";
    static constexpr std::string_view kSummary =
        "interpolatory triangle surfaces, not C1 where 3 or more than 7 triangles meet";
    static constexpr bool kSolids = false;
    static constexpr std::array<OptionInfo, 1> kOptions{
        {{"tension", "", kNumber, "1/16", "from 0 (linear) to below 1/8; 1/16 reproduces cubics"}}};

    void SetOption(std::string_view name, std::string_view value);
    /// @throws InvalidInput if the tension is outside [0, 1/8)
    void Validate() const;

    ButterflySurface surface() const { return {false, 0, 16 * tension}; }
    FourPointCurve curve() const { return {tension}; }
};

/// Zorin's: C1 everywhere, by rings of their own around extraordinary vertices.
struct ModifiedButterfly {
    double far_weight = 0;  ///< weight of the two far points of the ten-point stencil, in [-1/16, 1/16]

    static constexpr std::string_view kName = "modified-butterfly";
    static constexpr std::string_view kSummary = "interpolatory triangle surfaces, C1 everywhere";
    static constexpr bool kSolids = false;
    static constexpr std::array<OptionInfo, 1> kOptions{
        {{"tension", "", kNumber, "0",
          "weight of the two far points of the ten-point rule, from -1/16 to 1/16; C1 to below 1/24"}}};

    void SetOption(std::string_view name, std::string_view value);
    /// @throws InvalidInput if the weight is outside [-1/16, 1/16]
    void Validate() const;

    ButterflySurface surface() const { return {true, far_weight, 1}; }
    FourPointCurve curve() const { return {}; }
};

}  // namespace SolidSubdiv::Sdc

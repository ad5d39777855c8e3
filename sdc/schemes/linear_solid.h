// SPDX-License-Identifier: Apache-2.0
// The linear scheme for solids of any cells: vertices stay, every new point is the mean of its parent's vertices.
//
// Source: MacCracken and Joy's octree rule for lattices (maccracken1996) as in rules.md section 4, by either split.
#pragma once

#include <array>
#include <string_view>

#include <solidsubdiv/sdc/masks.h>
#include <solidsubdiv/sdc/options.h>
#include <solidsubdiv/sdc/polyhedral_masks.h>

namespace SolidSubdiv::Sdc {

struct LinearSolid {
    static constexpr std::string_view kName = "linear-solid";
    static constexpr std::string_view kSummary = "linear solids of any cells: a finer mesh of the same shape";
    static constexpr bool kSolids = true;
    static constexpr bool kVerticesStay = true;
    static constexpr bool kTetOct = true, kPolyhedral = true;
    static constexpr std::array<OptionInfo, 0> kOptions{};

    void SetOption(std::string_view name, std::string_view value);
    void Validate() const {}

    Footprint footprint() const { return {false, false, false, OctNeighbors::None}; }
    VertexWeights Vertex(VertexCounts) const { return {1.0, 0.0, 0.0}; }
    EdgeWeights Edge(EdgeCounts) const { return {0.5, 0.0, 0.0}; }
    OctWeights Centre() const { return {1.0 / 6.0, 1.0 / 6.0}; }
    PolyhedralRules polyhedral() const { return {PolyhedralRule::Linear, PolyhedralRule::Linear}; }
    LinearRule surface() const { return {}; }
    LinearRule curve() const { return {}; }
};

}  // namespace SolidSubdiv::Sdc

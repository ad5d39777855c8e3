// SPDX-License-Identifier: Apache-2.0
// Multilinear cell averaging: the linear split of any cells, then each new point becomes the mean of the centroids of
// the new cells at it. Tricubic B-splines on hexahedra in a regular block, smooth along extraordinary edges.
//
// Source: Bajaj, Schaefer, Warren, Xu 2002 (bajaj2002); rules.md section 4b. Boundary: the same for the boundary's new
// faces, or Catmull-Clark surfaces.
#pragma once

#include <array>
#include <string_view>

#include <solidsubdiv/sdc/common_options.h>
#include <solidsubdiv/sdc/creases.h>
#include <solidsubdiv/sdc/polyhedral_masks.h>

namespace SolidSubdiv::Sdc {

/// What the boundary of a solid follows.
enum class BoundarySurface { Averaged, CatmullClark };

struct Mlca {
    Features features = Features::Sharp;
    CreasingMethod creasing = CreasingMethod::Uniform;
    BoundarySurface surface = BoundarySurface::Averaged;

    static constexpr std::string_view kName = "mlca";
    static constexpr std::string_view kSummary =
        "approximating solids of any cells: tricubic on hexahedra, smooth along edges of any valence";
    static constexpr bool kSolids = true;
    static constexpr bool kTetOct = false, kPolyhedral = true;
    static constexpr std::array<OptionInfo, 3> kOptions{
        {kSharpSolidOption,
         kCreasingOption,
         {"surface", "", "averaged|catmull-clark", "averaged", "what the boundary follows"}}};

    void SetOption(std::string_view name, std::string_view value);
    void Validate() const {}

    PolyhedralRules polyhedral() const {
        const bool is_averaged = surface == BoundarySurface::Averaged;
        return {PolyhedralRule::Averaged, is_averaged ? PolyhedralRule::Averaged : PolyhedralRule::CatmullClark};
    }
    CreaseOptions creases() const { return SolidCreases(features, creasing); }
};

}  // namespace SolidSubdiv::Sdc

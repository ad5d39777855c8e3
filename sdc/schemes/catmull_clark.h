// SPDX-License-Identifier: Apache-2.0
// Catmull-Clark surfaces on polygons of any kind, with cubic B-spline curves along boundaries and for curves.
//
// Source: Catmull and Clark 1978 (catmull1978); DeRose, Kass, Truong 1998 (derose1998) for creases.
#pragma once

#include <array>
#include <string_view>

#include <solidsubdiv/sdc/common_options.h>
#include <solidsubdiv/sdc/creases.h>
#include <solidsubdiv/sdc/polyhedral_masks.h>

namespace SolidSubdiv::Sdc {

struct CatmullClark {
    Features features = Features::Smooth;
    CreasingMethod creasing = CreasingMethod::Uniform;
    TriangleWeights triangles = TriangleWeights::CatmullClark;

    static constexpr std::string_view kName = "catmull-clark";
    static constexpr std::string_view kSummary = "approximating surfaces of any polygons: bicubic on quadrilaterals";
    static constexpr bool kSolids = false;
    static constexpr bool kTetOct = false, kPolyhedral = true;
    static constexpr std::array<OptionInfo, 3> kOptions{
        {{"features", "", "smooth|sharp", "smooth", "sharp: vertices in one face of an open surface stay"},
         kCreasingOption,
         {"triangles", "", "catmull-clark|smooth", "catmull-clark", "weights of new points on edges of triangles"}}};

    void SetOption(std::string_view name, std::string_view value);
    void Validate() const {}

    PolyhedralRules polyhedral() const { return {.triangles = triangles}; }
    CreaseOptions creases() const { return {creasing, features == Features::Sharp, false}; }
};

}  // namespace SolidSubdiv::Sdc

// SPDX-License-Identifier: Apache-2.0
// The tet/oct scheme that needs no diagonals and is smooth inside every face: the linear split, then each new point
// becomes the mean over the new cells at it of a mask of the cell.
//
// A tet's mask weighs the point itself -1/16, the others 17/48; an octahedron's the point 3/8, its four neighbours
// 1/12, the opposite vertex 7/24. Split and masks are multiplied out here, by the parent's cells at a vertex or on an
// edge:
//
//   vertex, in 288ths    a tet: itself 135, the others 51    an octahedron: itself 170, neighbours 26, opposite 14
//   edge, in 48ths       a tet (three new cells): the ends 44, the others 28
//                        an octahedron (four): the ends 54, vertices of its two faces there 28, opposite to ends 14
//
// Source: Schaefer, Hakenberg, Warren 2004 (schaefer2004); rules.md section 4b. Boundary: Loop.
#pragma once

#include <array>
#include <string_view>

#include <solidsubdiv/sdc/common_options.h>
#include <solidsubdiv/sdc/creases.h>
#include <solidsubdiv/sdc/masks.h>

namespace SolidSubdiv::Sdc {

struct SmoothTet {
    LoopWeights loop_weights = LoopWeights::Loop;
    Features features = Features::Smooth;
    CreasingMethod creasing = CreasingMethod::Uniform;

    static constexpr std::string_view kName = "smooth-tet";
    static constexpr std::string_view kSummary = "approximating tet/oct solids without diagonals, smooth inside faces";
    static constexpr bool kSolids = true;
    static constexpr std::array<OptionInfo, 3> kOptions{kLoopWeightsOption, kSmoothSolidOption, kCreasingOption};

    void SetOption(std::string_view name, std::string_view value);
    void Validate() const {}

    Footprint footprint() const { return {true, true, false, OctNeighbors::All}; }

    CellVertexWeights Vertex(VertexCells n) const {
        const double share = 1.0 / (288.0 * (n.n_tets + n.n_octs));
        return {share * (135 * n.n_tets + 170 * n.n_octs), share * 51, share * 26, share * 14};
    }
    /// Each face has two cells at the edge, which both give its third vertex 28.
    EdgeWeights Edge(EdgeCounts n) const {
        const int n_tets = n.n_faces - n.n_octs;
        const double share = 1.0 / (48.0 * (3 * n_tets + 4 * n.n_octs));
        return {share * (44 * n_tets + 54 * n.n_octs), share * 56, share * 14};
    }
    OctWeights Centre() const { return {1.0 / 6.0, 1.0 / 6.0}; }

    LoopSurface surface() const { return {loop_weights}; }
    CubicCurve curve() const { return {}; }
    CreaseOptions creases() const { return SolidCreases(features, creasing); }
};

}  // namespace SolidSubdiv::Sdc

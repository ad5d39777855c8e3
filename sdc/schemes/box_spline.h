// SPDX-License-Identifier: Apache-2.0
// The approximating tet/oct scheme: on the regular lattice the box spline N(2,2,2,2), quintic and C2.
//
// Source: Chang, McDonnell, Qin 2002 (chang2002boxspline), eqs. (8)-(12), with eq. (11) replaced at links of four by
// the box spline's own mask, which is eq. (12); rules.md section 2 says why. Boundary: Loop.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include <solidsubdiv/sdc/common_options.h>
#include <solidsubdiv/sdc/creases.h>
#include <solidsubdiv/sdc/errors.h>
#include <solidsubdiv/sdc/masks.h>

namespace SolidSubdiv::Sdc {

enum class EdgeRule {
    BoxSpline,   ///< links of four follow the box spline
    Printed2002  ///< eq. (11) for every valence and the paper's wording of neighbours: not C2, for comparison
};

enum class Diagonals {
    Directional,  ///< the major diagonals of the octahedra give the mask its direction
    Averaged      ///< the mean of the three directional masks: needs no diagonals
};

struct BoxSpline {
    EdgeRule edge_rule = EdgeRule::BoxSpline;
    Diagonals diagonals = Diagonals::Directional;
    LoopWeights loop_weights = LoopWeights::Loop;
    Features features = Features::Smooth;
    CreasingMethod creasing = CreasingMethod::Uniform;

    static constexpr std::string_view kName = "box-spline";
    static constexpr std::string_view kSummary = "approximating tet/oct solids: C2 box splines, Loop boundary";
    static constexpr bool kSolids = true;
    static constexpr std::array<OptionInfo, 5> kOptions{{{"edge-rule", "", "box-spline|printed-2002", "box-spline",
                                                          "mask of inner edges; printed-2002 is the paper's wording"},
                                                         {"diagonals", "", "directional|averaged", "directional",
                                                          "averaged: no major diagonals, independent of input order"},
                                                         kLoopWeightsOption,
                                                         kSmoothSolidOption,
                                                         kCreasingOption}};

    /// @throws InvalidInput for an unknown name or value
    void SetOption(std::string_view name, std::string_view value);
    /// @throws InvalidInput where options contradict each other
    void Validate() const;

    Footprint footprint() const {
        Footprint f;
        f.tet_faces_only = edge_rule == EdgeRule::Printed2002;
        f.octs = diagonals == Diagonals::Averaged ? OctNeighbors::All : OctNeighbors::MajorDiagonal;
        return f;
    }

    /// Eq. (9); averaged: each opposite vertex of an oct counts as a third of a neighbour.
    VertexWeights Vertex(VertexCounts n) const {
        const double share = diagonals == Diagonals::Averaged ? 1.0 / 3.0 : 1.0;
        const double w = 14.0 / (32.0 * (n.n_edges + share * n.n_octs));
        return {18.0 / 32.0, w, share * w};
    }

    /// Eqs. (10), (11); k = 4: eq. (12).
    EdgeWeights Edge(EdgeCounts n) const {
        if (diagonals == Diagonals::Averaged && n.n_octs > 0) {
            return {28.0 / 96.0, 32.0 / (96.0 * n.n_faces), 4.0 / (96.0 * n.n_octs)};
        }
        const int k = n.n_faces + n.n_oct_vertices;
        if (k == 4 && edge_rule == EdgeRule::BoxSpline) return {8.0 / 32.0, 4.0 / 32.0, 4.0 / 32.0};
        const double w = 12.0 / (32.0 * k);
        return {10.0 / 32.0, w, w};
    }

    /// Eq. (12); averaged: the mean of the six.
    OctWeights Centre() const {
        if (diagonals == Diagonals::Averaged) return {1.0 / 6.0, 1.0 / 6.0};
        return {8.0 / 32.0, 4.0 / 32.0};
    }

    LoopSurface surface() const { return {loop_weights}; }
    CubicCurve curve() const { return {}; }
    CreaseOptions creases() const { return SolidCreases(features, creasing); }
};

}  // namespace SolidSubdiv::Sdc

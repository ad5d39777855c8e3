// SPDX-License-Identifier: Apache-2.0
// The interpolatory tet/oct scheme: vertices stay, new points follow one- and two-neighbours with a tension.
//
// Source: Chang, McDonnell, Qin 2003 (chang2003interpolatory), with the weights at links of four that make it C1 and
// reproduce cubics; rules.md section 3 says why. Boundary: modified butterfly, or butterfly.
#pragma once

#include <array>
#include <string_view>

#include <solidsubdiv/sdc/common_options.h>
#include <solidsubdiv/sdc/creases.h>
#include <solidsubdiv/sdc/interpolating_masks.h>
#include <solidsubdiv/sdc/masks.h>

namespace SolidSubdiv::Sdc {

enum class ButterflyKind { Modified, Plain };

/// How much a two-neighbour counts that lies across the faces of more than one tet around an edge.
enum class TwoNeighborCount {
    Once,     ///< like the others: rules.md section 3
    ByFaces,  ///< once for each of these faces: smoother where the lattice is not regular (docs/analysis.md)
};

/// end (a + b) + one sum(one-neighbours) + two sum(two-neighbours)
struct TwoNeighborWeights {
    double end, one, two;
};

struct Interpolatory {
    double tension = 1.0 / 16.0;  ///< w in [0, 1/8); 0: linear, 1/16: reproduces cubics
    ButterflyKind boundary = ButterflyKind::Modified;
    Features features = Features::Smooth;
    TwoNeighborCount two_neighbors = TwoNeighborCount::Once;

    static constexpr std::string_view kName = "interpolatory";
    static constexpr std::string_view kSummary = "interpolatory tet/oct solids with a tension, butterfly boundary";
    static constexpr bool kSolids = true;
    static constexpr bool kVerticesStay = true;
    static constexpr bool kTwoNeighbors = true;
    static constexpr std::array<OptionInfo, 4> kOptions{
        {{"tension", "", kNumber, "1/16", "from 0 (linear) to below 1/8; C1 up to 1/16, which reproduces cubics"},
         {"butterfly", "", "modified|plain", "modified", "which butterfly the boundary follows"},
         kSmoothSolidOption,
         {"two-neighbors", "", "once|by-faces", "once",
          "how much one counts that is across several faces; by-faces: smoother off the regular lattice"}}};

    void SetOption(std::string_view name, std::string_view value);
    /// @throws InvalidInput if the tension is outside [0, 1/8): the process converges there only
    void Validate() const;

    Footprint footprint() const { return {false, true, false, OctNeighbors::MajorDiagonal}; }
    VertexWeights Vertex(VertexCounts) const { return {1.0, 0.0, 0.0}; }

    /// New point on an edge, or on an octahedron's major diagonal, with n one- and m two-neighbours (rules.md section
    /// 3).
    TwoNeighborWeights Edge(int n, int m) const {
        const int t = n == 4;
        return {1.0 / 2.0 - t * m * tension / 2.0, (1 + t) * (static_cast<double>(m) / n) * tension, -tension};
    }

    /// The same by faces, of which there are 2 n: `two` is what each of them adds. In the regular lattice the rule is
    /// the other, elsewhere the totals are the means of those of n = 4 and n = 6.
    TwoNeighborWeights EdgeByFaces(int n) const {
        const double one = (n == 4 ? 16 : n == 6 ? 6 : 11) * tension, two = (n == 4 ? 8 : n == 6 ? 6 : 7) * tension;
        return {(1.0 - one + two) / 2.0, one / n, -two / (2.0 * n)};
    }

    ButterflySurface surface() const { return {boundary == ButterflyKind::Modified, 0, 16 * tension}; }
    FourPointCurve curve() const { return {tension}; }
    CreaseOptions creases() const { return SolidCreases(features); }
};

}  // namespace SolidSubdiv::Sdc

// SPDX-License-Identifier: Apache-2.0
// Surface and curve rules that keep every vertex: butterfly, modified butterfly and the 4-point scheme.
//
// Their stencils are wider than an edge's own faces: Far walks, these answer with weights. A new point on the edge a b
// of a regular triangulation has the weights of
//
//              wing ----- c ----- wing
//                 \     /   \     /
//                  \   /     \   /
//         far ----- a --- + --- b ----- far
//                  /   \     /   \                    (c, d: opposite)
//                 /     \   /     \                   .
//              wing ----- d ----- wing
//
// Sources: Dyn, Levin, Gregory 1990 (dyn1990butterfly); Zorin, Schroeder, Sweldens 1996 (zorin1996interpolating);
// borders: rules.md section 6.
#pragma once

#include <cmath>
#include <numbers>
#include <span>

namespace SolidSubdiv::Sdc {

/// end (a + b) + opposite (c + d) + wing (four wings) + far (two far points)
struct ButterflyWeights {
    double end, opposite, wing, far;
};

/// Butterfly surfaces, on triangles and on the boundary of tet/oct solids.
struct ButterflySurface {
    static constexpr bool kVerticesStay = true;
    static constexpr bool kIsWide = true;

    bool is_modified = false;  ///< rings of their own around extraordinary vertices
    double far_weight = 0;     ///< modified: weight w of the two far points between regular vertices
    /// How far a new point goes from the middle of its edge (0: linear) to the butterfly's point of tension 1/16 (1).
    double pull = 1;

    /// Between regular vertices. @param has_far whether all ten points are there
    ButterflyWeights Regular(bool has_far) const {
        const double w = has_far ? far_weight : 0;
        return {1.0 / 2.0 - w, 1.0 / 8.0 + 2.0 * w, -1.0 / 16.0 - w, w};
    }

    static constexpr double kClosedRingSelf = 3.0 / 4.0;
    /// Modified: around an inner vertex of n triangles, for the edge to ring[0]. Returns the weight of the vertex.
    static double ClosedRing(int n, std::span<double> ring) {
        if (n == 3) {
            ring[0] = 5.0 / 12.0;
            ring[1] = ring[2] = -1.0 / 12.0;
        } else if (n == 4) {
            ring[0] = 3.0 / 8.0;
            ring[2] = -1.0 / 8.0;
            ring[1] = ring[3] = 0;
        } else {
            for (int i = 0; i < n; ++i) {
                const double angle = 2.0 * std::numbers::pi * i / n;
                ring[i] = (1.0 / 4.0 + std::cos(angle) + std::cos(2.0 * angle) / 2.0) / n;
            }
        }
        return kClosedRingSelf;
    }

    /// Modified: around a border vertex of k triangles, ring[0] and ring[k] on the border, for the edge to ring[i].
    /// Returns the weight of the vertex. @pre 0 < i < k
    static double OpenRing(int k, int i, std::span<double> ring) {
        const double theta = std::numbers::pi / k;
        for (int j = 1; j < k; ++j) {
            ring[j] =
                (std::sin(i * theta) * std::sin(j * theta) + std::sin(2 * i * theta) * std::sin(2 * j * theta) / 2) / k;
        }
        const double c = std::cos(i * theta) / 4 - std::sin(2 * theta) * std::sin(2 * i * theta) /
                                                       (4 * k * (std::cos(theta) - std::cos(2 * theta)));
        ring[0] = c;
        ring[k] = -c;
        return 1.0 - std::sin(theta) * std::sin(i * theta) / (k * (1.0 - std::cos(theta)));
    }
};

/// Curves through every vertex: borders and creases of butterfly surfaces, and curves.
/// Source: Dyn, Levin, Gregory 1987 (dyn1987fourpoint); at an end a parabola through the three points nearest.
struct FourPointCurve {
    static constexpr bool kVerticesStay = true;
    static constexpr bool kIsWide = true;

    double tension = 1.0 / 16.0;

    struct Inner {
        double end, next;
    };
    struct AtEnd {
        double last, end, next;  ///< the curve's last vertex, the other end of its last edge, the one after that
    };
    Inner Edge() const { return {1.0 / 2.0 + tension, -tension}; }
    AtEnd LastEdge() const { return {1.0 / 2.0 - 2.0 * tension, 1.0 / 2.0 + 4.0 * tension, -2.0 * tension}; }
};

}  // namespace SolidSubdiv::Sdc

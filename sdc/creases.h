// SPDX-License-Identifier: Apache-2.0
// Sharp edges and vertices of surfaces: how sharpness decays from level to level, and which rule it asks for.
//
// Sharpness counts the levels for which an edge or a vertex stays sharp; 10 and more is for ever. Everything here is
// what OpenSubdiv does, in single precision and in its order of operations, so that results agree to round-off.
// Sources: DeRose, Kass, Truong 1998 (derose1998); rules.md section 5.
#pragma once

#include <algorithm>

namespace SolidSubdiv::Sdc {

inline constexpr float kInfinitelySharp = 10.0f;

inline bool IsSharp(float sharpness) { return sharpness > 0; }
inline bool IsInfinitelySharp(float sharpness) { return sharpness >= kInfinitelySharp; }

/// How edges pass their sharpness on.
enum class CreasingMethod {
    Uniform,  ///< less by one at each level
    Chaikin   ///< first averaged with the other sharp edges at the end vertex: creases whose sharpness varies smoothly
};

/// What becomes of an open surface's vertices that are in one face, and of a solid's edges and vertices in one cell.
enum class Features {
    Smooth,  ///< the border, the boundary runs through them (OpenSubdiv: EDGE_ONLY)
    Sharp    ///< they are corners (EDGE_AND_CORNER), creases
};

/// What a scheme does with creases and corners.
struct CreaseOptions {
    CreasingMethod method = CreasingMethod::Uniform;
    bool sharp_corners = false;  ///< vertices in one face of an open surface stay (OpenSubdiv's EDGE_AND_CORNER)
    bool sharp_cells = false;    ///< edges in one cell are creases, vertices in one cell corners
};

/// Those of a solid scheme with `features`.
constexpr CreaseOptions SolidCreases(Features features, CreasingMethod method = CreasingMethod::Uniform) {
    const bool is_sharp = features == Features::Sharp;
    return {method, is_sharp, is_sharp};
}

/// Sharpness of a vertex's child, and under CreasingMethod::Uniform of an edge's children.
inline float Decay(float sharpness) {
    if (IsInfinitelySharp(sharpness)) return kInfinitelySharp;
    return sharpness > 1.0f ? sharpness - 1.0f : 0.0f;
}

/// Sharpness of the child of a semi-sharp edge at a vertex where `n` such edges, this one among them, have the given
/// sum, under CreasingMethod::Chaikin.
inline float DecayByChaikin(float sharpness, float sum, int n) {
    if (n < 2) return Decay(sharpness);
    const float others = (sum - sharpness) / static_cast<float>(n - 1);
    return std::max(((0.75f * sharpness) + (0.25f * others)) - 1.0f, 0.0f);
}

/// What sharp edges and its own sharpness make of a surface's vertex.
enum class SharpRule { Smooth, Dart, Crease, Corner };

inline SharpRule SharpRuleOf(float vertex_sharpness, int n_sharp_edges) {
    if (IsSharp(vertex_sharpness) || n_sharp_edges > 2) return SharpRule::Corner;
    return static_cast<SharpRule>(n_sharp_edges);
}

}  // namespace SolidSubdiv::Sdc

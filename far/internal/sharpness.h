// SPDX-License-Identifier: Apache-2.0
// Sharpness of one level's edges and vertices, and what it makes of rules.
#pragma once

#include <array>
#include <vector>

#include <solidsubdiv/far/internal/check.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/sdc/creases.h>
#include <solidsubdiv/sdc/schemes.h>
#include <solidsubdiv/vtr/edge_graph.h>

namespace SolidSubdiv::Far::Internal {

/// The descriptor's creases and corners on the edges and vertices of level 0; what is on no surface is a defect.
/// @pre indices and sharpnesses are in range
Sharpness TakeSharpness(const TopologyDescriptor& descriptor, const Vtr::EdgeGraph& graph, DefectList& defects);

/// Calls body(e) for the edges of the surface at v.
template <class Body>
void ForSurfaceEdges(const Vtr::EdgeGraph& graph, Index v, Body&& body) {
    const bool in_cell = graph.vertex_tags[v].in_cell();
    for (Index e : graph.vertex_edges[v]) {
        const Vtr::Tag tag = graph.edge_tags[e];
        if (tag.in_face() && tag.in_cell() == in_cell && tag.rule() != Vtr::Rule::Solid) body(e);
    }
}
/// The same with body(e, sharpness): edges that end the surface are infinitely sharp. @pre !sharpness.empty()
template <class Body>
void ForSurfaceEdges(const Vtr::EdgeGraph& graph, const Sharpness& sharpness, Index v, Body&& body) {
    ForSurfaceEdges(graph, v, [&](Index e) {
        body(e, graph.edge_tags[e].rule() == Vtr::Rule::Surface ? sharpness.edges[e] : Sdc::kInfinitelySharp);
    });
}

/// Sharpness of the half at v of edge e. @pre !sharpness.empty()
float ChildSharpness(const Vtr::EdgeGraph& graph, const Sharpness& sharpness, Sdc::CreasingMethod method, Index e,
                     Index v);

/// Sharpness of the children of a level's edges and vertices; the others among the child's `n_edges` and `n_vertices`
/// are smooth.
Sharpness ChildrenSharpness(const Vtr::EdgeGraph& level, Index n_edges, Index n_vertices, const Sharpness& parent,
                            Sdc::CreasingMethod method);

/// A scheme's options for creases; those without any take them as they are.
template <class Scheme>
Sdc::CreaseOptions CreaseOptionsOf(const Scheme& scheme) {
    if constexpr (requires { scheme.creases(); }) return scheme.creases();
    return {};
}

/// Sharpness of the levels 0 to n_levels - 1 under a scheme, or under its options.
std::vector<Sharpness> SharpnessOfLevels(const TopologyRefiner& refiner, const Sdc::CreaseOptions& options,
                                         int n_levels);
std::vector<Sharpness> SharpnessOfLevels(const TopologyRefiner& refiner, const Sdc::Scheme& scheme, int n_levels);

/// Rows of surface vertices and edges that sharpness changes: shares of two rules, the level's and its child's.
class SharpRules {
  public:
    SharpRules(const Vtr::EdgeGraph& graph, const Sharpness& sharpness, Sdc::CreasingMethod method)
        : graph_(graph), sharpness_(sharpness), method_(method) {}

    bool ChangesEdge(Index e) const {
        return !sharpness_.empty() && Sdc::IsSharp(sharpness_.edges[e]) &&
               graph_.edge_tags[e].rule() == Vtr::Rule::Surface;
    }
    /// Whether an edge ends the surface on both sides, for ever.
    bool IsCrease(Index e) const { return ChangesEdge(e) && Sdc::IsInfinitelySharp(sharpness_.edges[e]); }
    bool IsCorner(Index v) const { return !sharpness_.empty() && Sdc::IsSharp(sharpness_.vertices[v]); }

    /// How much of a new point on a sharp edge follows the crease rule; the rest is smooth.
    double CreaseShare(Index e) const;

    bool ChangesVertex(Index v) const { return !sharpness_.empty() && HasSharpEdgeOrIsSharp(v); }
    /// Whether the vertex or an edge at it is sharp, but not for ever.
    bool IsFading(Index v) const;

    struct Part {
        Sdc::SharpRule rule = Sdc::SharpRule::Smooth;
        double share = 0;
        std::array<Index, 2> crease{kNoIndex, kNoIndex};  ///< its edges, of a crease
    };
    /// A vertex's rule and its child's; both the same: one share is 0.
    std::array<Part, 2> VertexParts(Index v) const;

  private:
    bool HasSharpEdgeOrIsSharp(Index v) const;

    const Vtr::EdgeGraph graph_;
    const Sharpness& sharpness_;
    Sdc::CreasingMethod method_;
};

}  // namespace SolidSubdiv::Far::Internal

// SPDX-License-Identifier: Apache-2.0
// Steps on the surfaces of a complex: from face to face across edges, around a vertex, and along curves.
//
// A surface is made of boundary faces and of triangles in no cell. It goes on across edges of the surface rule, which
// have two such faces; edges of the curve rule (borders, seams) and infinitely sharp ones (creases) end it.
#pragma once

#include <algorithm>
#include <vector>

#include <solidsubdiv/far/internal/sharpness.h>
#include <solidsubdiv/vtr/level.h>

namespace SolidSubdiv::Far::Internal {

using Vtr::Level;
using Vtr::Rule;
using Vtr::Tag;

/// The triangles of a surface around a vertex between two edges that end it, or all around.
struct Fan {
    bool is_closed = false;
    std::vector<Index> ring;  ///< the other vertices, in order; closed: from the edge asked for
    int place = 0;            ///< of the edge asked for in the ring
    Index border = kNoIndex;  ///< open: one of the two edges that end the fan

    int n_triangles() const { return static_cast<int>(ring.size()) - !is_closed; }
};

class SurfaceWalk {
  public:
    SurfaceWalk(const Level& level, const SharpRules& sharp) : level_(level), sharp_(sharp) {}

    struct Faces {
        Index first, second;
    };
    /// The two faces of the surface at an edge of the surface rule.
    Faces FacesAt(Index e) const {
        Faces faces{kNoIndex, kNoIndex};
        for (Index f : level_.edge_faces[e]) {
            if (level_.face_tags[f].is_boundary()) (faces.first == kNoIndex ? faces.first : faces.second) = f;
        }
        return faces;
    }
    bool EndsSurface(Index e) const { return level_.edge_tags[e].rule() != Rule::Surface || sharp_.IsCrease(e); }
    Index Across(Index e, Index f) const {
        const Faces faces = FacesAt(e);
        return faces.first == f ? faces.second : faces.first;
    }
    /// The edge of f that does not end in v. @pre v is a vertex of f
    Index EdgeOpposite(Index f, Index v) const {
        const auto vertices = level_.FaceVertices(f);
        return level_.FaceEdges(f)[vertices[0] == v ? 0 : vertices[1] == v ? 1 : 2];
    }

    /// Whether v lies inside a surface, with six triangles around it: the usual case, found without a walk.
    bool IsRegularInside(Index v) const {
        const Tag tag = level_.vertex_tags[v];
        if (tag.rule() != Rule::Surface || tag.non_manifold() || sharp_.ChangesVertex(v)) return false;
        if (!tag.in_cell()) return level_.vertex_edges.Count(v) == 6;
        int n = 0;
        for (Index e : level_.vertex_edges[v]) n += level_.edge_tags[e].rule() == Rule::Surface;
        return n == 6;
    }

    /// The fan around v, an end of edge e of the surface rule. An edge alone that ends the surface does not end the
    /// fan: where a single crease runs out the ring is closed.
    Fan FanAt(Index v, Index e) const {
        Fan fan;
        fan.ring.push_back(OtherEnd(e, v));
        const Faces faces = FacesAt(e);
        const Index end = Walk(v, e, faces.first, fan.ring);
        if (end == e) {
            fan.is_closed = true;
            fan.ring.pop_back();  // the walk came back to its first vertex
            return fan;
        }
        std::vector<Index> before;
        const Index start = Walk(v, e, faces.second, before);
        if (start == end) {
            fan.is_closed = true;
            before.pop_back();
            fan.ring.insert(fan.ring.end(), before.rbegin(), before.rend());
            return fan;
        }
        fan.border = start;
        fan.place = static_cast<int>(before.size());
        fan.ring.insert(fan.ring.begin(), before.rbegin(), before.rend());
        return fan;
    }

    /// The vertex after v on the curve that edge e belongs to, or kNoIndex where the curve ends in v.
    Index NextOnCurve(Index e, Index v) const {
        constexpr int kPart = Tag::kInCell | Tag::kInFace;
        if (level_.vertex_tags[v].rule() == Rule::Corner || sharp_.IsCorner(v)) return kNoIndex;
        const Tag mine = level_.edge_tags[e];
        Index next = kNoIndex;
        for (Index other : level_.vertex_edges[v]) {
            const Tag tag = level_.edge_tags[other];
            const bool is_on_curve = tag.rule() == Rule::Curve || sharp_.IsCrease(other);
            if (other == e || !is_on_curve || (tag.bits & kPart) != (mine.bits & kPart)) continue;
            if (next != kNoIndex) return kNoIndex;
            next = OtherEnd(other, v);
        }
        return next;
    }

  private:
    Index OtherEnd(Index e, Index v) const {
        const auto ends = level_.EdgeVertices(e);
        return ends[0] + ends[1] - v;
    }

    /// Turns around v from edge e over face f, appending vertices, until an edge ends the surface or e is met again.
    /// Returns that edge.
    Index Walk(Index v, Index e, Index f, std::vector<Index>& ring) const {
        Index at = e;
        while (true) {
            const Index next = EdgeOpposite(f, OtherEnd(at, v));
            ring.push_back(OtherEnd(next, v));
            if (next == e || EndsSurface(next)) return next;
            f = Across(next, f);
            at = next;
        }
    }

    const Level& level_;
    const SharpRules& sharp_;
};

}  // namespace SolidSubdiv::Far::Internal

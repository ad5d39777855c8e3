// SPDX-License-Identifier: Apache-2.0
// Steps on the surfaces of a complex: from face to face across edges, around a vertex, and along curves.
//
// A surface is made of boundary faces and of triangles in no cell. It goes on across edges of the surface rule, which
// have two such faces; edges of the curve rule (borders, seams) and infinitely sharp ones (creases) end it.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include <solidsubdiv/far/internal/sharpness.h>
#include <solidsubdiv/vtr/level.h>

namespace SolidSubdiv::Far::Internal {

using Vtr::Level;
using Vtr::Rule;
using Vtr::Tag;

/// Room for a few elements on the stack, for more in memory.
template <class T>
class Room {
  public:
    T* For(std::size_t n) {
        if (n <= few_.size()) return few_.data();
        many_.resize(n);
        return many_.data();
    }

  private:
    std::array<T, 24> few_;
    std::vector<T> many_;
};

/// The triangles of a surface around a vertex between two edges that end it, or all around.
struct Fan {
    bool is_closed = false;
    std::span<const Index> ring;  ///< the other vertices, in order; closed: from the edge asked for
    int place = 0;                ///< of the edge asked for in the ring
    Index border = kNoIndex;      ///< open: one of the two edges that end the fan

    int n_triangles() const { return static_cast<int>(ring.size()) - !is_closed; }
};

class SurfaceWalk {
  public:
    SurfaceWalk(const Level& level, const SharpRules& sharp) : level_(level), sharp_(sharp) {}

    struct Faces {
        Index first, second;
    };
    /// The two faces of the surface at an edge of the surface rule.
    [[gnu::always_inline]] Faces FacesAt(Index e) const {
        const auto all = level_.edge_faces[e];
        return all.size() == 2 ? Faces{all[0], all[1]} : BoundaryFacesOf(all);
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

    /// Whether the surface goes on across all its edges at v, once around.
    bool IsInside(Index v) const {
        const Tag tag = level_.vertex_tags[v];
        return tag.rule() == Rule::Surface && !tag.non_manifold() && !sharp_.ChangesVertex(v);
    }
    /// Whether v lies inside a surface, with six triangles around it: the usual case, found without a walk.
    bool IsRegularInside(Index v) const {
        if (!IsInside(v)) return false;
        if (!level_.vertex_tags[v].in_cell()) return level_.vertex_edges.Count(v) == 6;
        int n = 0;
        for (Index e : level_.vertex_edges[v]) n += level_.edge_tags[e].rule() == Rule::Surface;
        return n == 6;
    }

    /// The fan around v, an end of edge e of the surface rule. An edge alone that ends the surface does not end the
    /// fan: where a single crease runs out the ring is closed. The ring is written to the room.
    Fan FanAt(Index v, Index e, Room<Index>& room) const {
        Index* const ring = room.For(static_cast<std::size_t>(level_.vertex_edges.Count(v)) + 2);
        std::size_t n = 0;
        ring[n++] = OtherEnd(e, v);
        const Faces faces = FacesAt(e);
        const Index end = Walk(v, e, faces.first, ring, n);
        if (end == e) return {true, {ring, n - 1}};  // the walk came back to its first vertex
        const std::size_t n_first = n;
        const Index start = Walk(v, e, faces.second, ring, n);
        std::reverse(ring + n_first, ring + n);
        if (start == end) {
            std::copy(ring + n_first + 1, ring + n, ring + n_first);  // the vertex where both ended stands twice
            return {true, {ring, n - 1}};
        }
        std::rotate(ring, ring + n_first, ring + n);
        return {false, {ring, n}, static_cast<int>(n - n_first), start};
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
    /// The two of the surface among several. Out of line: the usual case is short where it is asked for.
    [[gnu::noinline]] Faces BoundaryFacesOf(std::span<const Index> all) const {
        Faces faces{kNoIndex, kNoIndex};
        for (Index f : all) {
            if (level_.face_tags[f].is_boundary()) (faces.first == kNoIndex ? faces.first : faces.second) = f;
        }
        return faces;
    }

    Index OtherEnd(Index e, Index v) const {
        const auto ends = level_.EdgeVertices(e);
        return ends[0] + ends[1] - v;
    }

    /// Turns around v from edge e over face f, appending vertices, until an edge ends the surface or e is met again.
    /// Returns that edge.
    Index Walk(Index v, Index e, Index f, Index* ring, std::size_t& n) const {
        Index last = OtherEnd(e, v);
        while (true) {
            const Index next = EdgeOpposite(f, last);
            last = OtherEnd(next, v);
            ring[n++] = last;
            if (next == e || EndsSurface(next)) return next;
            f = Across(next, f);
        }
    }

    const Level& level_;
    const SharpRules& sharp_;
};

}  // namespace SolidSubdiv::Far::Internal

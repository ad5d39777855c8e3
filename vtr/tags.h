// SPDX-License-Identifier: Apache-2.0
// What kind of place a vertex, an edge or a face is: one byte each, decided once on the control mesh and inherited.
//
// Rules are of dimension 3 (inside a solid), 2 (on a surface) or 1 (on a curve); rules.md section 7 says which governs
// where parts of different dimension meet. A child vertex or edge lies inside its parent component and is the same kind
// of place, so refinement copies tags and never looks at links again.
#pragma once

#include <cstdint>

namespace SolidSubdiv::Vtr {

/// Which rule places a new point.
enum class Rule : std::uint8_t {
    Solid = 0,    ///< inside a solid
    Surface = 1,  ///< on the boundary of a solid, or inside a surface
    Curve = 2,    ///< on a crease (of vertices: two creases meet), a surface's border, or a curve
    Corner = 3    ///< vertices only: stays
};

/// Tag of a vertex or an edge.
struct Tag {
    std::uint8_t bits = 0;

    enum : std::uint8_t {
        kRuleMask = 3,
        kInCell = 4,        ///< some cell has it
        kInFace = 8,        ///< some face has it
        kNonManifold = 16,  ///< the complex around it is no ball, half ball, disc, half disc or curve
        kOneCell = 32,      ///< exactly one cell has it
        kHalfBall = 64      ///< edges: the solid along it has exactly two boundary faces
    };

    Rule rule() const { return static_cast<Rule>(bits & kRuleMask); }
    bool in_cell() const { return (bits & kInCell) != 0; }
    bool in_face() const { return (bits & kInFace) != 0; }
    bool non_manifold() const { return (bits & kNonManifold) != 0; }
    bool one_cell() const { return (bits & kOneCell) != 0; }
    bool half_ball() const { return (bits & kHalfBall) != 0; }

    friend bool operator==(Tag, Tag) = default;
};

inline Tag MakeTag(Rule rule, int flags) { return {static_cast<std::uint8_t>(static_cast<int>(rule) | flags)}; }

/// Tag of the vertex that a split puts on an edge. Along a seam of a solid's boundary and a sheet the edge follows the
/// curve rule and its point the solid's surface, since the highest dimension governs vertices.
inline Tag TagOfEdgePoint(Tag edge) {
    const int kept = edge.bits & (Tag::kInCell | Tag::kInFace | Tag::kNonManifold);
    const bool on_solid_surface = edge.rule() == Rule::Curve && edge.half_ball();
    return MakeTag(on_solid_surface ? Rule::Surface : edge.rule(), kept);
}

/// Tag of a face: how many tets and octs it bounds, two together at most. None: a surface element.
struct FaceTag {
    std::uint8_t bits = 0;

    int n_tets() const { return bits & 3; }
    int n_octs() const { return (bits >> 2) & 3; }
    int n_cells() const { return n_tets() + n_octs(); }
    bool is_boundary() const { return n_cells() < 2; }

    friend bool operator==(FaceTag, FaceTag) = default;
};

inline FaceTag MakeFaceTag(int n_tets, int n_octs) { return {static_cast<std::uint8_t>(n_tets | (n_octs << 2))}; }

/// Tags of the four children of a face: at its corners the cells are of the parents' kinds; the middle one bounds the
/// oct inside each tet and the tet at this face of each oct.
inline FaceTag TagOfMiddleFace(FaceTag face) { return MakeFaceTag(face.n_octs(), face.n_tets()); }

/// Tag of an edge that a split puts on a face.
inline Tag TagOfFaceEdge(FaceTag face) {
    switch (face.n_cells()) {
        case 2:
            return MakeTag(Rule::Solid, Tag::kInCell | Tag::kInFace);
        case 1:
            return MakeTag(Rule::Surface, Tag::kInCell | Tag::kInFace | Tag::kHalfBall);
        default:
            return MakeTag(Rule::Surface, Tag::kInFace);
    }
}

/// Tag of a vertex that a split puts inside a face.
inline Tag TagOfFacePoint(FaceTag face) {
    const Tag edge = TagOfFaceEdge(face);
    return MakeTag(edge.rule(), edge.bits & (Tag::kInCell | Tag::kInFace));
}

/// Tag of an edge or a vertex that a split puts inside a cell.
inline Tag TagInsideCell() { return MakeTag(Rule::Solid, Tag::kInCell | Tag::kInFace); }

}  // namespace SolidSubdiv::Vtr

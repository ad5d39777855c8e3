// SPDX-License-Identifier: Apache-2.0
// A state's pocket is split as a mesh of its own; its children's pockets are found in the split.
#include <algorithm>
#include <cassert>

#include <solidsubdiv/far/internal/limit_states.h>
#include <solidsubdiv/far/internal/row_buffer.h>
#include <solidsubdiv/far/internal/with_rows.h>
#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/vtr/base_level.h>
#include <solidsubdiv/vtr/polyhedral_base.h>
#include <solidsubdiv/vtr/polyhedral_refinement.h>
#include <solidsubdiv/vtr/refinement.h>

namespace SolidSubdiv::Far::Internal {

/// Splits a pocket and finds what its root's children need.
class LimitExpansion {
  public:
    LimitExpansion(LimitStates& states, const Pocket& pocket, RowsOfChildren& rows)
        : states_(states), pocket_(pocket), table_(rows) {}

    std::vector<Transition> Run() { return pocket_.is_tet_oct ? RunTetOct() : RunPolyhedral(); }

  private:
    std::vector<Transition> RunTetOct() {
        Vtr::BaseElements elements{.n_vertices = pocket_.n_vertices()};
        elements.tets = pocket_.tets;
        elements.octs = pocket_.octs;
        elements.triangles = pocket_.faces.vertices;
        elements.edges = pocket_.edges;
        Vtr::BaseFindings findings;
        const Level parent = Vtr::MakeBaseLevel(elements, findings);
        assert(findings.IsUsable());
        const Level child = Vtr::Refine(parent, true);
        std::vector<Index> children;
        if (pocket_.root == RootKind::Tet) {
            children = {0, 1, 2, 3, child.n_tets};
        } else if (pocket_.root == RootKind::Oct) {
            for (Index i = 0; i < 8; ++i) children.push_back(4 * parent.n_tets + i);
            for (Index i = 0; i < 6; ++i) children.push_back(child.n_tets + parent.n_tets + i);
        } else {
            for (Index i = 0; i < 4; ++i) children.push_back(BoundaryFace(child, 4 * RootFace(parent) + i));
        }
        return Follow(parent, child, children);
    }

    std::vector<Transition> RunPolyhedral() {
        Vtr::PolyhedralElements elements{.n_vertices = pocket_.n_vertices()};
        elements.hexes = pocket_.hexes;
        elements.cell_offsets = pocket_.cell_offsets;
        elements.face_offsets = pocket_.cell_faces.offsets;
        elements.face_vertices = pocket_.cell_faces.vertices;
        elements.polygon_offsets = pocket_.faces.offsets;
        elements.polygon_vertices = pocket_.faces.vertices;
        elements.edges = pocket_.edges;
        Vtr::PolyhedralFindings findings;
        const Vtr::PolyhedralLevel parent = Vtr::MakePolyhedralBaseLevel(elements, findings);
        assert(findings.IsUsable());
        const Vtr::PolyhedralLevel child = Vtr::Refine(parent, true);
        std::vector<Index> children;
        if (pocket_.root == RootKind::Hex) {
            for (Index i = 0; i < 8; ++i) children.push_back(i);
        } else if (pocket_.root == RootKind::Polyhedron) {
            // Its children come first among those of cells other than hexahedra: hexahedra, then the others.
            const Vtr::Polyhedra& cells = parent.polyhedra;
            Index hex = 8 * parent.n_hexes, other = child.n_hexes;
            for (Offset i = 0; i < cells.vertex_offsets[1]; ++i) {
                children.push_back(cells.ring_offsets[i + 1] - cells.ring_offsets[i] == 3 ? hex++ : other++);
            }
        } else {
            Offset first = 0;  // of the root's children: as many as corners of the faces before it
            for (Index f = 0; f < RootFace(parent); ++f) first += static_cast<Offset>(parent.FaceVertices(f).size());
            for (Index i = 0; i < pocket_.n_root_vertices; ++i) {
                children.push_back(BoundaryFace(child, static_cast<Index>(first) + i));
            }
        }
        return Follow(parent, child, children);
    }

    /// The root's number among the faces: the one with its vertices, 0, 1, .., and no others.
    template <class AnyLevel>
    Index RootFace(const AnyLevel& level) const {
        for (Index f = 0; f < level.n_faces; ++f) {
            const auto v = level.FaceVertices(f);
            if (static_cast<Index>(v.size()) == pocket_.n_root_vertices &&
                *std::max_element(v.begin(), v.end()) < pocket_.n_root_vertices) {
                return f;
            }
        }
        assert(false);
        return 0;
    }
    template <class AnyLevel>
    static Index BoundaryFace(const AnyLevel& level, Index face) {
        const auto found = std::lower_bound(level.boundary_faces.begin(), level.boundary_faces.end(), face);
        return static_cast<Index>(found - level.boundary_faces.begin());
    }

    template <class AnyLevel>
    std::vector<Transition> Follow(const AnyLevel& parent, const AnyLevel& child, const std::vector<Index>& children) {
        const Sharpness sharpness = SharpnessOf(parent);
        const Sdc::CreasingMethod method =
            std::visit([](const auto& s) { return CreaseOptionsOf(s).method; }, states_.scheme_);
        const Sharpness child_sharpness =
            ChildrenSharpness(Vtr::EdgeGraph(parent), child.n_edges, child.n_vertices, sharpness, method);
        PocketMaker maker(child, child_sharpness, states_.reach_, states_.elements_);
        std::vector<Transition> transitions;
        std::vector<Pocket> pockets;
        for (Index c : children) {
            pockets.push_back(maker.Make(c));
            Transition& t = transitions.emplace_back();
            SetCoordinates(parent, pockets.back(), t);
            t.state = &states_.Find(pockets.back());
        }
        std::vector<Index> number(static_cast<std::size_t>(child.n_vertices), kNoIndex);
        const auto fill = [&](const auto& rows) {
            for (std::size_t i = 0; i < transitions.size(); ++i) {
                for (Index v : pockets[i].vertices) {
                    Index& row = number[static_cast<std::size_t>(v)];
                    if (row == kNoIndex && IsKnown(parent, v)) row = AddRow(rows, v);
                    transitions[i].rows.push_back(row);
                }
            }
        };
        if constexpr (std::is_same_v<AnyLevel, Level>) {
            WithTetOctScheme(states_.scheme_, [&]<class S>(const S& s) { fill(Rows<S>(parent, sharpness, s)); });
        } else {
            WithPolyhedralScheme(states_.scheme_, [&](const auto& s) {
                fill(PolyhedralRows(parent, sharpness, s.polyhedral(), CreaseOptionsOf(s).method));
            });
        }
        return transitions;
    }

    template <class AnyLevel>
    Sharpness SharpnessOf(const AnyLevel& level) const {
        Sharpness sharpness;
        if (pocket_.crease_sharpness.empty() && pocket_.corner_sharpness.empty()) return sharpness;
        sharpness.edges.assign(static_cast<std::size_t>(level.n_edges), 0.0f);
        sharpness.vertices.assign(static_cast<std::size_t>(level.n_vertices), 0.0f);
        for (std::size_t i = 0; i < pocket_.crease_sharpness.size(); ++i) {
            const Index e = level.FindEdge(pocket_.crease_edges[2 * i], pocket_.crease_edges[2 * i + 1]);
            if (e != kNoIndex) sharpness.edges[e] = pocket_.crease_sharpness[i];
        }
        for (std::size_t i = 0; i < pocket_.corner_sharpness.size(); ++i) {
            sharpness.vertices[pocket_.corner_vertices[i]] = pocket_.corner_sharpness[i];
        }
        return sharpness;
    }

    /// Calls body(kind, vertices of the parent component that the point of a child vertex comes from).
    enum class Feature { Vertex, Edge, Face, Cell };
    template <class Body>
    static void WithFeature(const Level& parent, Index child, Body&& body) {
        if (child < parent.n_vertices) return body(Feature::Vertex, std::span<const Index>(&child, 1));
        child -= parent.n_vertices;
        if (child < parent.n_edges) return body(Feature::Edge, std::span<const Index>(parent.EdgeVertices(child)));
        // The centre lies in the middle of the major diagonal, and of all vertices as well.
        body(Feature::Cell, std::span<const Index>(parent.OctVertices(child - parent.n_edges)).first(2));
    }
    template <class Body>
    static void WithFeature(const Vtr::PolyhedralLevel& parent, Index child, Body&& body) {
        if (child < parent.n_vertices) return body(Feature::Vertex, std::span<const Index>(&child, 1));
        child -= parent.n_vertices;
        if (child < parent.n_edges) return body(Feature::Edge, std::span<const Index>(parent.EdgeVertices(child)));
        child -= parent.n_edges;
        if (child < parent.n_faces) return body(Feature::Face, parent.FaceVertices(child));
        body(Feature::Cell, parent.CellVertices(child - parent.n_faces));
    }

    /// Where the child lies in the root's coordinates, which its own come from.
    template <class AnyLevel>
    void SetCoordinates(const AnyLevel& parent, const Pocket& child, Transition& t) const {
        const bool has_parts = pocket_.root == RootKind::Polyhedron ||
                               (pocket_.root == RootKind::Face && !pocket_.is_tet_oct && pocket_.n_root_vertices != 4);
        std::vector<Coordinates> corners;
        if (!has_parts) corners = CornersOf(pocket_.root, pocket_.n_root_vertices);
        std::vector<Coordinates> places;
        for (Index i = 0; i < child.n_root_vertices; ++i) {
            const Index v = child.vertices[static_cast<std::size_t>(i)];
            t.children.push_back(v < pocket_.n_root_vertices ? v : kNoIndex);
            WithFeature(parent, v, [&](Feature, std::span<const Index> from) {
                if (has_parts) {
                    std::vector<Index>& feature = t.features.emplace_back(from.begin(), from.end());
                    std::sort(feature.begin(), feature.end());
                    return;
                }
                Coordinates mean{};
                for (Index w : from) {
                    for (std::size_t a = 0; a < 3; ++a) {
                        mean[a] += corners[static_cast<std::size_t>(w)][a] / static_cast<double>(from.size());
                    }
                }
                places.push_back(mean);
            });
        }
        if (has_parts) return;
        const auto frame = FrameOf(child.root, places);
        Matrix3 axes;
        for (std::size_t r = 0; r < 3; ++r) {
            for (std::size_t c = 0; c < 3; ++c) axes[r][c] = frame[c + 1][r];
        }
        t.matrix = Inverse(axes);
        for (std::size_t r = 0; r < 3; ++r) {
            for (std::size_t c = 0; c < 3; ++c) t.shift[r] -= t.matrix[r][c] * frame[0][c];
        }
    }

    bool IsKnown(Feature feature, std::span<const Index> from) const {
        const auto is_complete = [&](Index v) { return pocket_.is_complete[static_cast<std::size_t>(v)] != 0; };
        const Reach& reach = states_.reach_;
        switch (feature) {
            case Feature::Vertex:
                return reach.interpolates || is_complete(from[0]);
            case Feature::Edge:
                if (reach.edges_need_both_ends) return is_complete(from[0]) && is_complete(from[1]);
                return is_complete(from[0]) || is_complete(from[1]) || pocket_.HasCompleteEdge(from[0], from[1]);
            case Feature::Face:
                return std::any_of(from.begin(), from.end(), is_complete);
            default:
                return !reach.interpolates || std::all_of(from.begin(), from.end(), is_complete);
        }
    }

    template <class AnyLevel>
    bool IsKnown(const AnyLevel& parent, Index child) const {
        bool is_known = false;
        WithFeature(parent, child, [&](Feature f, std::span<const Index> from) { is_known = IsKnown(f, from); });
        return is_known;
    }
    template <class AnyRows>
    Index AddRow(const AnyRows& rows, Index child) {
        row_.Read(rows, child);
        table_.indices.insert(table_.indices.end(), row_.Indices().begin(), row_.Indices().end());
        table_.weights.insert(table_.weights.end(), row_.Weights().begin(), row_.Weights().end());
        table_.offsets.push_back(static_cast<std::uint32_t>(table_.indices.size()));
        return static_cast<Index>(table_.offsets.size()) - 2;
    }

    LimitStates& states_;
    const Pocket& pocket_;
    RowsOfChildren& table_;
    RowBuffer<double> row_;
};

void LimitStates::Expand(LimitState& state) {
    std::call_once(state.expansion, [&] {
        const Sdc::SerialScope serial;  // other threads may wait for this
        state.children = LimitExpansion(*this, state.pocket, state.rows).Run();
        state.pocket = {};
        Offset bytes = state.rows.Bytes();
        for (const Transition& t : state.children) bytes += static_cast<Offset>(t.rows.size() * sizeof(Index));
        bytes_ += bytes;
    });
}

}  // namespace SolidSubdiv::Far::Internal

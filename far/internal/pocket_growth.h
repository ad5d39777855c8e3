// SPDX-License-Identifier: Apache-2.0
// Pockets grow across faces (of surfaces: across edges); new vertices are numbered by those that they lie across.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <solidsubdiv/far/internal/pocket_complexes.h>
#include <solidsubdiv/far/internal/pocket_order.h>
#include <solidsubdiv/far/internal/sharpness.h>

namespace SolidSubdiv::Far::Internal {

class PocketSource {
  public:
    virtual ~PocketSource() = default;
    virtual Pocket Make(Index element) = 0;
};

template <class Complex>
class PocketGrowth final : public PocketSource {
  public:
    template <class AnyLevel>
    PocketGrowth(const AnyLevel& level, const Sharpness& sharpness, const Reach& reach)
        : complex_(level),
          sharpness_(sharpness),
          reach_(reach),
          element_mark_(static_cast<std::size_t>(complex_.size()), 0),
          vertex_mark_(static_cast<std::size_t>(level.n_vertices), 0),
          side_mark_(static_cast<std::size_t>(complex_.n_sides()), 0),
          numbers_(static_cast<std::size_t>(level.n_vertices), kUnnumbered),
          side_elements_(static_cast<std::size_t>(complex_.n_sides())) {
        if constexpr (!Complex::kAreFaces) {
            for (Index f = 0; f < level.n_faces && !has_sheets_; ++f) has_sheets_ = complex_.IsSheet(f);
        }
        for (Index e = 0; e < level.n_edges && !has_curves_; ++e) has_curves_ = level.edge_faces.Count(e) == 0;
        if constexpr (Complex::kAreFaces) {
            for (Index v = 0; v < level.n_vertices && !solid_; ++v) {
                if (IsPinched(complex_.level(), v)) solid_.emplace(level);
            }
        }
    }

    Pocket Make(Index root) override {
        ++stamp_;
        elements_.clear();
        complete_.clear();
        opposite_edges_.clear();
        const auto corners = complex_.Vertices(root);
        for (Index v : corners) Complete(v);
        if constexpr (std::is_same_v<Complex, TetOctCells>) AddAcrossTets(corners);
        for (int ring = 0; ring < reach_.n_rings; ++ring) {
            const std::size_t n = elements_.size();
            for (std::size_t i = 0; i < n; ++i) {
                for (Index v : complex_.Vertices(elements_[i])) Complete(v);
            }
            opposite_edges_.clear();
        }
        pocket_ = {};
        pocket_.root = complex_.KindOf(root);
        pocket_.is_tet_oct = std::is_same_v<std::remove_cvref_t<decltype(complex_.level())>, Level>;
        pocket_.n_root_vertices = static_cast<Index>(corners.size());
        for (Index v : corners) Number(v);
        GrowFrom(root);
        if (has_sheets_ || has_curves_) AddThinParts();
        if constexpr (Complex::kAreFaces) {
            if (solid_ && std::any_of(complete_.begin(), complete_.end(),
                                      [&](Index v) { return IsPinched(complex_.level(), v); })) {
                AddCells();
            }
        }
        pocket_.is_complete.assign(pocket_.vertices.size(), 0);
        for (Index v : complete_) pocket_.is_complete[NumberOf(v)] = 1;
        AddCompleteEdges();
        if (!sharpness_.empty()) AddSharpness();
        for (Index v : pocket_.vertices) numbers_[static_cast<std::size_t>(v)] = kUnnumbered;
        return std::move(pocket_);
    }

  private:
    std::size_t NumberOf(Index v) const { return static_cast<std::size_t>(numbers_[static_cast<std::size_t>(v)]); }
    bool HasNumber(Index v) const { return numbers_[static_cast<std::size_t>(v)] != kUnnumbered; }
    void Number(Index v) {
        if (HasNumber(v)) return;
        numbers_[static_cast<std::size_t>(v)] = static_cast<Index>(pocket_.vertices.size());
        pocket_.vertices.push_back(v);
    }

    /// Takes in all elements at a vertex.
    void Complete(Index v) {
        if (std::exchange(vertex_mark_[static_cast<std::size_t>(v)], stamp_) == stamp_) return;
        complete_.push_back(v);
        complex_.ForElementsAt(v, [&](Index c) { Take(c); });
    }
    bool IsComplete(Index v) const { return vertex_mark_[static_cast<std::size_t>(v)] == stamp_; }
    void Take(Index c) {
        if (std::exchange(element_mark_[static_cast<std::size_t>(c)], stamp_) != stamp_) elements_.push_back(c);
    }

    /// Takes in the cells at those edges of tets that lie opposite to the root's vertices. Where B edges alone matter,
    /// at those opposite to the root's edges: new points on such an edge look, past the octahedron in a tet beyond it,
    /// at the B edge of that tet if it is another one, and so on around the root's vertex.
    void AddAcrossTets(std::span<const Index> corners) {
        if (!reach_.b_edges_only) {
            const std::size_t n = elements_.size();
            for (std::size_t i = 0; i < n; ++i) {
                if (complex_.KindOf(elements_[i]) != RootKind::Tet) continue;
                const auto t = complex_.Vertices(elements_[i]);
                for (const auto& edge : Sdc::Tet::edges) TakeAtEdge(t[edge[0]], t[edge[1]]);
            }
            return;
        }
        for (Index v : corners) AddAcrossVertex(v);
    }
    void AddAcrossVertex(Index v) {
        std::vector<std::array<Index, 2>> edges;
        const auto add = [&](std::array<Index, 2> edge) {
            if (edge[0] > edge[1]) std::swap(edge[0], edge[1]);
            if (std::find(edges.begin(), edges.end(), edge) != edges.end()) return;
            edges.push_back(edge);
            TakeAtEdge(edge[0], edge[1]);
        };
        complex_.ForElementsAt(v, [&](Index t) {
            if (complex_.KindOf(t) == RootKind::Tet && IsComplete(complex_.NearBEnd(t, v)))
                add(complex_.FarBEdge(t, v));
        });
        for (std::size_t i = 0; i < edges.size(); ++i) {
            const auto [a, b] = edges[i];
            ForElementsWith(a, b, [&](Index t) {
                const auto w = complex_.Vertices(t);
                const bool has_v = std::find(w.begin(), w.end(), v) != w.end();
                if (has_v && complex_.KindOf(t) == RootKind::Tet) add(complex_.FarBEdge(t, v));
            });
        }
    }
    template <class Body>
    void ForElementsWith(Index a, Index b, Body&& body) const {
        complex_.ForElementsAt(a, [&](Index c) {
            const auto v = complex_.Vertices(c);
            if (std::find(v.begin(), v.end(), b) != v.end() && !complex_.AreAcross(c, a, b)) body(c);
        });
    }
    void TakeAtEdge(Index a, Index b) {
        if (IsComplete(a) || IsComplete(b)) return;
        opposite_edges_.push_back({a, b});
        ForElementsWith(a, b, [&](Index c) { Take(c); });
    }

    /// Numbers vertices and lists elements, from the root across sides.
    void GrowFrom(Index root) {
        for (Index c : elements_) {
            for (Index s : complex_.Sides(c)) {
                auto& found = side_elements_[static_cast<std::size_t>(s)];
                const bool is_new = std::exchange(side_mark_[static_cast<std::size_t>(s)], stamp_) != stamp_;
                if (is_new)
                    found = {c, kNoIndex};
                else if (found[1] == kNoIndex)
                    found[1] = c;
                else
                    found[1] = kManyElements;
            }
        }
        queue_.clear();
        Enter(root, root);
        for (std::size_t head = 0;; ++head) {
            if (head == queue_.size() && !EnterNearest(root)) break;
            const Index c = queue_[head];
            sides_.clear();
            for (Index s : complex_.Sides(c)) {
                if (IsWaiting(Beyond(s, c))) sides_.push_back({PackSide(s), s});
            }
            std::sort(sides_.begin(), sides_.end());
            for (const auto& [key, s] : sides_) {
                const Index other = Beyond(s, c);
                if (IsWaiting(other)) Enter(other, root);  // an element may lie across two sides
            }
        }
    }
    /// The other element at a side, if there is one and no more.
    Index Beyond(Index side, Index c) const {
        const auto& [first, second] = side_elements_[static_cast<std::size_t>(side)];
        return second < 0 ? kNoIndex : first == c ? second : first;
    }
    bool IsWaiting(Index c) const { return c != kNoIndex && element_mark_[static_cast<std::size_t>(c)] == stamp_; }
    std::uint64_t PackSide(Index s) { return PackNumbered(complex_.SideVertices(s)); }
    std::uint64_t PackNumbered(std::span<const Index> vertices) {
        listed_.clear();
        for (Index v : vertices) {
            if (HasNumber(v)) listed_.push_back(numbers_[static_cast<std::size_t>(v)]);
        }
        return Pack(listed_);
    }

    /// Numbers an element's new vertices and lists it. Entered elements lose their mark.
    void Enter(Index c, Index root) {
        element_mark_[static_cast<std::size_t>(c)] = 0;
        queue_.push_back(c);
        const auto corners = complex_.Vertices(c);
        fresh_.clear();
        for (Index v : corners) {
            if (HasNumber(v)) continue;
            Index across = 0xFFFF;
            for (Index w : corners) {
                if (HasNumber(w) && complex_.AreAcross(c, v, w)) {
                    across = std::min(across, numbers_[static_cast<std::size_t>(w)]);
                }
            }
            fresh_.push_back({across, v});
        }
        std::stable_sort(fresh_.begin(), fresh_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        for (const auto& [across, v] : fresh_) Number(v);
        List(complex_, c, c == root);
    }
    /// Enters the element that meets what is there in the least numbers; false if none is left.
    bool EnterNearest(Index root) {
        Index nearest = kNoIndex;
        std::uint64_t least = ~std::uint64_t{0};
        for (Index c : elements_) {
            if (element_mark_[static_cast<std::size_t>(c)] != stamp_) continue;
            const std::uint64_t key = PackNumbered(complex_.Vertices(c));
            if (nearest == kNoIndex || key < least) {
                nearest = c;
                least = key;
            }
        }
        if (nearest == kNoIndex) return false;
        Enter(nearest, root);
        return true;
    }

    /// Adds an element to the pocket, its vertices in an order that its numbers decide; the root's as it is.
    template <class AnyComplex>
    void List(const AnyComplex& complex, Index c, bool is_root) {
        std::vector<Index>& v = listed_;
        v.clear();
        for (Index x : complex.Vertices(c)) v.push_back(numbers_[static_cast<std::size_t>(x)]);
        switch (complex.KindOf(c)) {
            case RootKind::Tet:
                if (!is_root) SortPairs(v);
                pocket_.tets.insert(pocket_.tets.end(), v.begin(), v.end());
                break;
            case RootKind::Oct:
                if (!is_root) SortPairs(v);
                pocket_.octs.insert(pocket_.octs.end(), v.begin(), v.end());
                break;
            case RootKind::Hex:
                if (!is_root) SortHex(v);
                pocket_.hexes.insert(pocket_.hexes.end(), v.begin(), v.end());
                break;
            case RootKind::Polyhedron:
                ListPolyhedron(complex, c, is_root);
                break;
            case RootKind::Face:
                if (!is_root) Rotate(v);
                pocket_.faces.Add(v);
                break;
        }
    }
    template <class AnyComplex>
    void ListPolyhedron([[maybe_unused]] const AnyComplex& complex, [[maybe_unused]] Index c,
                        [[maybe_unused]] bool is_root) {
        if constexpr (std::is_same_v<AnyComplex, PolyhedralCells>) {
            const Vtr::Polyhedra& p = complex.level().polyhedra;
            const Index i = c - complex.level().n_hexes;
            std::vector<std::vector<Index>> faces;
            for (Offset f = p.offsets[i]; f < p.offsets[i + 1]; ++f) {
                std::vector<Index>& face = faces.emplace_back();
                for (Offset k = p.face_vertex_offsets[f]; k < p.face_vertex_offsets[f + 1]; ++k) {
                    face.push_back(numbers_[static_cast<std::size_t>(p.face_vertices[k])]);
                }
                if (!is_root) Rotate(face);
            }
            if (!is_root) std::sort(faces.begin(), faces.end());
            for (const auto& face : faces) pocket_.cell_faces.Add(face);
            pocket_.cell_offsets.push_back(pocket_.cell_faces.size());
        }
    }

    /// Faces in no cell and edges in no face at complete vertices and edges.
    void AddThinParts() {
        const auto& level = complex_.level();
        std::vector<Index> sheets, curves;
        const auto look_at = [&](Index e) {
            if (level.edge_faces.Count(e) == 0) curves.push_back(e);
            if constexpr (!Complex::kAreFaces) {
                for (Index f : level.edge_faces[e]) {
                    if (complex_.IsSheet(f)) sheets.push_back(f);
                }
            }
        };
        for (Index v : complete_) {
            for (Index e : level.vertex_edges[v]) look_at(e);
        }
        for (const auto& [a, b] : opposite_edges_) look_at(level.FindEdge(a, b));
        const auto add_all = [&](std::vector<Index>& parts, auto&& vertices_of, auto&& list) {
            std::sort(parts.begin(), parts.end());
            parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
            std::vector<std::vector<Index>> lists;
            for (Index part : parts) {
                for (Index v : vertices_of(part)) Number(v);
                std::vector<Index>& numbers = lists.emplace_back();
                for (Index v : vertices_of(part)) numbers.push_back(numbers_[static_cast<std::size_t>(v)]);
                Rotate(numbers);
            }
            std::sort(lists.begin(), lists.end());
            for (const auto& numbers : lists) list(numbers);
        };
        if constexpr (!Complex::kAreFaces) {
            add_all(
                sheets, [&](Index f) { return level.FaceVertices(f); },
                [&](const std::vector<Index>& face) { pocket_.faces.Add(face); });
        }
        add_all(
            curves, [&](Index e) { return level.EdgeVertices(e); },
            [&](const std::vector<Index>& edge) {
                pocket_.edges.insert(pocket_.edges.end(), edge.begin(), edge.end());
            });
    }

    /// Of a pinched pocket of faces: the cells at its complete vertices.
    void AddCells() {
        std::vector<Index> cells;
        for (Index v : complete_) {
            solid_->ForElementsAt(v, [&](Index c) {
                if (std::find(cells.begin(), cells.end(), c) == cells.end()) cells.push_back(c);
            });
        }
        for (Index c : cells) {
            for (Index v : solid_->Vertices(c)) Number(v);
            List(*solid_, c, false);
        }
    }

    void AddCompleteEdges() {
        std::vector<std::array<Index, 2>> edges;
        for (const auto& [a, b] : opposite_edges_) {
            const Index i = numbers_[static_cast<std::size_t>(a)], k = numbers_[static_cast<std::size_t>(b)];
            edges.push_back({std::min(i, k), std::max(i, k)});
        }
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        for (const auto& e : edges) pocket_.complete_edges.insert(pocket_.complete_edges.end(), e.begin(), e.end());
    }

    /// Of complete vertices and edges.
    void AddSharpness() {
        const auto& level = complex_.level();
        std::vector<std::pair<std::array<Index, 2>, float>> creases;
        std::vector<std::pair<Index, float>> corners;
        const auto add_edge = [&](Index e) {
            const auto ends = level.EdgeVertices(e);
            if (!Sdc::IsSharp(sharpness_.edges[e]) || !HasNumber(ends[0]) || !HasNumber(ends[1])) return;
            const Index i = numbers_[static_cast<std::size_t>(ends[0])],
                        k = numbers_[static_cast<std::size_t>(ends[1])];
            creases.push_back({{std::min(i, k), std::max(i, k)}, sharpness_.edges[e]});
        };
        for (Index v : complete_) {
            const Index i = numbers_[static_cast<std::size_t>(v)];
            if (Sdc::IsSharp(sharpness_.vertices[v])) corners.push_back({i, sharpness_.vertices[v]});
            for (Index e : level.vertex_edges[v]) add_edge(e);
        }
        for (const auto& [a, b] : opposite_edges_) add_edge(level.FindEdge(a, b));
        std::sort(creases.begin(), creases.end());
        creases.erase(std::unique(creases.begin(), creases.end()), creases.end());
        std::sort(corners.begin(), corners.end());
        for (const auto& [ends, s] : creases) {
            pocket_.crease_edges.insert(pocket_.crease_edges.end(), ends.begin(), ends.end());
            pocket_.crease_sharpness.push_back(s);
        }
        for (const auto& [v, s] : corners) {
            pocket_.corner_vertices.push_back(v);
            pocket_.corner_sharpness.push_back(s);
        }
    }

    static constexpr Index kManyElements = -2;  // a side of more than two

    const Complex complex_;
    const Sharpness& sharpness_;
    const Reach reach_;
    bool has_sheets_ = false, has_curves_ = false;
    /// Of faces: the cells behind them, where they are needed anywhere.
    using LevelOfComplex = std::remove_cvref_t<decltype(std::declval<Complex>().level())>;
    std::optional<std::conditional_t<std::is_same_v<LevelOfComplex, Level>, TetOctCells, PolyhedralCells>> solid_;
    static constexpr Index kUnnumbered = -1;
    // Marks hold while they equal the stamp.
    std::uint32_t stamp_ = 0;
    std::vector<std::uint32_t> element_mark_, vertex_mark_, side_mark_;
    std::vector<Index> numbers_;  // of the level's vertices, while a pocket is made
    std::vector<std::array<Index, 2>> side_elements_;
    std::vector<Index> elements_, complete_, queue_, listed_;
    std::vector<std::array<Index, 2>> opposite_edges_;
    std::vector<std::pair<std::uint64_t, Index>> sides_;
    std::vector<std::pair<Index, Index>> fresh_;
    Pocket pocket_;
};

}  // namespace SolidSubdiv::Far::Internal

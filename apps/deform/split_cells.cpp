// SPDX-License-Identifier: Apache-2.0
// Children of chosen cells come from a uniform split; what lies beside them is put together from what it keeps.
#include <solidsubdiv/apps/deform/split_cells.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace SolidSubdiv::Deform {

namespace {

using Vtr::PolyhedralLevel;

/// Cells of each kind while they are collected, with what they are parts of.
class Builder {
  public:
    void Add(std::vector<Index> ControlLattice::*kind, std::span<const Index> vertices, Index parent) {
        auto& list = lattice_.*kind;
        list.insert(list.end(), vertices.begin(), vertices.end());
        ParentsOf(kind).push_back(parent);
    }
    void AddFace(std::span<const Index> vertices) {
        if (lattice_.polyhedron_offsets.empty()) {
            lattice_.polyhedron_offsets = lattice_.polyhedron_face_offsets = {0};
        }
        auto& list = lattice_.polyhedron_vertices;
        list.insert(list.end(), vertices.begin(), vertices.end());
        lattice_.polyhedron_face_offsets.push_back(static_cast<Offset>(list.size()));
    }
    /// Ends the polyhedron whose faces were added.
    void EndPolyhedron(Index parent) {
        lattice_.polyhedron_offsets.push_back(static_cast<Offset>(lattice_.polyhedron_face_offsets.size()) - 1);
        polyhedron_parents_.push_back(parent);
    }
    /// Everything but the positions.
    void Finish(SplitLattice& split) {
        split.lattice = std::move(lattice_);
        for (const auto* parents : {&hex_parents_, &tet_parents_, &oct_parents_, &polyhedron_parents_}) {
            split.parents.insert(split.parents.end(), parents->begin(), parents->end());
        }
    }

  private:
    std::vector<Index>& ParentsOf(std::vector<Index> ControlLattice::*kind) {
        return kind == &ControlLattice::hexes  ? hex_parents_
               : kind == &ControlLattice::tets ? tet_parents_
                                               : oct_parents_;
    }

    ControlLattice lattice_;
    std::vector<Index> hex_parents_, tet_parents_, oct_parents_, polyhedron_parents_;
};

class Splitter {
  public:
    Splitter(const ControlLattice& lattice, const Far::TopologyRefiner& refiner, std::span<const Index> cells)
        : lattice_(lattice),
          coarse_(refiner.polyhedral_level(0)),
          fine_(refiner.polyhedral_level(1)),
          cell_splits_(static_cast<std::size_t>(coarse_.n_cells()), false),
          edge_splits_(static_cast<std::size_t>(coarse_.n_edges), false),
          face_splits_(static_cast<std::size_t>(coarse_.n_faces), false) {
        for (Index c : cells) {
            cell_splits_[static_cast<std::size_t>(c)] = true;
            for (Index e : coarse_.CellEdges(c)) edge_splits_[static_cast<std::size_t>(e)] = true;
            for (Index f : coarse_.CellFaces(c)) face_splits_[static_cast<std::size_t>(f)] = true;
        }
    }

    SplitLattice Split() {
        SplitLattice split;
        NumberPoints(split.rows);
        for (Index c = 0; c < static_cast<Index>(coarse_.n_cells()); ++c) {
            if (cell_splits_[static_cast<std::size_t>(c)]) {
                AddChildren(c);
            } else {
                AddWhole(c);
            }
        }
        builder_.Finish(split);
        split.lattice.positions.assign(3 * static_cast<std::size_t>(split.rows.n_rows()), 0.);
        for (Index v = 0; v < split.rows.n_rows(); ++v) {
            const auto sources = split.rows.Indices(v);
            const auto weights = split.rows.Weights(v);
            for (std::size_t k = 0; k < sources.size(); ++k) {
                for (std::size_t x = 0; x < 3; ++x) {
                    split.lattice.positions[3 * static_cast<std::size_t>(v) + x] +=
                        weights[k] * lattice_.positions[3 * static_cast<std::size_t>(sources[k]) + x];
                }
            }
        }
        return split;
    }

  private:
    /// Numbers the points of the fine level that are used, ascending, and writes what they are means of.
    void NumberPoints(Far::StencilRows<double>& rows) {
        numbers_.assign(static_cast<std::size_t>(fine_.n_vertices), kNoIndex);
        rows.n_sources = coarse_.n_vertices;
        const auto add = [&](Index point, std::span<const Index> corners) {
            numbers_[static_cast<std::size_t>(point)] = rows.n_rows();
            std::vector<Index> sorted(corners.begin(), corners.end());
            std::sort(sorted.begin(), sorted.end());
            rows.indices.insert(rows.indices.end(), sorted.begin(), sorted.end());
            rows.weights.insert(rows.weights.end(), sorted.size(), 1. / static_cast<double>(sorted.size()));
            rows.offsets.push_back(static_cast<Offset>(rows.indices.size()));
        };
        for (Index v = 0; v < coarse_.n_vertices; ++v) add(v, std::span(&v, 1));
        for (Index e = 0; e < coarse_.n_edges; ++e) {
            if (edge_splits_[static_cast<std::size_t>(e)]) add(EdgePoint(e), coarse_.EdgeVertices(e));
        }
        for (Index f = 0; f < coarse_.n_faces; ++f) {
            if (face_splits_[static_cast<std::size_t>(f)]) add(FacePoint(f), coarse_.FaceVertices(f));
        }
        for (Index c = 0; c < static_cast<Index>(coarse_.n_cells()); ++c) {
            const Index point = coarse_.n_vertices + coarse_.n_edges + coarse_.n_faces + c;
            if (cell_splits_[static_cast<std::size_t>(c)]) add(point, coarse_.CellVertices(c));
            CountChildren(c);
        }
    }

    /// Children of hexahedra come first, then those of other cells: hexahedra at corners of three edges, what else
    /// there is after all of them (vtr/polyhedral_refinement.h).
    void CountChildren(Index c) {
        std::vector<Index>& children = children_.emplace_back();
        if (coarse_.IsHex(c)) {
            for (Index i = 0; i < Sdc::Hex::kVertices; ++i) children.push_back(Sdc::Hex::kVertices * c + i);
            next_hex_ = children.back() + 1;
            return;
        }
        const Vtr::Polyhedra& p = coarse_.polyhedra;
        const Index i = c - coarse_.n_hexes;
        for (Offset k = p.vertex_offsets[i]; k < p.vertex_offsets[i + 1]; ++k) {
            const bool is_hex = p.ring_offsets[k + 1] - p.ring_offsets[k] == 3;
            children.push_back(is_hex ? next_hex_++ : fine_.n_hexes + next_odd_++);
        }
    }

    void AddChildren(Index c) {
        std::vector<Index> vertices;
        const auto number = [&](std::span<const Index> points) {
            vertices.clear();
            for (Index point : points) vertices.push_back(numbers_[static_cast<std::size_t>(point)]);
            return std::span<const Index>(vertices);
        };
        for (Index child : children_[static_cast<std::size_t>(c)]) {
            if (fine_.IsHex(child)) {
                const auto first = fine_.hex_vertices.begin() + 8 * std::ptrdiff_t{child};
                builder_.Add(&ControlLattice::hexes, number({first, first + 8}), c);
                continue;
            }
            const Vtr::Polyhedra& p = fine_.polyhedra;
            const Index i = child - fine_.n_hexes;
            for (Offset f = p.offsets[i]; f < p.offsets[i + 1]; ++f) {
                const auto first = p.face_vertices.begin() + p.face_vertex_offsets[f];
                builder_.AddFace(number({first, p.face_vertices.begin() + p.face_vertex_offsets[f + 1]}));
            }
            builder_.EndPolyhedron(c);
        }
    }

    /// A cell that is not split: as it is, or with what is split around it.
    void AddWhole(Index c) {
        const auto edges = coarse_.CellEdges(c);
        const bool is_touched =
            std::any_of(edges.begin(), edges.end(), [&](Index e) { return edge_splits_[static_cast<std::size_t>(e)]; });
        if (!is_touched) return AddAsItIs(c);
        std::vector<Index> face;
        const auto faces = coarse_.CellFaces(c);
        for (std::size_t i = 0; i < faces.size(); ++i) {
            const std::vector<Index> v = FaceFromOutside(c, i);
            const auto middle_after = [&](std::size_t k) {
                const Index edge = coarse_.FindEdge(v[k], v[k + 1 < v.size() ? k + 1 : 0]);
                return numbers_[static_cast<std::size_t>(EdgePoint(edge))];
            };
            face.clear();
            for (std::size_t k = 0; k < v.size(); ++k) {
                const Index after = middle_after(k);
                if (face_splits_[static_cast<std::size_t>(faces[i])]) {
                    const Index middle = numbers_[static_cast<std::size_t>(FacePoint(faces[i]))];
                    const Index before = middle_after(k > 0 ? k - 1 : v.size() - 1);
                    builder_.AddFace(std::array<Index, 4>{v[k], after, middle, before});
                } else {
                    face.push_back(v[k]);
                    if (after != kNoIndex) face.push_back(after);
                }
            }
            if (!face.empty()) builder_.AddFace(face);
        }
        builder_.EndPolyhedron(c);
    }

    /// As the cell has it: a neighbour may be turned inside out.
    std::vector<Index> FaceFromOutside(Index c, std::size_t i) const {
        std::vector<Index> face;
        if (coarse_.IsHex(c)) {
            for (Sdc::Local k : Sdc::Hex::faces[i]) face.push_back(coarse_.CellVertices(c)[k]);
            return face;
        }
        const Vtr::Polyhedra& p = coarse_.polyhedra;
        const Offset f = p.offsets[c - coarse_.n_hexes] + static_cast<Offset>(i);
        return {p.face_vertices.begin() + p.face_vertex_offsets[f],
                p.face_vertices.begin() + p.face_vertex_offsets[f + 1]};
    }

    /// Keeps its kind and the order of its corners.
    void AddAsItIs(Index c) {
        Index i = c;
        for (auto [kind, corners] : {std::pair{&ControlLattice::hexes, 8}, std::pair{&ControlLattice::tets, 4},
                                     std::pair{&ControlLattice::octs, 6}}) {
            const std::vector<Index>& list = lattice_.*kind;
            const Index n = static_cast<Index>(list.size()) / corners;
            if (i < n) {
                const std::size_t size = static_cast<std::size_t>(corners);
                return builder_.Add(kind, std::span(list).subspan(size * static_cast<std::size_t>(i), size), c);
            }
            i -= n;
        }
        const std::size_t polyhedron = static_cast<std::size_t>(i);
        for (Offset f = lattice_.polyhedron_offsets[polyhedron]; f < lattice_.polyhedron_offsets[polyhedron + 1]; ++f) {
            const auto first = lattice_.polyhedron_vertices.begin();
            builder_.AddFace({first + lattice_.polyhedron_face_offsets[static_cast<std::size_t>(f)],
                              first + lattice_.polyhedron_face_offsets[static_cast<std::size_t>(f) + 1]});
        }
        builder_.EndPolyhedron(c);
    }

    Index EdgePoint(Index e) const { return coarse_.n_vertices + e; }
    Index FacePoint(Index f) const { return coarse_.n_vertices + coarse_.n_edges + f; }

    const ControlLattice& lattice_;
    const PolyhedralLevel &coarse_, &fine_;
    std::vector<bool> cell_splits_, edge_splits_, face_splits_;
    std::vector<Index> numbers_;                ///< of points of the fine level in the lattice that is made
    std::vector<std::vector<Index>> children_;  ///< of every cell, in the fine level
    Index next_hex_ = 0, next_odd_ = 0;
    Builder builder_;
};

}  // namespace

SplitLattice SplitCells(const ControlLattice& lattice, std::span<const Index> cells) {
    for (Index c : cells) {
        if (c >= 0 && c < lattice.n_cells()) continue;
        throw InvalidInput("cell " + std::to_string(c) + " is to be split; the lattice has " +
                           std::to_string(lattice.n_cells()) + " cells");
    }
    auto refiner = Far::TopologyRefiner::Create(lattice.View(), Sdc::Split::Polyhedral);
    refiner.RefineUniform({.max_level = 1});
    return Splitter(lattice, refiner, cells).Split();
}

}  // namespace SolidSubdiv::Deform

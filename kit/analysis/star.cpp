// SPDX-License-Identifier: Apache-2.0
// Stars are gathered from a level's cells or boundary faces and numbered anew, the given vertices first.
#include <solidsubdiv/kit/analysis/star.h>

#include <algorithm>
#include <span>
#include <unordered_map>

namespace SolidSubdiv::Analysis {

namespace {

using Vertices = std::span<const Index>;

bool Contains(Vertices list, Index v) { return std::find(list.begin(), list.end(), v) != list.end(); }

class Gatherer {
  public:
    Gatherer(Sdc::Split split, int dimension, Vertices first) {
        star_.split = split;
        star_.dimension = dimension;
        for (Index v : first) Number(v);
    }

    template <class Keep>
    void AddCells(const Vtr::Level& level, Keep&& keep) {
        for (Index t = 0; t < level.n_tets; ++t) {
            if (keep(level.TetVertices(t))) Append(level.TetVertices(t), star_.tets);
        }
        for (Index o = 0; o < level.n_octs; ++o) {
            if (keep(level.OctVertices(o))) Append(level.OctVertices(o), star_.octs);
        }
    }

    template <class Keep>
    void AddCells(const Vtr::PolyhedralLevel& level, Keep&& keep) {
        for (Index c = 0; c < static_cast<Index>(level.n_cells()); ++c) {
            if (!keep(level.CellVertices(c))) continue;
            if (level.IsHex(c)) {
                Append(level.CellVertices(c), star_.hexes);
            } else {
                AddPolyhedron(level.polyhedra, c - level.n_hexes);
            }
        }
    }

    void AddFace(Vertices face) {
        if (face.size() == 3) {
            Append(face, star_.triangles);
        } else if (face.size() == 4) {
            Append(face, star_.quads);
        } else {
            Append(face, star_.polygon_vertices);
            star_.polygon_offsets.push_back(static_cast<Offset>(star_.polygon_vertices.size()));
        }
    }

    Index Number(Index v) { return numbers_.emplace(v, static_cast<Index>(numbers_.size())).first->second; }

    Star Take() {
        star_.n_vertices = static_cast<Index>(numbers_.size());
        return std::move(star_);
    }

  private:
    void Append(Vertices element, std::vector<Index>& list) {
        for (Index v : element) list.push_back(Number(v));
    }
    void AddPolyhedron(const Vtr::Polyhedra& p, Index i) {
        for (Offset f = p.offsets[i]; f < p.offsets[i + 1]; ++f) {
            const auto begin = p.face_vertices.data() + p.face_vertex_offsets[f];
            Append({begin, p.face_vertices.data() + p.face_vertex_offsets[f + 1]}, star_.polyhedron_vertices);
            star_.polyhedron_face_offsets.push_back(static_cast<Offset>(star_.polyhedron_vertices.size()));
        }
        star_.polyhedron_offsets.push_back(static_cast<Offset>(star_.polyhedron_face_offsets.size()) - 1);
    }

    Star star_;
    std::unordered_map<Index, Index> numbers_;
};

/// Cells that have all of some vertices, which are numbered first, and others after them.
Star CellsWith(const Far::TopologyRefiner& refiner, int level, Vertices vertices, Vertices others = {}) {
    Gatherer gatherer(refiner.split(), 3, vertices);
    for (Index v : others) gatherer.Number(v);
    const auto keep = [&](Vertices cell) {
        return std::all_of(vertices.begin(), vertices.end(), [&](Index v) { return Contains(cell, v); });
    };
    if (refiner.is_polyhedral()) {
        gatherer.AddCells(refiner.polyhedral_level(level), keep);
    } else {
        gatherer.AddCells(refiner.level(level), keep);
    }
    return gatherer.Take();
}

/// Turns faces at a vertex so that all are seen from one side: cells of no volume may have their faces either way.
void Orient(std::vector<std::vector<Index>>& faces, Index vertex) {
    const auto next = [&](const std::vector<Index>& face, bool forward) {
        const auto n = face.size();
        const auto at = static_cast<std::size_t>(std::find(face.begin(), face.end(), vertex) - face.begin());
        return face[(at + (forward ? 1 : n - 1)) % n];
    };
    for (std::size_t done = 1; done < faces.size(); ++done) {
        for (std::size_t i = done; i < faces.size(); ++i) {
            const auto meets = [&](const std::vector<Index>& known, bool a, bool b) {
                return next(known, a) == next(faces[i], b);
            };
            const auto begin = faces.begin(), end = begin + static_cast<std::ptrdiff_t>(done);
            const bool fits =
                std::any_of(begin, end, [&](const auto& f) { return meets(f, true, false) || meets(f, false, true); });
            const bool is_turned =
                std::any_of(begin, end, [&](const auto& f) { return meets(f, true, true) || meets(f, false, false); });
            if (!fits && !is_turned) continue;
            if (is_turned) std::reverse(faces[i].begin(), faces[i].end());
            std::swap(faces[done], faces[i]);
            break;
        }
    }
}

/// Boundary faces that have a vertex, or the one that is `only`.
template <class AnyLevel>
Star FacesOf(const AnyLevel& level, Sdc::Split split, Index vertex, Index only) {
    const Index first[] = {vertex};
    std::vector<std::vector<Index>> faces;
    for (Index b = 0; b < level.n_boundary_faces; ++b) {
        const Vertices face = level.BoundaryVertices(b);
        const bool is_kept = only == kNoIndex ? Contains(face, vertex) : level.boundary_faces[b] == only;
        if (is_kept) faces.emplace_back(face.begin(), face.end());
    }
    if (only == kNoIndex) Orient(faces, vertex);
    Gatherer gatherer(split, 2, Vertices(first, only == kNoIndex ? 1 : 0));
    for (const auto& face : faces) gatherer.AddFace(face);
    return gatherer.Take();
}

Far::TopologyRefiner Refined(const Star& star, int n_levels) {
    auto refiner = Far::TopologyRefiner::Create(star.View(), star.split);
    refiner.RefineUniform({.max_level = n_levels, .full_topology_in_last_level = true});
    return refiner;
}

/// Of a vertex of level 1 on an edge whose neighbours along it are `below` and `above`.
Star OnEdge(const Far::TopologyRefiner& split, Index middle, Index below, Index above) {
    const Index along[] = {below, above};
    Star star = CellsWith(split, 1, {&middle, 1}, along);
    star.is_on_edge = true;
    return star;
}

}  // namespace

Far::TopologyDescriptor Star::View() const {
    return {.n_vertices = n_vertices,
            .tets = tets,
            .octs = octs,
            .hexes = hexes,
            .polyhedron_offsets = polyhedron_offsets,
            .polyhedron_face_offsets = polyhedron_face_offsets,
            .polyhedron_vertices = polyhedron_vertices,
            .triangles = triangles,
            .quads = quads,
            .polygon_offsets = polygon_offsets,
            .polygon_vertices = polygon_vertices};
}

Star StarOf(const Far::TopologyRefiner& refiner, int level, Index vertex, bool is_on_surface) {
    if (!is_on_surface) return CellsWith(refiner, level, {&vertex, 1});
    return refiner.is_polyhedral() ? FacesOf(refiner.polyhedral_level(level), refiner.split(), vertex, kNoIndex)
                                   : FacesOf(refiner.level(level), refiner.split(), vertex, kNoIndex);
}

Star PointOnEdge(const Far::TopologyRefiner& refiner, int level, Index edge) {
    const Star around = CellsWith(refiner, level, refiner.graph(level).EdgeVertices(edge));
    const auto split = Refined(around, 1);
    return OnEdge(split, around.n_vertices + split.graph(0).FindEdge(0, 1), 0, 1);
}

Star PointInFace(const Far::TopologyRefiner& refiner, int level, Index face) {
    if (!refiner.is_polyhedral()) {
        const auto split = Refined(CellsWith(refiner, level, refiner.level(level).FaceVertices(face)), 2);
        const auto middle = [&](int l, Index a, Index b) {
            return split.level(l).n_vertices + split.level(l).FindEdge(a, b);
        };
        return StarOf(split, 2, middle(1, middle(0, 0, 1), middle(0, 0, 2)), false);
    }
    const Vtr::PolyhedralLevel& l = refiner.polyhedral_level(level);
    const bool is_on_surface = l.IsBoundary(face);
    const Vertices corners = l.FaceVertices(face);
    const Star around =
        is_on_surface ? FacesOf(l, refiner.split(), kNoIndex, face) : CellsWith(refiner, level, corners);
    const auto split = Refined(around, 1);
    // A cell may have more corners than the face, and more faces: it is the one of the vertices numbered first.
    const Vtr::PolyhedralLevel& base = split.polyhedral_level(0);
    Index f = 0;
    const auto is_it = [&](Vertices v) {
        return v.size() == corners.size() &&
               std::all_of(v.begin(), v.end(), [&](Index i) { return i < static_cast<Index>(corners.size()); });
    };
    while (!is_it(base.FaceVertices(f))) ++f;
    return StarOf(split, 1, base.n_vertices + base.n_edges + f, is_on_surface);
}

Star PointInCell(const Far::TopologyRefiner& refiner, int level, Index cell) {
    const Star around = CellsWith(refiner, level, refiner.polyhedral_level(level).CellVertices(cell));
    const auto split = Refined(around, 1);
    const Vtr::PolyhedralLevel& base = split.polyhedral_level(0);
    return StarOf(split, 1, base.n_vertices + base.n_edges + base.n_faces, false);
}

Star SplitOnce(const Star& star) {
    if (star.split == Sdc::Split::TetOct) return star;
    const auto split = Refined(star, 1);
    if (!star.is_on_edge) return StarOf(split, 1, 0, star.dimension == 2);
    const auto half_way = [&](Index v) { return star.n_vertices + split.graph(0).FindEdge(0, v); };
    return OnEdge(split, 0, half_way(1), half_way(2));
}

}  // namespace SolidSubdiv::Analysis

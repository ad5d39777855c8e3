// SPDX-License-Identifier: Apache-2.0
// The catalogue of what may be wrong with a mesh.
#include <algorithm>
#include <array>
#include <set>
#include <string>

#include <solidsubdiv/far/internal/check.h>
#include <solidsubdiv/far/internal/sharpness.h>
#include <solidsubdiv/vtr/unique_tuples.h>

namespace SolidSubdiv::Far {

namespace Internal {

void DefectList::Add(DefectCode code, Offset element, double measure, std::string text) {
    has_fatal_ |= Defect{code}.IsFatal();
    if (counts_[static_cast<std::size_t>(code)]++ >= max_per_code_) return;
    defects_.push_back({code, static_cast<Index>(element), measure, std::move(text)});
}

std::vector<Defect> DefectList::TakeFatalFirst() {
    std::stable_sort(defects_.begin(), defects_.end(),
                     [](const Defect& a, const Defect& b) { return a.code < b.code; });
    return std::move(defects_);
}

namespace {

std::string Name(const char* kind, Offset i) { return std::string(kind) + " " + std::to_string(i); }

template <class Vertices>
std::string List(const Vertices& vertices) {
    std::string text = "(";
    for (Index v : vertices) text += (text.size() > 1 ? " " : "") + std::to_string(v);
    return text + ")";
}

/// One kind of element with a fixed number of vertices.
class KindCheck {
  public:
    KindCheck(const char* name, std::span<const Index> vertices, int arity, Index n_vertices, DefectList& defects)
        : name_(name), vertices_(vertices), arity_(arity), n_vertices_(n_vertices), defects_(defects) {}

    void Indices() const {
        if (vertices_.size() % arity_ != 0) {
            defects_.Add(DefectCode::BadOffsets, kNoIndex, static_cast<double>(vertices_.size()),
                         std::string(name_) + "s: " + std::to_string(vertices_.size()) +
                             " indices are no multiple of " + std::to_string(arity_));
            return;
        }
        const Offset n = static_cast<Offset>(vertices_.size()) / arity_;
        for (Offset i = 0; i < n; ++i) {
            const auto row = vertices_.subspan(i * arity_, arity_);
            for (int k = 0; k < arity_; ++k) {
                if (row[k] < 0 || row[k] >= n_vertices_) {
                    defects_.Add(DefectCode::IndexOutOfRange, i, row[k],
                                 Name(name_, i) + " names vertex " + std::to_string(row[k]) +
                                     ", but vertices are 0 to " + std::to_string(n_vertices_ - 1));
                } else if (std::find(row.begin(), row.begin() + k, row[k]) != row.begin() + k) {
                    defects_.Add(
                        DefectCode::RepeatedVertex, i, row[k],
                        Name(name_, i) + " " + List(row) + " names vertex " + std::to_string(row[k]) + " twice");
                }
            }
        }
    }

    /// @pre Indices() found nothing
    template <std::size_t N>
    void Duplicates() const {
        const Offset n = static_cast<Offset>(vertices_.size() / N);
        const auto tuple = [&](Offset i) {
            std::array<Index, N> t;
            std::copy_n(vertices_.begin() + i * static_cast<Offset>(N), N, t.begin());
            return t;
        };
        const Vtr::UniqueTuples<N> unique(n_vertices_, n, tuple);
        if (unique.size() == n) return;
        std::vector<Index> first(unique.size(), kNoIndex);
        for (Offset i = 0; i < n; ++i) {
            Index& f = first[unique.ids[i]];
            if (f != kNoIndex) {
                defects_.Add(DefectCode::DuplicateElement, i, f,
                             Name(name_, i) + " has the same vertices as " + Name(name_, f) + " " + List(tuple(i)));
            } else {
                f = static_cast<Index>(i);
            }
        }
    }

  private:
    const char* name_;
    std::span<const Index> vertices_;
    int arity_;
    Index n_vertices_;
    DefectList& defects_;
};

std::array<Index, 2> Ascending(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

std::set<std::array<Index, 2>> CreaseEdges(const TopologyDescriptor& d) {
    std::set<std::array<Index, 2>> edges;
    for (std::size_t i = 0; i < d.crease_sharpness.size(); ++i) {
        if (d.crease_sharpness[i] > 0) edges.insert(Ascending(d.crease_edges[2 * i], d.crease_edges[2 * i + 1]));
    }
    return edges;
}

void CheckSharpness(const char* name, std::span<const float> sharpness, std::size_t n, DefectList& defects) {
    if (sharpness.size() != n) {
        defects.Add(DefectCode::BadOffsets, kNoIndex, static_cast<double>(sharpness.size()),
                    std::to_string(n) + " " + name + "s have " + std::to_string(sharpness.size()) + " sharpnesses");
    }
    for (std::size_t i = 0; i < sharpness.size(); ++i) {
        if (sharpness[i] >= 0) continue;
        defects.Add(DefectCode::BadSharpness, static_cast<Offset>(i), sharpness[i],
                    Name(name, static_cast<Offset>(i)) + " has the sharpness " + std::to_string(sharpness[i]) +
                        "; it must be 0 or more");
    }
}

}  // namespace

void CheckElements(const TopologyDescriptor& d, DefectList& defects) {
    if (d.n_vertices < 0) {
        defects.Add(DefectCode::BadOffsets, kNoIndex, d.n_vertices, "the number of vertices is negative");
        return;
    }
    const KindCheck tets("tet", d.tets, 4, d.n_vertices, defects), octs("oct", d.octs, 6, d.n_vertices, defects);
    const KindCheck triangles("triangle", d.triangles, 3, d.n_vertices, defects),
        edges("edge", d.edges, 2, d.n_vertices, defects);
    for (const KindCheck* kind : {&tets, &octs, &triangles, &edges}) kind->Indices();
    const KindCheck creases("crease", d.crease_edges, 2, d.n_vertices, defects),
        corners("corner", d.corner_vertices, 1, d.n_vertices, defects);
    creases.Indices();
    corners.Indices();
    CheckSharpness("crease", d.crease_sharpness, d.crease_edges.size() / 2, defects);
    CheckSharpness("corner", d.corner_sharpness, d.corner_vertices.size(), defects);
    if (defects.has_fatal()) return;
    tets.Duplicates<4>();
    octs.Duplicates<6>();
}

void AddFindings(const TopologyDescriptor& d, const Vtr::Level& level, const Vtr::BaseFindings& findings,
                 DefectList& defects) {
    for (Index f : findings.faces_in_three_cells) {
        if (!defects.HasRoom(DefectCode::FaceInThreeCells)) break;
        const auto v = level.FaceVertices(f);
        const auto has = [&](Index other) { return other == f; };
        std::string cells;
        for (Index t = 0; t < level.n_tets; ++t) {
            const auto faces = level.TetFaces(t);
            if (std::any_of(faces.begin(), faces.end(), has)) cells += " tet " + std::to_string(t);
        }
        for (Index o = 0; o < level.n_octs; ++o) {
            const auto faces = level.OctFaces(o);
            if (std::any_of(faces.begin(), faces.end(), has)) cells += " oct " + std::to_string(o);
        }
        defects.Add(DefectCode::FaceInThreeCells, f, 3, "face " + List(v) + " bounds more than two cells:" + cells);
    }
    for (Index t : findings.duplicate_triangles) {
        defects.Add(DefectCode::DuplicateElement, t, 0,
                    Name("triangle", t) + " has the same vertices as an earlier one");
    }
    for (Index e : findings.duplicate_edges) {
        defects.Add(DefectCode::DuplicateElement, e, 0, Name("edge", e) + " has the same vertices as an earlier one");
    }
    if (!findings.IsUsable()) return;

    for (Index t : findings.coincident_triangles) {
        defects.Add(DefectCode::CoincidentElement, t, 2,
                    Name("triangle", t) + " lies on a face of a cell: a tag, not a part");
    }
    const std::set<std::array<Index, 2>> creases = CreaseEdges(d);
    for (Index e : findings.coincident_edges) {
        if (creases.count(Ascending(d.edges[2 * e], d.edges[2 * e + 1])) > 0) continue;
        defects.Add(DefectCode::CoincidentElement, e, 1,
                    Name("edge", e) + " lies on an edge of a face: a tag, not a part");
    }
    for (Index f : findings.flipped_faces) {
        defects.Add(
            DefectCode::InvertedCell, f, 0,
            "the cells on the two sides of face " + List(level.FaceVertices(f)) + " are oriented against each other");
    }
    for (Index e = 0; e < level.n_edges; ++e) {
        if (!level.edge_tags[e].non_manifold()) continue;
        defects.Add(DefectCode::NonManifoldEdge, e, static_cast<double>(level.edge_faces.Count(e)),
                    "edge " + List(level.EdgeVertices(e)) + " is not manifold");
    }
    for (Index v = 0; v < level.n_vertices; ++v) {
        if (level.vertex_edges.Count(v) == 0) {
            defects.Add(DefectCode::IsolatedVertex, v, 0, Name("vertex", v) + " is in no element");
        } else if (level.vertex_tags[v].non_manifold()) {
            defects.Add(DefectCode::NonManifoldVertex, v, 0, Name("vertex", v) + " is not manifold");
        }
    }
}

std::string KindsBeyondTetOct(const TopologyDescriptor& d) {
    std::string text;
    const auto add = [&](Offset n, const char* one, const char* many) {
        if (n > 0) text += (text.empty() ? "" : ", ") + std::to_string(n) + " " + (n == 1 ? one : many);
    };
    const auto rows = [](std::span<const Offset> offsets) {
        return offsets.empty() ? Offset{0} : static_cast<Offset>(offsets.size()) - 1;
    };
    add(static_cast<Offset>(d.hexes.size() / 8), "hexahedron", "hexahedra");
    add(static_cast<Offset>(d.wedges.size() / 6), "wedge", "wedges");
    add(static_cast<Offset>(d.pyramids.size() / 5), "pyramid", "pyramids");
    add(rows(d.polyhedron_offsets), "polyhedron", "polyhedra");
    add(static_cast<Offset>(d.quads.size() / 4), "quad", "quads");
    add(rows(d.polygon_offsets), "polygon", "polygons");
    return text;
}

Vtr::BaseElements ElementsOf(const TopologyDescriptor& d) {
    return {d.n_vertices, d.tets, d.octs, d.triangles, d.edges};
}

}  // namespace Internal

std::vector<Defect> Validate(const TopologyDescriptor& descriptor, Index max_per_code) {
    Internal::DefectList defects(max_per_code);
    Internal::CheckElements(descriptor, defects);
    if (!defects.has_fatal()) {
        Vtr::BaseFindings findings;
        const Vtr::Level level = Vtr::MakeBaseLevel(Internal::ElementsOf(descriptor), findings);
        Internal::AddFindings(descriptor, level, findings, defects);
        if (findings.IsUsable()) Internal::TakeSharpness(descriptor, level, defects);
    }
    return defects.TakeFatalFirst();
}

}  // namespace SolidSubdiv::Far

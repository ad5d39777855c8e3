// SPDX-License-Identifier: Apache-2.0
// Building level 0; which rule governs where is decided in vertex_rules.cpp.
#include <solidsubdiv/vtr/base_level.h>

#include <algorithm>
#include <array>

#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/vtr/internal/vertex_rules.h>
#include <solidsubdiv/vtr/unique_tuples.h>

namespace SolidSubdiv::Vtr {

namespace {

using Sdc::Oct;
using Sdc::Tet;

constexpr Offset kGrain = 2048;

class BaseBuilder {
  public:
    BaseBuilder(const BaseElements& elements, BaseFindings& findings) : in_(elements), findings_(findings) {
        n_tets_ = static_cast<Index>(in_.tets.size() / 4);
        n_octs_ = static_cast<Index>(in_.octs.size() / 6);
        n_triangles_ = static_cast<Index>(in_.triangles.size() / 3);
        n_edges_ = static_cast<Index>(in_.edges.size() / 2);
    }

    Level Build() {
        level_.n_vertices = in_.n_vertices;
        level_.n_tets = n_tets_;
        level_.n_octs = n_octs_;
        level_.tet_vertices.assign(in_.tets.begin(), in_.tets.end());
        level_.oct_vertices.assign(in_.octs.begin(), in_.octs.end());
        MakeFaces();
        MakeEdges();
        if (!findings_.IsUsable()) return std::move(level_);
        level_.vertex_edges = Invert(level_.edge_vertices, 2, level_.n_vertices, false);
        level_.vertex_octs = Invert(level_.oct_vertices, 6, level_.n_vertices, true);
        level_.edge_faces = Invert(level_.face_edges, 3, level_.n_edges, false);
        level_.edge_octs = Invert(level_.oct_edges, 12, level_.n_edges, true);
        MakeBoundary();
        Internal::TagEdgesAndVertices(level_);
        level_.is_full = true;
        return std::move(level_);
    }

  private:
    /// Items in the order tets, octs, triangles: item i is one side of a cell or a triangle.
    std::array<Index, 3> FaceOfItem(Offset i) const {
        if (i < 4 * static_cast<Offset>(n_tets_))
            return Pick(level_.TetVertices(static_cast<Index>(i / 4)), Tet::faces[i % 4]);
        i -= 4 * static_cast<Offset>(n_tets_);
        if (i < 8 * static_cast<Offset>(n_octs_))
            return Pick(level_.OctVertices(static_cast<Index>(i / 8)), Oct::faces[i % 8]);
        i -= 8 * static_cast<Offset>(n_octs_);
        return {in_.triangles[3 * i], in_.triangles[3 * i + 1], in_.triangles[3 * i + 2]};
    }

    template <class Row>
    static std::array<Index, 3> Pick(const Row& v, const std::array<Sdc::Local, 3>& face) {
        return {v[face[0]], v[face[1]], v[face[2]]};
    }

    void MakeFaces() {
        const Offset n_tet_items = 4 * static_cast<Offset>(n_tets_),
                     n_cell_items = n_tet_items + 8 * static_cast<Offset>(n_octs_);
        const Offset n_items = n_cell_items + n_triangles_;
        UniqueTuples<3> faces(in_.n_vertices, n_items, [&](Offset i) { return FaceOfItem(i); });
        level_.n_faces = faces.size();
        level_.face_vertices = std::move(faces.tuples);
        const Array<Index>& id = faces.ids;
        level_.tet_faces.assign(id.begin(), id.begin() + n_tet_items);
        level_.oct_faces.assign(id.begin() + n_tet_items, id.begin() + n_cell_items);
        triangle_faces_.assign(id.begin() + n_cell_items, id.end());

        // A face's sides are counted in the order of items, so the findings don't depend on threads.
        std::vector<std::uint8_t> tets(level_.n_faces, 0), octs(level_.n_faces, 0), triangles(level_.n_faces, 0);
        for (Index f : level_.tet_faces) tets[f] += tets[f] < 3;
        for (Index f : level_.oct_faces) octs[f] += octs[f] < 3;
        level_.face_tags.resize(level_.n_faces);
        for (Index f = 0; f < level_.n_faces; ++f) {
            if (tets[f] + octs[f] > 2) findings_.faces_in_three_cells.push_back(f);
            level_.face_tags[f] = MakeFaceTag(tets[f], octs[f]);
        }
        for (Index t = 0; t < n_triangles_; ++t) {
            const Index f = triangle_faces_[t];
            if (triangles[f]) {
                findings_.duplicate_triangles.push_back(t);
            } else if (level_.face_tags[f].n_cells() > 0) {
                findings_.coincident_triangles.push_back(t);
            }
            triangles[f] = 1;
        }
    }

    void MakeEdges() {
        const Offset n_face_items = 3 * static_cast<Offset>(level_.n_faces);
        const auto edge_of_item = [&](Offset i) -> std::array<Index, 2> {
            if (i < n_face_items) {
                const auto v = level_.FaceVertices(static_cast<Index>(i / 3));
                return {v[(i + 1) % 3], v[(i + 2) % 3]};  // opposite vertex i % 3
            }
            return {in_.edges[2 * (i - n_face_items)], in_.edges[2 * (i - n_face_items) + 1]};
        };
        UniqueTuples<2> edges(in_.n_vertices, n_face_items + n_edges_, edge_of_item);
        level_.n_edges = edges.size();
        level_.edge_vertices = std::move(edges.tuples);
        level_.face_edges.assign(edges.ids.begin(), edges.ids.begin() + n_face_items);

        std::vector<std::uint8_t> use(level_.n_edges, 0);
        for (Index e : level_.face_edges) use[e] = 1;
        for (Index i = 0; i < n_edges_; ++i) {
            const Index e = edges.ids[n_face_items + i];
            if (use[e] == 2) {
                findings_.duplicate_edges.push_back(i);
            } else if (use[e] == 1) {
                findings_.coincident_edges.push_back(i);
            } else {
                use[e] = 2;
            }
        }

        level_.tet_edges.resize(6 * static_cast<std::size_t>(n_tets_));
        level_.oct_edges.resize(12 * static_cast<std::size_t>(n_octs_));
        FindCellEdges<Tet>(n_tets_, level_.tet_faces, level_.tet_edges, [&](Index c) { return level_.TetVertices(c); });
        FindCellEdges<Oct>(n_octs_, level_.oct_faces, level_.oct_edges, [&](Index c) { return level_.OctVertices(c); });
    }

    /// An edge of a cell is an edge of one of its faces: look there.
    template <class Cell, class Vertices>
    void FindCellEdges(Index n_cells, const Array<Index>& faces, Array<Index>& edges, Vertices&& vertices) {
        Sdc::ParallelFor(n_cells, kGrain, [&](Offset begin, Offset end) {
            for (Offset c = begin; c < end; ++c) {
                const auto v = vertices(static_cast<Index>(c));
                for (int f = 0; f < Cell::kFaces; ++f) {
                    const Index face = faces[Cell::kFaces * c + f];
                    const auto face_vertices = level_.FaceVertices(face);
                    for (int k = 0; k < 3; ++k) {
                        const int a = Cell::faces[f][(k + 1) % 3], b = Cell::faces[f][(k + 2) % 3];
                        const auto opposite =
                            std::find(face_vertices.begin(), face_vertices.end(), v[Cell::faces[f][k]]);
                        edges[Cell::kEdges * c + Sdc::FindEdge<Cell>(a, b)] =
                            level_.FaceEdges(face)[opposite - face_vertices.begin()];
                    }
                }
            }
        });
    }

    /// Lists boundary faces with their orientation, and finds places where neighbours are oriented against each other.
    void MakeBoundary() {
        constexpr std::uint8_t kEven = 1, kOdd = 2;
        std::vector<std::uint8_t> seen(level_.n_faces, 0);
        Array<Index> oriented(3 * static_cast<std::size_t>(level_.n_faces));
        const Offset n_cell_items = 4 * static_cast<Offset>(n_tets_) + 8 * static_cast<Offset>(n_octs_);
        const auto face_of_item = [&](Offset i) {
            if (i < 4 * static_cast<Offset>(n_tets_)) return level_.tet_faces[i];
            return i < n_cell_items ? level_.oct_faces[i - 4 * static_cast<Offset>(n_tets_)]
                                    : triangle_faces_[i - n_cell_items];
        };
        for (Offset i = 0; i < n_cell_items + n_triangles_; ++i) {
            const Index f = face_of_item(i);
            if (i >= n_cell_items && level_.face_tags[f].n_cells() > 0) continue;
            const auto v = FaceOfItem(i);
            const int swaps = (v[0] > v[1]) + (v[1] > v[2]) + (v[0] > v[2]);
            const std::uint8_t side = swaps % 2 ? kOdd : kEven;
            if (seen[f] & side) findings_.flipped_faces.push_back(f);
            seen[f] |= side;
            std::copy(v.begin(), v.end(), oriented.begin() + 3 * static_cast<std::ptrdiff_t>(f));
        }
        for (Index f = 0; f < level_.n_faces; ++f) {
            if (!level_.face_tags[f].is_boundary()) continue;
            level_.boundary_faces.push_back(f);
            const auto at = oriented.begin() + 3 * static_cast<std::ptrdiff_t>(f);
            level_.boundary_vertices.insert(level_.boundary_vertices.end(), at, at + 3);
        }
        level_.n_boundary_faces = static_cast<Index>(level_.boundary_faces.size());
    }

    const BaseElements& in_;
    BaseFindings& findings_;
    Level level_;
    Array<Index> triangle_faces_;
    Index n_tets_, n_octs_, n_triangles_, n_edges_;
};

}  // namespace

Level MakeBaseLevel(const BaseElements& elements, BaseFindings& findings) {
    return BaseBuilder(elements, findings).Build();
}

}  // namespace SolidSubdiv::Vtr

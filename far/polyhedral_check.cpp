// SPDX-License-Identifier: Apache-2.0
// Level 0 of polyhedra from a caller's mesh.
#include <solidsubdiv/far/internal/polyhedral_check.h>

#include <algorithm>
#include <limits>

#include <solidsubdiv/far/internal/kind_check.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Far::Internal {

namespace {

Offset Rows(std::span<const Offset> offsets) { return offsets.empty() ? 0 : static_cast<Offset>(offsets.size()) - 1; }

/// Kinds of cells in the order of the level.
struct Kind {
    const char* name;
    Offset count;
};
std::array<Kind, 6> CellKinds(const TopologyDescriptor& d) {
    return {{{"hexahedron", static_cast<Offset>(d.hexes.size() / 8)},
             {"tet", static_cast<Offset>(d.tets.size() / 4)},
             {"oct", static_cast<Offset>(d.octs.size() / 6)},
             {"wedge", static_cast<Offset>(d.wedges.size() / 6)},
             {"pyramid", static_cast<Offset>(d.pyramids.size() / 5)},
             {"polyhedron", Rows(d.polyhedron_offsets)}}};
}

/// An array of offsets: from 0 on, ascending, up to n. False, and a defect, if not.
bool CheckOffsets(const char* name, std::span<const Offset> offsets, Offset n, DefectList& defects) {
    const bool is_good =
        offsets.empty() ? n == 0
                        : offsets.front() == 0 && offsets.back() == n && std::is_sorted(offsets.begin(), offsets.end());
    if (!is_good) {
        defects.Add(DefectCode::BadOffsets, kNoIndex, static_cast<double>(offsets.size()),
                    std::string(name) + ": offsets do not ascend from 0 to " + std::to_string(n));
    }
    return is_good;
}

/// Faces given one after another, each with at least three different vertices.
void CheckPolygons(const char* name, std::span<const Offset> offsets, std::span<const Index> vertices, Index n_vertices,
                   DefectList& defects) {
    for (Offset i = 0; i < Rows(offsets); ++i) {
        const auto row = vertices.subspan(static_cast<std::size_t>(offsets[i]),
                                          static_cast<std::size_t>(offsets[i + 1] - offsets[i]));
        if (row.size() < 3) {
            defects.Add(DefectCode::BadOffsets, i, static_cast<double>(row.size()),
                        Name(name, i) + " has " + std::to_string(row.size()) + " vertices; a face has three or more");
        }
        KindCheck::Vertices(name, i, row, n_vertices, defects);
    }
}

}  // namespace

PolyhedralInput::PolyhedralInput(const TopologyDescriptor& d) : descriptor_(d) {
    AddCells<Sdc::Tet>(d.tets);
    AddCells<Sdc::Oct>(d.octs);
    AddCells<Sdc::Wedge>(d.wedges);
    AddCells<Sdc::Pyramid>(d.pyramids);
    const Offset first_face = static_cast<Offset>(face_offsets_.size()) - 1, first_vertex = face_offsets_.back();
    for (Offset c = 1; c <= Rows(d.polyhedron_offsets); ++c)
        cell_offsets_.push_back(first_face + d.polyhedron_offsets[c]);
    for (Offset f = 1; f <= Rows(d.polyhedron_face_offsets); ++f) {
        face_offsets_.push_back(first_vertex + d.polyhedron_face_offsets[f]);
    }
    face_vertices_.insert(face_vertices_.end(), d.polyhedron_vertices.begin(), d.polyhedron_vertices.end());

    AddPolygons(d.triangles, 3);
    AddPolygons(d.quads, 4);
    const Offset first = polygon_offsets_.back();
    for (Offset i = 1; i <= Rows(d.polygon_offsets); ++i) polygon_offsets_.push_back(first + d.polygon_offsets[i]);
    polygon_vertices_.insert(polygon_vertices_.end(), d.polygon_vertices.begin(), d.polygon_vertices.end());
}

template <class Cell>
void PolyhedralInput::AddCells(std::span<const Index> cells) {
    for (std::size_t c = 0; c < cells.size(); c += Cell::kVertices) {
        for (const auto& face : Cell::faces) {
            for (Sdc::Local k : face) {
                if (k != Sdc::kNoLocal) face_vertices_.push_back(cells[c + k]);
            }
            face_offsets_.push_back(static_cast<Offset>(face_vertices_.size()));
        }
        cell_offsets_.push_back(static_cast<Offset>(face_offsets_.size()) - 1);
    }
}

void PolyhedralInput::AddPolygons(std::span<const Index> polygons, std::size_t arity) {
    polygon_vertices_.insert(polygon_vertices_.end(), polygons.begin(), polygons.end());
    for (std::size_t i = 0; i < polygons.size(); i += arity) {
        polygon_offsets_.push_back(polygon_offsets_.back() + static_cast<Offset>(arity));
    }
}

Vtr::PolyhedralElements PolyhedralInput::elements() const {
    return {descriptor_.n_vertices, descriptor_.hexes, cell_offsets_,     face_offsets_,
            face_vertices_,         polygon_offsets_,  polygon_vertices_, descriptor_.edges};
}

Offset PolyhedralInput::n_face_corners() const {
    return 3 * static_cast<Offset>(descriptor_.hexes.size()) + face_offsets_.back() + polygon_offsets_.back();
}

void CheckPolyhedralElements(const TopologyDescriptor& d, DefectList& defects) {
    if (d.n_vertices < 0) {
        defects.Add(DefectCode::BadOffsets, kNoIndex, d.n_vertices, "the number of vertices is negative");
        return;
    }
    const auto check = [&](const char* name, std::span<const Index> vertices, int arity) {
        KindCheck(name, vertices, arity, d.n_vertices, defects).Indices();
    };
    check("tet", d.tets, 4);
    check("oct", d.octs, 6);
    check("hexahedron", d.hexes, 8);
    check("wedge", d.wedges, 6);
    check("pyramid", d.pyramids, 5);
    check("triangle", d.triangles, 3);
    check("quad", d.quads, 4);
    check("edge", d.edges, 2);
    if (CheckOffsets("polyhedra", d.polyhedron_offsets, Rows(d.polyhedron_face_offsets), defects) &&
        CheckOffsets("faces of polyhedra", d.polyhedron_face_offsets, static_cast<Offset>(d.polyhedron_vertices.size()),
                     defects)) {
        CheckPolygons("face of polyhedra", d.polyhedron_face_offsets, d.polyhedron_vertices, d.n_vertices, defects);
    }
    if (CheckOffsets("polygons", d.polygon_offsets, static_cast<Offset>(d.polygon_vertices.size()), defects)) {
        CheckPolygons("polygon", d.polygon_offsets, d.polygon_vertices, d.n_vertices, defects);
    }
    CheckCreases(d, defects);
}

std::string CellName(const TopologyDescriptor& descriptor, Index cell) {
    Offset i = cell;
    for (const Kind& kind : CellKinds(descriptor)) {
        if (i < kind.count) return Name(kind.name, i);
        i -= kind.count;
    }
    return Name("cell", cell);
}

namespace {

std::string PolygonName(const TopologyDescriptor& d, Index polygon) {
    const Index n_triangles = static_cast<Index>(d.triangles.size() / 3),
                n_quads = static_cast<Index>(d.quads.size() / 4);
    if (polygon < n_triangles) return Name("triangle", polygon);
    polygon -= n_triangles;
    return polygon < n_quads ? Name("quad", polygon) : Name("polygon", polygon - n_quads);
}

void AddFindings(const TopologyDescriptor& d, const Vtr::PolyhedralLevel& level,
                 const Vtr::PolyhedralFindings& findings, DefectList& defects) {
    for (Index c : findings.open_cells) {
        defects.Add(DefectCode::OpenCell, c, 0,
                    CellName(d, c) + ": its faces do not close, or meet more than once in an edge or a vertex");
    }
    for (Index f : findings.faces_in_three_cells) {
        defects.Add(DefectCode::FaceInThreeCells, f, 3,
                    "face " + List(level.FaceVertices(f)) + " bounds more than two cells");
    }
    for (Index f : findings.twisted_faces) {
        defects.Add(DefectCode::TwistedFace, f, 0,
                    "face " + List(level.FaceVertices(f)) + " has its vertices in another order in another element");
    }
    for (Index c : findings.duplicate_cells) {
        defects.Add(DefectCode::DuplicateElement, c, 0, CellName(d, c) + " has the same vertices as another cell");
    }
    for (Index p : findings.duplicate_polygons) {
        defects.Add(DefectCode::DuplicateElement, p, 0, PolygonName(d, p) + " has the same vertices as an earlier one");
    }
    for (Index e : findings.duplicate_edges) {
        defects.Add(DefectCode::DuplicateElement, e, 0, Name("edge", e) + " has the same vertices as an earlier one");
    }
    if (!findings.IsUsable()) return;
    for (Index p : findings.coincident_polygons) {
        defects.Add(DefectCode::CoincidentElement, p, 2,
                    PolygonName(d, p) + " lies on a face of a cell: a tag, not a part");
    }
    AddCoincidentEdges(d, findings.coincident_edges, defects);
    for (Index f : findings.flipped_faces) {
        defects.Add(DefectCode::InvertedCell, f, 0,
                    "the elements on the two sides of face " + List(level.FaceVertices(f)) +
                        " are oriented against each other");
    }
    for (Index e : findings.flipped_edges) {
        defects.Add(
            DefectCode::InvertedCell, e, 0,
            "the faces on the two sides of edge " + List(level.EdgeVertices(e)) + " are oriented against each other");
    }
    AddManifoldDefects(Vtr::EdgeGraph(level), defects);
}

}  // namespace

std::optional<Vtr::PolyhedralLevel> MakeCheckedPolyhedralLevel(const TopologyDescriptor& descriptor,
                                                               DefectList& defects) {
    CheckPolyhedralElements(descriptor, defects);
    if (defects.has_fatal()) return std::nullopt;
    const PolyhedralInput input(descriptor);
    if (input.n_face_corners() > std::numeric_limits<Index>::max()) {
        throw InvalidInput("the faces of all cells have " + std::to_string(input.n_face_corners()) +
                           " corners; level 0 takes at most " + std::to_string(std::numeric_limits<Index>::max()));
    }
    Vtr::PolyhedralFindings findings;
    Vtr::PolyhedralLevel level = Vtr::MakePolyhedralBaseLevel(input.elements(), findings);
    AddFindings(descriptor, level, findings, defects);
    if (!findings.IsUsable()) return std::nullopt;
    return level;
}

}  // namespace SolidSubdiv::Far::Internal

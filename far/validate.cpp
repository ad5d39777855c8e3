// SPDX-License-Identifier: Apache-2.0
// The catalogue of what may be wrong with a mesh.
#include <algorithm>
#include <string>

#include <solidsubdiv/far/internal/check.h>
#include <solidsubdiv/far/internal/kind_check.h>
#include <solidsubdiv/far/internal/polyhedral_check.h>
#include <solidsubdiv/far/internal/sharpness.h>

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

void CheckElements(const TopologyDescriptor& d, DefectList& defects) {
    if (d.n_vertices < 0) {
        defects.Add(DefectCode::BadOffsets, kNoIndex, d.n_vertices, "the number of vertices is negative");
        return;
    }
    const KindCheck tets("tet", d.tets, 4, d.n_vertices, defects), octs("oct", d.octs, 6, d.n_vertices, defects);
    const KindCheck triangles("triangle", d.triangles, 3, d.n_vertices, defects),
        edges("edge", d.edges, 2, d.n_vertices, defects);
    for (const KindCheck* kind : {&tets, &octs, &triangles, &edges}) kind->Indices();
    CheckCreases(d, defects);
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
    AddCoincidentEdges(d, findings.coincident_edges, defects);
    for (Index f : findings.flipped_faces) {
        defects.Add(
            DefectCode::InvertedCell, f, 0,
            "the cells on the two sides of face " + List(level.FaceVertices(f)) + " are oriented against each other");
    }
    AddManifoldDefects(Vtr::EdgeGraph(level), defects);
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
    if (!Internal::KindsBeyondTetOct(descriptor).empty()) {
        Internal::MakeCheckedPolyhedralLevel(descriptor, defects);
        return defects.TakeFatalFirst();
    }
    Internal::CheckElements(descriptor, defects);
    if (!defects.has_fatal()) {
        Vtr::BaseFindings findings;
        const Vtr::Level level = Vtr::MakeBaseLevel(Internal::ElementsOf(descriptor), findings);
        Internal::AddFindings(descriptor, level, findings, defects);
        if (findings.IsUsable()) Internal::TakeSharpness(descriptor, Vtr::EdgeGraph(level), defects);
    }
    return defects.TakeFatalFirst();
}

}  // namespace SolidSubdiv::Far

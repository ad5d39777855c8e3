// SPDX-License-Identifier: Apache-2.0
// Lattices are read as refine reads its control meshes.
#include <solidsubdiv/apps/cli/model_lattice.h>

#include <algorithm>

#include <solidsubdiv/apps/cli/kind_check.h>
#include <solidsubdiv/apps/cli/mesh_kinds.h>
#include <solidsubdiv/kit/geometry/cell_quality.h>
#include <solidsubdiv/kit/io/formats.h>

namespace SolidSubdiv::Cli {

ModelLattice::ModelLattice(const std::string& file, const SchemeOptions& options, Session& session)
    : file_(file), mesh_(Io::ReadSolid(file)) {
    for (const std::string& note : mesh_.notes) session.Note(file + ": " + note);
    const MeshKind kind{true, IsTetOct(mesh_.topology)};
    settings_.choice = MakeScheme(options, kind);
    const Sdc::Scheme& scheme = settings_.choice.scheme;
    option_values_ = OptionValues(options, scheme);
    option_values_.emplace_back("diagonals", options.diagonals);
    About(file, [&] {
        settings_.split = SplitFor(mesh_.topology, scheme);
        settings_.levels = 0;
        refinement_ = std::make_unique<Refinement>(mesh_, settings_, session);
    });
    if (refinement_->orientation().n_inverted() > 0) {
        session.Note(file + ": " + Counted(refinement_->orientation().n_inverted(), "inverted cell", "inverted cells") +
                     " turned");
    }
}

Io::Mesh ModelLattice::ReadMoved(const std::string& file, Session& session) const {
    Io::Mesh moved = Io::ReadSolid(file);
    for (const std::string& note : moved.notes) session.Note(file + ": " + note);
    const Io::Topology& a = mesh_.topology;
    const Io::Topology& b = moved.topology;
    const std::string advice = "; a moved lattice keeps its cells and the order of its points";
    if (a.n_vertices != b.n_vertices) {
        throw InvalidInput(file + ": has " + Counted(b.n_vertices, "control point", "control points") + ", " + file_ +
                           " " + std::to_string(a.n_vertices) + advice);
    }
    const auto kinds_a = KindCounts(a), kinds_b = KindCounts(b);
    for (std::size_t k = 0; k < kinds_a.size(); ++k) {
        if (kinds_a[k].dimension == 3 && kinds_a[k].count != kinds_b[k].count) {
            throw InvalidInput(file + ": has " + Counted(kinds_b[k].count, kinds_b[k].singular, kinds_b[k].plural) +
                               ", " + file_ + " " + std::to_string(kinds_a[k].count) + advice);
        }
    }
    const auto require_same = [&](const auto& of_a, const auto& of_b, std::size_t arity, const char* kind) {
        const auto [x, y] = std::mismatch(of_a.begin(), of_a.end(), of_b.begin(), of_b.end());
        if (x == of_a.end() && y == of_b.end()) return;
        const auto place = static_cast<std::size_t>(x - of_a.begin()) / arity;
        throw InvalidInput(file + ": " + kind + (arity > 1 ? " " + std::to_string(place) : "") +
                           (arity > 1 ? " has" : " have") + " other vertices than in " + file_ + advice);
    };
    require_same(a.tets, b.tets, 4, "tetrahedron");
    require_same(a.octs, b.octs, 6, "octahedron");
    require_same(a.hexes, b.hexes, 8, "hexahedron");
    require_same(a.wedges, b.wedges, 6, "wedge");
    require_same(a.pyramids, b.pyramids, 5, "pyramid");
    require_same(a.polyhedron_face_offsets, b.polyhedron_face_offsets, 1, "polyhedra");
    require_same(a.polyhedron_vertices, b.polyhedron_vertices, 1, "polyhedra");
    return moved;
}

std::vector<Index> ModelLattice::FoldedCells(const std::vector<double>& positions) const {
    std::vector<Index> folded;
    const auto quality = Geometry::MeasureQuality(refinement_->refiner(), 0, positions);
    for (std::size_t c = 0; c < quality.size(); ++c) {
        if (quality[c].sign == Geometry::MinimumSign::Negative) folded.push_back(static_cast<Index>(c));
    }
    return folded;
}

}  // namespace SolidSubdiv::Cli

// SPDX-License-Identifier: Apache-2.0
// The steps of `refine`.
#include <solidsubdiv/apps/cli/refinement.h>

#include <unistd.h>

#include <algorithm>
#include <limits>

#include <solidsubdiv/apps/cli/diagonal_data.h>
#include <solidsubdiv/apps/cli/refined_mesh.h>
#include <solidsubdiv/apps/cli/refined_polyhedra.h>
#include <solidsubdiv/kit/geometry/compact_surface.h>
#include <solidsubdiv/kit/geometry/limits_of_vertices.h>
#include <solidsubdiv/kit/io/holes.h>
#include <solidsubdiv/osd/evaluator.h>

namespace SolidSubdiv::Cli {

namespace {

/// Data of the elements of a finer level but the diagonals, which are made anew.
template <class Rows>
void CopyCellData(const Io::Mesh& from, Io::Mesh& to, Rows&& rows) {
    for (const Io::Attribute& attribute : from.cell_data) {
        const bool is_of_holes = attribute.name == Io::kHole && from.topology.n_cells() == 0;  // they are gone
        if (attribute.name != kDiagonalName && !is_of_holes) to.cell_data.push_back(rows(attribute));
    }
}

/// Refuses what this machine's memory can't hold: the levels, the table of all of them, two copies of the refined
/// values, and the refined elements as they are and as they are written, octahedra cut into four. What indices can't
/// count is left to the refiner. @throws InvalidInput
template <class Counts, class WrittenCells>
void RequireMemory(const Far::TopologyRefiner& refiner, const Counts& base, Offset weights_of_row,
                   Offset bytes_of_element, WrittenCells&& written_cells, const RefinementSettings& settings,
                   const Io::Mesh& control) {
    const Offset bytes_of_row = 8 + weights_of_row * 12;  // and their indices
    Offset width = 3, cell_width = 1;
    for (const Io::Attribute& a : control.point_data) width += a.width;
    for (const Io::Attribute& a : control.cell_data) cell_width += a.width;

    auto last = base;
    Offset bytes = refiner.Bytes();
    for (int i = 1; i <= settings.levels; ++i) {
        last = Vtr::Refine(last);
        if (last.Largest() > std::numeric_limits<Index>::max()) return;
        bytes += Vtr::EstimateBytes(last, i < settings.levels || settings.limit) + bytes_of_row * last.n_vertices;
    }
    bytes += 2 * 8 * width * last.n_vertices + (bytes_of_element + 2 * 8 * cell_width) * written_cells(last);
    const Offset machine = static_cast<Offset>(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGESIZE);
    if (bytes <= machine) return;
    throw InvalidInput("level " + std::to_string(settings.levels) + " would have " + std::to_string(last.n_cells()) +
                       " cells, and to make and write them takes about " + Far::BytesText(bytes) + " (" +
                       std::to_string(bytes) + " bytes), more than the " + Far::BytesText(machine) +
                       " of this machine; refine fewer times");
}

void RequireMemory(const Far::TopologyRefiner& refiner, const RefinementSettings& settings, const Io::Mesh& control) {
    // Of a cell in memory: its vertices, the same once more, connectivity, offset and type.
    if (refiner.is_polyhedral()) {
        RequireMemory(
            refiner, refiner.PolyhedralCountsAt(0), 13, 3 * 32 + 13,
            [](const Vtr::PolyhedralCounts& c) { return c.n_cells(); }, settings, control);
    } else {
        RequireMemory(
            refiner, refiner.CountsAt(0), 9, 3 * 16 + 13, [](const Vtr::Counts& c) { return c.n_tets + 4 * c.n_octs; },
            settings, control);
    }
}

/// Creases whose ends are kept, by their new numbers.
Far::Creases Among(const Far::Creases& creases, const std::vector<Index>& numbers) {
    Far::Creases kept;
    for (std::size_t e = 0; e < creases.edge_sharpness.size(); ++e) {
        const Index a = numbers[creases.edges[2 * e]], b = numbers[creases.edges[2 * e + 1]];
        if (a == kNoIndex || b == kNoIndex) continue;
        kept.edges.insert(kept.edges.end(), {a, b});
        kept.edge_sharpness.push_back(creases.edge_sharpness[e]);
    }
    for (std::size_t i = 0; i < creases.vertices.size(); ++i) {
        if (numbers[creases.vertices[i]] == kNoIndex) continue;
        kept.vertices.push_back(numbers[creases.vertices[i]]);
        kept.vertex_sharpness.push_back(creases.vertex_sharpness[i]);
    }
    return kept;
}

void AddDiagonals(Io::Mesh& mesh, std::vector<double> values) {
    if (mesh.topology.n_cells() == 0) return;
    values.resize(static_cast<std::size_t>(mesh.topology.n_elements()), 0.0);
    mesh.cell_data.push_back({std::string(kDiagonalName), 1, std::move(values)});
}

}  // namespace

Refinement::Refinement(Io::Mesh control, const RefinementSettings& settings, Session& session)
    : settings_(settings), session_(session), control_(std::move(control)) {
    left_out_ = {settings_.drop_border, Io::HolesOf(control_)};
    session.Stage("orient");
    Orient();
    session.Stage("diagonals");
    ChooseDiagonals();
    session.Stage("topology");
    RefineTopology();
    Evaluate();
    session.Stage("gather");
    if (settings_.levels == 0) {
        GatherControl();
    } else {
        GatherElements();
    }
    session.EndStage();
}

Far::TopologyDescriptor Refinement::descriptor() const {
    Far::TopologyDescriptor descriptor = control_.topology.View();
    descriptor.tets = diagonals_.tets;
    descriptor.octs = diagonals_.octs;
    creases_.AddTo(descriptor);
    return descriptor;
}

void Refinement::Orient() {
    Io::Topology& t = control_.topology;
    orientation_ = Geometry::OrientCells(t.tets, t.octs, control_.positions, settings_.orient);
    Geometry::OrientOtherCells({.hexes = t.hexes,
                                .wedges = t.wedges,
                                .pyramids = t.pyramids,
                                .polyhedron_offsets = t.polyhedron_offsets,
                                .polyhedron_face_offsets = t.polyhedron_face_offsets,
                                .polyhedron_vertices = t.polyhedron_vertices},
                               control_.positions, settings_.orient, orientation_);
}

void Refinement::ChooseDiagonals() {
    if (settings_.split == Sdc::Split::Polyhedral) {
        diagonals_.tets = control_.topology.tets;
        diagonals_.octs = control_.topology.octs;
        return;
    }
    std::vector<std::uint8_t> given;
    if (settings_.choice.diagonals == Far::DiagonalPolicy::Given && control_.topology.n_cells() > 0) {
        given = RequireDiagonalData(control_);
    }
    diagonals_ = Far::ChooseDiagonals(control_.topology.View(), settings_.choice.diagonals, control_.positions, given);
}

void Refinement::RefineTopology() {
    creases_ = Io::CreasesOf(control_);
    refiner_ = Far::TopologyRefiner::Create(descriptor(), settings_.split);
    RequireMemory(*refiner_, settings_, control_);
    refiner_->RefineUniform({.max_level = settings_.levels,
                             .full_topology_in_last_level = settings_.limit,
                             .progress = session_.progress()});
}

void Refinement::Evaluate() {
    result_.positions = control_.positions;
    result_.point_data = control_.point_data;
    session_.Stage("stencils");
    const auto table = Far::StencilTable::Create(*refiner_, settings_.choice.scheme, {.progress = session_.progress()});
    stencil_bytes_ = table.Bytes();
    session_.Stage("evaluate");
    Osd::Evaluator evaluator(table, Osd::Backend::Best());
    for (int level = 1; level <= settings_.levels; ++level) {
        if (settings_.keep_levels) KeepLevel(level - 1);
        const Index n = refiner_->n_vertices(level);
        const auto evaluate = [&](std::vector<double>& values, int width) {
            std::vector<double> refined(static_cast<std::size_t>(n) * static_cast<std::size_t>(width));
            evaluator.EvaluateRange(level, Osd::BufferView<const double>(values, width),
                                    Osd::BufferView<double>(refined, width), 0, n);
            values = std::move(refined);
        };
        evaluate(result_.positions, 3);
        for (Io::Attribute& attribute : result_.point_data) evaluate(attribute.values, attribute.width);
    }
    if (settings_.limit) ApplyLimit();
}

/// Calls body with the elements of the levels.
template <class Body>
void Refinement::WithElements(Body&& body) const {
    if (refiner_->is_polyhedral()) {
        body(RefinedPolyhedra(control_.topology, *refiner_, left_out_));
    } else {
        body(RefinedElements(control_.topology, *refiner_, left_out_));
    }
}

void Refinement::KeepLevel(int level) {
    WithElements([&](const auto& elements) {
        earlier_.push_back({.topology = elements.At(level),
                            .positions = result_.positions,
                            .point_data = result_.point_data,
                            .cell_data = {},
                            .notes = {}});
    });
}

void Refinement::ApplyLimit() {
    session_.Stage("limit");
    Geometry::VertexLimits limits = Geometry::LimitsOfVertices(*refiner_, settings_.choice.scheme, settings_.levels);
    without_limit_ = std::move(limits.without_limit);
    const Index n = limits.rows.n_sources;
    const auto table = Far::StencilTable::FromRows(n, {std::move(limits.rows)});
    Osd::Evaluator evaluator(table, Osd::Backend::Best());
    const auto push = [&](std::vector<double>& values, int width) {
        std::vector<double> pushed(values.size());
        evaluator.Evaluate(values, pushed, width);
        values = std::move(pushed);
    };
    push(result_.positions, 3);
    for (Io::Attribute& attribute : result_.point_data) push(attribute.values, attribute.width);
}

void Refinement::GatherElements() {
    WithElements([&](const auto& elements) {
        const auto n_creases = static_cast<Offset>(creases_.edge_sharpness.size() + creases_.vertices.size());
        n_tags_ = std::max<Offset>(0, elements.n_tags() + control_.topology.n_point_elements() - n_creases);
        result_.topology = elements.At(settings_.levels);
        std::vector<Offset> rows;
        CopyCellData(control_, result_, [&](const Io::Attribute& attribute) {
            if (rows.empty()) rows = elements.ControlRows(settings_.levels);
            return InheritedRows(attribute, rows);
        });
        is_left_out_ = elements.LeftOut(settings_.levels);
        n_faces_left_out_ = elements.n_left_out();
    });
    if (!refiner_->is_polyhedral()) AddDiagonals(result_, {});
    for (const auto& option : control_.scheme_options) {
        if (option.second != "none") result_.scheme_options.push_back(option);  // the border that was dropped is gone
    }
    result_creases_ = Far::CreasesAt(*refiner_, settings_.choice.scheme, settings_.levels);
    if (!is_left_out_.empty()) LeaveOut();
    const Far::Creases& kept = result_creases_;
    Io::SetCreases(result_, settings_.keep_creases
                                ? Io::Creases{kept.edges, kept.edge_sharpness, kept.vertices, kept.vertex_sharpness}
                                : Io::Creases{});
}

/// Vertices that only the faces left out have go too, and what was sharp there: of a sharp edge between two such faces
/// every child has an end that goes.
void Refinement::LeaveOut() {
    if (result_.topology.n_elements() == 0) {
        throw InvalidInput("all its faces are holes, or lie at a border that is dropped: nothing is left to write");
    }
    const int level = settings_.levels;
    kept_vertices_ =
        VerticesInUse(result_.topology, refiner_->is_polyhedral() ? refiner_->polyhedral_level(level).boundary_vertices
                                                                  : refiner_->level(level).boundary_vertices);
    result_creases_ = Among(result_creases_, NewNumbers(kept_vertices_, result_.topology.n_vertices));
    KeepVertices(result_, kept_vertices_);
}

void Refinement::GatherControl() {
    // Tets stay as they came, with their diagonals beside them. Octs take theirs in their order: it decides how they
    // are cut for formats that don't hold them.
    result_.topology = control_.topology;
    result_.topology.octs = diagonals_.octs;
    for (const Io::Attribute& attribute : control_.cell_data) {
        if (attribute.name != kDiagonalName) result_.cell_data.push_back(attribute);
    }
    result_.scheme_options = control_.scheme_options;
    if (refiner_->is_polyhedral()) return;
    const auto first = diagonals_.diagonals.begin();
    AddDiagonals(result_, {first, first + control_.topology.n_tets()});
}

Io::Mesh Refinement::Boundary() const {
    const int level = settings_.levels;
    Geometry::BoundarySurface surface = refiner_->is_polyhedral()
                                            ? Geometry::ExtractBoundary(refiner_->polyhedral_level(level), is_left_out_)
                                            : Geometry::ExtractBoundary(refiner_->level(level), is_left_out_);
    Io::Mesh mesh;
    mesh.topology.n_vertices = static_cast<Index>(surface.vertices.size());
    AddPolygons(surface.rows, surface.corners, mesh.topology);
    if (!kept_vertices_.empty()) {  // the result has new numbers
        const std::vector<Index> numbers = NewNumbers(kept_vertices_, refiner_->n_vertices(level));
        for (Index& v : surface.vertices) v = numbers[v];
    }
    mesh.positions = Geometry::GatherRows(result_.positions, 3, surface.vertices);
    for (const Io::Attribute& a : result_.point_data) {
        mesh.point_data.push_back({a.name, a.width, Geometry::GatherRows(a.values, a.width, surface.vertices)});
    }
    return mesh;
}

void NoteWithoutLimit(Session& session, const std::string& input, const Refinement& refinement) {
    const std::vector<Index>& vertices = refinement.without_limit();
    if (vertices.empty()) return;
    session.Note(input + ": " + Counted(static_cast<Offset>(vertices.size()), "vertex", "vertices") + " of level " +
                 std::to_string(refinement.refiner().max_level()) +
                 " without a limit left in place, the first: vertex " + std::to_string(vertices.front()));
}

}  // namespace SolidSubdiv::Cli

// SPDX-License-Identifier: Apache-2.0
// The steps of `refine`.
#include <solidsubdiv/apps/cli/refinement.h>

#include <unistd.h>

#include <algorithm>
#include <limits>

#include <solidsubdiv/apps/cli/diagonal_data.h>
#include <solidsubdiv/apps/cli/refined_mesh.h>
#include <solidsubdiv/far/limit_stencil_table.h>
#include <solidsubdiv/kit/geometry/compact_surface.h>
#include <solidsubdiv/osd/evaluator.h>

namespace SolidSubdiv::Cli {

namespace {

/// The descriptor of a mesh with other vertex orders of its cells.
Far::TopologyDescriptor Reordered(const Io::Topology& topology, const Far::DiagonalChoice& choice,
                                  const Io::Creases& creases) {
    Far::TopologyDescriptor descriptor = topology.View();
    descriptor.tets = choice.tets;
    descriptor.octs = choice.octs;
    creases.AddTo(descriptor);
    return descriptor;
}

/// Data of every element but the diagonals, which are made anew.
template <class Rows>
void CopyCellData(const Io::Mesh& from, Io::Mesh& to, Rows&& rows) {
    for (const Io::Attribute& attribute : from.cell_data) {
        if (attribute.name != kDiagonalName) to.cell_data.push_back(rows(attribute));
    }
}

/// Refuses what this machine's memory can't hold: the levels, the table of all of them, two copies of the refined
/// values, and the refined elements as they are and as they are written, octahedra cut into four. What indices can't
/// count is left to the refiner. @throws InvalidInput
void RequireMemory(const Far::TopologyRefiner& refiner, const RefinementSettings& settings, const Io::Mesh& control) {
    constexpr Offset bytes_of_row = 8 + 9 * 12;             // about nine weights and their indices
    constexpr Offset bytes_of_element = 16 + 16 + 16 + 13;  // tet, the same once more, connectivity, offset and type
    Offset width = 3, cell_width = 1;
    for (const Io::Attribute& a : control.point_data) width += a.width;
    for (const Io::Attribute& a : control.cell_data) cell_width += a.width;

    Vtr::Counts last = refiner.CountsAt(0);
    Offset bytes = refiner.Bytes();
    for (int i = 1; i <= settings.levels; ++i) {
        last = Vtr::Refine(last);
        if (last.Largest() > std::numeric_limits<Index>::max()) return;
        bytes += Vtr::EstimateBytes(last, i < settings.levels || settings.limit) + bytes_of_row * last.n_vertices;
    }
    bytes += 2 * 8 * width * last.n_vertices;
    bytes += (bytes_of_element + 2 * 8 * cell_width) * (last.n_tets + 4 * last.n_octs);
    const Offset machine = static_cast<Offset>(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGESIZE);
    if (bytes <= machine) return;
    throw InvalidInput("level " + std::to_string(settings.levels) + " would have " + std::to_string(last.n_cells()) +
                       " cells, and to make and write them takes about " + Far::BytesText(bytes) + " (" +
                       std::to_string(bytes) + " bytes), more than the " + Far::BytesText(machine) +
                       " of this machine; refine fewer times");
}

void AddDiagonals(Io::Mesh& mesh, std::vector<double> values) {
    if (mesh.topology.n_cells() == 0) return;
    values.resize(static_cast<std::size_t>(mesh.topology.n_elements()), 0.0);
    mesh.cell_data.push_back({std::string(kDiagonalName), 1, std::move(values)});
}

}  // namespace

Refinement::Refinement(Io::Mesh control, const RefinementSettings& settings, Session& session)
    : settings_(settings), session_(session), control_(std::move(control)) {
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

void Refinement::Orient() {
    orientation_ =
        Geometry::OrientCells(control_.topology.tets, control_.topology.octs, control_.positions, settings_.orient);
}

void Refinement::ChooseDiagonals() {
    std::vector<std::uint8_t> given;
    if (settings_.choice.diagonals == Far::DiagonalPolicy::Given && control_.topology.n_cells() > 0) {
        given = RequireDiagonalData(control_);
    }
    // Kinds that can't be refined are refused with their names; that comes before anything is said of diagonals.
    if (!refiner_ && control_.topology.n_tets() + control_.topology.n_octs() != control_.topology.n_cells()) {
        Far::TopologyRefiner::Create(control_.topology.View(), Sdc::Split::TetOct);
    }
    diagonals_ = Far::ChooseDiagonals(control_.topology.View(), settings_.choice.diagonals, control_.positions, given);
}

void Refinement::RefineTopology() {
    creases_ = Io::CreasesOf(control_);
    refiner_ = Far::TopologyRefiner::Create(Reordered(control_.topology, diagonals_, creases_), Sdc::Split::TetOct);
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
        const Index n = refiner_->level(level).n_vertices;
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

void Refinement::KeepLevel(int level) {
    earlier_.push_back({.topology = RefinedElements(control_.topology, *refiner_, settings_.drop_border).At(level),
                        .positions = result_.positions,
                        .point_data = result_.point_data,
                        .cell_data = {},
                        .notes = {}});
}

void Refinement::ApplyLimit() {
    session_.Stage("limit");
    const auto limit = Far::LimitStencilTable::Create(*refiner_, settings_.choice.scheme);
    n_without_limit_ = static_cast<Offset>(limit.without_limit().size());
    const auto table = Far::StencilTable::FromRows(limit.rows().n_sources, {limit.rows()});
    Osd::Evaluator evaluator(table, Osd::Backend::Best());
    const auto push = [&](std::vector<double>& values, int width) {
        std::vector<double> pushed(values.size());
        evaluator.Evaluate(values, pushed, width);
        for (Index v : limit.without_limit()) {  // stays where it is
            std::copy_n(values.begin() + Offset{width} * v, width, pushed.begin() + Offset{width} * v);
        }
        values = std::move(pushed);
    };
    push(result_.positions, 3);
    for (Io::Attribute& attribute : result_.point_data) push(attribute.values, attribute.width);
}

void Refinement::GatherElements() {
    const RefinedElements elements(control_.topology, *refiner_, settings_.drop_border);
    const auto n_creases = static_cast<Offset>(creases_.edge_sharpness.size() + creases_.vertices.size());
    n_tags_ = std::max<Offset>(0, elements.n_tags() + control_.topology.n_point_elements() - n_creases);
    result_.topology = elements.At(settings_.levels);
    std::vector<Offset> rows;
    CopyCellData(control_, result_, [&](const Io::Attribute& attribute) {
        if (rows.empty()) rows = elements.ControlRows(settings_.levels);
        return InheritedRows(attribute, rows);
    });
    AddDiagonals(result_, {});
    for (const auto& option : control_.scheme_options) {
        if (option.second != "none") result_.scheme_options.push_back(option);  // the border that was dropped is gone
    }
    result_creases_ = Far::CreasesAt(*refiner_, settings_.choice.scheme, settings_.levels);
    const Far::Creases& kept = result_creases_;
    Io::SetCreases(result_, settings_.keep_creases
                                ? Io::Creases{kept.edges, kept.edge_sharpness, kept.vertices, kept.vertex_sharpness}
                                : Io::Creases{});
}

void Refinement::GatherControl() {
    // Tets stay as they came, with their diagonals beside them. Octs take theirs in their order: it decides how they
    // are cut for formats that don't hold them.
    result_.topology = control_.topology;
    result_.topology.octs = diagonals_.octs;
    CopyCellData(control_, result_, [](const Io::Attribute& attribute) { return attribute; });
    const auto first = diagonals_.diagonals.begin();
    AddDiagonals(result_, {first, first + control_.topology.n_tets()});
}

Io::Mesh Refinement::Boundary() const {
    const Geometry::CompactSurface surface = Geometry::ExtractBoundary(refiner_->level(settings_.levels));
    Io::Mesh mesh;
    mesh.topology.n_vertices = static_cast<Index>(surface.vertices.size());
    mesh.topology.triangles = surface.triangles;
    mesh.positions = Geometry::GatherRows(result_.positions, 3, surface.vertices);
    for (const Io::Attribute& a : result_.point_data) {
        mesh.point_data.push_back({a.name, a.width, Geometry::GatherRows(a.values, a.width, surface.vertices)});
    }
    return mesh;
}

}  // namespace SolidSubdiv::Cli

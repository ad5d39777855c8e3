// SPDX-License-Identifier: Apache-2.0
// Validator ffd-laws: affine maps, lattices at rest, equal bits and the reach of control points, under every scheme.
#include "ffd_laws.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

#include <solidsubdiv/apps/deform/octree_lattices.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/sdc/parallel.h>

#include "cell_shapes.h"
#include "ffd_oracle.h"
#include "location.h"
#include "meshes.h"
#include "points.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

using Points = std::vector<double>;

constexpr Offset kMoves = 6;    // of one control point, in each lattice
constexpr double kFloat = 1e6;  // 1e-6 of the size is asked for in float, 1e-12 in double

template <class T>
bool HasSameBits(const T& a, const T& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
}

bool HasSameBits(std::span<const double> a, std::span<const double> b, std::size_t point) {
    return std::memcmp(&a[3 * point], &b[3 * point], 3 * sizeof(double)) == 0;
}

std::vector<Index> AllPoints(Index n) {
    std::vector<Index> all(static_cast<std::size_t>(n));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

Points DeformAll(const Deform::Embedding& embedding, std::span<const double> control) {
    Points points(3 * static_cast<std::size_t>(embedding.n_points()));
    Deform::Deformer(embedding).Deform(control, points);
    return points;
}

Points DeformInFloat(const Deform::Embedding& embedding, std::span<const double> control) {
    const std::vector<float> floats(control.begin(), control.end());
    std::vector<float> points(3 * static_cast<std::size_t>(embedding.n_points()));
    Deform::DeformerReal<float>(embedding).Deform(floats, points);
    return {points.begin(), points.end()};
}

std::vector<std::vector<int>> CellsOfHexes(std::span<const Index> hexes) {
    std::vector<std::vector<int>> cells;
    for (std::size_t c = 0; c < hexes.size(); c += 8) cells.emplace_back(&hexes[c], &hexes[c] + 8);
    return cells;
}

bool IsOfTetsAndOcts(const Far::TopologyDescriptor& lattice) {
    return lattice.hexes.empty() && lattice.wedges.empty() && lattice.pyramids.empty() &&
           lattice.polyhedron_vertices.empty();
}

std::vector<Sdc::Scheme> SchemesFor(const FfdShape& shape) {
    if (IsOfTetsAndOcts(shape.lattice)) {
        return {Sdc::BoxSpline{}, Sdc::SmoothTet{}, Sdc::Interpolatory{}, Sdc::LinearSolid{}};
    }
    return {Sdc::CatmullClarkSolid{}, Sdc::Mlca{}, Sdc::LinearSolid{}};
}

void CheckLaws(const FfdShape& shape, const Deform::EmbedOptions& options, int& most_steps, Findings& findings) {
    const auto create = [&](const Deform::EmbedOptions& o, int n_threads) {
        const Sdc::ThreadLimit limit(n_threads);
        return Deform::Embedding::Create(shape.lattice, shape.control, shape.points, o);
    };
    // Carried alike however far, so that affine maps stay affine outside: cells that bend leave points out. Not so in
    // the limit, which has no derivatives to go on by at its edges and extraordinary vertices.
    Deform::EmbedOptions everywhere = options;
    everywhere.falloff = std::numeric_limits<double>::infinity();
    const Deform::Embedding embedding = create(everywhere, 2);
    CompareBits(embedding, create(everywhere, 1), shape.control, findings);
    const Points expected = MapAffinely(shape.points);
    Points mapped = DeformAll(embedding, MapAffinely(shape.control));
    for (const Deform::OutsidePoint& out : embedding.outside()) {
        const auto first = 3 * static_cast<std::ptrdiff_t>(out.point);
        if (options.limit) std::copy_n(expected.begin() + first, 3, mapped.begin() + first);
    }
    ComparePoints(expected, mapped, SizeOf(MapAffinely(shape.control)), "affine map", findings);
    const double size = SizeOf(shape.control);
    for (const Deform::Outside outside : {Deform::Outside::Clamp, Deform::Outside::Leave, Deform::Outside::Carry}) {
        if (options.limit && outside != Deform::Outside::Clamp) continue;  // they differ in points outside alone
        Deform::EmbedOptions o = options;
        o.outside = outside;
        const Deform::Embedding at_rest = create(o, 2);
        const std::string name = "at rest, " + std::string(NameOf(outside));
        ComparePoints(shape.points, DeformAll(at_rest, shape.control), size, name, findings);
        ComparePoints(shape.points, DeformInFloat(at_rest, shape.control), size * kFloat, name + ", float", findings);
    }
    const bool is_near = std::holds_alternative<Sdc::CatmullClarkSolid>(options.scheme) && !shape.homes.empty();
    const auto rows = embedding.ControlRows(AllPoints(embedding.n_points()));
    for (Offset i = 0; i < kMoves; ++i) {
        const auto moved = static_cast<Index>(i * embedding.n_control_points() / kMoves);
        most_steps =
            std::max(most_steps, CheckMove(shape, rows, MoveOne(embedding, shape.control, moved), is_near, findings));
    }
}

void CheckSchemes(const FfdShape& shape, bool limit, bool is_quick, int& most_steps, Findings& findings) {
    std::vector<Sdc::Scheme> schemes = SchemesFor(shape);
    // Limits are slow: by turns, one scheme a shape.
    if (limit && is_quick) schemes = {schemes[shape.name.size() % schemes.size()]};
    for (const Sdc::Scheme& scheme : schemes) {
        Findings found;
        // Steps of Newton's stop where they are near enough, by default 1e-12 of the size: nearly all that is allowed.
        CheckLaws(shape,
                  {.scheme = scheme,
                   .levels = limit ? 1 : 2,
                   .limit = limit,
                   .tolerance = limit ? 1e-13 * SizeOf(shape.control) : 0},
                  most_steps, found);
        findings.Merge(found, shape.name + ", " + std::string(Sdc::NameOf(scheme)) + (limit ? ", limit" : ""));
    }
}

void CheckLattice(const std::string& name, const Far::TopologyDescriptor& lattice, const std::vector<double>& control,
                  int n_points, bool is_quick, int& most_steps, Findings& findings) {
    // Limits take milliseconds a point where cells are irregular: fewer points.
    for (const bool limit : {false, true}) {
        const int n = limit ? 10 : n_points;
        CheckSchemes(DrawFfdShape(name, lattice, control, is_quick ? n / 5 : n, 1), limit, is_quick, most_steps,
                     findings);
    }
}

/// A model in its octree lattice.
void CheckModel(const std::filesystem::path& path, int level, bool is_quick, int& most_steps, Findings& findings) {
    const std::string name = path.filename().string() + ", level " + std::to_string(level);
    if (!std::filesystem::exists(path)) {
        findings.skipped.push_back(name + ": there is no " + path.string());
        return;
    }
    const Io::Mesh mesh = Io::ReadMesh(path);
    const auto hierarchy = Deform::MakeOctreeLattices(mesh.positions, mesh.topology.triangles, {.levels = level});
    const Deform::ControlLattice& lattice = hierarchy.levels.back().lattice;
    for (const bool limit : {false, true}) {
        const std::size_t n = (limit ? 100 : 2000) / (is_quick ? 20 : 1);
        const std::size_t step = 3 * std::max<std::size_t>(1, mesh.positions.size() / (3 * n));
        Points points;
        for (std::size_t i = 0; i < mesh.positions.size(); i += step) {
            points.insert(points.end(), &mesh.positions[i], &mesh.positions[i] + 3);
        }
        CheckSchemes(InBoxes(name, lattice, std::move(points)), limit, is_quick, most_steps, findings);
    }
}

}  // namespace

FfdShape DrawFfdShape(std::string name, const Far::TopologyDescriptor& lattice, std::vector<double> control, int n,
                      std::uint32_t seed) {
    FfdShape shape{std::move(name), lattice, std::move(control), {}};
    const bool is_tet_oct = IsOfTetsAndOcts(lattice);
    const auto refiner =
        Far::TopologyRefiner::Create(lattice, is_tet_oct ? Sdc::Split::TetOct : Sdc::Split::Polyhedral);
    const LocationShape cells{refiner, 0, shape.control};
    const auto drawn = DrawPlaces(cells, n, seed);
    shape.points = EvaluatePlainly(cells, drawn);
    if (8 * static_cast<std::size_t>(refiner.n_cells(0)) == lattice.hexes.size()) {
        shape.cells = CellsOfHexes(lattice.hexes);
        for (const Far::Place& place : drawn) shape.homes.push_back(place.element);
    }
    return shape;
}

FfdShape InBoxes(std::string name, const Deform::ControlLattice& lattice, std::vector<double> points) {
    FfdShape shape{std::move(name), lattice.View(), lattice.positions, std::move(points), CellsOfHexes(lattice.hexes)};
    const double slack = 1e-12 * SizeOf(shape.control);
    for (std::size_t i = 0; i < shape.points.size(); i += 3) {
        const auto holds = [&](const std::vector<int>& cell) {
            const double *const low = &shape.control[3 * static_cast<std::size_t>(cell[0])],
                                *const high = &shape.control[3 * static_cast<std::size_t>(cell[6])];
            for (std::size_t c = 0; c < 3; ++c) {
                if (shape.points[i + c] < low[c] - slack || shape.points[i + c] > high[c] + slack) return false;
            }
            return true;
        };
        const auto home = std::find_if(shape.cells.begin(), shape.cells.end(), holds);
        if (home == shape.cells.end()) throw InvalidInput("point " + std::to_string(i / 3) + " is in no cell");
        shape.homes.push_back(static_cast<int>(home - shape.cells.begin()));
    }
    return shape;
}

std::vector<double> MapAffinely(std::span<const double> points) {
    constexpr double kMap[3][4] = {{1.3, 0.4, -0.2, 0.3}, {-0.7, 0.9, 0.5, -0.1}, {0.2, -0.6, 1.1, 0.2}};
    Points mapped;
    for (std::size_t i = 0; i < points.size(); i += 3) {
        for (const auto& m : kMap) {
            mapped.push_back(m[0] * points[i] + m[1] * points[i + 1] + m[2] * points[i + 2] + m[3]);
        }
    }
    return mapped;
}

void ComparePoints(std::span<const double> expected, std::span<const double> found, double size,
                   const std::string& what, Findings& findings) {
    if (expected.size() != found.size()) {
        findings.Fault(what + ": another number of points");
        return;
    }
    for (std::size_t i = 0; i < expected.size(); i += 3) {
        const double error =
            std::hypot(found[i] - expected[i], found[i + 1] - expected[i + 1], found[i + 2] - expected[i + 2]);
        findings.Error(error / size, [&] { return what + ", point " + std::to_string(i / 3); });
    }
}

void CompareBits(const Deform::Embedding& a, const Deform::Embedding& b, std::span<const double> control,
                 Findings& findings) {
    ++findings.n_compared;
    if (a.n_points() != b.n_points()) {
        findings.Fault("another number of points");
        return;
    }
    const std::vector<Index> all = AllPoints(a.n_points());
    const auto rows_a = a.ControlRows(all), rows_b = b.ControlRows(all);
    if (!HasSameBits(rows_a.offsets, rows_b.offsets) || !HasSameBits(rows_a.indices, rows_b.indices) ||
        !HasSameBits(rows_a.weights, rows_b.weights)) {
        findings.Fault("embedded twice, other rows");
    }
    if (!HasSameBits(DeformAll(a, control), DeformAll(b, control))) findings.Fault("embedded twice, other points");
}

FfdMove MoveOne(const Deform::Embedding& embedding, std::span<const double> control, Index control_point) {
    FfdMove move;
    move.control_point = control_point;
    Deform::Deformer deformer(embedding);
    Points moved(control.begin(), control.end());
    move.before.resize(3 * static_cast<std::size_t>(embedding.n_points()));
    deformer.Deform(moved, move.before);
    const double step = 0.1 * SizeOf(control);
    for (std::size_t c = 0; c < 3; ++c) moved[3 * static_cast<std::size_t>(control_point) + c] += step;
    move.updated = move.before;
    const auto written = deformer.Update(std::span(&control_point, 1), moved, move.updated);
    move.written.assign(written.begin(), written.end());
    move.deformed = DeformAll(embedding, moved);
    move.affected = deformer.Affected(std::span(&control_point, 1));
    return move;
}

int CheckMove(const FfdShape& shape, const Far::StencilRows<double>& rows, const FfdMove& move, bool is_near,
              Findings& findings) {
    const std::size_t n = shape.points.size() / 3;
    if (static_cast<std::size_t>(rows.n_rows()) != n || move.updated.size() != 3 * n || move.before.size() != 3 * n ||
        move.deformed.size() != 3 * n) {
        findings.Fault("another number of points");
        return 0;
    }
    findings.n_compared += static_cast<std::int64_t>(n);
    const auto of = " of control point " + std::to_string(move.control_point);
    const std::vector<int> steps =
        is_near ? StepsByCells(shape.cells, static_cast<int>(shape.control.size() / 3), move.control_point)
                : std::vector<int>{};
    std::vector<bool> is_affected(n), is_written(n);
    for (Index v : move.affected) is_affected[static_cast<std::size_t>(v)] = true;
    for (Index v : move.written) is_written[static_cast<std::size_t>(v)] = true;
    int most_steps = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const auto fault = [&](const std::string& what) { findings.Fault("point " + std::to_string(i) + ": " + what); };
        const auto columns = rows.Indices(static_cast<Index>(i));
        const bool is_in_row = std::find(columns.begin(), columns.end(), move.control_point) != columns.end();
        if (is_in_row != is_affected[i]) fault("the affected set" + of + " is not that of the rows");
        if (is_in_row && !is_written[i]) fault("left out by an update" + of);
        if (!HasSameBits(move.updated, move.deformed, i)) fault("an update" + of + " gives other bits");
        if (!is_in_row && !HasSameBits(move.updated, move.before, i)) fault("changed by a move" + of);
        if (!is_in_row || !is_near) continue;
        for (int v : shape.cells[static_cast<std::size_t>(shape.homes[i])]) {
            const int step = steps[static_cast<std::size_t>(v)];
            most_steps = std::max(most_steps, step);
            if (step < 0 || step > 3) fault("affected, but in a cell that is not in N_p,3" + of);
        }
    }
    return most_steps;
}

Findings ValidateFfdLaws(const Context& context) {
    Findings findings;
    int most_steps = 0;
    for (const CellShape& cells : CellShapes()) {
        const DescribedCells described(cells);
        CheckLattice(cells.name, described.descriptor, cells.positions, 100, context.is_quick, most_steps, findings);
    }
    std::vector<SolidShape> solids = ManifoldShapes();
    solids.push_back(ReadSolidShape(context.shapes / "demo" / "bunny_lattice.vtu", "a real lattice"));
    for (const SolidShape& solid : solids) {
        const CellArrays arrays(solid.complex);
        CheckLattice(solid.name, arrays.Descriptor(solid.n_vertices()), solid.positions, 100, context.is_quick,
                     most_steps, findings);
    }
    const std::filesystem::path hexes = context.tets.parent_path() / "hexes";
    for (const auto& path : {context.tets / "sofa_liver.msh", hexes / "cino_ellipsoid.mesh",
                             hexes / "cino_rockerarm.mesh", hexes / "mfem_fichera-mixed.vtk"}) {
        const std::string name = path.filename().string();
        if (!std::filesystem::exists(path)) {
            findings.skipped.push_back(name + ": there is no " + path.string());
            continue;
        }
        const Io::Mesh mesh = Io::ReadSolid(path);
        if (context.is_quick && mesh.topology.n_cells() > 1000) continue;
        CheckLattice(name, mesh.topology, mesh.positions, 500, context.is_quick, most_steps, findings);
    }
    const std::filesystem::path surfaces = context.tets.parent_path() / "surfaces";
    for (int level : {0, 2, 4}) {
        if (context.is_quick && level > 2) continue;
        for (const auto& path : {context.shapes / "demo" / "bunny.obj", surfaces / "ode_koala.obj",
                                 surfaces / "hoppe_mechpart.recon.obj", surfaces / "ode_human_woman.obj"}) {
            CheckModel(path, level, context.is_quick, most_steps, findings);
        }
    }
    findings.notes.push_back("cells of affected points are at most " + std::to_string(most_steps) +
                             " steps from the control point that moves");
    return findings;
}

}  // namespace SolidSubdiv::Validation

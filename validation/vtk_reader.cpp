// SPDX-License-Identifier: Apache-2.0
// Validator vtk-reader: VTU files as the framework and its program write them, read by VTK.
#include <cstdlib>
#include <stdexcept>

#include <solidsubdiv/far/choose_diagonals.h>
#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/osd/evaluator.h>

#include "validators.h"
#include "vtk_files.h"

namespace SolidSubdiv::Validation {

namespace {

/// A mesh of the last level, with its point data and a cell attribute.
Io::Mesh Refine(const Io::Mesh& control, int n_levels, const Sdc::Scheme& scheme) {
    const auto choice = Far::ChooseDiagonals(control.topology.View(), Far::DiagonalPolicy::Matched);
    Far::TopologyDescriptor descriptor = control.topology.View();
    descriptor.tets = choice.tets;
    descriptor.octs = choice.octs;
    auto refiner = Far::TopologyRefiner::Create(descriptor, Sdc::Split::TetOct);
    Far::UniformRefinementOptions options;
    options.max_level = n_levels;
    refiner.RefineUniform(options);
    const Far::Level& last = refiner.level(n_levels);
    const auto table = Far::StencilTable::Create(refiner, scheme);
    Osd::Evaluator evaluator(table, Osd::Backend::Best());
    const auto evaluate = [&](const std::vector<double>& values, int width) {
        std::vector<double> fine(static_cast<std::size_t>(width) * static_cast<std::size_t>(last.n_vertices));
        evaluator.Evaluate(std::span<const double>(values), std::span<double>(fine), width);
        return fine;
    };

    Io::Mesh mesh;
    mesh.topology.n_vertices = last.n_vertices;
    mesh.topology.tets.assign(last.tet_vertices.begin(), last.tet_vertices.end());
    mesh.topology.octs.assign(last.oct_vertices.begin(), last.oct_vertices.end());
    if (last.n_cells() == 0)
        mesh.topology.triangles.assign(last.boundary_vertices.begin(), last.boundary_vertices.end());
    mesh.positions = evaluate(control.positions, 3);
    for (const Io::Attribute& a : control.point_data) {
        mesh.point_data.push_back({a.name, a.width, evaluate(a.values, a.width)});
    }
    mesh.point_data.push_back({"a name with spaces, <, & and \"", 3, mesh.positions});
    std::vector<double> numbers(static_cast<std::size_t>(mesh.topology.n_elements()));
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<double>(i % 3);
    mesh.cell_data.push_back({"diagonal", 1, std::move(numbers)});
    return mesh;
}

struct WrittenFile {
    std::filesystem::path path;
    std::string name;
    GridSummary expected;
};

void WriteEveryForm(const Io::Mesh& mesh, const std::string& name, const Context& context,
                    std::vector<WrittenFile>& files) {
    for (const bool binary : {false, true}) {
        for (const bool keep_octahedra : {false, true}) {
            Io::WriteOptions options;
            options.binary = binary;
            options.keep_octahedra = keep_octahedra;
            const std::string form =
                name + (binary ? ", compressed" : ", ascii") + (keep_octahedra ? ", octahedra kept" : "");
            const auto path = context.scratch / ("file " + std::to_string(files.size()) + ".vtu");
            Io::WriteMesh(path, mesh, options);
            files.push_back({path, form, Expect(mesh, keep_octahedra)});
        }
    }
}

/// What the program itself writes; what to expect is in the file as our reader takes it, its counts by formula.
void RunProgram(const std::filesystem::path& input, const Context& context, std::vector<WrittenFile>& files,
                Findings& findings) {
    const auto program = context.programs / "solidsubdiv";
    if (!std::filesystem::exists(program)) {
        findings.skipped.push_back("files of the program: there is no " + program.string());
        return;
    }
    constexpr int kLevels = 2;
    const Io::Mesh control = Io::ReadMesh(input);
    auto refiner = Far::TopologyRefiner::Create(control.topology.View(), Sdc::Split::TetOct);
    for (const bool keep_octahedra : {false, true}) {
        for (const bool ascii : {false, true}) {
            const auto path = context.scratch / ("program " + std::to_string(files.size()) + ".vtu");
            const std::string command = "'" + program.string() + "' refine '" + input.string() + "' -o '" +
                                        path.string() + "' --scheme box-spline --quiet --levels " +
                                        std::to_string(kLevels) + (keep_octahedra ? " --keep-octahedra" : "") +
                                        (ascii ? " --ascii" : "");
            if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
            const Io::Mesh mesh = Io::ReadMesh(path);
            GridSummary expected = Expect(mesh, true);  // octahedra are in the file as it says
            const Vtr::Counts counts = refiner.CountsAt(kLevels);
            expected.n_points = counts.n_vertices;
            expected.n_cells = {{10, counts.n_tets + (keep_octahedra ? 0 : 4 * counts.n_octs)}};
            if (keep_octahedra) expected.n_cells[42] = counts.n_octs;
            files.push_back({path,
                             "solidsubdiv refine" + std::string(keep_octahedra ? " --keep-octahedra" : "") +
                                 (ascii ? " --ascii" : ""),
                             expected});
        }
    }
}

}  // namespace

Findings ValidateVtkReader(const Context& context) {
    Findings findings;
    std::vector<WrittenFile> files;
    const auto bunny = context.shapes / "demo" / "bunny_lattice.vtu";
    const auto lattice = context.shapes / "validation" / "lattice_28.vtu";
    const Io::Mesh small = Io::ReadSolid(lattice), large = Io::ReadSolid(bunny);
    WriteEveryForm(Refine(small, 0, Sdc::BoxSpline{}), "lattice_28, level 0", context, files);
    WriteEveryForm(Refine(small, 2, Sdc::BoxSpline{}), "lattice_28, level 2", context, files);
    WriteEveryForm(Refine(large, 1, Sdc::LinearSolid{}), "bunny_lattice, linear, level 1", context, files);
    WriteEveryForm(Refine(Io::ReadMesh(context.shapes / "demo" / "bunny.obj"), 1, Sdc::Loop{}),
                   "bunny surface, level 1", context, files);
    WriteEveryForm(Refine(large, 1, Sdc::BoxSpline{}), "bunny_lattice, box spline, level 1", context, files);
    RunProgram(lattice, context, files, findings);

    std::vector<std::filesystem::path> paths = {bunny, lattice};
    for (const WrittenFile& file : files) paths.push_back(file.path);
    const std::vector<GridSummary> grids = ReadByVtk(context.scripts / "vtk_reader.py", paths);
    for (std::size_t i = 0; i < paths.size(); ++i) {
        Findings found;
        const bool committed = i < 2;
        const GridSummary expected = committed ? Expect(Io::ReadMesh(paths[i]), true) : files[i - 2].expected;
        if (expected.n_inverted > 0) found.Fault("a cell of no positive volume");
        CompareGrids(expected, grids[i], found);
        findings.Merge(found, committed ? paths[i].filename().string() : files[i - 2].name);
    }
    findings.notes.push_back(std::to_string(paths.size()) + " files");
    return findings;
}

}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
// solidsubdiv sample IN -o OUT: the limit itself, as triangles and quads of the boundary or tets of the inside.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include <solidsubdiv/apps/cli/commands.h>
#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/apps/cli/files_help.h>
#include <solidsubdiv/apps/cli/kind_check.h>
#include <solidsubdiv/apps/cli/mesh_kinds.h>
#include <solidsubdiv/apps/cli/refined_mesh.h>
#include <solidsubdiv/apps/cli/refined_polyhedra.h>
#include <solidsubdiv/apps/cli/refinement.h>
#include <solidsubdiv/kit/geometry/cell_volume.h>
#include <solidsubdiv/kit/geometry/compact_surface.h>
#include <solidsubdiv/kit/geometry/tessellation.h>
#include <solidsubdiv/kit/geometry/tessellation_inside.h>
#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/kit/io/holes.h>

namespace SolidSubdiv::Cli {

namespace {

struct SampleOptions {
    std::string input, output;
    SchemeOptions scheme;
    int rate = 4;
    double tolerance = 0;
    bool inside = false, quads = false, ascii = false;
    std::string orient = "repair";
};

class SampleCommand {
  public:
    SampleCommand(const SampleOptions& options, Session& session) : options_(options), session_(session) {}

    void Run() {
        const Io::Format& format = RequireUsable();
        const std::filesystem::path output = session_.outputs().Stage(options_.output);
        session_.Stage("read");
        Io::Mesh mesh = Io::ReadMesh(options_.input);
        for (const std::string& note : mesh.notes) session_.Note(options_.input + ": " + note);
        json_["input"] = {{"file", options_.input}, {"vertices", mesh.topology.n_vertices}};
        const RefinementSettings settings = Settings(mesh);
        Io::Mesh samples = About(options_.input, [&] {
            if (options_.inside && mesh.topology.n_cells() == 0) {
                throw InvalidInput("has no cells; leave out --inside to sample its surface");
            }
            const Refinement refinement(std::move(mesh), settings, session_);
            if (refinement.orientation().n_inverted() > 0) {
                session_.Note(options_.input + ": " +
                              Counted(refinement.orientation().n_inverted(), "inverted cell", "inverted cells") +
                              (options_.orient == "repair" ? " turned (--orient)" : " kept"));
            }
            return options_.inside ? Inside(refinement)
                                   : Boundary(refinement, settings.choice.scheme, format.extension);
        });
        session_.Stage("write");
        Io::WriteMesh(output, samples, {.binary = !options_.ascii});
        std::string names;
        for (const std::string& name : Io::AttributesLeftOut(output, samples)) {
            names += (names.empty() ? "" : ", ") + name;
        }
        if (!names.empty()) session_.Note(options_.output + ": the format can't carry " + names + ", left out");
        session_.EndStage();
        json_["output"] = {{"file", options_.output}, {"bytes", std::filesystem::file_size(output)}};
        json_["seconds"] = session_.Seconds();
        session_.Print(text_ + "\nwrote " + options_.output);
        session_.Finish(json_);
    }

  private:
    const Io::Format& RequireUsable() const {
        try {
            const Io::Format& format = Io::FormatOf(options_.output);
            const bool can_hold = format.write && (options_.inside ? format.solids : format.surfaces);
            if (!can_hold) {
                throw UsageError(options_.output + ": " + std::string(format.name) + " files can't hold " +
                                 (options_.inside ? "tets; name a .vtu file" : "a surface; name a .ply file"));
            }
            if (options_.quads && format.extension == ".stl") {
                throw UsageError(options_.output + ": STL files hold triangles only; leave out --quads");
            }
            if (options_.inside && (options_.tolerance > 0 || options_.quads)) {
                throw UsageError("--inside makes tets at a --rate; leave out --tolerance and --quads");
            }
            if (options_.inside && !std::has_single_bit(static_cast<unsigned>(options_.rate))) {
                throw UsageError("--inside takes a --rate of 1, 2, 4, 8 ...: cells are halved again and again");
            }
            return format;
        } catch (const IoError& error) {
            throw UsageError(error.what());
        }
    }

    RefinementSettings Settings(const Io::Mesh& mesh) {
        const MeshKind kind{mesh.topology.n_cells() > 0, IsTetOct(mesh.topology)};
        const SchemeOptions scheme = WithFileOptions(options_.scheme, mesh.scheme_options, kind);
        RefinementSettings settings;
        settings.choice = MakeScheme(scheme, kind);
        const Sdc::Scheme& s = settings.choice.scheme;
        settings.split = About(options_.input, [&] { return SplitFor(mesh.topology, s); });
        settings.orient = Geometry::OrientationPolicyOf(options_.orient);
        settings.levels = options_.inside ? std::countr_zero(static_cast<unsigned>(options_.rate)) : 0;
        settings.limit = options_.inside;
        Json& json = json_["settings"];
        json = {{"scheme", Sdc::NameOf(s)}};
        for (const auto& [name, value] : OptionValues(scheme, s)) json[name] = value;
        if (options_.tolerance > 0) {
            json["tolerance"] = options_.tolerance;
        } else {
            json["rate"] = options_.rate;
        }
        json["inside"] = options_.inside;
        json["threads"] = Sdc::ThreadCount();
        return settings;
    }

    Io::Mesh Boundary(const Refinement& refinement, const Sdc::Scheme& scheme, std::string_view extension) {
        const Io::Mesh& control = refinement.control();
        const Far::TopologyRefiner& refiner = refinement.refiner();
        const FacesLeftOut left_out{false, Io::HolesOf(control)};
        session_.Stage("sample");
        const bool has_normals = extension != ".obj" && extension != ".stl";
        const Geometry::TessellationOptions how{
            .rate = options_.rate,
            .tolerance = options_.tolerance,
            .quads = options_.quads,
            .normals = has_normals,
            .is_left_out = refiner.is_polyhedral() ? RefinedPolyhedra(control.topology, refiner, left_out).LeftOut(0)
                                                   : RefinedElements(control.topology, refiner, left_out).LeftOut(0),
            .progress = session_.progress()};
        const Geometry::Tessellation t = Geometry::TessellateBoundary(refiner, scheme, control.positions, how);
        if (t.n_facets() == 0) throw InvalidInput("has no faces to sample");
        Geometry::TessellationError error{t.error, t.n_tests};
        if (options_.tolerance == 0) {
            session_.Stage("measure");
            error = Geometry::MeasureError(refiner, scheme, t, control.positions, session_.progress());
        }
        Io::Mesh mesh;
        mesh.topology.n_vertices = t.n_vertices();
        mesh.topology.triangles = t.triangles;
        mesh.topology.quads = t.quads;
        mesh.positions = t.Positions(control.positions);
        for (const Io::Attribute& a : control.point_data) {
            mesh.point_data.push_back({a.name, a.width, t.Values(a.values, a.width)});
        }
        if (has_normals) AddNormals(t.Normals(control.positions), extension, mesh);
        json_["vertices"] = t.n_vertices();
        json_["triangles"] = mesh.topology.n_triangles();
        json_["quads"] = mesh.topology.n_quads();
        json_["error"] = {{"largest", error.largest}, {"tests", error.n_tests}};
        text_ = Counted(t.n_vertices(), "vertex", "vertices") + ", " +
                (t.triangles.empty() ? "" : Counted(mesh.topology.n_triangles(), "triangle", "triangles")) +
                (t.triangles.empty() || t.quads.empty() ? "" : ", ") +
                (t.quads.empty() ? "" : Counted(mesh.topology.n_quads(), "quad", "quads")) + "\nat " +
                Counted(error.n_tests, "test point", "test points") + " the limit is at most " + Text(error.largest) +
                " away";
        if (options_.tolerance > 0 && error.largest > options_.tolerance) {
            session_.Note(options_.input + ": the tolerance of " + Text(options_.tolerance) +
                          " is not reached: edges were halved as often as they may be");
        }
        return mesh;
    }

    /// PLY has its own names.
    static void AddNormals(const std::vector<double>& normals, std::string_view extension, Io::Mesh& mesh) {
        if (extension != ".ply") {
            mesh.point_data.push_back({"Normals", 3, normals});
            return;
        }
        const char* const names[] = {"nx", "ny", "nz"};
        for (std::size_t k = 0; k < 3; ++k) {
            Io::Attribute a{names[k], 1, {}};
            for (std::size_t i = k; i < normals.size(); i += 3) a.values.push_back(normals[i]);
            mesh.point_data.push_back(std::move(a));
        }
    }

    Io::Mesh Inside(const Refinement& refinement) {
        session_.Stage("cut");
        const Io::Mesh& refined = refinement.result();
        const std::vector<Index> tets =
            Geometry::CutIntoTets(refinement.refiner(), std::countr_zero(static_cast<unsigned>(options_.rate)));
        const Geometry::CompactSurface used = Geometry::MakeCompactSurface(tets, refined.topology.n_vertices);
        Io::Mesh mesh;
        mesh.topology.n_vertices = static_cast<Index>(used.vertices.size());
        mesh.topology.tets = used.corners;
        mesh.positions = Geometry::GatherRows(refined.positions, 3, used.vertices);
        for (const Io::Attribute& a : refined.point_data) {
            mesh.point_data.push_back({a.name, a.width, Geometry::GatherRows(a.values, a.width, used.vertices)});
        }
        double volume = 0;
        Offset n_not_positive = 0;
        for (double v : Geometry::CellVolumes(mesh.topology, mesh.positions)) {
            volume += v;
            n_not_positive += !(v > 0);
        }
        json_["vertices"] = mesh.topology.n_vertices;
        json_["tetrahedra"] = mesh.topology.n_tets();
        json_["volume"] = volume;
        json_["not_positive"] = n_not_positive;
        json_["without_limit"] = refinement.without_limit().size();
        text_ = Counted(mesh.topology.n_vertices, "vertex", "vertices") + ", " +
                Counted(mesh.topology.n_tets(), "tet", "tets") + ", volume " + Text(volume);
        if (n_not_positive > 0) text_ += "; " + Counted(n_not_positive, "tet is", "tets are") + " not positive";
        NoteWithoutLimit(session_, options_.input, refinement);
        return mesh;
    }

    const SampleOptions& options_;
    Session& session_;
    Json json_ = {{"command", "sample"}};
    std::string text_;
};

}  // namespace

Work AddSample(CLI::App& command) {
    const auto options = std::make_shared<SampleOptions>();
    SampleOptions& o = *options;
    command.add_option("IN", o.input, "the control mesh: cells, faces and edges of any kind, or a mix")
        ->required()
        ->option_text(" ");
    command.add_option("-o,--output", o.output, "the samples; the extension chooses the format")
        ->required()
        ->option_text("OUT (required)");
    CLI::Option* rate =
        command.add_option("--rate", o.rate, "cut every edge of the control mesh into N; default 4")->option_text("N");
    rate->check(CLI::Range(1, 4096));
    command
        .add_option("--tolerance", o.tolerance,
                    "instead: as few triangles as keep within this distance\nof the limit, in the mesh's unit")
        ->option_text("T")
        ->check([](const std::string& text) {
            const double tolerance = std::strtod(text.c_str(), nullptr);
            return tolerance > 0 && std::isfinite(tolerance) ? std::string() : "'" + text + "' is no distance above 0";
        })
        ->excludes(rate);
    command.add_flag("--inside", o.inside, "tets of the inside, not the boundary; N is 1, 2, 4, 8 ...");
    command.add_flag("--quads", o.quads, "keep quads that quads are cut into, at a rate");
    AddSchemeOptions(command, o.scheme);
    AddOrientOption(command, o.orient);
    command.add_flag("--ascii", o.ascii, "write text where the format has a binary form too");
    command.footer(
        "Where 'refine' writes the cells of a level, 'sample' writes the limit that they converge to: all vertices lie "
        "on\n"
        "it. What is closed stays closed. By --tolerance triangles are cut where the limit curves, and the largest\n"
        "distance found is said; docs/sampling.md has pictures. Point data come along; normals are written as nx, ny,\n"
        "nz to .ply, as 'Normals' to .vtu and .vtk.\n\n" +
        SchemesHelp() + "\n\n" + ReadableFilesHelp() + "\n" + WritableFilesHelp() +
        "\n\nExamples:\n"
        "  solidsubdiv sample lattice.vtu -o skin.ply --rate 8\n"
        "  solidsubdiv sample lattice.vtu -o skin.stl --scheme interpolatory --tolerance 0.01\n"
        "  solidsubdiv sample lattice.vtu -o solid.vtu --inside --rate 4 --json -");
    return [options](Session& session) { SampleCommand(*options, session).Run(); };
}

}  // namespace SolidSubdiv::Cli

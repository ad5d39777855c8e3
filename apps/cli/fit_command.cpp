// SPDX-License-Identifier: Apache-2.0
// The steps of `fit`: target, start, rounds, refined solid, files.
#include <solidsubdiv/apps/cli/fit_command.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include <solidsubdiv/apps/cli/fit_report.h>
#include <solidsubdiv/apps/cli/lattice_mesh.h>
#include <solidsubdiv/apps/cli/refinement.h>
#include <solidsubdiv/apps/fit/find_start.h>
#include <solidsubdiv/apps/fit/start.h>
#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/kit/geometry/cell_quality.h>
#include <solidsubdiv/kit/geometry/surface_components.h>
#include <solidsubdiv/kit/io/formats.h>

namespace SolidSubdiv::Cli {

namespace {

namespace fs = std::filesystem;

Io::Mesh MeshOf(const Fit::ControlMesh& control) {
    Io::Mesh mesh;
    mesh.positions = control.positions;
    mesh.topology.n_vertices = control.n_vertices();
    mesh.topology.tets = control.tets;
    mesh.topology.octs = control.octs;
    mesh.topology.hexes = control.hexes;
    mesh.topology.triangles = control.triangles;
    mesh.topology.quads = control.quads;
    return mesh;
}

class FitCommand {
  public:
    FitCommand(const FitCommandOptions& options, Session& session) : options_(options), session_(session) {}

    void Run() {
        // What can't be written is found out before any work.
        session_.outputs().MakeFolder(options_.folder);
        const auto stage = [&](const std::string& name) {
            const fs::path file = fs::path(options_.folder) / name;
            staged_.push_back({name, file, session_.outputs().Stage(file)});
        };
        ReadTarget();
        for (const char* name : {"fitted.obj", "fitted.vtu", "fit.json"}) stage(name);
        stage(is_solid_ ? "lattice.vtu" : "cage.obj");
        if (is_solid_) stage("solid.vtu");
#ifdef SOLIDSUBDIV_HAS_PICTURES
        if (options_.pictures) {
            for (const char* name : {"fit.png", "convergence.svg", "report.html"}) stage(name);
        }
#endif
        About(options_.input, [&] {
            MakeStart();
            Solve();
        });
        WriteMeshes();
        if (is_solid_) WriteSolid();
        WriteReport();
        session_.Print(text_);
        session_.Finish(json_);
    }

  private:
    struct Staged {
        std::string name;
        fs::path file, written;
    };

    void ReadTarget() {
        session_.Stage("read");
        const Io::Mesh mesh = Io::ReadMesh(options_.input);
        for (const std::string& note : mesh.notes) session_.Note(options_.input + ": " + note);
        points_ = mesh.positions;
        triangles_ = SurfaceTriangles(mesh);
        if (triangles_.empty()) {
            throw InvalidInput(options_.input + ": has no faces: there is no surface to fit to");
        }
        const auto components = Geometry::SurfaceComponents(triangles_, static_cast<Index>(points_.size() / 3));
        Offset n_border = 0, euler = 0;
        for (const auto& c : components) {
            n_border += c.n_border_edges;
            euler += c.EulerCharacteristic();
        }
        if (About(options_.input, [&] { return Fit::LooksInwards(Target()); })) {
            for (std::size_t t = 0; t < triangles_.size(); t += 3) std::swap(triangles_[t + 1], triangles_[t + 2]);
            session_.Note(options_.input + ": its faces look inwards; turned around");
        }
        diagonal_ = Geometry::BoundingBox(points_).Diagonal();
        if (!(diagonal_ > 0)) throw InvalidInput(options_.input + ": is a single point; there is nothing to fit to");
        is_solid_ = options_.model.empty() ? n_border == 0 : options_.model == "solid";
        if (options_.model.empty() && n_border > 0) {
            session_.Note(options_.input + ": has " + Counted(n_border, "border edge", "border edges") +
                          ": a cage is fitted (--model surface), since it bounds no solid");
        }
        json_["target"] = {{"file", options_.input},
                           {"vertices", points_.size() / 3},
                           {"triangles", triangles_.size() / 3},
                           {"components", components.size()},
                           {"border_edges", n_border},
                           {"euler_characteristic", euler},
                           {"diagonal", diagonal_}};
    }

    Fit::TargetSurface Target() const { return {.positions = points_, .triangles = triangles_}; }

    void MakeStart() {
        session_.Stage("start");
        SchemeOptions scheme = options_.scheme;
        if (scheme.scheme.empty()) scheme.scheme = is_solid_ ? "catmull-clark-solid" : "loop";
        // The cells that a scheme was made for: of solids by what its own default mesh is.
        const bool is_tet_oct = scheme.scheme != "catmull-clark-solid" && scheme.scheme != "mlca";
        const bool is_quad = scheme.scheme == "catmull-clark";
        const MeshKind kind{is_solid_, is_solid_ ? is_tet_oct : !is_quad};
        choice_ = MakeScheme(scheme, kind);
        const Fit::StartOptions how{.n_control = options_.control,
                                    .tets = is_solid_ && is_tet_oct,
                                    .quads = is_quad,
                                    .progress = session_.progress()};
        Fit::StartReport report;
        mesh_ = is_solid_ ? Fit::FindSolidStart(Target(), choice_->scheme, how, &report)
                          : Fit::MakeCage(Target(), how, &report);
        if (!report.has_target_topology) {
            session_.Note(options_.input + ": the start has " + Counted(report.n_components, "piece", "pieces") +
                          " and Euler characteristic " + std::to_string(report.euler) + ", the target " +
                          std::to_string(report.target_components) + " and " + std::to_string(report.target_euler) +
                          ": parts are too thin for so few control points; try more (--control)");
        }
        json_["settings"] = {{"model", is_solid_ ? "solid" : "surface"},
                             {"scheme", Sdc::NameOf(choice_->scheme)},
                             {"control", options_.control},
                             {"levels", options_.levels},
                             {"iterations", options_.fit.max_rounds},
                             {"tolerance", options_.fit.tolerance},
                             {"fairness", options_.fit.least_fairness},
                             {"robust", options_.fit.robust},
                             {"threads", Sdc::ThreadCount()}};
        for (const auto& option : OptionValues(scheme, choice_->scheme))
            json_["settings"][option.first] = option.second;
        json_["control"] = {{"points", mesh_.n_vertices()},
                            {"cells", (mesh_.tets.size() / 4) + (mesh_.octs.size() / 6) + (mesh_.hexes.size() / 8)},
                            {"faces", (mesh_.triangles.size() / 3) + (mesh_.quads.size() / 4)},
                            {"components", report.n_components},
                            {"euler_characteristic", report.euler},
                            {"has_target_topology", report.has_target_topology}};
    }

    void Solve() {
        session_.Stage("fit");
        constexpr int kRate = 4, kFineRate = 12;
        problem_ = Fit::MakeProblem(mesh_, choice_->scheme, Target(), kRate, kFineRate);
        Fit::Options how = options_.fit;
        how.progress = session_.progress();
        result_ = Fit::FitControlPoints(problem_, how);
        if (result_.stopped == "cancelled") throw Cancelled();
        mesh_.positions = result_.control;
        if (result_.n_folded > 0) {
            session_.Note(options_.input + ": " +
                          Counted(result_.n_folded, "corner of a cell is", "corners of cells are") +
                          " folded; try --fairness 0.01 or more control points");
        }
    }

    const Staged& StagedFile(const std::string& name) const {
        return *std::find_if(staged_.begin(), staged_.end(), [&](const Staged& s) { return s.name == name; });
    }
    void AddOutput(const Staged& s) {
        json_["outputs"].push_back({{"file", s.file.string()}, {"bytes", fs::file_size(s.written)}});
    }

    void WriteMeshes() {
        session_.Stage("write");
        const Staged& control = StagedFile(is_solid_ ? "lattice.vtu" : "cage.obj");
        Io::WriteMesh(control.written, MeshOf(mesh_), {.keep_octahedra = true});
        AddOutput(control);
        Io::Mesh surface;
        surface.positions = result_.vertices;
        surface.topology.n_vertices = static_cast<Index>(result_.vertices.size() / 3);
        surface.topology.triangles = problem_.fine.triangles;
        const Staged& obj = StagedFile("fitted.obj");
        Io::WriteMesh(obj.written, surface);
        AddOutput(obj);
        surface.point_data = {{"distance", 1, result_.to_target_distances}};
        const Staged& vtu = StagedFile("fitted.vtu");
        Io::WriteMesh(vtu.written, surface);
        AddOutput(vtu);
    }

    RefinementSettings SettingsAt(int levels, bool limit) const {
        RefinementSettings settings;
        settings.choice = *choice_;
        settings.split = mesh_.hexes.empty() ? Sdc::Split::TetOct : Sdc::Split::Polyhedral;
        settings.levels = levels;
        settings.limit = limit;
        return settings;
    }

    void WriteSolid() {
        session_.Stage("refine");
        const Refinement refinement(MeshOf(mesh_), SettingsAt(options_.levels, true), session_);
        const Staged& solid = StagedFile("solid.vtu");
        Io::WriteMesh(solid.written, refinement.result());
        AddOutput(solid);
        Offset n_folded = 0;
        double least = 1;
        for (const Geometry::CellQuality& q :
             Geometry::MeasureQuality(refinement.refiner(), options_.levels, refinement.result().positions)) {
            n_folded += q.sign == Geometry::MinimumSign::Negative;
            least = std::min(least, q.scaled_jacobian);
        }
        json_["solid"] = {
            {"cells", refinement.result().topology.n_cells()}, {"folded", n_folded}, {"least_scaled_jacobian", least}};
    }

    /// The control mesh as it is seen: of a solid its boundary.
    Io::Mesh ControlSurface() {
        if (!is_solid_) return MeshOf(mesh_);
        return Refinement(MeshOf(mesh_), SettingsAt(0, false), session_).Boundary();
    }

    void WriteReport() {
        const FitSummary summary{result_, problem_, diagonal_};
        json_["fit"] = FitJson(summary);
        text_ = FitText(summary, json_);
        json_["seconds"] = session_.Seconds();
#ifdef SOLIDSUBDIV_HAS_PICTURES
        if (options_.pictures) {
            session_.Stage("pictures");
            const std::string plot = ConvergencePlot(summary);
            const Io::Mesh control = ControlSurface();
            const std::vector<std::uint8_t> picture = FitPicture(summary, control, session_.progress());
            WriteText(StagedFile("convergence.svg").written, plot);
            WriteText(StagedFile("fit.png").written, std::string(picture.begin(), picture.end()));
            WriteText(StagedFile("report.html").written, FitPage(summary, control, json_, text_, plot, picture));
            for (const char* name : {"fit.png", "convergence.svg", "report.html"}) AddOutput(StagedFile(name));
        }
#endif
        session_.EndStage();
        WriteText(StagedFile("fit.json").written, json_.dump(2) + "\n");
        AddOutput(StagedFile("fit.json"));
        for (const Staged& s : staged_) text_ += "\nwrote " + s.file.string();
    }

    const FitCommandOptions& options_;
    Session& session_;
    std::vector<Staged> staged_;
    std::vector<double> points_;
    std::vector<Index> triangles_;
    double diagonal_ = 0;
    bool is_solid_ = false;
    std::optional<SchemeChoice> choice_;
    Fit::ControlMesh mesh_;
    Fit::Problem problem_;
    Fit::Result result_;
    Json json_;
    std::string text_;
};

}  // namespace

void RunFit(const FitCommandOptions& options, Session& session) { FitCommand(options, session).Run(); }

}  // namespace SolidSubdiv::Cli

// SPDX-License-Identifier: Apache-2.0
// The steps of `fit`: target, start, rounds, refined solid, files.
#include <solidsubdiv/apps/cli/fit_command.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include <solidsubdiv/apps/cli/fit_report.h>
#include <solidsubdiv/apps/cli/lattice_mesh.h>
#include <solidsubdiv/apps/cli/refinement.h>
#include <solidsubdiv/apps/fit/creases.h>
#include <solidsubdiv/apps/fit/find_start.h>
#include <solidsubdiv/apps/fit/fit_solid.h>
#include <solidsubdiv/apps/fit/start.h>
#include <solidsubdiv/far/choose_diagonals.h>
#include <solidsubdiv/kit/geometry/cell_quality.h>
#include <solidsubdiv/kit/io/creases.h>
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
    Io::SetCreases(mesh, {control.crease_edges, control.crease_sharpness, {}, {}});
    return mesh;
}

/// Parts of an edge of a control face: in the rounds, and in what is measured and written.
constexpr int kRate = 4, kFineRate = 12;

class FitCommand {
  public:
    FitCommand(const FitCommandOptions& options, Session& session) : options_(options), session_(session) {}

    void Run() {
        RequireTemplate();
        // What can't be written is found out before any work.
        session_.outputs().MakeFolder(options_.folder);
        const auto stage = [&](const std::string& name) {
            const fs::path file = fs::path(options_.folder) / name;
            staged_.push_back({name, file, session_.outputs().Stage(file)});
        };
        ReadTarget();
        if (is_lattice_) ReadTemplate();
        for (const char* name : {"fitted.obj", "fitted.vtu", "fit.json"}) stage(name);
        stage(is_solid_ || is_lattice_ ? "lattice.vtu" : "cage.obj");
        if (is_solid_) stage("solid.vtu");
        if (is_lattice_) stage("start.vtu");
#ifdef SOLIDSUBDIV_HAS_PICTURES
        if (options_.pictures) {
            for (const char* name : {"fit.png", "convergence.svg", "report.html"}) stage(name);
        }
#endif
        About(options_.input, [&] {
            ChooseScheme();
            FitUntilNear();
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

    void RequireTemplate() const {
        const bool has_template = !options_.template_file.empty();
        if (options_.model == "lattice" && !has_template) {
            throw UsageError("--model lattice needs --template: the model that the lattice carries to the target");
        }
        if (has_template && !options_.model.empty() && options_.model != "lattice") {
            throw UsageError("--template is for --model lattice; --model is " + options_.model);
        }
        if (options_.matched && !has_template) throw UsageError("--matched needs --template");
    }

    void ReadTarget() {
        target_ = ReadFitTarget(options_.input, options_.target, session_);
        const bool is_closed = target_.n_border_edges == 0;
        is_lattice_ = options_.model == "lattice" || (options_.model.empty() && !options_.template_file.empty());
        is_solid_ = options_.model.empty() ? is_closed && !is_lattice_ : options_.model == "solid";
        if (options_.model.empty() && !is_closed && !is_lattice_) {
            session_.Note(options_.input + ": has " + Counted(target_.n_border_edges, "border edge", "border edges") +
                          ": a cage is fitted (--model surface), since it bounds no solid");
        }
        if (is_solid_ && !is_closed) CloseFitTarget(options_.input, target_, session_);
        json_["target"] = target_.json;
    }

    void ReadTemplate() {
        template_ = Io::ReadMesh(options_.template_file);
        for (const std::string& note : template_.notes) session_.Note(options_.template_file + ": " + note);
        template_triangles_ = SurfaceTriangles(template_);
        if (template_triangles_.empty()) {
            throw InvalidInput(options_.template_file + ": has no faces: there is no surface to carry");
        }
        if (options_.matched && template_.positions.size() != target_.positions.size()) {
            throw InvalidInput(options_.template_file + ": has " + std::to_string(template_.positions.size() / 3) +
                               " vertices, " + options_.input + " has " + std::to_string(target_.positions.size() / 3) +
                               ": with --matched they must be as many");
        }
        json_["template"] = {{"file", options_.template_file},
                             {"vertices", template_.positions.size() / 3},
                             {"triangles", template_triangles_.size() / 3}};
    }

    void ChooseScheme() {
        SchemeOptions scheme = options_.scheme;
        const bool has_cells = is_solid_ || is_lattice_;
        if (!is_lattice_ && !target_.Surface().triangles.empty()) {
            crease_degrees_ = options_.creases >= 0 ? options_.creases : Fit::SharpAngle(target_.Surface());
        }
        if (scheme.scheme.empty()) {
            // Creases are cut into tets.
            const bool is_sharp_solid = is_solid_ && crease_degrees_ > 0;
            scheme.scheme = is_sharp_solid ? "box-spline" : has_cells ? "catmull-clark-solid" : "loop";
        }
        // The cells that a scheme was made for: of solids by what its own default mesh is.
        is_tet_oct_ = scheme.scheme != "catmull-clark-solid" && scheme.scheme != "mlca";
        is_quad_ = scheme.scheme == "catmull-clark";
        if (is_lattice_ && is_tet_oct_) {
            throw UsageError("--scheme " + scheme.scheme +
                             ": lattices around a template are of hexahedra; use "
                             "catmull-clark-solid or mlca");
        }
        if (is_solid_ && !is_tet_oct_ && crease_degrees_ > 0) {
            if (options_.creases > 0) {
                throw UsageError("--creases is for cages and lattices of tets; --scheme " + scheme.scheme +
                                 " makes one of hexahedra");
            }
            session_.Note(options_.input +
                          ": has sharp edges; hexahedra round them off (--scheme box-spline does not)");
        }
        choice_ = MakeScheme(scheme, MeshKind{has_cells, has_cells ? is_tet_oct_ : !is_quad_});
        json_["settings"] = {{"model", is_lattice_ ? "lattice"
                                       : is_solid_ ? "solid"
                                                   : "surface"},
                             {"scheme", Sdc::NameOf(choice_->scheme)},
                             {"control", options_.control},
                             {"levels", options_.levels},
                             {"iterations", options_.fit.max_rounds},
                             {"tolerance", options_.fit.tolerance},
                             {"fairness", options_.fit.least_fairness},
                             {"robust", options_.fit.robust},
                             {"normals", options_.fit.normals},
                             {"spring", options_.fit.spring},
                             {"threads", Sdc::ThreadCount()}};
        for (const auto& option : OptionValues(scheme, choice_->scheme))
            json_["settings"][option.first] = option.second;
    }

    /// With more control points each time, as long as a tolerance is not met.
    void FitUntilNear() {
        const int most = std::max(options_.control, options_.max_control > 0 ? options_.max_control
                                                                             : std::min(4 * options_.control, 100'000));
        for (int n_control = options_.control;; n_control = std::min(most, n_control + n_control / 2)) {
            if (is_lattice_) {
                MakeLattice(n_control);
            } else {
                MakeStart(n_control);
            }
            Solve();
            const double rms = std::max(result_.to_target.rms, result_.from_target.rms),
                         tolerance = options_.fit.tolerance;
            json_["tried"].push_back({{"control_points", mesh_.n_vertices()}, {"rms", rms}});
            if (!(tolerance > 0) || rms <= tolerance || result_.stopped == "cancelled") break;
            std::ostringstream what;
            what << options_.input << ": RMS " << rms << " with " << mesh_.n_vertices()
                 << " control points, --tolerance is " << tolerance;
            session_.Note(what.str() +
                          (n_control < most ? "; again with more of them" : "; it is not met (--max-control)"));
            if (n_control == most) break;
        }
    }

    /// A lattice of cubes around the template.
    void MakeLattice(int n_control) {
        session_.Stage("start");
        constexpr int kLevels = 2;  // of the cells that the template is put into
        About(options_.template_file, [&] {
            mesh_ = Fit::MakeBoxLattice(template_.positions, n_control);
            problem_ = Fit::MakeLatticeProblem(mesh_, choice_->scheme,
                                               {.positions = template_.positions, .triangles = template_triangles_},
                                               target_.Surface(), kLevels);
        });
        if (options_.matched) problem_.partners = target_.positions;
        json_["settings"]["matched"] = options_.matched;
        json_["control"] = {{"points", mesh_.n_vertices()}, {"cells", mesh_.hexes.size() / 8}, {"faces", 0}};
        start_ = mesh_;
    }

    void MakeStart(int n_control) {
        session_.Stage("start");
        const Fit::StartOptions how{.n_control = n_control,
                                    .tets = is_solid_ && is_tet_oct_,
                                    .quads = is_quad_,
                                    .creases = is_tet_oct_ ? crease_degrees_ : 0,
                                    .progress = session_.progress()};
        Fit::StartReport report;
        constexpr int kTried = 12;
        mesh_ = is_solid_
                    ? Fit::FindSolidStart(target_.Start(), choice_->scheme, how, &report, kTried, target_.Surface())
                    : Fit::MakeCage(target_.Start(), how, &report);
        if (!report.has_target_topology) {
            session_.Note(options_.input + ": the start has " + Counted(report.n_components, "piece", "pieces") +
                          " and Euler characteristic " + std::to_string(report.euler) + ", the target " +
                          std::to_string(report.target_components) + " and " + std::to_string(report.target_euler) +
                          ": parts are too thin for so few control points; try more (--control)");
        }
        if (!is_solid_) {
            if (crease_degrees_ > 0) Fit::MarkCreases(mesh_, target_.Surface(), {.degrees = crease_degrees_});
            problem_ =
                Fit::MakeProblem(mesh_, choice_->scheme, target_.Surface(), kRate, kFineRate, options_.fit.normals > 0);
        }
        json_["control"] = {{"points", mesh_.n_vertices()},
                            {"cells", (mesh_.tets.size() / 4) + (mesh_.octs.size() / 6) + (mesh_.hexes.size() / 8)},
                            {"faces", (mesh_.triangles.size() / 3) + (mesh_.quads.size() / 4)},
                            {"creases", mesh_.crease_sharpness.size()},
                            {"components", report.n_components},
                            {"euler_characteristic", report.euler},
                            {"has_target_topology", report.has_target_topology}};
    }

    void Solve() {
        session_.Stage("fit");
        if (is_solid_ && is_tet_oct_) {  // the fit refines cells as they are ordered
            Far::DiagonalChoice diagonals = Far::ChooseDiagonals(mesh_.View(), choice_->diagonals, mesh_.positions);
            mesh_.tets = std::move(diagonals.tets);
            mesh_.octs = std::move(diagonals.octs);
        }
        Fit::Options how = options_.fit;
        how.progress = session_.progress();
        if (is_solid_) {
            Fit::SolidFit fit = Fit::FitSolid(mesh_, choice_->scheme, target_.Surface(), how, kRate, kFineRate);
            problem_ = std::move(fit.problem);
            result_ = std::move(fit.result);
            json_["fits"] = fit.n_fits;
            n_folded_ = fit.n_folded;
            fold_level_ = fit.level;
        } else {
            result_ = Fit::FitControlPoints(problem_, how);
        }
        if (result_.stopped == "cancelled") {
            if (result_.rounds.empty()) throw Cancelled();
            ForgetInterrupt();
            session_.Note(options_.input + ": interrupted; the best so far is written (Ctrl-C again: nothing is)");
        }
        mesh_.positions = result_.control;
        if (result_.n_folded > 0) {
            session_.Note(options_.input + ": " +
                          Counted(result_.n_folded, "corner of a cell is", "corners of cells are") +
                          " folded; try --fairness 0.01 or more control points");
        } else if (n_folded_ > 0) {
            session_.Note(options_.input + ": " + Counted(n_folded_, "refined cell is", "refined cells are") +
                          " folded at level " + std::to_string(fold_level_) +
                          "; try --fairness 0.001 or another number of control points");
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
        const Staged& control = StagedFile(is_solid_ || is_lattice_ ? "lattice.vtu" : "cage.obj");
        Io::WriteMesh(control.written, MeshOf(mesh_), {.keep_octahedra = true});
        AddOutput(control);
        if (is_lattice_) {
            Io::WriteMesh(StagedFile("start.vtu").written, MeshOf(start_));
            AddOutput(StagedFile("start.vtu"));
        }
        Io::Mesh surface;
        if (is_lattice_) {
            surface = template_;
        } else {
            surface.topology.n_vertices = static_cast<Index>(result_.vertices.size() / 3);
            surface.topology.triangles = problem_.fine.triangles;
        }
        surface.positions = result_.vertices;
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
        settings.choice.diagonals = Far::DiagonalPolicy::First;  // as they were fitted
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
        if (!is_solid_) return MeshOf(mesh_);  // of a lattice all of it: the template lies inside
        return Refinement(MeshOf(mesh_), SettingsAt(0, false), session_).Boundary();
    }

    void WriteReport() {
        const FitSummary summary{result_, problem_, target_.diagonal};
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
    FitTarget target_;
    bool is_solid_ = false, is_lattice_ = false;  // neither: a cage
    Io::Mesh template_;                           // of a lattice
    std::vector<Index> template_triangles_;
    Fit::ControlMesh start_;
    bool is_tet_oct_ = false, is_quad_ = false;
    double crease_degrees_ = 0;  // 0: none
    Offset n_folded_ = 0;        // of a solid's refined cells,
    int fold_level_ = 0;         // at this level
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

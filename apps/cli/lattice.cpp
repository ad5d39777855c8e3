// SPDX-License-Identifier: Apache-2.0
// solidsubdiv lattice MODEL -o LATTICE: control lattices around a model, one or a whole hierarchy.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include <solidsubdiv/apps/cli/commands.h>
#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/apps/cli/files_help.h>
#include <solidsubdiv/apps/cli/lattice_mesh.h>
#include <solidsubdiv/apps/deform/octree_lattices.h>
#include <solidsubdiv/apps/deform/split_cells.h>
#include <solidsubdiv/apps/deform/tet_lattice.h>
#include <solidsubdiv/kit/io/formats.h>
#ifdef SOLIDSUBDIV_HAS_PICTURES
#include <solidsubdiv/kit/picture/deformation_picture.h>
#endif

namespace SolidSubdiv::Cli {

namespace {

using SolidSubdiv::Deform::ControlLattice;
using SolidSubdiv::Deform::LatticeHierarchy;
using SolidSubdiv::Deform::LatticeLevel;

struct LatticeOptions {
    std::string model, output, hierarchy, picture;
    std::string kind = "octree", box = "aabb";
    std::string cut;  ///< empty: what suits the kind
    int levels = 2;
    double offset = 0, padding = 0;
    std::vector<double> region, split_region;
    std::vector<Index> split;
    bool ascii = false;
};

/// Low corner, then high corner. @throws UsageError
Geometry::Box BoxOf(const std::vector<double>& numbers, const char* option) {
    Geometry::Box box;
    for (std::size_t c = 0; c < 3; ++c) {
        box.low[c] = numbers[c];
        box.high[c] = numbers[3 + c];
        if (!(std::isfinite(box.low[c]) && std::isfinite(box.high[c]) && box.low[c] <= box.high[c])) {
            throw UsageError(std::string(option) + ": the low corner comes first, then the high one: 0 0 0 1 1 1");
        }
    }
    return box;
}

class LatticeCommand {
  public:
    LatticeCommand(const LatticeOptions& options, Session& session) : options_(options), session_(session) {}

    void Run() {
        const SolidSubdiv::Deform::OctreeOptions how = Settings();
        RequireUsable();
        session_.Stage("read");
        model_ = Io::ReadMesh(options_.model);
        json_["model"] = {{"file", options_.model}, {"vertices", model_.topology.n_vertices}};
        session_.Stage("lattice");
        About(options_.model, [&] {
            hierarchy_ = SolidSubdiv::Deform::MakeOctreeLattices(model_.positions, SurfaceTriangles(model_), how);
            Split();
        });
        json_["box"] = BoxJson();
        for (const LatticeLevel& level : hierarchy_.levels) TellLevel(level.lattice);
        const LatticeLevel& last = hierarchy_.levels.back();
        result_ = options_.kind == "tet" ? SolidSubdiv::Deform::MakeTetLattice(last.lattice, last.cells).lattice
                                         : last.lattice;
        if (options_.kind == "tet") TellLevel(result_);
        Write();
        json_["seconds"] = session_.Seconds();
        session_.Print(text_.substr(1));
        session_.Finish(json_);
    }

  private:
    SolidSubdiv::Deform::OctreeOptions Settings() {
        const LatticeOptions& o = options_;
        // Octahedra need full surroundings.
        const std::string cut = !o.cut.empty() ? o.cut : o.kind == "tet" ? "outside" : "vertices";
        json_["settings"] = {{"kind", o.kind},
                             {"box", o.box},
                             {"cut", cut},
                             {"levels", o.levels},
                             {"offset", o.offset},
                             {"padding", o.padding},
                             {"threads", Sdc::ThreadCount()}};
        SolidSubdiv::Deform::OctreeOptions how;
        how.box = Geometry::BoxKindOf(o.box);
        how.levels = o.levels;
        how.cut = SolidSubdiv::Deform::CutOf(cut);
        how.padding = o.padding;
        how.shrink = o.kind == "shrink";
        how.offset = o.offset;
        how.progress = session_.progress();
        if (!o.region.empty()) {
            how.region = BoxOf(o.region, "--region");
            json_["settings"]["region"] = o.region;
        }
        return how;
    }

    void RequireUsable() {
        const LatticeOptions& o = options_;
        if (o.output.empty() && o.hierarchy.empty()) {
            throw UsageError("name the lattice's file with -o, or a folder for all levels with --hierarchy");
        }
        const bool splits = !o.split.empty() || !o.split_region.empty();
        if (o.kind == "tet" && (splits || !o.hierarchy.empty())) {
            throw UsageError(
                "lattices of tets have no levels and no cells to split; leave out --hierarchy and --split");
        }
        if (!o.split_region.empty()) BoxOf(o.split_region, "--split-region");
        if (o.offset > 0 && o.kind == "octree") throw UsageError("--offset is for --kind shrink; or use --padding");
        if (!o.output.empty()) {
            try {
                const Io::Format& format = Io::FormatOf(o.output);
                if (!format.write || !format.solids) {
                    throw UsageError(o.output + ": " + std::string(format.name) +
                                     " files can't hold a lattice; name a "
                                     ".vtu file");
                }
            } catch (const IoError& error) {
                throw UsageError(error.what());
            }
            output_ = session_.outputs().Stage(o.output);
        }
        if (!o.hierarchy.empty()) {
            if (!std::filesystem::is_directory(o.hierarchy)) {
                throw UsageError(o.hierarchy + ": there is no such folder; make it first");
            }
            const int n_levels = o.levels + 1 + (splits ? 1 : 0);
            for (int i = 0; i < n_levels; ++i) {
                level_files_.push_back(session_.outputs().Stage(std::filesystem::path(o.hierarchy) / LevelName(i)));
            }
            hierarchy_file_ = session_.outputs().Stage(std::filesystem::path(o.hierarchy) / "hierarchy.json");
        }
        if (!o.picture.empty()) picture_ = session_.outputs().Stage(o.picture);
    }

    static std::string LevelName(std::size_t i) { return "level" + std::to_string(i) + ".vtu"; }

    /// Splits chosen cells of the last level: one more level.
    void Split() {
        if (options_.split.empty() && options_.split_region.empty()) return;
        const LatticeLevel& last = hierarchy_.levels.back();
        std::vector<Index> cells = options_.split;
        if (!options_.split_region.empty()) {
            const std::vector<Index> in =
                CellsWithMiddleIn(last.lattice, BoxOf(options_.split_region, "--split-region"));
            if (in.empty()) throw InvalidInput("no cell of the lattice has its middle in --split-region");
            cells.insert(cells.end(), in.begin(), in.end());
        }
        std::sort(cells.begin(), cells.end());
        cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
        SolidSubdiv::Deform::SplitLattice split = SolidSubdiv::Deform::SplitCells(last.lattice, cells);
        json_["settings"]["split"] = cells;
        hierarchy_.levels.push_back({std::move(split.lattice), std::move(split.parents), std::move(split.rows), {}});
    }

    Json BoxJson() const {
        const Geometry::OrientedBox& box = hierarchy_.box;
        return {{"corner", box.corner}, {"axes", box.axes}, {"lengths", box.lengths}, {"volume", box.Volume()}};
    }

    void TellLevel(const ControlLattice& lattice) {
        const Json counts = {{"control_points", lattice.n_control_points()}, {"cells", lattice.n_cells()},
                             {"hexahedra", lattice.hexes.size() / 8},        {"tetrahedra", lattice.tets.size() / 4},
                             {"octahedra", lattice.octs.size() / 6},         {"polyhedra", lattice.n_polyhedra()}};
        const bool is_tets = lattice.hexes.empty() && lattice.n_polyhedra() == 0;
        text_ += "\n" + (is_tets ? "tet lattice" : "level " + std::to_string(json_["levels"].size())) + ": " +
                 Counted(lattice.n_control_points(), "control point", "control points") + ", " +
                 Counted(lattice.n_cells(), "cell", "cells");
        if (is_tets) {
            text_ += " (" + Counted(static_cast<Offset>(lattice.tets.size() / 4), "tet", "tets") + ", " +
                     Counted(static_cast<Offset>(lattice.octs.size() / 6), "octahedron", "octahedra") + ")";
            json_["tet_lattice"] = counts;
        } else {
            json_["levels"].push_back(counts);
        }
    }

    void Write() {
        session_.Stage("write");
        const Io::WriteOptions how{.keep_octahedra = true, .binary = !options_.ascii};
        if (!output_.empty()) {
            const bool has_parents = options_.kind != "tet";
            Io::WriteMesh(output_,
                          MeshOf(result_, has_parents ? hierarchy_.levels.back().parents : std::vector<Index>()), how);
            AddOutput("lattice", options_.output, output_);
        }
        for (std::size_t i = 0; i < level_files_.size(); ++i) {
            const LatticeLevel& level = hierarchy_.levels[i];
            Io::WriteMesh(level_files_[i], MeshOf(level.lattice, level.parents), how);
            AddOutput("level", (std::filesystem::path(options_.hierarchy) / LevelName(i)).string(), level_files_[i]);
        }
        if (!hierarchy_file_.empty()) WriteHierarchy();
#ifdef SOLIDSUBDIV_HAS_PICTURES
        if (!picture_.empty()) {
            session_.Stage("picture");
            const Io::Mesh mesh = MeshOf(result_, {});
            const std::vector<Picture::DeformationState> states{{&model_, &mesh, "model in its lattice"}};
            Picture::WritePng(picture_, Picture::DeformationPicture(states, {}, session_.progress()));
            AddOutput("picture", options_.picture, picture_);
        }
#endif
        session_.EndStage();
    }

    /// The parent relations: of cells, and of control points (their mean is where the octree rule puts the point).
    void WriteHierarchy() {
        Json json = {{"format", "solidsubdiv lattice hierarchy"},
                     {"version", 1},
                     {"model", options_.model},
                     {"settings", json_["settings"]},
                     {"box", BoxJson()}};
        for (std::size_t i = 0; i < hierarchy_.levels.size(); ++i) {
            const LatticeLevel& level = hierarchy_.levels[i];
            Json rule = Json::array();
            for (Index p = 0; p < level.octree_rule.n_rows(); ++p) {
                const auto of = level.octree_rule.Indices(p);
                rule.push_back(std::vector<Index>(of.begin(), of.end()));
            }
            json["levels"].push_back({{"file", LevelName(i)},
                                      {"control_points", level.lattice.n_control_points()},
                                      {"cells", level.lattice.n_cells()},
                                      {"parent_cells", level.parents},
                                      {"parent_points", rule}});
        }
        std::ofstream file(hierarchy_file_);
        file << json << "\n";
        file.close();
        const std::string name = (std::filesystem::path(options_.hierarchy) / "hierarchy.json").string();
        if (!file) throw IoError(name + ": can't be written");
        AddOutput("hierarchy", name, hierarchy_file_);
    }

    void AddOutput(const std::string& what, const std::string& file, const std::filesystem::path& written) {
        json_["outputs"].push_back({{"what", what}, {"file", file}, {"bytes", std::filesystem::file_size(written)}});
        text_ += "\nwrote " + file;
    }

    const LatticeOptions& options_;
    Session& session_;
    std::filesystem::path output_, hierarchy_file_, picture_;
    std::vector<std::filesystem::path> level_files_;
    Io::Mesh model_;
    LatticeHierarchy hierarchy_;
    ControlLattice result_;
    Json json_ = {{"command", "lattice"}};
    std::string text_;
};

std::string NotNegative(const std::string& text) {
    char* end = nullptr;
    const double x = std::strtod(text.c_str(), &end);
    return x >= 0 && std::isfinite(x) && end != text.c_str() ? std::string() : "'" + text + "' is no distance";
}

}  // namespace

Work AddLattice(CLI::App& command) {
    const auto options = std::make_shared<LatticeOptions>();
    LatticeOptions& o = *options;
    command.add_option("MODEL", o.model, "what the lattice is made around: a surface, a solid, points")
        ->required()
        ->option_text(" ");
    command.add_option("-o,--output", o.output, "the lattice of the last level; .vtu, .vtk and others that hold cells")
        ->option_text("LATTICE");
    command
        .add_option("--hierarchy", o.hierarchy,
                    "write all levels into this folder, level0.vtu, level1.vtu ...,\nand how they hang together, "
                    "hierarchy.json")
        ->option_text("FOLDER");
    command
        .add_option("--kind", o.kind,
                    "octree: a box split in eight again and again, empty cells cut\nshrink: the same, its border drawn "
                    "to the model\ntet: tets and octahedra in place of its cells; default octree")
        ->option_text("KIND")
        ->check(CLI::IsMember({"octree", "shrink", "tet"}));
    command
        .add_option("--box", o.box,
                    "aabb: along the axes; obb: along the model's principal axes;\nminimum: of the least volume found; "
                    "default aabb")
        ->option_text("BOX")
        ->check(CLI::IsMember({"aabb", "obb", "minimum"}));
    command.add_option("--levels", o.levels, "how often cells are split; default 2")
        ->option_text("N")
        ->check(CLI::Range(0, 10));
    command
        .add_option("--cut", o.cut,
                    "which cells stay: vertices: those with a vertex of the model;\ntriangles: those that the surface "
                    "meets; outside: these and what\nthey enclose, so closed models are filled; none: all;\ndefault "
                    "vertices, for tet outside")
        ->option_text("WHAT")
        ->check(CLI::IsMember({"vertices", "triangles", "outside", "none"}));
    command
        .add_option("--offset", o.offset, "shrink: how far before the model the border stays, in its\nunit; default 0")
        ->option_text("D")
        ->check(NotNegative);
    command
        .add_option("--padding", o.padding,
                    "how far the box goes beyond the model, as a part of its longest\nside; "
                    "default 0")
        ->option_text("P")
        ->check(NotNegative);
    command
        .add_option("--region", o.region, "only the part of the model in this box: its low corner, its\nhigh corner")
        ->option_text("X Y Z X Y Z")
        ->expected(6);
    command
        .add_option("--split", o.split,
                    "split these cells of the last level once more; neighbours stay whole\nand "
                    "become polyhedra")
        ->option_text("CELL ...");
    command.add_option("--split-region", o.split_region, "the same for cells whose middle is in this box")
        ->option_text("X Y Z X Y Z")
        ->expected(6);
#ifdef SOLIDSUBDIV_HAS_PICTURES
    command.add_option("--picture", o.picture, "a picture of the model in its lattice")->option_text("OUT.png");
#endif
    command.add_flag("--ascii", o.ascii, "write text where the format has a binary form too");
    command.footer(
        "Cells are written with their parents as cell data 'parent'. Move the control points in any program that "
        "keeps\n"
        "the order of points and cells, then 'solidsubdiv deform'. docs/lattices.md shows the kinds.\n\n" +
        ReadableFilesHelp() +
        "\n\nExamples:\n"
        "  solidsubdiv lattice bunny.obj -o box.vtu --levels 1\n"
        "  solidsubdiv lattice bunny.obj -o close.vtu --kind shrink --levels 3 --offset 0.01 --box obb\n"
        "  solidsubdiv lattice bunny.obj -o tets.vtu --kind tet --levels 3");
    return [options](Session& session) { LatticeCommand(*options, session).Run(); };
}

}  // namespace SolidSubdiv::Cli

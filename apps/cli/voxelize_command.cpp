// SPDX-License-Identifier: Apache-2.0
// A solid is refined, as far as was asked for or a tolerance needs, and its last cells are filled with voxels.
#include <solidsubdiv/apps/cli/voxelize_command.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include <solidsubdiv/apps/cli/kind_check.h>
#include <solidsubdiv/apps/cli/mesh_kinds.h>
#include <solidsubdiv/apps/cli/refinement.h>
#include <solidsubdiv/apps/cli/voxel_report.h>
#include <solidsubdiv/apps/voxel/voxelize.h>
#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/kit/geometry/cell_volume.h>
#include <solidsubdiv/kit/geometry/tessellation.h>
#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/kit/io/holes.h>

namespace SolidSubdiv::Cli {

namespace {

constexpr int kMostLevels = 6;  ///< by tolerance

class VoxelizeCommand {
  public:
    VoxelizeCommand(const VoxelizeCommandOptions& options, Session& session) : options_(options), session_(session) {}

    void Run() {
        RequireUsable();
        session_.Stage("read");
        Io::Mesh mesh = Io::ReadMesh(options_.input);
        for (const std::string& note : mesh.notes) session_.Note(options_.input + ": " + note);
        json_["input"] = {{"file", options_.input}, {"vertices", mesh.topology.n_vertices}};
        for (const KindCount& kind : KindCounts(mesh.topology)) {
            if (kind.count > 0) json_["input"][std::string(kind.plural)] = kind.count;
        }
        if (mesh.topology.n_cells() == 0) {
            throw InvalidInput(options_.input +
                               ": has no cells to fill; name a solid: Gmsh, TetGen and others make one of a surface");
        }
        // Holes are of surfaces, which fill nothing.
        std::erase_if(mesh.cell_data, [](const Io::Attribute& a) { return a.name == Io::kHole; });
        RequireAttributes(mesh);
        settings_ = Settings(mesh);
        About(options_.input, [&] {
            if (options_.tolerance > 0) ChooseLevel(mesh);
            const Refinement refinement(std::move(mesh), settings_, session_);
            Describe(refinement);
            Fill(refinement);
        });
        json_["seconds"] = session_.Seconds();
        session_.Print(text_);
        session_.Finish(json_);
    }

  private:
    /// All that can be known to be wrong before any work.
    void RequireUsable() {
        if (std::filesystem::path(options_.output).extension() != ".vdb") {
            throw UsageError(options_.output + ": grids are written to .vdb files; name one");
        }
        output_ = session_.outputs().Stage(options_.output);
        if (!options_.picture.empty()) picture_ = session_.outputs().Stage(options_.picture);
        std::set<std::string> names;
        for (const std::string& name : options_.attributes) {
            if (!names.insert(name).second) throw UsageError("--attribute " + name + " is given twice");
        }
        if (options_.kind == "none" && names.empty()) {
            throw UsageError("--kind none writes attributes alone; name some with --attribute");
        }
    }

    static bool IsBuiltIn(std::string_view name) { return name == "jacobian" || name == "cell_id" || name == "level"; }
    static bool IsUsable(const Io::Attribute& a) { return a.width == 1 || a.width == 3; }

    void RequireAttributes(const Io::Mesh& mesh) const {
        for (const std::string& name : options_.attributes) {
            const Io::Attribute* const data = mesh.FindPointData(name);
            if ((data != nullptr && IsUsable(*data)) || (data == nullptr && IsBuiltIn(name))) continue;
            std::string known;
            for (const Io::Attribute& a : mesh.point_data) known += IsUsable(a) ? a.name + ", " : "";
            throw InvalidInput(options_.input + ": has no point data '" + name +
                               "' of 1 or 3 numbers a point; there are " + known + "jacobian, cell_id, level");
        }
    }

    RefinementSettings Settings(const Io::Mesh& mesh) {
        const MeshKind kind{true, IsTetOct(mesh.topology)};
        const SchemeOptions scheme = WithFileOptions(options_.scheme, mesh.scheme_options, kind);
        RefinementSettings settings;
        settings.choice = MakeScheme(scheme, kind);
        const Sdc::Scheme& s = settings.choice.scheme;
        settings.split = About(options_.input, [&] { return SplitFor(mesh.topology, s); });
        settings.levels = options_.levels;
        settings.orient = Geometry::OrientationPolicyOf(options_.orient);
        settings.limit = options_.limit || options_.tolerance > 0;
        metadata_.emplace_back("scheme", Sdc::NameOf(s));
        for (const auto& option : OptionValues(scheme, s)) metadata_.push_back(option);
        if (settings.split == Sdc::Split::TetOct) metadata_.emplace_back("diagonals", options_.scheme.diagonals);
        metadata_.emplace_back("limit", settings.limit ? "true" : "false");
        Json& json = json_["settings"];
        for (const auto& entry : metadata_) json[entry.first] = entry.second;
        json["limit"] = settings.limit;
        json["orient"] = options_.orient;
        json["kind"] = options_.kind;
        json["half_width"] = options_.half_width;
        json["half"] = options_.half;
        json["threads"] = Sdc::ThreadCount();
        return settings;
    }

    /// The fewest levels whose boundary, with vertices at their limits, was measured to be within the tolerance.
    void ChooseLevel(const Io::Mesh& mesh) {
        RefinementSettings coarse = settings_;
        coarse.levels = 0;
        coarse.limit = false;
        const Refinement base(mesh, coarse, session_);
        session_.Stage("measure");
        const auto& positions = base.control().positions;
        Geometry::TessellationError error;
        for (int level = 0;; ++level) {
            const auto boundary =
                Geometry::TessellateBoundary(base.refiner(), settings_.choice.scheme, positions,
                                             {.rate = 1 << level, .normals = false, .progress = session_.progress()});
            error = Geometry::MeasureError(base.refiner(), settings_.choice.scheme, boundary, positions,
                                           session_.progress());
            settings_.levels = level;
            const bool fits = 4 * boundary.n_facets() <= Geometry::TessellationOptions().max_facets;
            if (error.largest <= options_.tolerance || level == kMostLevels || !fits) break;
        }
        if (error.largest > options_.tolerance) {
            session_.Note(options_.input + ": the tolerance of " + Text(options_.tolerance) +
                          " is not reached at level " + std::to_string(settings_.levels) + ", the most there are");
        }
        json_["tolerance"] = {{"asked", options_.tolerance}, {"error", error.largest}, {"tests", error.n_tests}};
        metadata_.emplace_back("tolerance", Text(options_.tolerance));
        metadata_.emplace_back("measured_error", Text(error.largest));
        told_error_ = ", at " + Counted(error.n_tests, "test point", "test points") + " at most " +
                      Text(error.largest) + " from the limit";
    }

    /// The refined solid.
    void Describe(const Refinement& refinement) {
        const auto& orientation = refinement.orientation();
        if (orientation.n_inverted() > 0) {
            session_.Note(options_.input + ": " + Counted(orientation.n_inverted(), "inverted cell", "inverted cells") +
                          (options_.orient == "repair" ? " turned (--orient)" : " kept"));
        }
        NoteWithoutLimit(session_, options_.input, refinement);
        const Io::Mesh& solid = refinement.result();
        const Io::Topology boundary = refinement.Boundary().topology;
        Offset n_triangles = boundary.n_triangles() + 2 * boundary.n_quads();
        n_triangles += static_cast<Offset>(boundary.polygon_vertices.size()) - 2 * boundary.n_polygons();
        double volume = 0;
        for (double v : Geometry::CellVolumes(solid.topology.View(), solid.positions)) volume += v;
        json_["solid"] = {{"level", settings_.levels},
                          {"cells", solid.topology.n_cells()},
                          {"triangles", n_triangles},
                          {"volume", volume}};
        text_ = "level " + std::to_string(settings_.levels) + ": " +
                Counted(solid.topology.n_cells(), "cell", "cells") + ", " +
                Counted(n_triangles, "triangle", "triangles") + " around them, volume " + Text(volume) + told_error_;
    }

    void Fill(const Refinement& refinement) {
        const Io::Mesh& solid = refinement.result();
        session_.Stage("voxelize");
        Voxel::VoxelizeOptions how{.voxel_size = options_.voxel_size,
                                   .kind = Voxel::KindOf(options_.kind),
                                   .half_width = options_.half_width,
                                   .max_bytes = MemoryShare(),
                                   .progress = session_.progress()};
        if (how.voxel_size == 0) {
            const auto box = Geometry::BoundingBox(solid.positions);
            how.voxel_size = std::max({box.Extent(0), box.Extent(1), box.Extent(2)}) / options_.resolution;
            if (!(how.voxel_size > 0)) throw InvalidInput("is a single point; there is nothing to fill");
        }
        for (const std::string& name : options_.attributes) AddAttribute(solid, name, how);
        Voxel::Grids grids = Voxel::Voxelize(refinement.refiner(), settings_.levels, solid.positions, how);
        metadata_.emplace_back("levels", std::to_string(settings_.levels));
        metadata_.emplace_back("source", std::filesystem::path(options_.input).filename().string());
        metadata_.emplace_back("creator", "solidsubdiv " SOLIDSUBDIV_VERSION);  // a name of OpenVDB's
        for (const auto& entry : metadata_) grids.SetMetadata(entry.first, entry.second);
        json_["settings"]["voxel_size"] = how.voxel_size;
        json_["grids"] = DescribeGrids(grids);
        text_ += "\nvoxels of size " + Text(how.voxel_size) + "\n" + GridsText(json_["grids"]);
        session_.Stage("write");
        grids.Write(output_, options_.half);
        AddOutput("grids", options_.output, output_);
        if (!picture_.empty()) {
            session_.Stage("picture");
            std::vector<std::string> names;
            for (const Json& grid : json_["grids"]) names.push_back(grid["name"].get<std::string>());
            WriteGridPicture(picture_, grids, names, {}, session_);
            AddOutput("picture", options_.picture, picture_);
        }
        session_.EndStage();
    }

    /// Three quarters of the machine's memory.
    static Offset MemoryShare() {
        return static_cast<Offset>(sysconf(_SC_PHYS_PAGES)) / 4 * 3 * static_cast<Offset>(sysconf(_SC_PAGESIZE));
    }

    /// The mesh's own data go before what is built in, under other names.
    void AddAttribute(const Io::Mesh& solid, const std::string& name, Voxel::VoxelizeOptions& how) const {
        if (const Io::Attribute* const data = solid.FindPointData(name)) {
            const bool is_taken = name == "surface" || name == "density" || IsBuiltIn(name);
            if (is_taken)
                session_.Note("--attribute " + name + ": the mesh's own data become grid 'point_" + name + "'");
            how.attributes.push_back({is_taken ? "point_" + name : name, data->width, data->values});
        } else {
            how.jacobian = how.jacobian || name == "jacobian";
            how.cell_id = how.cell_id || name == "cell_id";
            how.level_id = how.level_id || name == "level";
        }
    }

    void AddOutput(const std::string& what, const std::string& file, const std::filesystem::path& written) {
        const auto size = static_cast<Offset>(std::filesystem::file_size(written));
        json_["outputs"].push_back({{"what", what}, {"file", file}, {"bytes", size}});
        text_ += "\nwrote " + file + " (" + Far::BytesText(size) + ")";
    }

    const VoxelizeCommandOptions& options_;
    Session& session_;
    std::filesystem::path output_, picture_;
    RefinementSettings settings_;
    std::vector<std::pair<std::string, std::string>> metadata_;
    Json json_ = {{"command", "voxelize"}};
    std::string text_, told_error_;
};

}  // namespace

void RunVoxelize(const VoxelizeCommandOptions& options, Session& session) { VoxelizeCommand(options, session).Run(); }

}  // namespace SolidSubdiv::Cli

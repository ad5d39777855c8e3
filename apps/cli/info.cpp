// SPDX-License-Identifier: Apache-2.0
// solidsubdiv info FILE: what is in a file.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include <solidsubdiv/apps/cli/commands.h>
#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/apps/cli/files_help.h>
#include <solidsubdiv/apps/cli/mesh_report.h>
#include <solidsubdiv/apps/cli/quality_report.h>
#include <solidsubdiv/apps/cli/target_report.h>
#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/kit/io/points.h>
#include <solidsubdiv/kit/io/volumes.h>
#ifdef SOLIDSUBDIV_HAS_VOXEL
#include <solidsubdiv/apps/cli/voxel_report.h>
#endif
#ifdef SOLIDSUBDIV_HAS_PICTURES
#include <solidsubdiv/kit/picture/quality_picture.h>
#endif

namespace SolidSubdiv::Cli {

namespace {

struct InfoOptions {
    std::string file, quality_map, picture, grid, slice;
    bool quality = false;

    bool wants_quality() const { return quality || !quality_map.empty() || !picture.empty(); }
};

/// A format that can hold a solid and its data. @throws UsageError
void RequireSolidFormat(const std::string& file) {
    try {
        const Io::Format& format = Io::FormatOf(file);
        if (format.write && format.solids) return;
        throw UsageError(file + ": " + std::string(format.name) + " files can't hold it; name a .vtu file");
    } catch (const IoError& error) {
        throw UsageError(error.what());
    }
}

/// Measures cells, adds `quality` to the result and writes what was asked for; the lines for people.
std::string AddQuality(Session& session, const InfoOptions& options, const Io::Mesh& mesh, Json& result) {
    const auto stage = [&](const std::string& file) {
        return file.empty() ? std::filesystem::path() : session.outputs().Stage(file);
    };
    const std::filesystem::path map = stage(options.quality_map), picture = stage(options.picture);
    session.Stage("quality");
    const auto cells = About(options.file, [&] { return MeasureCells(mesh, session.progress()); });
    result["quality"] = DescribeQuality(mesh, cells);
    std::string text = "\n" + QualityText(result["quality"]);
    if (!map.empty()) {
        session.Stage("write");
        Io::WriteMesh(map, QualityMap(mesh, cells), {.keep_octahedra = true});
        text += "\nwrote " + options.quality_map;
    }
#ifdef SOLIDSUBDIV_HAS_PICTURES
    if (!picture.empty()) {
        session.Stage("picture");
        std::vector<double> scaled;
        for (const Geometry::CellQuality& q : cells) {
            // A fold that corners don't show is red too.
            const bool is_good = q.sign == Geometry::MinimumSign::Positive;
            scaled.push_back(is_good ? q.scaled_jacobian : std::min(q.scaled_jacobian, 0.0));
        }
        Picture::WritePng(picture, Picture::QualityPicture(mesh, scaled, {}, session.progress()));
        text += "\nwrote " + options.picture;
    }
#endif
    return text;
}

/// Files of OpenVDB's grids.
void RunGridInfo([[maybe_unused]] Session& session, const InfoOptions& options) {
    if (options.quality || !options.quality_map.empty()) {
        throw UsageError(options.file + ": --quality is of cells, and this file holds grids of voxels");
    }
#ifdef SOLIDSUBDIV_HAS_VOXEL
    const SlicePlace place = options.slice.empty() ? SlicePlace{} : SlicePlaceOf(options.slice);
    const std::filesystem::path picture =
        options.picture.empty() ? std::filesystem::path() : session.outputs().Stage(options.picture);
    session.Stage("read");
    const Voxel::Grids grids = Voxel::Grids::Read(options.file);
    session.Stage("analyze");
    Json result = {{"command", "info"}, {"file", options.file}, {"format", "OpenVDB"}, {"grids", DescribeGrids(grids)}};
    const Json& described = result["grids"];
    std::string text = options.file + ": OpenVDB\n" + (described.empty() ? "no grids" : GridsText(described));
    const std::string metadata = MetadataText(described);
    if (!metadata.empty()) text += "\nmetadata: " + metadata;
    if (!picture.empty()) {
        session.Stage("picture");
        About(options.file, [&] {
            if (described.empty()) throw InvalidInput("has no grids; there is nothing to draw");
            WriteGridPicture(picture, grids,
                             {options.grid.empty() ? described[0]["name"].get<std::string>() : options.grid}, place,
                             session);
        });
        text += "\nwrote " + options.picture;
    }
    session.EndStage();
    result["seconds"] = session.Seconds();
    session.Print(text);
    session.Finish(result);
#else
    throw IoError(options.file + ": holds OpenVDB's grids, and this program was built without OpenVDB");
#endif
}

/// Volumes and points, which hold no mesh: read(), describe and put into words.
template <class Read, class Describe, class TextOf>
void RunTargetInfo(Session& session, const InfoOptions& options, std::string_view format, Read&& read,
                   Describe&& describe, TextOf&& text_of) {
    if (options.wants_quality() || !options.grid.empty()) {
        throw UsageError(options.file + ": --quality, --picture and --grid are of meshes and OpenVDB's grids");
    }
    session.Stage("read");
    const auto target = read(options.file);
    for (const std::string& note : target.notes) session.Note(options.file + ": " + note);
    session.Stage("analyze");
    Json result = {{"command", "info"}, {"file", options.file}, {"format", format}, {"notes", target.notes}};
    result.update(describe(target));
    session.EndStage();
    result["seconds"] = session.Seconds();
    session.Print(options.file + ": " + std::string(format) + "\n" + text_of(result));
    session.Finish(result);
}

void RunInfo(Session& session, const InfoOptions& options) {
    if (const Io::VolumeFormat* format = Io::FindVolumeFormat(options.file)) {
        return RunTargetInfo(session, options, format->name, Io::ReadVolume, DescribeVolume, VolumeText);
    }
    const Io::PointFormat* points = Io::FindPointFormat(options.file);
    if (points && HoldsPointsAlone(options.file)) {
        return RunTargetInfo(session, options, points->name, Io::ReadPoints, DescribePoints, PointsText);
    }
    if (std::filesystem::path(options.file).extension() == ".vdb") return RunGridInfo(session, options);
    if (!options.grid.empty()) throw UsageError(options.file + ": --grid is of .vdb files");
    if (!options.slice.empty()) throw UsageError(options.file + ": --slice is of .vdb files");
    if (!options.quality_map.empty()) RequireSolidFormat(options.quality_map);
    const std::string& file = options.file;
    session.Stage("read");
    const Io::Mesh mesh = Io::ReadMesh(file);
    for (const std::string& note : mesh.notes) session.Note(file + ": " + note);

    session.Stage("analyze");
    Json result;
    result["command"] = "info";
    result["file"] = file;
    result["format"] = Io::FormatOf(file).name;
    result["notes"] = mesh.notes;
    const Json description = About(file, [&] { return DescribeMesh(mesh); });
    result.update(description);
    std::string text = file + ": " + std::string(Io::FormatOf(file).name) + "\n" + MeshReportText(description);
    const bool is_usable = description["analysis"] == "complete";
    if (options.wants_quality() && !is_usable && options.quality_map.empty() && options.picture.empty()) {
        session.Note(file + ": quality is not measured while there are fatal defects");
    } else if (options.wants_quality()) {
        text += AddQuality(session, options, mesh, result);
    }
    session.EndStage();
    result["seconds"] = session.Seconds();
    session.Print(text);
    session.Finish(result);
}

}  // namespace

Work AddInfo(CLI::App& command) {
    const auto options = std::make_shared<InfoOptions>();
    InfoOptions& o = *options;
    command.add_option("FILE", o.file, "the mesh, the volume, the points, or grids of voxels (.vdb)")
        ->required()
        ->option_text(" ");
    command.add_flag("--quality", o.quality,
                     "measure cells: the least Jacobian determinant, with a proof\n"
                     "of its sign, scaled Jacobians, the worst cells");
    command
        .add_option("--quality-map", o.quality_map,
                    "write the cells with the cell data jacobian_minimum and\nscaled_jacobian (.vtu, .vtk)")
        ->option_text("FILE");
#ifdef SOLIDSUBDIV_HAS_PICTURES
    CLI::Option* const picture =
        command
            .add_option(
                "--picture", o.picture,
                "draw the cells coloured by quality as a PNG: from outside,\ncut open, the worst by themselves; "
                "of a grid the surface\nand a slice by value")
            ->option_text("FILE");
    command.add_option("--grid", o.grid, "the grid that --picture draws; default the first")->option_text("NAME");
    command
        .add_option(
            "--slice", o.slice,
            "where --picture cuts it: the axis and how far along what\nis active, x|y|z:FRACTION; default z:0.5")
        ->option_text("PLACE")
        ->needs(picture);
#endif
    command.footer(
        "The size; of cells the volume, inverted ones and those of no volume; components of the boundary with their\n"
        "Euler characteristic and genus; histograms of valences and of the cells around inner edges; cells that meet\n"
        "only in an edge or a vertex; defects, those that make a mesh unusable too. Where all cells are tetrahedra or\n"
        "octahedra also the share of matched faces. Of OpenVDB's files the grids, their sizes, values and "
        "metadata; of volumes and points the size, the box, the range of values and labels.\n\n" +
        ReadableFilesHelp() + "\n" + ReadableTargetsHelp() +
        "\n\nExamples:\n"
        "  solidsubdiv info lattice.vtu --json lattice.json\n"
        "  solidsubdiv info lattice.vtu --quality --quality-map quality.vtu --picture quality.png"
#ifdef SOLIDSUBDIV_HAS_VOXEL
        "\n  solidsubdiv info solid.vdb --picture grid.png --grid density --slice y:0.25"
#endif
    );
    return [options](Session& session) { RunInfo(session, *options); };
}

}  // namespace SolidSubdiv::Cli

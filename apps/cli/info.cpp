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
#include <solidsubdiv/kit/io/formats.h>
#ifdef SOLIDSUBDIV_HAS_PICTURES
#include <solidsubdiv/kit/picture/quality_picture.h>
#endif

namespace SolidSubdiv::Cli {

namespace {

struct InfoOptions {
    std::string file, quality_map, picture;
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

void RunInfo(Session& session, const InfoOptions& options) {
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
    command.add_option("FILE", o.file, "the mesh")->required()->option_text(" ");
    command.add_flag("--quality", o.quality,
                     "measure cells: the least Jacobian determinant, with a proof\n"
                     "of its sign, scaled Jacobians, the worst cells");
    command
        .add_option("--quality-map", o.quality_map,
                    "write the cells with the cell data jacobian_minimum and\nscaled_jacobian (.vtu, .vtk)")
        ->option_text("FILE");
#ifdef SOLIDSUBDIV_HAS_PICTURES
    command
        .add_option("--picture", o.picture,
                    "draw the cells coloured by quality as a PNG: from outside,\ncut open, the worst by themselves")
        ->option_text("FILE");
#endif
    command.footer(
        "The size; of cells the volume, inverted ones and those of no volume; components of the boundary with their\n"
        "Euler characteristic and genus; histograms of valences and of the cells around inner edges; cells that meet\n"
        "only in an edge or a vertex; defects, those that make a mesh unusable too. Where all cells are tetrahedra or\n"
        "octahedra also the share of matched faces.\n\n" +
        ReadableFilesHelp() +
        "\n\nExamples:\n"
        "  solidsubdiv info lattice.vtu --json lattice.json\n"
        "  solidsubdiv info lattice.vtu --quality --quality-map quality.vtu --picture quality.png");
    return [options](Session& session) { RunInfo(session, *options); };
}

}  // namespace SolidSubdiv::Cli

// SPDX-License-Identifier: Apache-2.0
// solidsubdiv info FILE: what is in a file.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include <solidsubdiv/apps/cli/commands.h>
#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/apps/cli/files_help.h>
#include <solidsubdiv/apps/cli/mesh_report.h>
#include <solidsubdiv/kit/io/formats.h>

namespace SolidSubdiv::Cli {

namespace {

void RunInfo(Session& session, const std::string& file) {
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
    session.EndStage();
    result["seconds"] = session.Seconds();
    session.Print(file + ": " + std::string(Io::FormatOf(file).name) + "\n" + MeshReportText(description));
    session.Finish(result);
}

}  // namespace

Work AddInfo(CLI::App& command) {
    const auto file = std::make_shared<std::string>();
    command.add_option("FILE", *file, "the mesh")->required()->option_text(" ");
    command.footer(
        "The size; of cells the volume, inverted ones and those of no volume; components of the boundary with their\n"
        "Euler characteristic and genus; histograms of valences and of the cells around inner edges; cells that meet\n"
        "only in an edge or a vertex; defects, those that make a mesh unusable too. Where all cells are tetrahedra or\n"
        "octahedra also the share of matched faces.\n\n" +
        ReadableFilesHelp() +
        "\n\nExample:\n"
        "  solidsubdiv info lattice.vtu --json lattice.json");
    return [file](Session& session) { RunInfo(session, *file); };
}

}  // namespace SolidSubdiv::Cli

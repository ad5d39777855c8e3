// SPDX-License-Identifier: Apache-2.0
// solidsubdiv voxelize IN -o OUT.vdb: refined solids and their data as grids of voxels.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cmath>
#include <cstdlib>
#include <memory>

#include <solidsubdiv/apps/cli/commands.h>
#include <solidsubdiv/apps/cli/files_help.h>
#include <solidsubdiv/apps/cli/voxelize_command.h>

namespace SolidSubdiv::Cli {

namespace {

/// A check of options that are lengths.
std::string LengthProblem(const std::string& text) {
    char* end = nullptr;
    const double length = std::strtod(text.c_str(), &end);
    const bool is_length = end != text.c_str() && *end == 0 && length > 0 && std::isfinite(length);
    return is_length ? std::string() : "'" + text + "' is no length above 0";
}

}  // namespace

Work AddVoxelize(CLI::App& command) {
    const auto options = std::make_shared<VoxelizeCommandOptions>();
    VoxelizeCommandOptions& o = *options;
    command.add_option("IN", o.input, "the control mesh: a solid of cells of any kind")->required()->option_text(" ");
    command.add_option("-o,--output", o.output, "the grids")->required()->option_text("OUT.vdb (required)");
    CLI::Option* resolution =
        command.add_option("--resolution", o.resolution, "voxels along the longest side of the solid; default 128")
            ->option_text("N");
    resolution->check(CLI::Range(1, 1'000'000'000));
    command.add_option("--voxel-size", o.voxel_size, "instead: the side of a voxel, in the mesh's unit")
        ->option_text("H")
        ->check(LengthProblem)
        ->excludes(resolution);
    command
        .add_option("--kind", o.kind,
                    "level-set: grid 'surface' of signed distances (default);\nfog: grid 'density', the filled part of "
                    "each voxel; both;\nnone: attributes alone")
        ->option_text("level-set|fog|both|none")
        ->check(CLI::IsMember({"level-set", "fog", "both", "none"}));
    command
        .add_option("--attribute", o.attributes,
                    "a grid of values inside: point data of the mesh of 1 or 3\nnumbers, or jacobian, cell_id, level; "
                    "can be repeated")
        ->option_text("NAME")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command.add_option("--half-width", o.half_width, "voxels beside the boundary with exact distances; default 3")
        ->option_text("W")
        ->check([](const std::string& text) {
            const double width = std::strtod(text.c_str(), nullptr);
            return width >= 1 && width <= 100 ? std::string() : "'" + text + "' is not from 1 to 100 voxels";
        });
    command.add_flag("--half", o.half, "write numbers of 16 bits");
    CLI::Option* levels =
        command.add_option("--levels", o.levels, "refinements before cells are filled; default 2")->option_text("N");
    levels->check(CLI::Range(0, 20));
    command
        .add_option("--tolerance", o.tolerance,
                    "instead: as many levels, up to 6, as bring the boundary, its\nvertices at their limits, within "
                    "this distance of the limit")
        ->option_text("T")
        ->check(LengthProblem)
        ->excludes(levels);
    command.add_flag("--limit", o.limit, "move the vertices of the last level to their limits");
    AddSchemeOptions(command, o.scheme);
    AddOrientOption(command, o.orient);
#ifdef SOLIDSUBDIV_HAS_PICTURES
    command.add_option("--picture", o.picture, "draw the surface, and a slice of each grid")->option_text("OUT.png");
#endif
    command.footer(
        "Voxel (i, j, k) has its centre at H (i, j, k). Inside is what a cell holds: cavities stay empty, and shells\n"
        "within shells are kept. All grids carry the scheme, its options, the levels and the file as metadata;\n"
        "'solidsubdiv info' shows them. docs/voxels.md explains more. Point data called surface, density, jacobian,\n"
        "cell_id or level are written as 'point_NAME'.\n\n" +
        SchemesHelp() + "\n\n" + ReadableFilesHelp() +
        "\n\nExamples:\n"
        "  solidsubdiv voxelize lattice.vtu -o solid.vdb --resolution 64\n"
        "  solidsubdiv voxelize lattice.vtu -o solid.vdb --kind both --attribute jacobian --tolerance 0.05 --json -\n"
        "  solidsubdiv voxelize lattice.vtu -o fog.vdb --kind fog --voxel-size 0.1 --half --picture fog.png");
    return [options](Session& session) { RunVoxelize(*options, session); };
}

}  // namespace SolidSubdiv::Cli

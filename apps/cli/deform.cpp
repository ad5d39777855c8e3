// SPDX-License-Identifier: Apache-2.0
// solidsubdiv deform MODEL --lattice L0 --to L1 -o OUT: free-form deformation.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdlib>
#include <memory>

#include <solidsubdiv/apps/cli/commands.h>
#include <solidsubdiv/apps/cli/deform_command.h>
#include <solidsubdiv/apps/cli/files_help.h>

namespace SolidSubdiv::Cli {

Work AddDeform(CLI::App& command) {
    const auto options = std::make_shared<DeformOptions>();
    DeformOptions& o = *options;
    command.add_option("MODEL", o.model, "what is deformed: a surface, a solid, points, with attributes")
        ->required()
        ->option_text(" ");
    CLI::Option* lattice =
        command.add_option("--lattice", o.lattice, "the control lattice around the model, before it moves")
            ->option_text("L0");
    CLI::Option* to =
        command.add_option("--to", o.to, "the same lattice, moved; several make a sequence")->option_text("L1 ...");
    command
        .add_option("-o,--output", o.output,
                    "the deformed model; of a sequence OUT_0001, OUT_0002 ...;\nthe extension chooses the format")
        ->option_text("OUT");
    CLI::Option* levels = command
                              .add_option("--levels", o.levels,
                                          "refinements of the lattice, whose last cells carry "
                                          "the model;\ndefault 2")
                              ->option_text("N");
    levels->check(CLI::Range(0, 20));
    CLI::Option* limit = command.add_flag("--limit", o.limit, "embed in the limit instead of level N: smooth, slower");
    CLI::Option* outside =
        command
            .add_option("--outside", o.outside,
                        "vertices in no cell: carry (by the nearest cell, fading),\nclamp (move as the nearest place "
                        "does), leave; default carry")
            ->option_text("WAY");
    outside->check(CLI::IsMember({"leave", "clamp", "carry"}));
    CLI::Option* falloff =
        command
            .add_option("--falloff", o.falloff,
                        "how far cells carry vertices, in the model's unit;\ndefault the mean edge of the lattice, inf "
                        "without end")
            ->option_text("D");
    falloff->check([](const std::string& text) {
        return std::strtod(text.c_str(), nullptr) > 0 ? std::string() : "'" + text + "' is no distance above 0";
    });
    CLI::Option* save = command
                            .add_option("--save-embedding", o.save_embedding,
                                        "keep where the vertices lie, for --embedding and for "
                                        "applications")
                            ->option_text("FILE");
    CLI::Option* drag =
        command
            .add_option(
                "--drag", o.drag,
                "instead of --to: lines 'vertex x y z', where vertices of the model go;\nthe control points follow by "
                "the least change")
            ->option_text("FILE")
            ->excludes(to)
            ->needs(lattice);
    command.add_flag("--preserve-volume", o.preserve_volume, "--drag: keep the volume of the model, a closed surface")
        ->needs(drag);
    command.add_option("--lock", o.lock, "--drag: control points that stay")->option_text("I ...")->needs(drag);
    command.add_option("--save-lattice", o.save_lattice, "--drag: write the moved lattice")
        ->option_text("FILE")
        ->needs(drag);
    command
        .add_option("--embedding", o.embedding,
                    "instead of --lattice: an embedding saved before, with its scheme and "
                    "levels")
        ->option_text("FILE")
        ->excludes(lattice)
        ->excludes(levels)
        ->excludes(limit)
        ->excludes(outside)
        ->excludes(falloff)
        ->excludes(save);
    AddSchemeOptions(command, o.scheme);
#ifdef SOLIDSUBDIV_HAS_PICTURES
    command.add_option("--picture", o.picture, "a picture of before and after")->option_text("OUT.png");
#endif
    command.add_flag("--keep-octahedra", o.keep_octahedra, "write octahedra of solids as polyhedra (.vtu, .vtk)");
    command.add_flag("--ascii", o.ascii, "write text where the format has a binary form too");
    command.footer(
        "'solidsubdiv lattice' makes lattices around a model. Move their control points in any program that keeps the\n"
        "order of points and cells. Attributes come along; normals (point data 'Normals', or nx, ny, nz) turn with "
        "the\n"
        "model. docs/deformation.md says what happens at the lattice's border.\n\n" +
        SchemesHelp() + "\n\n" + ReadableFilesHelp() + "\n" + WritableFilesHelp() +
        "\n\nExamples:\n"
        "  solidsubdiv lattice bunny.obj -o box.vtu --levels 1\n"
        "  solidsubdiv deform bunny.obj --lattice box.vtu --to moved.vtu -o deformed.obj\n"
        "  solidsubdiv deform bunny.obj --lattice box.vtu --drag ears.txt -o dragged.obj --picture dragged.png\n"
        "  solidsubdiv deform bunny.obj --lattice box.vtu --to walk1.vtu walk2.vtu walk3.vtu -o walk.obj --json -");
    return [options](Session& session) { RunDeform(*options, session); };
}

}  // namespace SolidSubdiv::Cli

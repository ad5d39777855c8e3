// SPDX-License-Identifier: Apache-2.0
// solidsubdiv fit TARGET -o DIR: a control lattice or cage whose limit is the target's shape.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>

#include <solidsubdiv/apps/cli/commands.h>
#include <solidsubdiv/apps/cli/files_help.h>
#include <solidsubdiv/apps/cli/fit_command.h>

namespace SolidSubdiv::Cli {

Work AddFit(CLI::App& command) {
    const auto options = std::make_shared<FitCommandOptions>();
    FitCommandOptions& o = *options;
    const Fit::Options defaults;
    command
        .add_option("TARGET", o.input,
                    "the shape: a surface, or a solid, whose boundary is taken;\na volume, whose surface is; points")
        ->required()
        ->option_text(" ");
    command.add_option("-o,--output", o.folder, "a folder for all that is found; made where it is not there")
        ->required()
        ->option_text("DIR (required)");
    command
        .add_option("--model", o.model,
                    "solid: a lattice of cells whose boundary's limit is the target\n(default for closed targets; "
                    "holes of others "
                    "are bridged);\n"
                    "surface: a cage whose limit is;\n"
                    "lattice: one around --template whose deformation carries that\nto the target (default with "
                    "--template)")
        ->option_text("solid|surface|lattice")
        ->check(CLI::IsMember({"solid", "surface", "lattice"}));
    command
        .add_option("--template", o.template_file, "the model that a lattice carries to the target, near which it lies")
        ->option_text("FILE");
    command.add_flag("--matched", o.matched,
                     "vertices of --template go to the target's of the same number;\nwithout: to where it is nearest");
    command.add_option("--label", o.target.label, "of volumes: the voxels of this value; default those of a mask")
        ->option_text("L");
    command
        .add_option("--iso", o.target.iso,
                    "of volumes: all from this level on; default of grey values\nOtsu's threshold")
        ->option_text("V");
    command
        .add_option("--smooth", o.target.smooth,
                    "of volumes: a Gaussian of so many voxels before; default 1\nfor labels, 0 for grey values")
        ->option_text("S")
        ->check(CLI::Range(0.0, 16.0));
    command.add_option("--control", o.control, "about how many control points; default 400")
        ->option_text("N")
        ->check(CLI::Range(8, 100'000));
    command
        .add_option(
            "--creases", o.creases,
            "of cages and lattices of tets: edges of the target that bend\nby more degrees become creases; 0: "
            "none; default 50 for parts\nwhose edges are sharp or not, none for scans. Solids with creases\nare "
            "of tets (box-spline) if no --scheme is given")
        ->option_text("D")
        ->check(CLI::Range(0.0, 179.0));
    command.add_option("--levels", o.levels, "refinements of the solid in fitted.vtu; default 3")
        ->option_text("N")
        ->check(CLI::Range(0, 8));
    command
        .add_option(
            "--iterations", o.fit.max_rounds,
            "rounds of nearest points and least squares at most;\ndefault " + std::to_string(defaults.max_rounds))
        ->option_text("N")
        ->check(CLI::Range(1, 10'000));
    command
        .add_option(
            "--tolerance", o.fit.tolerance,
            "the root of the mean squared distance that is near enough,\nboth ways, in the target's unit: where "
            "it can't be met, again\nwith half as many control points more, up to --max-control;\ndefault 0: as "
            "near as --control allows")
        ->option_text("T")
        ->check(CLI::NonNegativeNumber);
    command
        .add_option("--max-control", o.max_control, "most control points to meet --tolerance; default 4 x --control")
        ->option_text("N")
        ->check(CLI::Range(8, 100'000));
    command
        .add_option("--fairness", o.fit.least_fairness,
                    "how stiff the lattice stays in the end: 0.01 smooths noise,\n1e-6 follows every detail; default "
                    "1e-4")
        ->option_text("F")
        ->check(CLI::Range(0.0, 1e6));
    command
        .add_option("--robust", o.fit.robust,
                    "count points less that are farther than so many times the\nmedian distance (outliers, holes); "
                    "default 0: all count alike")
        ->option_text("R")
        ->check(CLI::Range(0.0, 1e6));
    command
        .add_option("--normals", o.fit.normals,
                    "how much normals count beside distances: 1e-5 to 1e-3 for points\nthat are few and have normals; "
                    "default 0")
        ->option_text("W")
        ->check(CLI::Range(0.0, 1e6));
    command
        .add_option("--spring", o.fit.spring,
                    "how strongly control points of a cell attract each other, which\nkeeps those in place that no "
                    "data reach; default 0")
        ->option_text("S")
        ->check(CLI::Range(0.0, 1e6));
    AddSchemeOptions(command, o.scheme);
#ifdef SOLIDSUBDIV_HAS_PICTURES
    command.add_flag("!--no-pictures", o.pictures, "leave out pictures and report.html");
#endif
    command.footer(
        "Into DIR go lattice.vtu (or cage.obj), the control mesh; fitted.obj, its limit surface; fitted.vtu, that with "
        "each\nvertex's distance from the target; solid.vtu, the refined solid; fit.json with settings, distances both "
        "ways,\nfolded cells and times; pictures and report.html. Of --template fitted.obj is the deformed model; "
        "start.vtu the\nlattice before ('deform --lattice start.vtu --to lattice.vtu' carries other models along).\n"
        "Ctrl-C during the rounds writes the best so far. docs/fitting.md explains how it works.\n\n" +
        SchemesHelp() + "\n\n" + ReadableFilesHelp() + "\n" + ReadableTargetsHelp() +
        "\n\nExamples:\n"
        "  solidsubdiv fit bunny.obj -o fitted --control 150 --levels 2\n"
        "  solidsubdiv fit bunny.obj -o cage --model surface --scheme loop --control 200 --json -\n"
        "  solidsubdiv fit part.obj -o part --scheme box-spline --creases 40 --control 100 --levels 2\n"
        "  solidsubdiv fit deformed.obj -o carried --template bunny.obj --control 200\n"
        "  solidsubdiv fit labels.nii.gz -o caudate --label 1 --control 100\n"
        "  solidsubdiv fit scan.xyz -o fitted --robust 3 --control 100");
    return [options](Session& session) { RunFit(*options, session); };
}

}  // namespace SolidSubdiv::Cli

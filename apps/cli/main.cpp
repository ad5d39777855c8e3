// SPDX-License-Identifier: Apache-2.0
// The program solidsubdiv: reads the command line, runs one sub-command, turns errors into one line and a status.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cstdio>
#include <new>

#include <solidsubdiv/apps/cli/commands.h>
#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/apps/cli/programs.h>

namespace SolidSubdiv::Cli {
namespace {

enum Status { kSuccess = 0, kFailure = 1, kBadUsage = 2 };

int Fail(Status status, std::string text) {
    for (char& c : text) {
        if (c == '\n') c = ' ';
    }
    std::fprintf(stderr, "solidsubdiv: error: %s\n", text.c_str());
    return status;
}

int Run(const Work& work, const CommonOptions& options) {
    CatchInterrupts();
    // A session's destructor removes what is unfinished before the error is said.
    std::string text;
    Status status = kSuccess;
    try {
        Session session(options);
        const auto fail = [&](Status s, const std::string& what) {
            status = s;
            text = session.outputs().WithFinalNames(what);
        };
        try {
            work(session);
        } catch (const Cancelled&) {
            fail(kFailure, "cancelled; no file was written");
        } catch (const UsageError& error) {
            fail(kBadUsage, error.what());
        } catch (const std::bad_alloc&) {
            fail(kFailure, "there is not enough memory; take a smaller mesh or fewer levels");
        } catch (const std::exception& error) {
            fail(kFailure, error.what());
        }
    } catch (const UsageError& error) {
        return Fail(kBadUsage, error.what());
    } catch (const std::exception& error) {
        return Fail(kFailure, error.what());
    }
    return status == kSuccess ? kSuccess : Fail(status, text);
}

int Start(const Program& program, int argc, char** argv) {
    try {
        Become(program, argc, argv);
    } catch (const Error& error) {
        return Fail(kFailure, error.what());
    }
}

int Main(int argc, char** argv) {
    CLI::App app("Subdivision of solids: control lattices of tets and octs refined into smooth solids.", "solidsubdiv");
    app.set_version_flag("--version", "solidsubdiv " SOLIDSUBDIV_VERSION, "the version");
    app.set_help_flag("-h,--help", "this text; 'solidsubdiv COMMAND --help' explains a command, with an example");
    app.get_formatter()->column_width(34);
    app.get_formatter()->label("SUBCOMMAND", "COMMAND");
    app.require_subcommand(1);
    app.footer(
        "Exit status: 0 success, 1 failure (one line on standard error, no output file is left), 2 bad usage.\n\n"
        "Example:\n"
        "  solidsubdiv info lattice.vtu");

    CommonOptions options;
    std::vector<Work> works;
    for (const Command& command : kCommands) {
        CLI::App* sub = app.add_subcommand(std::string(command.name), std::string(command.summary));
        sub->group("Commands");
        sub->set_help_flag("-h,--help", "this text");
        works.push_back(command.add(*sub));
        AddCommonOptions(*sub, options);
    }
    for (const Program& program : kPrograms) {
        if (argc > 1 && program.name == argv[1]) return Start(program, argc, argv);
        if (!IsThere(program)) continue;
        app.add_subcommand(std::string(program.name), std::string(program.summary))->group("Commands");
    }
    const auto is_called = [&](const Command& command) { return command.name == argv[1]; };
    if (argc > 1 && argv[1][0] != '-' && std::none_of(kCommands.begin(), kCommands.end(), is_called)) {
        std::string known;
        const auto add = [&](std::string_view name) { known += (known.empty() ? "" : ", ") + std::string(name); };
        for (const Command& command : kCommands) add(command.name);
        for (const Program& program : kPrograms) {
            if (IsThere(program)) add(program.name);
        }
        return Fail(kBadUsage, "there is no command '" + std::string(argv[1]) + "'; there are " + known +
                                   "; see solidsubdiv --help");
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help_or_version) {
        return app.exit(help_or_version);
    } catch (const CLI::ParseError& error) {
        std::string help = "solidsubdiv";
        for (const CLI::App* sub : app.get_subcommands()) help += " " + sub->get_name();
        return Fail(kBadUsage, std::string(error.what()) + "; see " + help + " --help");
    } catch (const UsageError& error) {
        return Fail(kBadUsage, error.what());
    }
    for (std::size_t i = 0; i < works.size(); ++i) {
        if (app.got_subcommand(std::string(kCommands[i].name))) return Run(works[i], options);
    }
    return kBadUsage;
}

}  // namespace
}  // namespace SolidSubdiv::Cli

int main(int argc, char** argv) { return SolidSubdiv::Cli::Main(argc, argv); }

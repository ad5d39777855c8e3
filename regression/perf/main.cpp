// SPDX-License-Identifier: Apache-2.0
// solidsubdiv-bench: runs the races of races.h and prints what they found.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>
#include <vector>

#include "perf/machine.h"
#include "perf/races.h"
#include "perf/report.h"

namespace {

using namespace SolidSubdiv::Perf;

constexpr const char* kUsage =
    "usage: solidsubdiv-bench [--only NAME] [--quick] [--threads N] [--json FILE|-] [--quiet]\n"
    "\n"
    "Races the framework with its peers, in turns in one process: medians, ratios to the peers, bytes kept a unit,\n"
    "percent of the bandwidth of copying that was measured meanwhile. A table a race; minutes all together.\n"
    "\n"
    "  --only NAME     races whose names start so (repeatable): ";
constexpr const char* kOptions =
    "  --quick         small sizes and few turns: to see that it works, not to quote\n"
    "  --threads N     1: races on one thread only (default: on one and on two)\n"
    "  --json FILE|-   all figures for programs; - writes to the standard output instead of the tables\n"
    "  --quiet         no tables\n"
    "\n"
    "Example:\n"
    "  solidsubdiv bench --quick --only evaluation\n";

struct Arguments {
    std::vector<std::string> only;
    std::string json;
    bool is_quiet = false, wants_help = false;
    RaceSettings settings;
};

int Help() {
    std::fputs(kUsage, stdout);
    for (const RaceEntry& entry : kRaces) std::printf("%s%s", &entry == kRaces ? "" : ", ", entry.name);
    std::printf("\n%s", kOptions);
    return 0;
}

/// What is wrong with the command line, or nothing.
std::string Parse(int argc, char** argv, Arguments& arguments) {
    for (int i = 1; i < argc; ++i) {
        const std::string name = argv[i];
        if (name == "--help" || name == "-h") {
            arguments.wants_help = true;
        } else if (name == "--quick") {
            arguments.settings.is_quick = true;
        } else if (name == "--quiet") {
            arguments.is_quiet = true;
        } else if (name == "--only" || name == "--json" || name == "--threads") {
            if (i + 1 == argc) return name + " needs a value";
            const std::string value = argv[++i];
            if (name == "--json") arguments.json = value;
            if (name == "--only") {
                const auto is_it = [&](const RaceEntry& entry) {
                    return std::string_view(entry.name).starts_with(value);
                };
                if (std::none_of(std::begin(kRaces), std::end(kRaces), is_it)) return "there is no race " + value;
                arguments.only.push_back(value);
            }
            if (name == "--threads") {
                const auto [end, error] =
                    std::from_chars(value.data(), value.data() + value.size(), arguments.settings.max_threads);
                if (error != std::errc() || *end || arguments.settings.max_threads < 1) {
                    return "--threads takes a number from 1, not " + value;
                }
            }
        } else {
            return "unknown argument " + name;
        }
    }
    return "";
}

int Fail(int status, const std::string& text) {
    std::fprintf(stderr, "solidsubdiv-bench: error: %s\n", text.c_str());
    return status;
}

int Run(const Arguments& arguments) {
    const PinnedThreads pinned;
    const MachineInfo machine = DescribeMachine();
    const bool prints = !arguments.is_quiet && arguments.json != "-";
    if (prints) std::fputs(TextOf(machine).c_str(), stdout);
    std::vector<Race> races;
    for (const RaceEntry& entry : kRaces) {
        const auto& only = arguments.only;
        const auto is_named = [&](const std::string& name) { return std::string_view(entry.name).starts_with(name); };
        if (!only.empty() && std::none_of(only.begin(), only.end(), is_named)) continue;
        races.push_back(entry.run(arguments.settings));
        if (prints) std::printf("\n%s", TableOf(races.back()).c_str());
        std::fflush(stdout);
    }
    if (arguments.json.empty()) return 0;
    const std::string json = JsonOf(machine, races, arguments.settings);
    if (arguments.json == "-") {
        std::fputs(json.c_str(), stdout);
    } else if (!(std::ofstream(arguments.json) << json).flush()) {
        return Fail(1, arguments.json + ": can't be written");
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    const std::string wrong = Parse(argc, argv, arguments);
    if (!wrong.empty()) return Fail(2, wrong + "; see --help");
    if (arguments.wants_help) return Help();
    try {
        return Run(arguments);
    } catch (const std::exception& error) {
        return Fail(1, error.what());
    }
}

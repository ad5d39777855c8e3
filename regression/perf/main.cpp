// SPDX-License-Identifier: Apache-2.0
// solidsubdiv-bench: runs the races of races.h and prints what they found.
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>

#include "perf/machine.h"
#include "perf/races.h"
#include "perf/report.h"

namespace {

using namespace SolidSubdiv::Perf;

constexpr const char* kUsage =
    "usage: solidsubdiv-bench [--json FILE] [--quick] [--only NAME]\n"
    "  --json FILE   writes all figures as JSON too\n"
    "  --quick       small sizes and few rounds: to see that it works, not to quote\n"
    "  --only NAME   one race: ";

int Usage(std::FILE* to) {
    std::fputs(kUsage, to);
    for (const RaceEntry& entry : kRaces) std::fprintf(to, "%s%s", &entry == kRaces ? "" : ", ", entry.name);
    std::fputs("\n", to);
    return to == stdout ? 0 : 2;
}

int Run(const std::string& only, const std::string& json, const RaceSettings& settings) {
    const PinnedThreads pinned;
    const MachineInfo machine = DescribeMachine();
    std::fputs(TextOf(machine).c_str(), stdout);
    std::vector<Race> races;
    for (const RaceEntry& entry : kRaces) {
        if (!only.empty() && only != entry.name) continue;
        races.push_back(entry.run(settings));
        std::printf("\n%s", TableOf(races.back()).c_str());
        std::fflush(stdout);
    }
    if (!json.empty() && !(std::ofstream(json) << JsonOf(machine, races, settings)).flush()) {
        std::fprintf(stderr, "solidsubdiv-bench: error: %s: can't be written\n", json.c_str());
        return 1;
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    std::string only, json;
    RaceSettings settings;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument == "--help") return Usage(stdout);
        if (argument == "--quick") {
            settings.is_quick = true;
        } else if ((argument == "--only" || argument == "--json") && i + 1 < argc) {
            (argument == "--only" ? only : json) = argv[++i];
        } else {
            return Usage(stderr);
        }
    }
    bool is_known = only.empty();
    for (const RaceEntry& entry : kRaces) is_known = is_known || only == entry.name;
    if (!is_known) return Usage(stderr);
    try {
        return Run(only, json, settings);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "solidsubdiv-bench: error: %s\n", error.what());
        return 1;
    }
}

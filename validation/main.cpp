// SPDX-License-Identifier: Apache-2.0
// The program solidsubdiv-validate: runs the reference validators, one line each.
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <unistd.h>

#include <solidsubdiv/sdc/parallel.h>

#include "validators.h"

namespace {

using namespace SolidSubdiv::Validation;

constexpr const char* kUsage =
    "usage: solidsubdiv-validate [--list] [--only NAME] [--shapes DIR] [--report FILE.html] [--json FILE|-]\n"
    "                            [--threads N] [--quick] [--quiet]\n"
    "\n"
    "Holds the framework to references that were not derived from it. One line a validator: PASS, FAIL or SKIPPED,\n"
    "with its largest error. Exit 0 if none fails, 1 if one does, 2 on bad usage.\n"
    "\n"
    "  --list             names of the validators and what they check\n"
    "  --only NAME        this one only (repeatable)\n"
    "  --shapes DIR       the project's shapes (default: regression/shapes of the source tree)\n"
    "  --report FILE.html a page with everything that was found\n"
    "  --json FILE|-      the same for programs; - writes to the standard output instead of the lines\n"
    "  --threads N        the framework uses at most N threads\n"
    "  --quick            two levels, few places, small shapes: to see that it works, not to rely on\n"
    "  --quiet            only what fails\n"
    "\n"
    "Data from elsewhere is used where it is present, and named as SKIPPED where it is not: SOLIDSUBDIV_DATA names "
    "its\n"
    "folder (with tets/ and opensubdiv_shapes/; a checkout looks beside itself too), SOLIDSUBDIV_OSD_SHAPES that of\n"
    "OpenSubdiv's catalogue alone.\n"
    "\n"
    "Example:\n"
    "  solidsubdiv validate --only counts --report counts.html\n";

struct Arguments {
    bool list = false, quick = false, quiet = false;
    int threads = 0;  ///< 0: as many as the machine has
    std::vector<std::string> only;
    std::filesystem::path shapes = SOLIDSUBDIV_SHAPES;
    std::string report, json;
};

int Fail(int code, const std::string& text) {
    std::fprintf(stderr, "solidsubdiv-validate: error: %s\n", text.c_str());
    return code;
}

std::optional<std::string> Parse(int argc, char** argv, Arguments& arguments) {
    for (int i = 1; i < argc; ++i) {
        const std::string name = argv[i];
        bool* const flag = name == "--list"    ? &arguments.list
                           : name == "--quick" ? &arguments.quick
                           : name == "--quiet" ? &arguments.quiet
                                               : nullptr;
        if (flag) {
            *flag = true;
            continue;
        }
        if (name != "--only" && name != "--shapes" && name != "--report" && name != "--json" && name != "--threads") {
            return "unknown argument " + name + "; see --help";
        }
        if (i + 1 >= argc) return name + " needs a value";
        const std::string value = argv[++i];
        if (name == "--only") arguments.only.push_back(value);
        if (name == "--shapes") arguments.shapes = value;
        if (name == "--report") arguments.report = value;
        if (name == "--json") arguments.json = value;
        if (name == "--threads") {
            const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), arguments.threads);
            if (error != std::errc() || *end || arguments.threads < 1) {
                return "--threads takes a number from 1, not " + value;
            }
        }
    }
    for (const std::string& only : arguments.only) {
        bool known = false;
        for (const Validator& validator : Validators()) known |= validator.name == only;
        if (!known) return "there is no validator " + only + "; see --list";
    }
    return std::nullopt;
}

std::filesystem::path FromEnvironment(const char* name, const std::filesystem::path& otherwise) {
    const char* value = std::getenv(name);
    return value && *value ? std::filesystem::path(value) : otherwise;
}

bool Write(const std::string& file, const std::string& text) {
    std::ofstream stream(file);
    stream << text;
    stream.flush();
    return stream.good();
}

}  // namespace

int main(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        if (std::string(argv[i]) == "--help" || std::string(argv[i]) == "-h") {
            std::fputs(kUsage, stdout);
            return 0;
        }
    }
    Arguments arguments;
    if (const auto wrong = Parse(argc, argv, arguments)) return Fail(2, *wrong);
    if (arguments.list) {
        for (const Validator& v : Validators()) {
            std::printf("%-20s  %s\n", std::string(v.name).c_str(), std::string(v.checks).c_str());
        }
        return 0;
    }
    if (!std::filesystem::is_directory(arguments.shapes)) {
        return Fail(1, arguments.shapes.string() + ": there is no such folder; name regression/shapes with --shapes");
    }

    const std::filesystem::path data = FromEnvironment("SOLIDSUBDIV_DATA", SOLIDSUBDIV_DATA);
    Context context;
    context.shapes = arguments.shapes;
    context.is_quick = arguments.quick;
    context.osd_shapes = FromEnvironment("SOLIDSUBDIV_OSD_SHAPES", data / "opensubdiv_shapes");
    context.tets = data / "tets";
    context.scripts = std::filesystem::path(SOLIDSUBDIV_SOURCE) / "validation";
    std::error_code ignored;
    context.programs = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
    std::string scratch = (std::filesystem::temp_directory_path() / "solidsubdiv-validate-XXXXXX").string();
    if (!::mkdtemp(scratch.data())) return Fail(1, scratch + ": can't be made");
    context.scratch = scratch;

    std::optional<SolidSubdiv::Sdc::ThreadLimit> limit;
    if (arguments.threads > 0) limit.emplace(arguments.threads);
    std::vector<Outcome> outcomes;
    bool failed = false;
    for (const Validator& validator : Validators()) {
        bool wanted = arguments.only.empty();
        for (const std::string& only : arguments.only) wanted |= validator.name == only;
        if (!wanted) continue;
        outcomes.push_back(Run(validator, context));
        failed |= outcomes.back().status == Status::Fail;
        if (arguments.json == "-" || (arguments.quiet && outcomes.back().status != Status::Fail)) continue;
        std::puts(LineOf(outcomes.back()).c_str());
        for (const std::string& text : outcomes.back().findings.skipped)
            std::printf("           SKIPPED %s\n", text.c_str());
        std::fflush(stdout);
    }
    std::filesystem::remove_all(context.scratch, ignored);

    if (arguments.json == "-") {
        std::fputs(JsonOf(outcomes).c_str(), stdout);
    } else if (!arguments.json.empty() && !Write(arguments.json, JsonOf(outcomes))) {
        return Fail(1, arguments.json + ": can't be written");
    }
    if (!arguments.report.empty() && !Write(arguments.report, HtmlOf(outcomes))) {
        return Fail(1, arguments.report + ": can't be written");
    }
    return failed ? 1 : 0;
}

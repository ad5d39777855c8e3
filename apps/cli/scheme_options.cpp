// SPDX-License-Identifier: Apache-2.0
// The choice of a scheme and its options on the command line.
#include <solidsubdiv/apps/cli/scheme_options.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <set>

#include <solidsubdiv/apps/cli/common.h>

namespace SolidSubdiv::Cli {

namespace {

/// --diagonals has this scheme option as one of its values.
constexpr std::string_view kDiagonalsOption = "diagonals";

struct MergedOption {
    std::string name, values, help;
};

/// Every option of every scheme, one entry a name; the help says whose it is.
std::vector<MergedOption> MergedOptions() {
    std::vector<MergedOption> merged;
    Sdc::ForEachScheme([&](auto scheme) {
        for (const Sdc::OptionInfo& option : scheme.kOptions) {
            if (option.name == kDiagonalsOption) continue;
            const std::string help = std::string(scheme.kName) + ": " + std::string(option.help) +
                                     (option.unit.empty() ? "" : " (" + std::string(option.unit) + ")") + "; default " +
                                     std::string(option.initial);
            const auto known = std::find_if(merged.begin(), merged.end(),
                                            [&](const MergedOption& m) { return m.name == option.name; });
            if (known == merged.end()) {
                merged.push_back({std::string(option.name), std::string(option.values), help});
            } else {
                known->help += "\n" + help;
            }
        }
    });
    return merged;
}

std::string SchemeNames() {
    std::string names;
    Sdc::ForEachScheme([&](auto scheme) { names += (names.empty() ? "" : "|") + std::string(scheme.kName); });
    return names;
}

/// With default options. @throws UsageError for an unknown name
Sdc::Scheme NamedScheme(const SchemeOptions& options, MeshKind kind) {
    const char* const usual = kind.is_solid ? (kind.is_tet_oct ? "box-spline" : "catmull-clark-solid")
                                            : (kind.is_tet_oct ? "loop" : "catmull-clark");
    try {
        return Sdc::SchemeOf(!options.scheme.empty() ? options.scheme : usual);
    } catch (const InvalidInput& error) {
        throw UsageError(error.what());
    }
}

}  // namespace

void AddSchemeOptions(CLI::App& command, SchemeOptions& options) {
    command
        .add_option("--scheme", options.scheme,
                    "the scheme; default: box-spline for tets and octs, loop for triangles,\ncatmull-clark-solid and "
                    "catmull-clark for others")
        ->option_text(SchemeNames());
    command
        .add_option("--diagonals", options.diagonals,
                    "which diagonal the octahedron in each tet gets; default matched:\n"
                    "as many inner faces as possible agree with both their cells\n"
                    "shortest: by length; first: as the cells are ordered;\n"
                    "given: by the cell data 'diagonal' (0, 1 or 2);\n"
                    "averaged: box-spline's mask without diagonals")
        ->option_text("matched|shortest|first|averaged|given")
        ->check(CLI::IsMember(std::set<std::string>{"matched", "shortest", "first", "averaged", "given"}));
    for (const MergedOption& option : MergedOptions()) {
        const std::string name = option.name;
        command
            .add_option_function<std::string>(
                "--" + name, [&options, name](const std::string& value) { options.values.emplace_back(name, value); },
                option.help)
            ->option_text(option.values);
    }
}

void AddOrientOption(CLI::App& command, std::string& orient) {
    command
        .add_option("--orient", orient, "inverted cells: repair (default) turns them,\nkeep leaves them, refuse fails")
        ->option_text("repair|keep|refuse")
        ->check(CLI::IsMember(std::set<std::string>{"repair", "keep", "refuse"}));
}

SchemeOptions WithFileOptions(SchemeOptions options, const std::vector<std::pair<std::string, std::string>>& file,
                              MeshKind kind) {
    const Sdc::Scheme scheme = NamedScheme(options, kind);
    for (const auto& option : file) {
        std::string name = option.first, value = option.second;
        if (name == "boundary") {  // what files call it
            name = "features";
            value = value == "edge-and-corner" ? "sharp" : "smooth";
        }
        const auto has_option = [&](const auto& s) {
            return std::any_of(s.kOptions.begin(), s.kOptions.end(), [&](const auto& o) { return o.name == name; });
        };
        if (std::visit(has_option, scheme)) options.values.emplace(options.values.begin(), name, value);
    }
    return options;
}

SchemeChoice MakeScheme(const SchemeOptions& options, MeshKind kind) {
    SchemeChoice choice;
    try {
        choice.scheme = NamedScheme(options, kind);
        for (const auto& [name, value] : options.values) Sdc::SetOption(choice.scheme, name, value);
        if (options.diagonals == "averaged") {
            Sdc::SetOption(choice.scheme, kDiagonalsOption, options.diagonals);
            choice.diagonals = Far::DiagonalPolicy::First;
        } else {
            choice.diagonals = Far::DiagonalPolicyOf(options.diagonals);
        }
        std::visit([](const auto& s) { s.Validate(); }, choice.scheme);
    } catch (const InvalidInput& error) {
        throw UsageError(error.what());
    }
    return choice;
}

std::vector<std::pair<std::string, std::string>> OptionValues(const SchemeOptions& options, const Sdc::Scheme& scheme) {
    std::vector<std::pair<std::string, std::string>> values;
    const auto add = [&](const Sdc::OptionInfo& option) {
        if (option.name == kDiagonalsOption) return;
        std::string value(option.initial);
        for (const auto& given : options.values) {
            if (given.first == option.name) value = given.second;
        }
        values.emplace_back(option.name, value);
    };
    std::visit([&](const auto& s) { std::for_each(s.kOptions.begin(), s.kOptions.end(), add); }, scheme);
    return values;
}

std::string SchemesHelp() {
    std::string text = "Schemes:";
    Sdc::ForEachScheme([&](auto scheme) {
        std::string name(scheme.kName);
        name.resize(std::max<std::size_t>(name.size() + 1, 20), ' ');
        text += "\n  " + name + std::string(scheme.kSummary);
    });
    return text;
}

}  // namespace SolidSubdiv::Cli

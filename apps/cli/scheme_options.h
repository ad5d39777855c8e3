// SPDX-License-Identifier: Apache-2.0
// The choice of a scheme and its options on the command line; names, ranges and help come from the schemes' own tables.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <solidsubdiv/far/choose_diagonals.h>
#include <solidsubdiv/sdc/schemes.h>

namespace CLI {
class App;
}

namespace SolidSubdiv::Cli {

/// What schemes are chosen by.
struct MeshKind {
    bool is_solid = true;
    bool is_tet_oct = true;  ///< tets, octs, triangles and edges alone
};

struct SchemeOptions {
    std::string scheme;  ///< empty: the default of the mesh's kind
    std::vector<std::pair<std::string, std::string>> values;
    std::string diagonals = "matched";  ///< a policy, or averaged
};

/// Adds --scheme, --diagonals and one option for each name in the schemes' tables. `options` must outlive the command.
void AddSchemeOptions(CLI::App& command, SchemeOptions& options);

/// Adds --orient: what is done about inverted cells.
void AddOrientOption(CLI::App& command, std::string& orient);

/// The options with what a file asks for (Io::Mesh::scheme_options) where the scheme has such an option and the command
/// line does not say otherwise.
SchemeOptions WithFileOptions(SchemeOptions options, const std::vector<std::pair<std::string, std::string>>& file,
                              MeshKind kind);

struct SchemeChoice {
    Sdc::Scheme scheme;
    Far::DiagonalPolicy diagonals = Far::DiagonalPolicy::Matched;
};

/// @throws UsageError for unknown names and values, and where they contradict each other
SchemeChoice MakeScheme(const SchemeOptions& options, MeshKind kind);

/// The value of every option that the scheme has (but diagonals), given or by default.
std::vector<std::pair<std::string, std::string>> OptionValues(const SchemeOptions& options, const Sdc::Scheme& scheme);

/// Lines on the schemes that there are, for the help.
std::string SchemesHelp();

}  // namespace SolidSubdiv::Cli

// SPDX-License-Identifier: Apache-2.0
// solidsubdiv analyze: eigenvalues of a scheme on its regular lattice or around edges, and what they say.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <charconv>
#include <memory>
#include <nlohmann/json.hpp>

#include <solidsubdiv/apps/cli/commands.h>
#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/apps/cli/scheme_options.h>
#include <solidsubdiv/kit/analysis/places.h>
#include <solidsubdiv/kit/analysis/spectrum.h>

namespace SolidSubdiv::Cli {

namespace {

constexpr int kMaxCells = 32;

struct AnalyzeOptions {
    SchemeOptions scheme;
    bool regular = false;
    std::string edge;  ///< "5" or "3..8"
};

Json EigenvaluesOf(const Analysis::Spectrum& spectrum) {
    Json list = Json::array();
    for (const Analysis::Eigenvalue& e : spectrum) {
        list.push_back({{"real", e.value.real()}, {"imaginary", e.value.imag()}, {"multiplicity", e.multiplicity}});
    }
    return list;
}

/// First and last of a range. @throws UsageError
std::pair<int, int> RangeOf(const std::string& text) {
    const auto number = [&](std::string_view part) {
        int n = 0;
        const auto read = std::from_chars(part.data(), part.data() + part.size(), n);
        if (read.ec != std::errc() || read.ptr != part.data() + part.size() || n < 3 || n > kMaxCells) {
            throw UsageError("--edge is '" + text + "'; it is a number of cells or a range such as 3..8, from 3 to " +
                             std::to_string(kMaxCells));
        }
        return n;
    };
    const std::size_t dots = text.find("..");
    if (dots == std::string::npos) return {number(text), number(text)};
    const int first = number(std::string_view(text).substr(0, dots)),
              last = number(std::string_view(text).substr(dots + 2));
    if (first > last) throw UsageError("--edge is '" + text + "': it starts above its end");
    return {first, last};
}

const char* RegularPlace(bool is_solid, bool is_tet_oct) {
    if (is_tet_oct) return is_solid ? "inner vertex of the octet truss" : "vertex of valence 6";
    return is_solid ? "inner vertex of a block of hexahedra" : "vertex of four quadrilaterals";
}

std::string AnalyzeRegular(const Sdc::Scheme& scheme, Json& result) {
    const bool is_solid = std::visit([](const auto& s) { return s.kSolids; }, scheme);
    const Far::LocalMatrix matrix = Analysis::RegularLocalMatrix(scheme);
    const Analysis::Spectrum spectrum = Analysis::SpectrumOf(matrix);
    const Analysis::Verdict verdict = Analysis::VerdictOf(spectrum, is_solid ? 3 : 2);
    const std::vector<double> limit = Far::LimitMaskOf(matrix);
    result["place"] = RegularPlace(is_solid, Sdc::Takes(scheme, Sdc::Split::TetOct));
    result["neighbors"] = matrix.size() - 1;
    result["eigenvalues"] = EigenvaluesOf(spectrum);
    result["verdict"] = verdict.text;
    result["limit_mask"] = limit;

    std::string text = std::string(Sdc::NameOf(scheme)) + ", regular lattice: a vertex and its " +
                       Counted(matrix.size() - 1, "neighbor", "neighbors") + "\n";
    text += "  eigenvalues  " + Analysis::SpectrumText(spectrum) + "\n";
    text += "  verdict      " + verdict.text + "\n";
    if (!limit.empty() && limit[0] == 1) {
        text += "  limit mask   1: the vertex stays";
    } else if (!limit.empty()) {
        text += "  limit mask   " + Text(limit[0]);
        for (std::size_t i = 1; i < limit.size(); ++i) text += ", " + Text(limit[i]);
    }
    return text;
}

std::string AnalyzeEdges(const Sdc::Scheme& scheme, const std::string& edge, Json& result) {
    const auto [first, last] = RangeOf(edge);
    std::string text = std::string(Sdc::NameOf(scheme)) + ": a vertex on an inner edge of n cells";
    result["edges"] = Json::array();
    for (int n = first; n <= last; ++n) {
        const Analysis::Spectrum spectrum = Analysis::SpectrumOf(Analysis::EdgeLocalMatrix(scheme, n));
        const Analysis::EdgeVerdict verdict = Analysis::EdgeVerdictOf(spectrum);
        result["edges"].push_back({{"cells", n}, {"eigenvalues", EigenvaluesOf(spectrum)}, {"verdict", verdict.text}});
        constexpr std::size_t kShown = 7;
        const Analysis::Spectrum shown(spectrum.begin(),
                                       spectrum.begin() + static_cast<long>(std::min(kShown, spectrum.size())));
        text += "\n  n = " + std::to_string(n) + "   " + Analysis::SpectrumText(shown) +
                (spectrum.size() > kShown ? " ..." : "") + "\n          " + verdict.text;
    }
    return text;
}

void RunAnalyze(Session& session, const AnalyzeOptions& options) {
    const Sdc::Scheme scheme = MakeScheme(options.scheme, {}).scheme;
    if (options.regular == !options.edge.empty()) {
        throw UsageError("analyze takes --regular or --edge N: which place is meant?");
    }
    if (!options.edge.empty() && !std::visit([](const auto& s) { return s.kSolids; }, scheme)) {
        throw UsageError("--edge is for schemes of solids; " + std::string(Sdc::NameOf(scheme)) +
                         " is one of surfaces");
    }
    session.Stage("analyze");
    Json result;
    result["command"] = "analyze";
    result["scheme"] = Sdc::NameOf(scheme);
    for (const auto& [name, value] : options.scheme.values) result["options"][name] = value;
    const std::string text =
        options.regular ? AnalyzeRegular(scheme, result) : AnalyzeEdges(scheme, options.edge, result);
    session.EndStage();
    result["seconds"] = session.Seconds();
    session.Print(text);
    session.Finish(result);
}

}  // namespace

Work AddAnalyze(CLI::App& command) {
    const auto options = std::make_shared<AnalyzeOptions>();
    command.add_flag("--regular", options->regular, "the scheme's regular lattice");
    command
        .add_option("--edge", options->edge,
                    "inner edges with this number of cells and a regular mesh around:\n"
                    "hexahedra, or what a split makes of tets")
        ->option_text("N|N..M");
    AddSchemeOptions(command, options->scheme);
    command.footer(
        "\nThe subdivision matrix says how a vertex and its neighbors move in one refinement. Its eigenvalues tell "
        "how\n"
        "smooth the limit can be there, the left eigenvector of the eigenvalue 1 is the limit mask.\n\n" +
        SchemesHelp() +
        "\n\nExamples:\n"
        "  solidsubdiv analyze --regular --scheme box-spline --edge-rule printed-2002\n"
        "  solidsubdiv analyze --regular --scheme interpolatory --tension 0.1\n"
        "  solidsubdiv analyze --edge 3..8 --scheme mlca");
    return [options](Session& session) { RunAnalyze(session, *options); };
}

}  // namespace SolidSubdiv::Cli

// SPDX-License-Identifier: Apache-2.0
// solidsubdiv analyze --regular: eigenvalues of a scheme on its regular lattice, and what they say.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include <solidsubdiv/apps/cli/commands.h>
#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/apps/cli/scheme_options.h>
#include <solidsubdiv/kit/analysis/spectrum.h>

namespace SolidSubdiv::Cli {

namespace {

struct AnalyzeOptions {
    SchemeOptions scheme;
    bool regular = false;
};

Json EigenvaluesOf(const Analysis::Spectrum& spectrum) {
    Json list = Json::array();
    for (const Analysis::Eigenvalue& e : spectrum) {
        list.push_back({{"real", e.value.real()}, {"imaginary", e.value.imag()}, {"multiplicity", e.multiplicity}});
    }
    return list;
}

void RunAnalyze(Session& session, const AnalyzeOptions& options) {
    const Sdc::Scheme scheme = MakeScheme(options.scheme, {}).scheme;
    if (!Sdc::Takes(scheme, Sdc::Split::TetOct)) {
        throw UsageError("analyze knows the schemes of tets and triangles, not yet " +
                         std::string(Sdc::NameOf(scheme)));
    }
    session.Stage("analyze");
    const bool is_solid = std::visit([](const auto& s) { return s.kSolids; }, scheme);
    const Far::LocalMatrix matrix = Analysis::RegularLocalMatrix(scheme);
    const Analysis::Spectrum spectrum = Analysis::SpectrumOf(matrix);
    const Analysis::Verdict verdict = Analysis::VerdictOf(spectrum, is_solid ? 3 : 2);
    const std::vector<double> limit = Far::LimitMaskOf(matrix);
    session.EndStage();

    Json result;
    result["command"] = "analyze";
    result["scheme"] = Sdc::NameOf(scheme);
    for (const auto& [name, value] : options.scheme.values) result["options"][name] = value;
    result["place"] = is_solid ? "inner vertex of the octet truss" : "vertex of valence 6";
    result["neighbors"] = matrix.size() - 1;
    result["eigenvalues"] = EigenvaluesOf(spectrum);
    result["verdict"] = verdict.text;
    result["limit_mask"] = limit;
    result["seconds"] = session.Seconds();

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
    session.Print(text);
    session.Finish(result);
}

}  // namespace

Work AddAnalyze(CLI::App& command) {
    const auto options = std::make_shared<AnalyzeOptions>();
    command.add_flag("--regular", options->regular, "the scheme's regular lattice (the only place so far)")->required();
    AddSchemeOptions(command, options->scheme);
    command.footer(
        "\nThe subdivision matrix says how a vertex and its neighbors move in one refinement. Its eigenvalues tell "
        "how\n"
        "smooth the limit can be there, the left eigenvector of the eigenvalue 1 is the limit mask.\n\n" +
        SchemesHelp() +
        "\n\nExamples:\n"
        "  solidsubdiv analyze --regular --scheme box-spline --edge-rule printed-2002\n"
        "  solidsubdiv analyze --regular --scheme interpolatory --tension 0.1");
    return [options](Session& session) { RunAnalyze(session, *options); };
}

}  // namespace SolidSubdiv::Cli

// SPDX-License-Identifier: Apache-2.0
// solidsubdiv analyze: eigenvalues of a scheme around the places of a mesh or places made to order, and what they say.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <charconv>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include <solidsubdiv/apps/cli/analyze_file.h>
#include <solidsubdiv/apps/cli/analyze_report.h>
#include <solidsubdiv/apps/cli/commands.h>
#include <solidsubdiv/apps/cli/files_help.h>
#include <solidsubdiv/kit/analysis/places.h>

namespace SolidSubdiv::Cli {

namespace {

struct AnalyzeOptions {
    std::string input;
    SchemeOptions scheme;
    bool regular = false, faces = false;
    std::string edge, valence, border;  ///< "5" or "3..8"
    std::size_t top = 10;
    std::string plot;
};

constexpr int kMost = 32;  // cells or faces of a place made to order

/// First and last of a range. @throws UsageError
std::pair<int, int> RangeOf(const std::string& option, const std::string& text, int least) {
    const auto number = [&](std::string_view part) {
        int n = 0;
        const auto read = std::from_chars(part.data(), part.data() + part.size(), n);
        if (read.ec != std::errc() || read.ptr != part.data() + part.size() || n < least || n > kMost) {
            throw UsageError(option + " is '" + text + "'; it is a number or a range such as 3..8, from " +
                             std::to_string(least) + " to " + std::to_string(kMost));
        }
        return n;
    };
    const std::size_t dots = text.find("..");
    if (dots == std::string::npos) return {number(text), number(text)};
    const int first = number(std::string_view(text).substr(0, dots)),
              last = number(std::string_view(text).substr(dots + 2));
    if (first > last) throw UsageError(option + " is '" + text + "': it starts above its end");
    return {first, last};
}

const char* RegularPlace(bool is_solid, bool is_tet_oct) {
    if (is_tet_oct) return is_solid ? "inner vertex of the octet truss" : "vertex of valence 6";
    return is_solid ? "inner vertex of a block of hexahedra" : "vertex of four quadrilaterals";
}

class AnalyzeCommand {
  public:
    AnalyzeCommand(const AnalyzeOptions& options, Session& session) : options_(options), session_(session) {}

    void Run() {
        const int n_places = !options_.input.empty() + options_.regular + options_.faces + !options_.edge.empty() +
                             !options_.valence.empty() + !options_.border.empty();
        if (n_places != 1) {
            throw UsageError(
                "analyze takes a FILE, --regular or --edge N, --face, --valence N or --border N: which place is "
                "meant?");
        }
        if (!options_.plot.empty()) plot_ = session_.outputs().Stage(options_.plot);
        json_["command"] = "analyze";
        std::string text = !options_.input.empty() ? File() : MadeToOrder();
        if (!options_.plot.empty()) text += Plot();
        json_["seconds"] = session_.Seconds();
        session_.Print(text);
        session_.Finish(json_);
    }

  private:
    void Announce(const Sdc::Scheme& scheme) {
        name_ = Sdc::NameOf(scheme);
        json_["scheme"] = name_;
        for (const auto& [name, value] : options_.scheme.values) json_["options"][name] = value;
    }

    std::string File() {
        FilePlaces found = AnalyzeFile(options_.input, options_.scheme, options_.top == 0, session_);
        Announce(found.scheme);
        json_.update(found.json);
        json_["kinds"] = PlacesJson(found.places);
        places_ = std::move(found.places);
        title_ = name_ + ": " + std::filesystem::path(options_.input).filename().string();
        return name_ + " on " + options_.input + "\n\n" + PlacesText(places_, options_.top) + found.left_out;
    }

    std::string MadeToOrder() {
        const Sdc::Scheme scheme = MakeScheme(options_.scheme, {}).scheme;
        Announce(scheme);
        std::vector<Analysis::Star> stars;
        std::vector<int> numbers;
        const auto add = [&](const std::string& group, const std::string& what, Analysis::Star star) {
            places_.push_back({group, what, 0, {}, {}});
            stars.push_back(std::move(star));
        };
        const auto add_range = [&](const std::string& option, const std::string& text, int least,
                                   const std::string& group, const std::string& one, const std::string& many,
                                   auto&& star_of) {
            const auto [first, last] = RangeOf(option, text, least);
            for (int n = first; n <= last; ++n) {
                numbers.push_back(n);
                add(group, Counted(n, one, many), star_of(n));
            }
        };
        const bool is_tet_oct = Sdc::Takes(scheme, Sdc::Split::TetOct);
        const std::string face = is_tet_oct ? "triangle" : "quadrilateral";
        try {
            if (options_.regular) {
                add("the regular lattice", RegularPlace(Analysis::IsSolid(scheme), is_tet_oct),
                    Analysis::RegularStar(scheme));
            } else if (options_.faces) {
                add("a vertex inside a face of two tets", "matched", Analysis::FaceStar(scheme, true));
                add("a vertex inside a face of two tets", "unmatched", Analysis::FaceStar(scheme, false));
            } else if (!options_.edge.empty()) {
                if (!Analysis::IsSolid(scheme)) {
                    throw UsageError("--edge is for schemes of solids; " + name_ + " is one of surfaces");
                }
                add_range("--edge", options_.edge, 3, "a vertex on an inner edge of", "cell", "cells",
                          [&](int n) { return Analysis::EdgeStar(scheme, n); });
            } else if (!options_.valence.empty()) {
                add_range("--valence", options_.valence, 3, "a vertex inside a surface of", face, face + "s",
                          [&](int n) { return Analysis::SurfaceStar(scheme, n, false); });
            } else {
                add_range("--border", options_.border, 1, "a vertex on the border of a surface of", face, face + "s",
                          [&](int n) { return Analysis::SurfaceStar(scheme, n, true); });
            }
        } catch (const InvalidInput& error) {
            throw UsageError(error.what());
        }
        session_.Stage("analyze");
        AnalyzeAll(places_, stars, scheme, session_.progress());
        session_.EndStage();
        title_ = name_ + ": " + places_[0].group + (places_.size() > 1 && !numbers.empty() ? " ..." : "");
        if (options_.regular) return Regular();
        Json list = PlacesJson(places_);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            list[i][options_.edge.empty() ? "faces" : "cells"] = numbers[i];
        json_[options_.edge.empty() ? "places" : "edges"] = std::move(list);
        return name_ + ", " + PlacesText(places_, 0);
    }

    /// All that is known of the one place.
    std::string Regular() {
        const Analysis::PlaceReport& report = places_[0].report;
        const std::vector<double> limit = Far::LimitMaskOf(report.matrix);
        const int n_neighbors = report.matrix.size() - 1;
        json_["place"] = places_[0].what;
        json_["neighbors"] = n_neighbors;
        json_.update(ReportJson(report));
        json_["limit_mask"] = limit;
        std::string text = name_ + ", regular lattice: a vertex and its " +
                           Counted(n_neighbors, "neighbor", "neighbors") + "\n  eigenvalues  " +
                           Analysis::SpectrumText(report.spectrum) + "\n  verdict      " + report.verdict.text + "\n";
        if (report.map) {
            text += "  Jacobian     of the characteristic map: smallest by largest " + Text(report.map->ratio()) + "\n";
        }
        if (!limit.empty() && limit[0] == 1) {
            text += "  limit mask   1: the vertex stays";
        } else if (!limit.empty()) {
            text += "  limit mask   " + Text(limit[0]);
            for (std::size_t i = 1; i < limit.size(); ++i) text += ", " + Text(limit[i]);
        }
        return text;
    }

    std::string Plot() {
        session_.Stage("plot");
        std::ofstream(plot_) << PlacesPlot(places_, options_.input.empty() ? 0 : options_.top, title_);
        session_.EndStage();
        json_["outputs"].push_back({{"what", "plot"}, {"file", options_.plot}});
        return "\nwrote " + options_.plot;
    }

    const AnalyzeOptions& options_;
    Session& session_;
    std::string name_, title_;
    std::filesystem::path plot_;
    std::vector<AnalyzedPlace> places_;
    Json json_;
};

}  // namespace

Work AddAnalyze(CLI::App& command) {
    const auto options = std::make_shared<AnalyzeOptions>();
    AnalyzeOptions& o = *options;
    command.add_option("FILE", o.input, "a mesh: all kinds of places in it")->option_text(" ");
    command.add_flag("--regular", o.regular, "the scheme's regular lattice, with its limit mask");
    command
        .add_option("--edge", o.edge,
                    "inner edges with this number of cells and a regular mesh around:\n"
                    "hexahedra, or what a split makes of tets")
        ->option_text("N|N..M");
    command.add_flag("--face", o.faces, "a face of two tets whose diagonals match, and one where they don't");
    command.add_option("--valence", o.valence, "vertices inside a surface with this number of faces")
        ->option_text("N|N..M");
    command.add_option("--border", o.border, "vertices on a surface's border with this number of faces")
        ->option_text("N|N..M");
    command
        .add_option("--top", o.top,
                    "of each type of place in a FILE list the N most frequent kinds;\ndefault 10; 0: all. JSON has all "
                    "of the 2000 that are analyzed,\nwith 0 of all there are")
        ->option_text("N");
#ifdef SOLIDSUBDIV_HAS_PICTURES
    command.add_option("--plot", o.plot, "draw the eigenvalues of the places listed as an SVG")
        ->option_text("FILE.svg");
#endif
    AddSchemeOptions(command, o.scheme);
    command.footer(
        "\nThe subdivision matrix says how a vertex and its neighbors move in one refinement. After the eigenvalue 1 "
        "the\n"
        "three largest (two on a surface) belong to the characteristic map, which the limit looks like from near by. "
        "They\n"
        "have to be real, positive and above all others, and the map's Jacobian (smallest by largest is shown) of one "
        "sign:\n"
        "  C2 spectrum  all that and 1/2, with the next at most 1/4: what C2 needs\n"
        "  C1           smooth\n"
        "  C1 uneven    the three differ: smooth, but lengths along some directions shrink faster than along others\n"
        "  C0           a crease or a peak in general\n"
        "  diverges\n"
        "docs/analysis.md has the tables of all schemes. Elements and places with the same matrix are one kind.\n\n" +
        SchemesHelp() + "\n\n" + ReadableFilesHelp() +
        "\n\nExamples:\n"
        "  solidsubdiv analyze lattice.vtu --scheme smooth-tet --top 3 --json lattice.json\n"
#ifdef SOLIDSUBDIV_HAS_PICTURES
        "  solidsubdiv analyze lattice.vtu --scheme box-spline --plot lattice.svg\n"
#endif
        "  solidsubdiv analyze --regular --scheme interpolatory --tension 0.1\n"
        "  solidsubdiv analyze --edge 3..16 --scheme mlca\n"
        "  solidsubdiv analyze --face --scheme interpolatory\n"
        "  solidsubdiv analyze --valence 3..12 --scheme loop");
    return [options](Session& session) { AnalyzeCommand(*options, session).Run(); };
}

}  // namespace SolidSubdiv::Cli

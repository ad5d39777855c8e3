// SPDX-License-Identifier: Apache-2.0
// The plot of `analyze`: a column of eigenvalues for each place.
#include <solidsubdiv/apps/cli/analyze_report.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#ifdef SOLIDSUBDIV_HAS_PICTURES
#include <solidsubdiv/kit/picture/plot.h>
#endif

namespace SolidSubdiv::Cli {

#ifdef SOLIDSUBDIV_HAS_PICTURES

namespace {

constexpr double kSmallest = 0.11;  // of moduli that are drawn: 1/8 is

/// A row of dots side by side for each eigenvalue, as many as its multiplicity.
void AddColumn(double x, const Analysis::Spectrum& spectrum, Picture::PlotSeries& series) {
    for (const Analysis::Eigenvalue& e : spectrum) {
        const double modulus = std::abs(e.value);
        if (modulus < kSmallest) continue;
        constexpr double kColumn = 0.72;
        const double step = std::min(0.13, kColumn / e.multiplicity);
        for (int i = 0; i < e.multiplicity; ++i) {
            series.points.push_back({x + step * (i - 0.5 * (e.multiplicity - 1)), modulus});
        }
    }
}

/// "vertices inside" as "vertices", "vertices of the border" as "border", "faces of the surface" as "surface faces".
std::string Heading(const std::string& group) {
    const std::size_t of = group.find(" of the ");
    if (of == std::string::npos) return group.substr(0, group.find(' '));
    return group.substr(of + 8) + (group.starts_with("faces") ? " faces" : "");
}

struct Look {
    Picture::Marker marker;
    int color;
};

Look LookOf(Analysis::Smoothness smoothness) {
    using Analysis::Smoothness;
    switch (smoothness) {
        case Smoothness::C2:
            return {Picture::Marker::Circle, 2};
        case Smoothness::C1:
            return {Picture::Marker::Circle, 0};
        case Smoothness::Uneven:
            return {Picture::Marker::Ring, 0};
        case Smoothness::C0:
            return {Picture::Marker::Triangle, 1};
        case Smoothness::Diverges:
            break;
    }
    return {Picture::Marker::Cross, 6};
}

}  // namespace

std::string PlacesPlot(const std::vector<AnalyzedPlace>& places, std::size_t n_listed, const std::string& title) {
    Picture::Plot plot{.title = title, .y_label = "modulus of eigenvalue"};
    std::map<Analysis::Smoothness, Picture::PlotSeries> series;  // the smoothest last, drawn over
    std::string group;
    std::size_t n_in_group = 0;
    double x = 0;
    for (const AnalyzedPlace& place : places) {
        if (place.group != group) {
            if (!group.empty()) x += 0.8;
            group = place.group;
            n_in_group = 0;
            if (place.count > 0) plot.headings.push_back({x + 1, Heading(group)});
        }
        if (n_listed > 0 && n_in_group == n_listed) continue;
        ++n_in_group;
        x += 1;
        if (n_in_group > 1 && !plot.headings.empty()) plot.headings.back().at += 0.5;
        const auto smoothness = place.report.verdict.smoothness;
        const Look look = LookOf(smoothness);
        Picture::PlotSeries& of_verdict = series[smoothness];
        of_verdict.name = Analysis::NameOf(smoothness);
        of_verdict.marker = look.marker;
        of_verdict.color = look.color;
        AddColumn(x, place.report.spectrum, of_verdict);
        const std::string count = place.count > 0 ? std::to_string(place.count) + " x " : "";
        plot.x_ticks.push_back({x, count + place.what});
    }
    for (auto it = series.rbegin(); it != series.rend(); ++it) plot.series.push_back(std::move(it->second));
    plot.is_logarithmic = true;
    plot.y_ticks = {{1, "1"}, {0.8, "0.8"}, {0.6, "0.6"}, {0.4, "0.4"}, {0.3, "0.3"}, {0.2, "0.2"}};
    plot.lines = {{1.0 / 2, "1/2"}, {1.0 / 4, "1/4"}, {1.0 / 8, "1/8"}};
    plot.width = std::max(560, 160 + static_cast<int>(44 * x));
    return Picture::ToSvg(plot);
}

#else

std::string PlacesPlot(const std::vector<AnalyzedPlace>&, std::size_t, const std::string&) {
    throw UsageError("--plot: this program was built without pictures");
}

#endif

}  // namespace SolidSubdiv::Cli

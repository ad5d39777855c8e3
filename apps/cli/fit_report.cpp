// SPDX-License-Identifier: Apache-2.0
// Numbers of a fit as JSON and text, its rounds as a plot, its shapes as a picture.
#include <solidsubdiv/apps/cli/fit_report.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#ifdef SOLIDSUBDIV_HAS_PICTURES
#include <solidsubdiv/kit/picture/cut.h>
#include <solidsubdiv/kit/picture/image.h>
#include <solidsubdiv/kit/picture/panels.h>
#include <solidsubdiv/kit/picture/plot.h>
#include <solidsubdiv/kit/picture/report_page.h>
#endif

namespace SolidSubdiv::Cli {

namespace {

Json DistanceJson(const Geometry::DistanceSummary& d, double diagonal) {
    Json json;
    const auto add = [&](const char* name, double value) {
        json[name] = value;
        json[std::string(name) + "_percent"] = 100 * value / diagonal;
    };
    add("rms", d.rms);
    add("mean", d.mean);
    add("p95", d.p95);
    add("p99", d.p99);
    add("max", d.most);
    json["points"] = d.n_points;
    json["left_out_percent"] = 100 * d.left_out;
    return json;
}

std::string Line(const char* name, const Geometry::DistanceSummary& d, double diagonal) {
    char text[200];
    const auto percent = [&](double x) { return 100 * x / diagonal; };
    std::snprintf(text, sizeof text, "\n%-20s %10.4f %% %10.4f %% %10.4f %% %10.4f %%", name, percent(d.rms),
                  percent(d.p95), percent(d.p99), percent(d.most));
    return text;
}

}  // namespace

Json FitJson(const FitSummary& s) {
    Json json;
    json["stopped"] = s.result.stopped;
    json["folded_corners"] = s.result.n_folded;
    json["surface_to_target"] = DistanceJson(s.result.to_target, s.diagonal);
    json["target_to_surface"] = DistanceJson(s.result.from_target, s.diagonal);
    json["normals_rms_degrees"] = s.result.normal_rms * 180 / std::numbers::pi;
    json["hausdorff"] = std::max(s.result.to_target.most, s.result.from_target.most);
    for (const Fit::Round& r : s.result.rounds) {
        json["rounds"].push_back({{"fairness", r.fairness},
                                  {"surface_rms", r.surface_rms},
                                  {"target_rms", r.target_rms},
                                  {"steps", r.steps},
                                  {"seconds", r.seconds}});
    }
    return json;
}

std::string FitText(const FitSummary& s, const Json& json) {
    std::string text = json["settings"]["model"].get<std::string>() + " of " +
                       Counted(json["control"]["points"].get<long long>(), "control point", "control points");
    if (json["control"]["faces"] == 0) {
        text += ", " + Counted(json["control"]["cells"].get<long long>(), "cell", "cells");
    } else {
        text += ", " + Counted(json["control"]["faces"].get<long long>(), "face", "faces");
    }
    const long long n_creases = json["control"].value("creases", 0LL);
    if (n_creases > 0) text += ", " + Counted(n_creases, "crease", "creases");
    text += "; " + Counted(static_cast<long long>(s.result.rounds.size()), "round", "rounds") + ", stopped by " +
            s.result.stopped;
    char head[120];
    std::snprintf(head, sizeof head, "\n%-20s %12s %12s %12s %12s", "of the diagonal", "RMS", "95 %", "99 %",
                  "largest");
    text += head + Line("limit to target", s.result.to_target, s.diagonal) +
            Line("target to limit", s.result.from_target, s.diagonal);
    if (s.result.to_target.left_out > 0) {
        char over[120];
        std::snprintf(over, sizeof over, "\n%.2f %% of the limit's area, over holes of the target, is not counted",
                      100 * s.result.to_target.left_out);
        text += over;
    }
    if (json.contains("solid")) {
        text += "\n" + Counted(json["solid"]["folded"].get<long long>(), "cell", "cells") + " of " +
                std::to_string(json["solid"]["cells"].get<long long>()) +
                " refined ones folded, least scaled Jacobian " +
                Text(json["solid"]["least_scaled_jacobian"].get<double>());
    }
    return text;
}

void WriteText(const std::filesystem::path& file, const std::string& text) {
    std::ofstream out(file, std::ios::binary);
    out << text;
    out.close();
    if (!out) throw IoError(file.string() + ": can't be written");
}

#ifdef SOLIDSUBDIV_HAS_PICTURES
std::string ConvergencePlot(const FitSummary& s) {
    Picture::Plot plot{.title = "distances, round by round",
                       .x_label = "round",
                       .y_label = "RMS in percent of the diagonal",
                       .is_logarithmic = true};
    Picture::PlotSeries there{.name = "limit to target", .is_line = true},
        back{.name = "target to limit", .is_line = true};
    for (std::size_t i = 0; i < s.result.rounds.size(); ++i) {
        const Fit::Round& r = s.result.rounds[i];
        constexpr double kLeast = 1e-12;  // what is exact has no logarithm
        there.points.push_back({static_cast<double>(i), std::max(kLeast, 100 * r.surface_rms / s.diagonal)});
        back.points.push_back({static_cast<double>(i), std::max(kLeast, 100 * r.target_rms / s.diagonal)});
    }
    plot.series = {there, back};
    return Picture::ToSvg(plot);
}

namespace {

const Fit::MovingSurface& LimitOf(const FitSummary& s) {
    return s.problem.fine.triangles.empty() ? s.problem.surface : s.problem.fine;
}

/// Distances of the limit's vertices from the target, in percent of its diagonal.
std::vector<double> PercentOf(const FitSummary& s) {
    std::vector<double> percent;
    for (double d : s.result.to_target_distances) percent.push_back(100 * d / s.diagonal);
    return percent;
}

/// Points as dashes, too short to look like any: the page draws surfaces and lines. At most so many, evenly.
struct Dashes {
    std::vector<double> positions{};
    std::vector<Index> lines{};

    Dashes(std::span<const double> points, double diagonal) {
        constexpr std::size_t kMost = 20'000;
        const std::size_t n = points.size() / 3, n_shown = std::min(n, kMost);
        const double half = 1e-3 * diagonal;
        for (std::size_t i = 0; i < n_shown; ++i) {
            const double* const p = &points[3 * (i * n / n_shown)];
            for (double side : {-half, half}) {
                lines.push_back(static_cast<Index>(positions.size() / 3));
                for (std::size_t c = 0; c < 3; ++c) positions.push_back(p[c] + side);
            }
        }
    }
};

/// Where colours end: all but a hundredth of the area is nearer.
double HighestPercent(const FitSummary& s) { return std::max(1e-9, 100 * s.result.to_target.p99 / s.diagonal); }

}  // namespace

std::vector<std::uint8_t> FitPicture(const FitSummary& s, const Io::Mesh& control, const Progress& progress) {
    const Fit::MovingSurface& limit = LimitOf(s);
    const std::vector<double> percent = PercentOf(s);
    const double high = HighestPercent(s);
    Picture::Scene target, lattice, error;
    if (s.problem.target.triangles.empty()) {
        target.Add(Picture::Points{.positions = s.problem.target.positions, .diameter = 3});
    } else {
        target.Add(Picture::Surface{.positions = s.problem.target.positions, .triangles = s.problem.target.triangles});
    }
    lattice.Add(Picture::Surface{.positions = s.result.vertices, .triangles = limit.triangles});
    const std::vector<Index> edges = Picture::ElementEdges(control.topology);
    lattice.Add(Picture::Lines{
        .positions = control.positions, .edges = edges, .color = Picture::Palette::kLattice, .width = 2});
    error.Add(Picture::Surface{
        .positions = s.result.vertices, .triangles = limit.triangles, .values = percent, .low = 0, .high = high});
    const Picture::ScenePanel panels[] = {
        {&target, "target"},
        {&lattice, "limit of the control mesh"},
        {&error, "distance from the target",
         Picture::ColorBar{.low = 0, .high = high, .title = "percent of the diagonal"}}};
    return Picture::EncodePng(Picture::RenderPanels(panels, {.azimuth = 20, .elevation = 14},
                                                    {.width = 640, .height = 600}, {.columns = 3}, progress));
}

std::string FitPage(const FitSummary& s, const Io::Mesh& control, const Json& json, const std::string& text,
                    const std::string& plot, const std::vector<std::uint8_t>& picture) {
    const std::vector<double> percent = PercentOf(s);
    const std::vector<Index> edges = Picture::ElementEdges(control.topology);
    Picture::Report report{
        .title = "fit of " + std::filesystem::path(json["target"]["file"].get<std::string>()).filename().string(),
        .summary = text.substr(0, text.find('\n')) + ".",
        .view = {.azimuth = 20, .elevation = 14}};
    const bool is_cloud = s.problem.target.triangles.empty();
    const Dashes dashes(is_cloud ? s.problem.target.positions : std::span<const double>(), s.diagonal);
    if (is_cloud) {
        report.meshes.push_back(
            {.name = "target", .positions = dashes.positions, .lines = dashes.lines, .color = Picture::Palette::kInk});
    } else {
        report.meshes.push_back({.name = "target",
                                 .positions = s.problem.target.positions,
                                 .triangles = s.problem.target.triangles,
                                 .is_shown = false});
    }
    report.meshes.push_back({.name = "limit",
                             .positions = s.result.vertices,
                             .triangles = LimitOf(s).triangles,
                             .values = percent,
                             .value_name = "distance from the target",
                             .unit = "% of the diagonal",
                             .low = 0,
                             .high = HighestPercent(s)});
    report.meshes.push_back(
        {.name = "control mesh", .positions = control.positions, .lines = edges, .color = Picture::Palette::kLattice});
    Picture::ReportSection distances{.title = "Distances"};
    for (const char* way : {"surface_to_target", "target_to_surface"}) {
        for (const char* what : {"rms", "p95", "p99", "max"}) {
            const Json& d = json["fit"][way];
            distances.rows.push_back(
                {std::string(way == std::string("surface_to_target") ? "limit to target, " : "target to limit, ") +
                     what,
                 Text(d[what].get<double>()) + " (" + Text(d[std::string(what) + "_percent"].get<double>()) + " %)"});
        }
    }
    distances.plots.push_back({"", plot});
    report.sections.push_back(std::move(distances));
    report.sections.push_back({.title = "Pictures", .pictures = {{"", picture}}});
    for (const char* part : {"target", "settings", "control", "solid", "seconds"}) {
        if (!json.contains(part)) continue;
        Picture::ReportSection section{.title = part};
        for (const auto& [name, value] : json[part].items()) {
            section.rows.push_back({name, value.is_string() ? value.get<std::string>() : value.dump()});
        }
        report.sections.push_back(std::move(section));
    }
    return Picture::ReportPage(report);
}
#endif

}  // namespace SolidSubdiv::Cli

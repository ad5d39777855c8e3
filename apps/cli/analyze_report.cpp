// SPDX-License-Identifier: Apache-2.0
// Tables and JSON of places.
#include <solidsubdiv/apps/cli/analyze_report.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

namespace SolidSubdiv::Cli {

namespace {

constexpr std::size_t kShown = 6;  // different eigenvalues in a line

std::string Padded(std::string text, std::size_t width) {
    text.resize(std::max(width, text.size()), ' ');
    return text;
}

/// The characteristic map's smallest Jacobian by its largest.
std::string RatioText(const Analysis::PlaceReport& report) {
    if (!report.map || report.map->is_defective) return "-";
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", report.map->ratio());
    return text;
}

/// "C1 uneven: 640, C0: 560"
std::string VerdictsText(const std::vector<const AnalyzedPlace*>& group) {
    std::map<Analysis::Smoothness, long long> counts;
    for (const AnalyzedPlace* place : group) counts[place->report.verdict.smoothness] += place->count;
    std::string text;
    for (auto it = counts.rbegin(); it != counts.rend(); ++it) {
        text += (text.empty() ? "" : ", ") + std::to_string(it->second) + " " + Analysis::NameOf(it->first);
    }
    return text;
}

std::string GroupText(const std::vector<const AnalyzedPlace*>& group, std::size_t n_listed) {
    const std::size_t n = n_listed == 0 ? group.size() : std::min(n_listed, group.size());
    const bool has_counts = group[0]->count > 0;
    long long total = 0, others = 0;
    std::size_t width = 5, count_width = 5;
    for (std::size_t i = 0; i < group.size(); ++i) {
        total += group[i]->count;
        if (i >= n) others += group[i]->count;
        if (i < n) width = std::max(width, group[i]->what.size());
        count_width = std::max(count_width, std::to_string(group[i]->count).size());
    }
    std::string text = group[0]->group;
    if (has_counts) {
        text += ": " + std::to_string(total) + " of " + Counted(static_cast<long long>(group.size()), "kind", "kinds") +
                "; " + VerdictsText(group);
    }
    const auto line = [&](const std::string& count, const std::string& what, const std::string& verdict,
                          const std::string& ratio, const std::string& rest) {
        text += "\n  ";
        if (has_counts) text += std::string(count_width - std::min(count_width, count.size()), ' ') + count + "  ";
        text += Padded(what, width) + "  " + Padded(verdict, 11) + "  " + Padded(ratio, 8) + "  " + rest;
    };
    line("count", "place", "verdict", "Jacobian", "eigenvalues");
    for (std::size_t i = 0; i < n; ++i) {
        const AnalyzedPlace& place = *group[i];
        line(std::to_string(place.count), place.what, Analysis::NameOf(place.report.verdict.smoothness),
             RatioText(place.report),
             Analysis::SpectrumText(place.report.spectrum, kShown) +
                 (place.example.empty() ? "" : "  (" + place.example + ")"));
    }
    if (n < group.size()) {
        line(std::to_string(others),
             "of " + Counted(static_cast<long long>(group.size() - n), "more kind", "more kinds") +
                 ", not listed; --top 0 lists all",
             "", "", "");
        text.erase(text.find_last_not_of(' ') + 1);
    }
    return text;
}

/// By group, in the order of their first places.
std::vector<std::vector<const AnalyzedPlace*>> Groups(const std::vector<AnalyzedPlace>& places) {
    std::vector<std::vector<const AnalyzedPlace*>> groups;
    for (const AnalyzedPlace& place : places) {
        if (groups.empty() || groups.back()[0]->group != place.group) groups.emplace_back();
        groups.back().push_back(&place);
    }
    return groups;
}

}  // namespace

void AnalyzeAll(std::vector<AnalyzedPlace>& places, const std::vector<Analysis::Star>& stars, const Sdc::Scheme& scheme,
                const Progress& progress) {
    const auto n = static_cast<Offset>(places.size());
    constexpr Offset kBlock = 64;  // between reports of progress
    for (Offset begin = 0; begin < n; begin += kBlock) {
        Report(progress, "analyze", static_cast<double>(begin) / static_cast<double>(n));
        Sdc::ParallelFor(std::min(kBlock, n - begin), 1, [&](Offset first, Offset last) {
            for (Offset i = begin + first; i < begin + last; ++i) {
                places[static_cast<std::size_t>(i)].report =
                    Analysis::AnalyzeStar(stars[static_cast<std::size_t>(i)], scheme);
            }
        });
    }
}

std::string PlacesText(const std::vector<AnalyzedPlace>& places, std::size_t n_listed) {
    std::string text;
    for (const auto& group : Groups(places)) text += (text.empty() ? "" : "\n\n") + GroupText(group, n_listed);
    return text;
}

Json ReportJson(const Analysis::PlaceReport& report) {
    Json eigenvalues = Json::array();
    for (const Analysis::Eigenvalue& e : report.spectrum) {
        eigenvalues.push_back(
            {{"real", e.value.real()}, {"imaginary", e.value.imag()}, {"multiplicity", e.multiplicity}});
    }
    Json json;
    json["points"] = report.matrix.size();
    json["eigenvalues"] = std::move(eigenvalues);
    if (report.map && !report.map->is_defective) {
        json["characteristic_map"] = {{"smallest_jacobian", report.map->smallest},
                                      {"largest_jacobian", report.map->largest},
                                      {"ratio", report.map->ratio()},
                                      {"samples", report.map->n_samples}};
    }
    json["smoothness"] = Analysis::NameOf(report.verdict.smoothness);
    json["verdict"] = report.verdict.text;
    return json;
}

Json PlacesJson(const std::vector<AnalyzedPlace>& places) {
    Json list = Json::array();
    for (const AnalyzedPlace& place : places) {
        Json json = {{"group", place.group}, {"place", place.what}};
        if (place.count > 0) json["count"] = place.count;
        if (!place.example.empty()) json["example"] = place.example;
        json.update(ReportJson(place.report));
        list.push_back(std::move(json));
    }
    return list;
}

}  // namespace SolidSubdiv::Cli

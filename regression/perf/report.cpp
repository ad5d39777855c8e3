// SPDX-License-Identifier: Apache-2.0
// Formats results.
#include "perf/report.h"

#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

namespace SolidSubdiv::Perf {

namespace {

template <class... Args>
std::string Print(const char* format, Args... args) {
    char text[256];
    std::snprintf(text, sizeof text, format, args...);
    return text;
}

std::string RateText(const Result& r) {
    if (r.candidate.work == 0)
        return r.candidate.moved_bytes > 0 ? Print("%.1f GB/s", r.candidate.moved_bytes / r.median_seconds / 1e9) : "";
    return Print("%.3g M %s/s", r.candidate.work / r.median_seconds / 1e6, r.candidate.unit.c_str());
}

std::string RatiosText(const Result& r) {
    std::string text;
    for (std::size_t i = 0; i < r.speed_ratios.size(); ++i) {
        text += Print("%s%.2f ", i == 0 ? "" : "; ", r.speed_ratios[i]) + r.candidate.peers[i];
    }
    return text;
}

}  // namespace

std::string TableOf(const Race& race) {
    std::vector<std::vector<std::string>> rows = {
        {race.name(), "threads", "median ms", "rate", "bytes kept a unit", "% of copy bandwidth", "times as fast as"}};
    for (const Result& r : race.results()) {
        const Candidate& c = r.candidate;
        const double ms = r.median_seconds * 1e3;
        rows.push_back({c.name, std::to_string(c.n_threads), Print(ms < 1 ? "%.4f" : "%.1f", ms), RateText(r),
                        c.kept_bytes > 0 ? Print("%.1f", c.kept_bytes / c.work) : "",
                        c.moved_bytes > 0 ? Print("%.0f", r.bandwidth_share * 100) : "", RatiosText(r)});
    }
    std::vector<std::size_t> widths(rows[0].size(), 3);
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string text;
    for (const std::string& note : race.notes) text += note + "\n";
    text += "\n";
    for (std::size_t k = 0; k < rows.size(); ++k) {
        for (std::size_t i = 0; i < rows[k].size(); ++i) {
            const std::string pad(widths[i] - rows[k][i].size(), ' ');
            const bool is_number = i > 0 && i != 6;
            text += "| " + (is_number ? pad + rows[k][i] : rows[k][i] + pad) + " ";
        }
        text += "|\n";
        if (k > 0) continue;
        for (std::size_t i = 0; i < widths.size(); ++i) {
            text += "|" + std::string(widths[i] + (i > 0 && i != 6 ? 1 : 2), '-') + (i > 0 && i != 6 ? ":" : "");
        }
        text += "|\n";
    }
    return text + "\n";
}

std::string TextOf(const MachineInfo& m) {
    return m.processor + "; " + std::to_string(m.n_processors) + " processors, " +
           Print("%.0f GiB", m.memory_bytes / (1 << 30)) + "; " + m.system + "; " + m.compiler +
           Print("; load %.1f at the start", m.load) + "\n";
}

std::string JsonOf(const MachineInfo& m, const std::vector<Race>& races, const RaceSettings& settings) {
    nlohmann::ordered_json json;
    json["machine"] = {{"processor", m.processor}, {"processors", m.n_processors}, {"memory_bytes", m.memory_bytes},
                       {"system", m.system},       {"compiler", m.compiler},       {"load_at_start", m.load}};
    json["quick"] = settings.is_quick;
    for (const Race& race : races) {
        nlohmann::ordered_json results;
        for (const Result& r : race.results()) {
            const Candidate& c = r.candidate;
            nlohmann::ordered_json row = {{"name", c.name},
                                          {"threads", c.n_threads},
                                          {"median_seconds", r.median_seconds},
                                          {"passed_seconds", r.passed},
                                          {"ran_seconds", r.ran}};
            if (c.work > 0) row.update({{"work", c.work}, {"unit", c.unit}});
            for (std::size_t i = 0; i < c.peers.size(); ++i) row["times_as_fast_as"][c.peers[i]] = r.speed_ratios[i];
            if (c.kept_bytes > 0) row["kept_bytes"] = c.kept_bytes;
            if (c.moved_bytes > 0) row.update({{"moved_bytes", c.moved_bytes}, {"bandwidth_share", r.bandwidth_share}});
            results.push_back(row);
        }
        json["races"].push_back({{"name", race.name()}, {"notes", race.notes}, {"results", results}});
    }
    return json.dump(2) + "\n";
}

}  // namespace SolidSubdiv::Perf

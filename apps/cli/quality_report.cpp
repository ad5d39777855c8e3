// SPDX-License-Identifier: Apache-2.0
// Numbers of folded cells, a histogram and the worst cells.
#include <solidsubdiv/apps/cli/quality_report.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <tuple>

#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/apps/cli/mesh_kinds.h>
#include <solidsubdiv/far/topology_refiner.h>

namespace SolidSubdiv::Cli {

namespace {

using Geometry::CellQuality;
using Geometry::MinimumSign;

constexpr std::size_t kWorstListed = 100;
constexpr std::size_t kWorstSaid = 5;
constexpr int kBins = 10;  // of scaled Jacobians from 0 to 1

/// The cells alone: faces, edges and vertices need not fit a split.
Io::Topology CellsOf(const Io::Topology& t) {
    Io::Topology cells;
    cells.n_vertices = t.n_vertices;
    cells.tets = t.tets;
    cells.octs = t.octs;
    cells.hexes = t.hexes;
    cells.wedges = t.wedges;
    cells.pyramids = t.pyramids;
    cells.polyhedron_offsets = t.polyhedron_offsets;
    cells.polyhedron_face_offsets = t.polyhedron_face_offsets;
    cells.polyhedron_vertices = t.polyhedron_vertices;
    return cells;
}

const char* NameOf(MinimumSign sign) {
    switch (sign) {
        case MinimumSign::Positive:
            return "positive";
        case MinimumSign::Negative:
            return "negative";
        case MinimumSign::Undecided:
            return "undecided";
    }
    return "";
}

/// A cell's kind and its number among those.
struct CellName {
    std::string kind;
    Offset number;
};
CellName NameOfCell(const Io::Topology& topology, Offset cell) {
    for (const KindCount& kind : KindCounts(topology)) {
        if (cell < kind.count) return {std::string(kind.singular), cell};
        cell -= kind.count;
    }
    return {"cell", cell};
}

Json DescribeCell(const Io::Topology& topology, const CellQuality& q, std::size_t cell) {
    const CellName name = NameOfCell(topology, static_cast<Offset>(cell));
    return {{"kind", name.kind},
            {"number", name.number},
            {"scaled_jacobian", q.scaled_jacobian},
            {"jacobian_minimum", q.jacobian_minimum},
            {"lower_bound", q.lower_bound},
            {"sign", NameOf(q.sign)},
            {"part", q.place.part},
            {"at", q.place.at}};
}

std::string PlaceText(const Json& cell) {
    std::string text = cell["kind"].get<std::string>() + " " + cell["number"].dump() + ": scaled Jacobian " +
                       Text(cell["scaled_jacobian"].get<double>()) + ", least Jacobian " +
                       Text(cell["jacobian_minimum"].get<double>());
    if (cell["sign"] == "undecided") text += " (sign undecided)";
    if (cell["kind"] != "hexahedron") return text;
    text += " at (";
    for (std::size_t k = 0; k < 3; ++k) text += (k > 0 ? ", " : "") + Text(cell["at"][k].get<double>());
    return text + ")";
}

std::string Line(const std::string& name, const std::string& value) {
    std::string line = "  " + name;
    line.resize(std::max<std::size_t>(20, line.size() + 1), ' ');
    return line + value + "\n";
}

}  // namespace

std::vector<CellQuality> MeasureCells(const Io::Mesh& mesh, const Progress& progress) {
    const Io::Topology cells = CellsOf(mesh.topology);
    if (cells.n_cells() == 0) throw InvalidInput("has no cells whose quality could be measured");
    const auto refiner =
        Far::TopologyRefiner::Create(cells, IsTetOct(cells) ? Sdc::Split::TetOct : Sdc::Split::Polyhedral);
    auto qualities = Geometry::MeasureQuality(refiner, 0, mesh.positions, {.progress = progress});
    // The polyhedral split numbers hexahedra first, a mesh tets and octahedra.
    if (refiner.is_polyhedral()) {
        const auto n_hexes = static_cast<std::ptrdiff_t>(cells.n_hexes());
        const auto n_before = static_cast<std::ptrdiff_t>(cells.n_tets() + cells.n_octs());
        std::rotate(qualities.begin(), qualities.begin() + n_hexes, qualities.begin() + n_hexes + n_before);
    }
    return qualities;
}

Json DescribeQuality(const Io::Mesh& mesh, const std::vector<CellQuality>& cells) {
    std::array<Offset, 3> n_of_sign{};
    std::array<Offset, kBins> bins{};
    Offset n_below = 0;
    double sum = 0;
    for (const CellQuality& q : cells) {
        ++n_of_sign[static_cast<std::size_t>(q.sign)];
        sum += q.scaled_jacobian;
        const int bin = std::min(kBins - 1, static_cast<int>(std::floor(q.scaled_jacobian * kBins)));
        ++(q.scaled_jacobian < 0 ? n_below : bins[static_cast<std::size_t>(std::max(0, bin))]);
    }
    std::vector<std::size_t> order(cells.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const std::size_t n_listed = std::min(kWorstListed, cells.size());
    // Folded cells, then those of the least scaled Jacobian.
    const auto rank = [&](std::size_t c) {
        return std::tuple(cells[c].sign != MinimumSign::Negative, cells[c].scaled_jacobian, c);
    };
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(n_listed), order.end(),
                      [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
    Json worst = Json::array();
    for (std::size_t i = 0; i < n_listed; ++i) worst.push_back(DescribeCell(mesh.topology, cells[order[i]], order[i]));
    const auto by = [](double CellQuality::*value) {
        return [value](const CellQuality& a, const CellQuality& b) { return a.*value < b.*value; };
    };
    const auto least = std::min_element(cells.begin(), cells.end(), by(&CellQuality::jacobian_minimum));
    const auto [low, high] = std::minmax_element(cells.begin(), cells.end(), by(&CellQuality::scaled_jacobian));
    return {{"cells", cells.size()},
            {"positive", n_of_sign[0]},
            {"folded", n_of_sign[1]},
            {"undecided", n_of_sign[2]},
            {"least_jacobian", DescribeCell(mesh.topology, *least, static_cast<std::size_t>(least - cells.begin()))},
            {"scaled_jacobian",
             {{"least", low->scaled_jacobian},
              {"mean", sum / static_cast<double>(cells.size())},
              {"greatest", high->scaled_jacobian},
              {"below_zero", n_below},
              {"tenths", bins}}},
            {"worst", worst}};
}

std::string QualityText(const Json& d) {
    const auto n_folded = d["folded"].get<Offset>(), n_undecided = d["undecided"].get<Offset>(),
               n_cells = d["cells"].get<Offset>();
    std::string proved = "proved positive in ";
    proved += n_folded + n_undecided == 0 ? "all cells" : d["positive"].dump() + " of " + std::to_string(n_cells);
    if (n_folded > 0) proved += ", negative in " + Counted(n_folded, "cell", "cells") + " (folded or inverted)";
    if (n_undecided > 0) proved += ", undecided in " + Counted(n_undecided, "cell", "cells");
    std::string text = Line("Jacobians", proved);
    text += Line("", "the least: " + PlaceText(d["least_jacobian"]));

    const Json& scaled = d["scaled_jacobian"];
    text +=
        Line("scaled Jacobians", Text(scaled["least"].get<double>()) + " to " + Text(scaled["greatest"].get<double>()) +
                                     ", mean " + Text(scaled["mean"].get<double>()));
    const auto bar = [&](const std::string& range, Offset count) {
        char share[40];
        std::snprintf(share, sizeof share, "%10lld  %5.1f %%  ", static_cast<long long>(count),
                      100.0 * static_cast<double>(count) / static_cast<double>(n_cells));
        std::string line = range + share;
        line += std::string(static_cast<std::size_t>(40 * count / n_cells), '#');
        line.erase(line.find_last_not_of(' ') + 1);
        text += Line("", line);
    };
    if (scaled["below_zero"].get<Offset>() > 0) bar("below 0   ", scaled["below_zero"].get<Offset>());
    for (int i = 0; i < kBins; ++i) {
        char range[24];
        std::snprintf(range, sizeof range, "%.1f to %.1f", 0.1 * i, 0.1 * (i + 1));
        bar(range, scaled["tenths"][static_cast<std::size_t>(i)].get<Offset>());
    }
    std::size_t n_said = 0;
    for (const Json& cell : d["worst"]) {
        if (n_said == kWorstSaid) break;
        text += Line(n_said++ == 0 ? "worst cells" : "", PlaceText(cell));
    }
    text.pop_back();
    return text;
}

Io::Mesh QualityMap(const Io::Mesh& mesh, const std::vector<CellQuality>& cells) {
    Io::Mesh map;
    map.topology = CellsOf(mesh.topology);
    map.positions = mesh.positions;
    map.point_data = mesh.point_data;
    for (const Io::Attribute& a : mesh.cell_data) {
        if (a.name == "jacobian_minimum" || a.name == "scaled_jacobian") continue;
        map.cell_data.push_back(a);
        map.cell_data.back().values.resize(cells.size() * static_cast<std::size_t>(a.width));
    }
    const auto add = [&](const char* name, double CellQuality::*value) {
        Io::Attribute& a = map.cell_data.emplace_back(Io::Attribute{name, 1, {}});
        for (const CellQuality& q : cells) a.values.push_back(q.*value);
    };
    add("jacobian_minimum", &CellQuality::jacobian_minimum);
    add("scaled_jacobian", &CellQuality::scaled_jacobian);
    return map;
}

}  // namespace SolidSubdiv::Cli

// SPDX-License-Identifier: Apache-2.0
// Figures of a mesh by plain sums, and figures that another process prints.
#include "vtk_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "python_script.h"

namespace SolidSubdiv::Validation {

namespace {

constexpr int kVtkVertex = 1, kVtkLine = 3, kVtkTriangle = 5, kVtkTet = 10, kVtkPolyhedron = 42;

double VolumeOfTet(const std::vector<double>& p, Index a, Index b, Index c, Index d) {
    const auto edge = [&](Index v, int i) {
        return p[3 * static_cast<std::size_t>(v) + i] - p[3 * static_cast<std::size_t>(a) + i];
    };
    return (edge(b, 0) * (edge(c, 1) * edge(d, 2) - edge(c, 2) * edge(d, 1)) -
            edge(b, 1) * (edge(c, 0) * edge(d, 2) - edge(c, 2) * edge(d, 0)) +
            edge(b, 2) * (edge(c, 0) * edge(d, 1) - edge(c, 1) * edge(d, 0))) /
           6;
}

/// Sums of cell arrays do not survive cutting cells (a value stands in each piece): those are compared by width only.
constexpr double kNoSum = std::numeric_limits<double>::infinity();

}  // namespace

GridSummary Expect(const Io::Mesh& mesh, bool keep_octahedra) {
    const Io::Topology& t = mesh.topology;
    GridSummary grid;
    grid.n_points = t.n_vertices;
    const auto count = [&](int type, std::int64_t n) {
        if (n > 0) grid.n_cells[type] += n;
    };
    count(kVtkTet, t.n_tets() + (keep_octahedra ? 0 : 4 * t.n_octs()));
    count(kVtkPolyhedron, keep_octahedra ? t.n_octs() : 0);
    count(kVtkTriangle, t.n_triangles());
    count(kVtkLine, t.n_edges());
    count(kVtkVertex, t.n_point_elements());

    std::vector<double> volumes;
    for (std::size_t i = 0; i < t.tets.size(); i += 4) {
        volumes.push_back(VolumeOfTet(mesh.positions, t.tets[i], t.tets[i + 1], t.tets[i + 2], t.tets[i + 3]));
    }
    for (std::size_t i = 0; i < t.octs.size(); i += 6) {
        const Index* v = &t.octs[i];
        const Index ring[] = {v[2], v[4], v[3], v[5]};
        std::array<double, 4> pieces;
        for (int k = 0; k < 4; ++k) pieces[k] = VolumeOfTet(mesh.positions, v[0], v[1], ring[k], ring[(k + 1) % 4]);
        if (keep_octahedra) {
            volumes.push_back(pieces[0] + pieces[1] + pieces[2] + pieces[3]);
        } else {
            volumes.insert(volumes.end(), pieces.begin(), pieces.end());
        }
    }
    for (const double volume : volumes) {
        grid.volume += volume;
        grid.n_inverted += !(volume > 0);
    }
    if (!volumes.empty()) grid.least_volume = *std::min_element(volumes.begin(), volumes.end());

    const auto add = [&](const char* place, const Io::Attribute& a, bool has_sum) {
        GridArray& array = grid.arrays[place + (" " + a.name)];
        array.width = a.width;
        for (const double x : a.values) array.sum += x;
        if (!has_sum) array.sum = kNoSum;
    };
    for (const Io::Attribute& a : mesh.point_data) add("point", a, true);
    for (const Io::Attribute& a : mesh.cell_data) add("cell", a, keep_octahedra || t.octs.empty());
    return grid;
}

std::vector<GridSummary> ReadByVtk(const std::filesystem::path& script,
                                   const std::vector<std::filesystem::path>& files) {
    const std::string output = RunVtkScript(script, files);
    std::vector<GridSummary> grids;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string keyword;
        words >> keyword;
        if (keyword == "file") grids.emplace_back();
        if (grids.empty()) continue;
        GridSummary& grid = grids.back();
        if (keyword == "points") {
            words >> grid.n_points;
        } else if (keyword == "cells") {
            int type = 0;
            words >> type;
            words >> grid.n_cells[type];
        } else if (keyword == "volume") {
            words >> grid.least_volume >> grid.volume >> grid.n_inverted;
        } else if (keyword == "array") {
            std::string place, name;
            GridArray array;
            words >> place >> array.width >> array.sum >> std::ws;
            std::getline(words, name);
            grid.arrays[place + " " + name] = array;
        }
        if (!words && !words.eof()) throw std::runtime_error("vtk_reader.py says '" + line + "'");
    }
    if (grids.size() != files.size()) throw std::runtime_error("vtk_reader.py says '" + output + "'");
    return grids;
}

void CompareGrids(const GridSummary& expected, const GridSummary& by_vtk, Findings& findings) {
    const auto compare_count = [&](std::int64_t ours, std::int64_t theirs, const std::string& what) {
        findings.Error(0, [] { return ""; });
        if (ours != theirs) {
            findings.Fault(std::to_string(theirs) + " " + what + " by VTK, " + std::to_string(ours) + " expected");
        }
    };
    compare_count(expected.n_points, by_vtk.n_points, "points");
    std::map<int, std::int64_t> types = expected.n_cells;
    types.insert(by_vtk.n_cells.begin(), by_vtk.n_cells.end());
    const auto count_of = [](const GridSummary& grid, int type) {
        const auto found = grid.n_cells.find(type);
        return found == grid.n_cells.end() ? 0 : found->second;
    };
    for (const auto& entry : types) {
        const int type = entry.first;
        compare_count(count_of(expected, type), count_of(by_vtk, type), "cells of type " + std::to_string(type));
    }

    const bool solid = count_of(expected, kVtkTet) + count_of(expected, kVtkPolyhedron) > 0;
    if (solid) {
        compare_count(expected.n_inverted, by_vtk.n_inverted, "cells of no positive volume");
        findings.Error(std::abs(by_vtk.volume - expected.volume) / std::abs(expected.volume),
                       [] { return "sum of volumes"; });
        findings.Error(std::abs(by_vtk.least_volume - expected.least_volume) / std::abs(expected.volume),
                       [] { return "least volume"; });
    }

    compare_count(static_cast<std::int64_t>(expected.arrays.size()), static_cast<std::int64_t>(by_vtk.arrays.size()),
                  "arrays");
    for (const auto& entry : expected.arrays) {
        const std::string& name = entry.first;
        const GridArray& ours = entry.second;
        const auto found = by_vtk.arrays.find(name);
        if (found == by_vtk.arrays.end()) {
            findings.Fault("no array '" + name + "' by VTK");
            continue;
        }
        compare_count(ours.width, found->second.width, "numbers a row of '" + name + "'");
        if (std::isinf(ours.sum)) continue;
        findings.Error(std::abs(found->second.sum - ours.sum) / std::max(1.0, std::abs(ours.sum)),
                       [&] { return "sum of '" + name + "'"; });
    }
}

}  // namespace SolidSubdiv::Validation

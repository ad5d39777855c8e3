// SPDX-License-Identifier: Apache-2.0
// What Voxel::Grids::Describe knows, for people and programs.
#include <solidsubdiv/apps/cli/voxel_report.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include <solidsubdiv/far/topology_refiner.h>

namespace SolidSubdiv::Cli {

namespace {

bool IsOfNumbers(const std::string& type) { return type == "float" || type == "double" || type == "int32"; }

}  // namespace

Json DescribeGrids(const Voxel::Grids& grids) {
    Json result = Json::array();
    for (const Voxel::GridInfo& info : grids.Describe()) {
        Json grid = {{"name", info.name},        {"type", info.type},
                     {"class", info.grid_class}, {"active_voxels", info.active_voxels},
                     {"bytes", info.bytes},      {"low", info.low},
                     {"high", info.high},        {"voxel_size", info.voxel_size},
                     {"origin", info.origin}};
        if (IsOfNumbers(info.type)) {
            grid["background"] = info.background;
            grid["least"] = info.least;
            grid["greatest"] = info.greatest;
        }
        Json metadata = Json::object();
        for (const auto& entry : info.metadata) metadata[entry.first] = entry.second;
        grid["metadata"] = std::move(metadata);
        result.push_back(std::move(grid));
    }
    return result;
}

std::string GridsText(const Json& described) {
    std::string text;
    for (const Json& grid : described) {
        const auto low = grid["low"].get<std::array<int, 3>>(), high = grid["high"].get<std::array<int, 3>>();
        const auto side = [&](std::size_t c) { return std::to_string(static_cast<long long>(high[c]) - low[c] + 1); };
        text += (text.empty() ? "" : "\n") + grid["name"].get<std::string>() + ": " + grid["type"].get<std::string>();
        if (grid["class"] != "unknown") text += ", " + grid["class"].get<std::string>();
        const auto n = grid["active_voxels"].get<Offset>();
        text += ", " + Counted(n, "active voxel", "active voxels");
        if (n > 0) text += " in " + side(0) + " x " + side(1) + " x " + side(2);
        if (grid.contains("least") && n > 0) {
            text += ", " + Text(grid["least"].get<double>()) + " to " + Text(grid["greatest"].get<double>());
        }
        text += ", " + Far::BytesText(grid["bytes"].get<Offset>());
    }
    return text;
}

std::string MetadataText(const Json& described) {
    std::string text;
    if (described.empty()) return text;
    for (const auto& entry : described[0]["metadata"].items()) {
        // OpenVDB's own, told otherwise or of the file.
        const std::string& key = entry.key();
        if (key == "name" || key == "class" || key.starts_with("file_") || key.starts_with("is_")) {
            continue;
        }
        const auto has_same = [&](const Json& grid) {
            return grid["metadata"].contains(key) && grid["metadata"][key] == entry.value();
        };
        if (!std::all_of(described.begin(), described.end(), has_same)) continue;
        text += (text.empty() ? "" : ", ") + key + " " + entry.value().get<std::string>();
    }
    return text;
}

}  // namespace SolidSubdiv::Cli

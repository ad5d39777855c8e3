// SPDX-License-Identifier: Apache-2.0
// Volumes and point clouds in words and numbers.
#include <solidsubdiv/apps/cli/target_report.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/kit/io/points.h>

namespace SolidSubdiv::Cli {

namespace {

constexpr std::size_t kLabelsListed = 10;

Json BoxJson(const Geometry::Box& box) { return {{"low", box.low}, {"high", box.high}}; }

std::string BoxText(const Json& box) {
    std::string text;
    for (std::size_t k = 0; k < 3; ++k) {
        text += (k > 0 ? ",  " : "") + Text(box["low"][k].get<double>()) + " to " + Text(box["high"][k].get<double>());
    }
    return text;
}

std::string Joined(const Json& numbers, const std::string& between) {
    std::string text;
    for (const Json& number : numbers) text += (text.empty() ? "" : between) + Text(number.get<double>());
    return text;
}

}  // namespace

Json DescribeVolume(const Geometry::Volume& volume) {
    const auto [least, greatest] = std::minmax_element(volume.values.begin(), volume.values.end());
    Json result = {{"dims", volume.dims},
                   {"voxels", volume.n_voxels()},
                   {"spacing", volume.Spacing()},
                   {"voxel_to_world", volume.voxel_to_world},
                   {"bounding_box", BoxJson(Geometry::BoundingBox(volume))},
                   {"least", *least},
                   {"greatest", *greatest}};
    std::vector<double> labels = Geometry::LabelsOf(volume);
    if (labels.empty()) return result;
    const std::size_t n_labels = labels.size();
    labels.resize(std::min(n_labels, kLabelsListed));
    result["labels"] = {{"count", n_labels}, {"first", labels}};
    return result;
}

std::string VolumeText(const Json& description) {
    std::string text = "  voxels            " + Joined(description["dims"], " x ") + "\n  spacing           " +
                       Joined(description["spacing"], ", ") + "\n  bounding box      " +
                       BoxText(description["bounding_box"]) + " (centres of voxels)\n  values            " +
                       Text(description["least"].get<double>()) + " to " + Text(description["greatest"].get<double>());
    if (!description.contains("labels")) return text;
    const Json& labels = description["labels"];
    const auto n = labels["count"].get<Offset>();
    text +=
        "\n  labels            " + Counted(n, "whole number", "whole numbers") + ": " + Joined(labels["first"], ", ");
    return text + (static_cast<Offset>(labels["first"].size()) < n ? ", ..." : "");
}

bool HoldsPointsAlone(const std::string& file) {
    const Io::PointFormat* const format = Io::FindPointFormat(file);
    if (!format) return false;
    return format->extension != ".ply" || Io::ReadMesh(file).topology.n_elements() == 0;
}

Json DescribePoints(const Geometry::PointCloud& cloud) {
    return {{"points", cloud.n_points()},
            {"bounding_box", BoxJson(Geometry::BoundingBox(cloud.positions))},
            {"normals", cloud.has_normals()}};
}

std::string PointsText(const Json& description) {
    return "  points            " + description["points"].dump() + "\n  bounding box      " +
           BoxText(description["bounding_box"]) + "\n  normals           " +
           (description["normals"].get<bool>() ? "yes" : "no");
}

}  // namespace SolidSubdiv::Cli

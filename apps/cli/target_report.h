// SPDX-License-Identifier: Apache-2.0
// What `info` says of volumes and point clouds, as JSON and as text made from the JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/kit/geometry/point_cloud.h>
#include <solidsubdiv/kit/geometry/volume.h>

namespace SolidSubdiv::Cli {

using Json = nlohmann::ordered_json;

/// Size, place and range of values; of whole numbers how many there are, and the first ten.
Json DescribeVolume(const Geometry::Volume& volume);
std::string VolumeText(const Json& description);

/// Whether a file is one of points: a format of them, and of PLY files one without faces, edges and cells. A PLY file
/// is read for it. @throws IoError
bool HoldsPointsAlone(const std::string& file);

Json DescribePoints(const Geometry::PointCloud& cloud);
std::string PointsText(const Json& description);

}  // namespace SolidSubdiv::Cli

// SPDX-License-Identifier: Apache-2.0
// The readers of points on bytes in memory: what the files' readers, the tests and the fuzzers call.
#pragma once

#include <string>
#include <string_view>

#include <solidsubdiv/kit/geometry/point_cloud.h>

namespace SolidSubdiv::Io::Internal {

Geometry::PointCloud ParseXyz(std::string_view bytes, const std::string& file);
Geometry::PointCloud ParsePcd(std::string_view bytes, const std::string& file);
Geometry::PointCloud ParsePlyPoints(std::string_view bytes, const std::string& file);

}  // namespace SolidSubdiv::Io::Internal

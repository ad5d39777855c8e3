// SPDX-License-Identifier: Apache-2.0
// Files of points, chosen by the file name's extension, and the one visible list of their formats.
//
//     Geometry::PointCloud scan = Io::ReadPoints("scan.pcd");
//
//     .xyz .pts .txt   a point a line: x y z, or x y z nx ny nz. Lines may begin with p; # begins a comment; a first
//                      line may hold the number of points. Intensities and colours (4 or 7 columns; six of which the
//                      last three are integers from 0 to 255) are left out with a note.
//     .pcd             the Point Cloud Library's, of versions 0.6 and 0.7: text, binary, compressed. Points without a
//                      place (not finite: the format's mark for them) are left out with a note, and so is a missing
//                      normal of a point: it becomes the zero vector.
//     .ply             the vertices, with the properties nx, ny, nz as normals; faces are left out with a note
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include <solidsubdiv/kit/geometry/point_cloud.h>

namespace SolidSubdiv::Io {

struct PointFormat {
    std::string_view extension;  ///< lower case, with the dot
    std::string_view name;
    Geometry::PointCloud (*read)(const std::filesystem::path&);
};

/// The list; a new format is a file in formats/ and a line in points.cpp.
std::span<const PointFormat> PointFormats();

/// The format of a file name, or null if it is none of points.
const PointFormat* FindPointFormat(const std::filesystem::path& path);

/// Reads points. What comes back is consistent: at least one point, every number finite, a normal for each point or
/// for none. @throws IoError with one line: the file, what is wrong, where.
Geometry::PointCloud ReadPoints(const std::filesystem::path& path);

}  // namespace SolidSubdiv::Io

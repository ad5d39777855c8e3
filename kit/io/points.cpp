// SPDX-License-Identifier: Apache-2.0
// The list of formats of points, and reading through it.
#include <solidsubdiv/kit/io/points.h>

#include <array>

#include <solidsubdiv/kit/io/internal/format_choice.h>
#include <solidsubdiv/kit/io/internal/point_readers.h>

namespace SolidSubdiv::Io {

namespace {

template <Geometry::PointCloud (*Parse)(std::string_view, const std::string&)>
Geometry::PointCloud ReadOneFile(const std::filesystem::path& path) {
    return Parse(Internal::ReadWholeFile(path), Internal::NameOf(path));
}

constexpr std::array kFormats = {
    PointFormat{".xyz", "points as text", ReadOneFile<Internal::ParseXyz>},
    PointFormat{".pts", "points as text", ReadOneFile<Internal::ParseXyz>},
    PointFormat{".txt", "points as text", ReadOneFile<Internal::ParseXyz>},
    PointFormat{".pcd", "PCD", ReadOneFile<Internal::ParsePcd>},
    PointFormat{".ply", "PLY", ReadOneFile<Internal::ParsePlyPoints>},
};

}  // namespace

std::span<const PointFormat> PointFormats() { return kFormats; }

const PointFormat* FindPointFormat(const std::filesystem::path& path) {
    return Internal::FindFormat(PointFormats(), path);
}

Geometry::PointCloud ReadPoints(const std::filesystem::path& path) {
    Geometry::PointCloud cloud = Internal::ReadWithinMemory(
        path, "thin the points out", [&] { return Internal::ChooseFormat(PointFormats(), path).read(path); });
    if (cloud.positions.empty()) Internal::Fail(Internal::NameOf(path), "holds no points");
    return cloud;
}

}  // namespace SolidSubdiv::Io

// SPDX-License-Identifier: Apache-2.0
// Grids of voxels told in words, in JSON and in a picture. Only where OpenVDB is there.
#pragma once

#include <filesystem>
#include <string>

#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/apps/voxel/grids.h>

namespace SolidSubdiv::Cli {

/// An array, one object a grid.
Json DescribeGrids(const Voxel::Grids& grids);
/// A line for each grid that was described.
std::string GridsText(const Json& described);
/// The metadata of the program's own that all grids have: one line, or none.
std::string MetadataText(const Json& described);

/// A plane of voxels across what is active in a grid.
struct SlicePlace {
    std::size_t axis = 2;   ///< x, y or z
    double fraction = 0.5;  ///< along it, 0 to 1
};
/// "y:0.25". @throws UsageError
SlicePlace SlicePlaceOf(const std::string& text);

/// The surface of the first of these grids, and slices of all of them. @throws InvalidInput where there is no such grid
/// or nothing is active in one
void WriteGridPicture(const std::filesystem::path& path, const Voxel::Grids& grids,
                      const std::vector<std::string>& names, const SlicePlace& place, Session& session);

}  // namespace SolidSubdiv::Cli

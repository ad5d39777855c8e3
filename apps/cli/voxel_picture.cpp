// SPDX-License-Identifier: Apache-2.0
// Arrays from grids of voxels go into a picture.
#include <solidsubdiv/apps/cli/voxel_report.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#ifdef SOLIDSUBDIV_HAS_PICTURES
#include <solidsubdiv/kit/picture/grid_picture.h>
#endif

namespace SolidSubdiv::Cli {

#ifdef SOLIDSUBDIV_HAS_PICTURES
namespace {

/// @param caption says where it is
Voxel::GridSurface SurfaceOf(const Voxel::Grids& grids, const Voxel::GridInfo& info, std::string& caption) {
    const bool is_level_set = info.grid_class == "level set";
    if (is_level_set || info.grid_class == "fog volume") {
        caption = "where '" + info.name + "' is " + (is_level_set ? "0" : "0.5");
        return grids.Surface(info.name, is_level_set ? 0 : 0.5);
    }
    caption = "where '" + info.name + "' is active";
    return grids.ActiveSurface(info.name);
}

std::vector<Index> Triangles(const Voxel::GridSurface& surface) {
    std::vector<Index> triangles = surface.triangles;
    for (std::size_t q = 0; q + 4 <= surface.quads.size(); q += 4) {
        const Index* quad = &surface.quads[q];
        triangles.insert(triangles.end(), {quad[0], quad[1], quad[2], quad[0], quad[2], quad[3]});
    }
    return triangles;
}

/// Active values of the plane of voxels at z in the middle; the length of vectors. Others are NaN.
std::vector<double> SliceValues(const Voxel::Grids& grids, const Voxel::GridInfo& info, const std::array<int, 3>& low,
                                const std::array<int, 3>& high) {
    std::vector<double> values;
    if (info.type.starts_with("vec3")) {
        const std::vector<double> vectors = grids.Vectors(info.name, low, high);
        for (std::size_t i = 0; i < vectors.size(); i += 3) {
            values.push_back(std::hypot(vectors[i], vectors[i + 1], vectors[i + 2]));
        }
    } else {
        values = grids.Values(info.name, low, high);
    }
    const std::vector<bool> is_active = grids.IsActive(info.name, low, high);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!is_active[i]) values[i] = std::numeric_limits<double>::quiet_NaN();
    }
    return values;
}

Picture::VoxelSlice SliceOf(const Voxel::Grids& grids, const Voxel::GridInfo& info, std::vector<double>& values) {
    if (info.active_voxels == 0) throw InvalidInput("no voxel of grid '" + info.name + "' is active: nothing to draw");
    std::array<int, 3> low = info.low, high = info.high;
    low[2] = high[2] = static_cast<int>((static_cast<long long>(low[2]) + high[2]) / 2);
    values = SliceValues(grids, info, low, high);
    const auto corner = grids.ToWorld(info.name, low);
    const auto u = grids.ToWorld(info.name, {low[0] + 1, low[1], low[2]});
    const auto v = grids.ToWorld(info.name, {low[0], low[1] + 1, low[2]});
    Picture::VoxelSlice slice{.corner = corner,
                              .step_u = {u[0] - corner[0], u[1] - corner[1], u[2] - corner[2]},
                              .step_v = {v[0] - corner[0], v[1] - corner[1], v[2] - corner[2]},
                              .n_u = high[0] - low[0] + 1,
                              .n_v = high[1] - low[1] + 1,
                              .values = values,
                              .title = info.type.starts_with("vec3") ? "length" : "",
                              .caption = "'" + info.name + "', sliced"};
    if (info.grid_class == "level set") {  // white at the surface
        slice.map = Picture::ColorMap::Diverging;
        slice.high = std::max(std::abs(info.least), std::abs(info.greatest));
        slice.low = -slice.high;
        slice.title = "distance";
    } else if (info.grid_class == "fog volume") {
        slice.high = 1;
        slice.title = "filled part";
    }
    return slice;
}

}  // namespace

void WriteGridPicture(const std::filesystem::path& path, const Voxel::Grids& grids,
                      const std::vector<std::string>& names, Session& session) {
    const std::vector<Voxel::GridInfo> infos = grids.Describe();
    Voxel::GridSurface surface;
    std::string caption;
    std::vector<Picture::VoxelSlice> slices;
    std::vector<std::vector<double>> values(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto info =
            std::find_if(infos.begin(), infos.end(), [&](const auto& grid) { return grid.name == names[i]; });
        if (info == infos.end()) {
            std::string known;
            for (const Voxel::GridInfo& grid : infos) known += (known.empty() ? "" : ", ") + grid.name;
            throw InvalidInput("there is no grid '" + names[i] + "'; there " +
                               (known.empty() ? "is none" : "are " + known));
        }
        slices.push_back(SliceOf(grids, *info, values[i]));
        if (i == 0) surface = SurfaceOf(grids, *info, caption);
    }
    const std::vector<Index> triangles = Triangles(surface);
    Picture::WritePng(path, Picture::GridPicture({.positions = surface.positions, .triangles = triangles}, slices,
                                                 {.caption = caption}, session.progress()));
}
#else
void WriteGridPicture(const std::filesystem::path&, const Voxel::Grids&, const std::vector<std::string>&, Session&) {}
#endif

}  // namespace SolidSubdiv::Cli

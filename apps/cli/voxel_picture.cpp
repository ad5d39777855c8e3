// SPDX-License-Identifier: Apache-2.0
// Arrays from grids of voxels go into a picture.
#include <solidsubdiv/apps/cli/voxel_report.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#ifdef SOLIDSUBDIV_HAS_PICTURES
#include <solidsubdiv/kit/picture/grid_picture.h>
#endif

namespace SolidSubdiv::Cli {

SlicePlace SlicePlaceOf(const std::string& text) {
    SlicePlace place;
    const std::size_t axis = std::string_view("xyz").find(text.front());
    const char* const end = text.data() + text.size();
    const char* const number = text.data() + std::min<std::size_t>(2, text.size());
    const auto [last, error] = std::from_chars(number, end, place.fraction);
    const bool is_fraction = error == std::errc() && last == end && place.fraction >= 0 && place.fraction <= 1;
    if (axis > 2 || text[1] != ':' || !is_fraction) {
        throw UsageError("--slice '" + text + "': is not x, y or z with a number from 0 to 1, such as y:0.25");
    }
    place.axis = axis;
    return place;
}

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

/// Active values of a plane of voxels; the length of vectors. Others are NaN.
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

/// From where a slice is seen well, and as much of the surface as can be.
Picture::View ViewOf(const SlicePlace& place) {
    constexpr double kAzimuth[] = {70, 20, 20}, kElevation[] = {14, 62, 14};
    return {.azimuth = kAzimuth[place.axis], .elevation = kElevation[place.axis]};
}

Picture::VoxelSlice SliceOf(const Voxel::Grids& grids, const Voxel::GridInfo& info, const SlicePlace& place,
                            std::vector<double>& values) {
    if (info.active_voxels == 0) throw InvalidInput("no voxel of grid '" + info.name + "' is active: nothing to draw");
    std::array<int, 3> low = info.low, high = info.high;
    const double from = low[place.axis], to = high[place.axis];
    low[place.axis] = high[place.axis] = static_cast<int>(std::floor(from + place.fraction * (to - from)));
    values = SliceValues(grids, info, low, high);
    const std::size_t u_axis = place.axis == 0 ? 1 : 0, v_axis = place.axis == 2 ? 1 : 2;
    const auto next = [&](std::size_t axis) {
        std::array<int, 3> voxel = low;
        ++voxel[axis];
        return grids.ToWorld(info.name, voxel);
    };
    const auto corner = grids.ToWorld(info.name, low), u = next(u_axis), v = next(v_axis);
    Picture::VoxelSlice slice{.corner = corner,
                              .step_u = {u[0] - corner[0], u[1] - corner[1], u[2] - corner[2]},
                              .step_v = {v[0] - corner[0], v[1] - corner[1], v[2] - corner[2]},
                              .n_u = high[u_axis] - low[u_axis] + 1,
                              .n_v = high[v_axis] - low[v_axis] + 1,
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
                      const std::vector<std::string>& names, const SlicePlace& place, Session& session) {
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
        slices.push_back(SliceOf(grids, *info, place, values[i]));
        if (i == 0) surface = SurfaceOf(grids, *info, caption);
    }
    const std::vector<Index> triangles = Triangles(surface);
    Picture::WritePng(path, Picture::GridPicture({.positions = surface.positions, .triangles = triangles}, slices,
                                                 {.view = ViewOf(place), .caption = caption}, session.progress()));
}
#else
void WriteGridPicture(const std::filesystem::path&, const Voxel::Grids&, const std::vector<std::string>&,
                      const SlicePlace&, Session&) {}
#endif

}  // namespace SolidSubdiv::Cli

// SPDX-License-Identifier: Apache-2.0
// A scene of the surface, and one a slice; see grid_picture.h.
#include <solidsubdiv/kit/picture/grid_picture.h>
#include <solidsubdiv/sdc/errors.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace SolidSubdiv::Picture {
namespace {

using Vector = std::array<double, 3>;

Vector Cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double Dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// From the scene to the viewer.
Vector ToViewer(const View& view) {
    const double a = view.azimuth * std::numbers::pi / 180, e = view.elevation * std::numbers::pi / 180;
    const double side = std::sin(a) * std::cos(e), back = std::cos(a) * std::cos(e);
    return view.up == UpAxis::Y ? Vector{side, std::sin(e), back} : Vector{side, -back, std::sin(e)};
}

/// Triangles all of whose corners the slice's plane leaves on the far side, a quarter of a voxel away: what lies in the
/// plane would be seen through the squares.
std::vector<Index> TrianglesBehind(const Surface& surface, const VoxelSlice& slice, const View& view) {
    Vector normal = Cross(slice.step_u, slice.step_v);
    if (Dot(normal, ToViewer(view)) < 0) normal = {-normal[0], -normal[1], -normal[2]};
    const double step = std::sqrt(Dot(slice.step_u, slice.step_u)), length = std::sqrt(Dot(normal, normal));
    const double height = Dot(normal, slice.corner) - 0.25 * step * length;
    const auto is_behind = [&](Index v) {
        const double* p = &surface.positions[3 * static_cast<std::size_t>(v)];
        return Dot(normal, {p[0], p[1], p[2]}) < height;
    };
    std::vector<Index> behind;
    for (std::size_t t = 0; t + 3 <= surface.triangles.size(); t += 3) {
        const auto triangle = surface.triangles.subspan(t, 3);
        if (std::all_of(triangle.begin(), triangle.end(), is_behind)) {
            behind.insert(behind.end(), triangle.begin(), triangle.end());
        }
    }
    return behind;
}

/// Two triangles a voxel that has a value.
struct Squares {
    std::vector<double> positions, values;
    std::vector<Index> triangles;
};

Squares MakeSquares(const VoxelSlice& slice) {
    constexpr int kMost = 1000;  // more than panels have pixels
    const int step = 1 + (std::max(slice.n_u, slice.n_v) - 1) / kMost;
    Squares squares;
    for (int u = 0; u < slice.n_u; u += step) {
        for (int v = 0; v < slice.n_v; v += step) {
            const double value = slice.values[static_cast<std::size_t>(u) * static_cast<std::size_t>(slice.n_v) +
                                              static_cast<std::size_t>(v)];
            if (std::isnan(value)) continue;
            const auto first = static_cast<Index>(squares.values.size());
            for (const auto& [du, dv] : {std::array{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
                for (std::size_t c = 0; c < 3; ++c) {
                    squares.positions.push_back(slice.corner[c] + (u + step * du) * slice.step_u[c] +
                                                (v + step * dv) * slice.step_v[c]);
                }
                squares.values.push_back(value);
            }
            squares.triangles.insert(squares.triangles.end(),
                                     {first, first + 1, first + 2, first, first + 2, first + 3});
        }
    }
    return squares;
}

}  // namespace

Image GridPicture(const Surface& surface, std::span<const VoxelSlice> slices, const GridPictureOptions& options,
                  const Progress& progress) {
    std::vector<Scene> scenes;
    std::vector<ScenePanel> panels;
    scenes.reserve(slices.size() + 1);  // panels point to them
    if (!surface.triangles.empty()) {
        scenes.emplace_back().Add(surface);
        panels.push_back({&scenes.back(), options.caption, {}});
    }
    for (const VoxelSlice& slice : slices) {
        if (slice.n_u < 1 || slice.n_v < 1 ||
            slice.values.size() != static_cast<std::size_t>(slice.n_u) * static_cast<std::size_t>(slice.n_v)) {
            throw InvalidInput("picture: a slice of " + std::to_string(slice.n_u) + " x " + std::to_string(slice.n_v) +
                               " voxels has " + std::to_string(slice.values.size()) + " numbers");
        }
        Scene& scene = scenes.emplace_back();
        const std::vector<Index> behind = TrianglesBehind(surface, slice, options.view);
        if (!behind.empty()) {
            scene.Add(Surface{.positions = surface.positions, .triangles = behind, .material = surface.material});
        }
        const Squares squares = MakeSquares(slice);
        std::optional<ColorBar> bar;
        if (!squares.triangles.empty()) {
            double low = slice.low, high = slice.high;
            if (low == high) {
                const auto ends = std::minmax_element(squares.values.begin(), squares.values.end());
                low = *ends.first, high = *ends.second;
            }
            scene.Add(Surface{.positions = squares.positions,
                              .triangles = squares.triangles,
                              .material = {.smooth = false, .gloss = 0},
                              .values = squares.values,
                              .map = slice.map,
                              .low = low,
                              .high = high});
            bar = ColorBar{.map = slice.map, .low = low, .high = high, .title = slice.title};
        }
        panels.push_back({&scene, slice.caption, bar});
    }
    if (panels.empty()) throw InvalidInput("picture: there is neither a surface nor a slice to show");
    PanelOptions arranged = options.panels;
    if (arranged.columns == 0) arranged.columns = panels.size() == 4 ? 2 : 3;
    return RenderPanels(panels, options.view, options.render, arranged, progress);
}

}  // namespace SolidSubdiv::Picture

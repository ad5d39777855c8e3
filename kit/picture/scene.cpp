// SPDX-License-Identifier: Apache-2.0
// Checks and copies what is added to a scene; see scene.h.
#include <solidsubdiv/kit/picture/internal/scene_data.h>
#include <solidsubdiv/kit/picture/scene.h>
#include <solidsubdiv/sdc/errors.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace SolidSubdiv::Picture {
namespace {

template <class... Parts>
[[noreturn]] void Refuse(const Parts&... parts) {
    std::ostringstream text;
    text << "picture: ";
    (text << ... << parts);
    throw InvalidInput(text.str());
}

std::vector<Internal::Vec3d> CheckedPositions(std::span<const double> positions) {
    if (positions.size() % 3 != 0) Refuse("positions: ", positions.size(), " numbers are not triples");
    std::vector<Internal::Vec3d> points(positions.size() / 3);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        // Squares of coordinates must not overflow either.
        if (!(std::abs(positions[i]) < 1e150)) {
            Refuse("point ", i / 3, ", coordinate ", i % 3, ": ", positions[i], " is not finite or too large");
        }
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i] = {positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]};
    }
    return points;
}

std::vector<Index> CheckedIndices(std::span<const Index> indices, std::size_t width, const char* element,
                                  std::size_t n_points) {
    if (indices.size() % width != 0) Refuse(element, "s: ", indices.size(), " indices are not rows of ", width);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] < 0 || static_cast<std::size_t>(indices[i]) >= n_points) {
            Refuse(element, " ", i / width, " names point ", indices[i], " of ", n_points);
        }
    }
    return {indices.begin(), indices.end()};
}

void CheckPixels(const char* what, double pixels) {
    if (!(pixels > 0 && pixels <= 1000)) Refuse(what, ": ", pixels, " pixels; must be over 0, at most 1000");
}

/// Places of the values on the colour map.
std::vector<float> Normalized(const Surface& surface) {
    double low = surface.low, high = surface.high;
    if (!std::isfinite(low) || !std::isfinite(high)) Refuse("range of values: ", low, " to ", high, " is not finite");
    if (low == high) {
        low = HUGE_VAL;
        high = -HUGE_VAL;
        for (double x : surface.values) {
            if (std::isfinite(x)) low = std::min(low, x), high = std::max(high, x);
        }
    }
    std::vector<float> places(surface.values.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double x = surface.values[i];
        places[i] = !std::isfinite(x) ? NAN : high == low ? 0.5f : static_cast<float>((x - low) / (high - low));
    }
    return places;
}

}  // namespace

Scene::Scene() : data_(std::make_unique<Internal::SceneData>()) {}
Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

Scene& Scene::Add(const Surface& surface) {
    auto positions = CheckedPositions(surface.positions);
    auto triangles = CheckedIndices(surface.triangles, 3, "triangle", positions.size());
    const std::size_t n_triangles = triangles.size() / 3;
    if (!surface.triangle_colors.empty() && surface.triangle_colors.size() != n_triangles) {
        Refuse("triangle_colors: ", surface.triangle_colors.size(), " for ", n_triangles, " triangles");
    }
    if (!surface.values.empty() && surface.values.size() != positions.size()) {
        Refuse("values: ", surface.values.size(), " for ", positions.size(), " points");
    }
    const Material& material = surface.material;
    if (!(material.crease_angle >= 0 && material.crease_angle <= 180)) {
        Refuse("crease_angle: ", material.crease_angle, " degrees; must be from 0 to 180");
    }
    if (material.stripes < 0 || material.stripes > 1000) {
        Refuse("stripes: ", material.stripes, "; must be from 0 to 1000");
    }
    if (!(material.gloss >= 0 && material.gloss <= 1)) Refuse("gloss: ", material.gloss, "; must be from 0 to 1");
    data_->surfaces.push_back({.positions = std::move(positions),
                               .triangles = std::move(triangles),
                               .material = material,
                               .triangle_colors = {surface.triangle_colors.begin(), surface.triangle_colors.end()},
                               .values = Normalized(surface),
                               .map = surface.map});
    return *this;
}

Scene& Scene::Add(const Lines& lines) {
    auto positions = CheckedPositions(lines.positions);
    auto edges = CheckedIndices(lines.edges, 2, "edge", positions.size());
    CheckPixels("line width", lines.width);
    data_->lines.push_back({std::move(positions), std::move(edges), lines.color, lines.width, lines.shaded});
    return *this;
}

Scene& Scene::Add(const Points& points) {
    auto positions = CheckedPositions(points.positions);
    CheckPixels("point diameter", points.diameter);
    data_->points.push_back({std::move(positions), points.color, points.diameter, points.shaded});
    return *this;
}

bool Scene::IsEmpty() const {
    bool empty = true;
    data_->ForEachUsedPoint([&](const Internal::Vec3d&) { empty = false; });
    return empty;
}

}  // namespace SolidSubdiv::Picture

// SPDX-License-Identifier: Apache-2.0
// Fits a pinhole camera to points; see camera.h.
#include <solidsubdiv/kit/picture/camera.h>
#include <solidsubdiv/kit/picture/internal/scene_data.h>
#include <solidsubdiv/sdc/errors.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace SolidSubdiv::Picture {
namespace {

using Internal::Vec3d;

void CheckRange(const char* name, double value, double low, double high) {
    if (!(value >= low && value <= high)) {
        throw InvalidInput(std::string("view: ") + name + " is " + std::to_string(value) + "; must be from " +
                           std::to_string(low) + " to " + std::to_string(high));
    }
}

std::array<double, 3> ToArray(Vec3d v) { return {v.x, v.y, v.z}; }

/// Turns the axes so that y, which is up in the code below, becomes z.
Vec3d FromYUp(Vec3d v, UpAxis up) { return up == UpAxis::Y ? v : Vec3d{v.x, -v.z, v.y}; }

}  // namespace

void View::Validate() const {
    CheckRange("azimuth", azimuth, -1e6, 1e6);
    CheckRange("elevation", elevation, -90, 90);
    CheckRange("field_of_view", field_of_view, 1, 120);
    CheckRange("margin", margin, 0, 0.45);
}

Camera FitCamera(const View& view, int width, int height, std::span<const Scene* const> scenes) {
    view.Validate();
    const double a = view.azimuth * std::numbers::pi / 180, e = view.elevation * std::numbers::pi / 180;
    const Vec3d right = FromYUp({std::cos(a), 0, -std::sin(a)}, view.up);
    const Vec3d back = FromYUp({std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)}, view.up);
    const Vec3d up = Cross(back, right);
    const double tangent = std::tan(view.field_of_view * std::numbers::pi / 360);
    const double longer = std::max(width, height);
    Camera camera{.right = ToArray(right),
                  .up = ToArray(up),
                  .forward = ToArray(-back),
                  .half_width = tangent * width / longer,
                  .half_height = tangent * height / longer,
                  .world_up = ToArray(FromYUp({0, 1, 0}, view.up))};

    // A camera at (cx, cy, cz) in the view's axes, z pointing back, sees a point if |x - cx| <= tx (cz - z) and the
    // same for y. So cx + tx cz >= max(x + tx z) and -cx + tx cz >= max(-x + tx z): the sum of the two bounds cz from
    // below.
    const double tx = camera.half_width * (1 - 2 * view.margin), ty = camera.half_height * (1 - 2 * view.margin);
    double most_right = -HUGE_VAL, most_left = -HUGE_VAL, most_up = -HUGE_VAL, most_down = -HUGE_VAL,
           nearest = -HUGE_VAL;
    for (const Scene* scene : scenes) {
        scene->data().ForEachUsedPoint([&](const Vec3d& p) {
            const double x = Dot(p, right), y = Dot(p, up), z = Dot(p, back);
            most_right = std::max(most_right, x + tx * z);
            most_left = std::max(most_left, -x + tx * z);
            most_up = std::max(most_up, y + ty * z);
            most_down = std::max(most_down, -y + ty * z);
            nearest = std::max(nearest, z);
        });
    }
    if (nearest == -HUGE_VAL) throw InvalidInput("picture: the scene has nothing in it to look at");
    const double cz = std::max((most_right + most_left) / (2 * tx), (most_up + most_down) / (2 * ty));
    // A single point has no size: any distance will do.
    const double distance = cz - nearest > 1e-9 * std::abs(nearest) ? cz : nearest + std::max(1.0, std::abs(nearest));
    camera.position = ToArray((most_right - most_left) / 2 * right + (most_up - most_down) / 2 * up + distance * back);
    return camera;
}

Camera FitCamera(const View& view, int width, int height, const Scene& scene) {
    const Scene* one = &scene;
    return FitCamera(view, width, height, std::span(&one, 1));
}

}  // namespace SolidSubdiv::Picture

// SPDX-License-Identifier: Apache-2.0
// Where a picture is taken from. A View says from which side; FitCamera steps back until everything is in the frame.
#pragma once

#include <array>
#include <span>

namespace SolidSubdiv::Picture {

class Scene;

enum class UpAxis { Y, Z };

/// A direction of sight, in degrees. Azimuth 0 looks from +z when y is up (from -y when z is up), 90 from +x.
struct View {
    double azimuth = 30;        ///< degrees, any
    double elevation = 18;      ///< degrees above the horizon, [-90, 90]
    double field_of_view = 25;  ///< degrees across the longer side of the picture, [1, 120]: small = little perspective
    double margin = 0.06;       ///< free part of the picture on each side, [0, 0.45]
    UpAxis up = UpAxis::Y;

    /// @throws InvalidInput naming the field and its range
    void Validate() const;
};

/// A pinhole camera. Directions are unit vectors at right angles, right x up = back (against the line of sight).
struct Camera {
    std::array<double, 3> position{}, right{}, up{}, forward{};
    double half_width = 0, half_height = 0;  ///< of the picture at distance 1
    std::array<double, 3> world_up{};        ///< the ground lies at right angles to it
};

/// The camera that shows all of the scenes, as large as fits. Several scenes: for panels that share one scale.
/// @throws InvalidInput if nothing is in them
Camera FitCamera(const View& view, int width, int height, std::span<const Scene* const> scenes);
Camera FitCamera(const View& view, int width, int height, const Scene& scene);

}  // namespace SolidSubdiv::Picture

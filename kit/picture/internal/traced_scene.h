// SPDX-License-Identifier: Apache-2.0
// A scene as Embree sees it: recentred, scaled to radius 1, in floats. The only file that knows Embree is its source.
#pragma once

#include <memory>

#include <solidsubdiv/kit/picture/camera.h>
#include <solidsubdiv/kit/picture/internal/scene_data.h>

namespace SolidSubdiv::Picture::Internal {

/// What a ray met first. Lengths are in the scaled scene.
struct Hit {
    float distance = 0;
    Vec3f position;
    Vec3f normal;  ///< unit, for shading; towards the ray's origin, as far as the surface is seen from there
    Vec3f origin;  ///< where shadow rays start: just off the surface, on the rounded shape where it is smooth
    Vec3f facing;  ///< unit, of the flat triangle, towards the ray's origin
    Color color;
    float gloss = 0;
    int stripes = 0;
    bool shaded = true;  ///< false: `color` is the result
};

class TracedScene {
  public:
    /// Pixel sizes of lines and points are those of a picture of `width_in_pixels` taken with the camera.
    TracedScene(const SceneData& scene, const Camera& camera, int width_in_pixels);
    ~TracedScene();
    TracedScene(const TracedScene&) = delete;
    TracedScene& operator=(const TracedScene&) = delete;

    /// The caller's coordinates to the scaled scene's.
    Vec3f ToScaled(Vec3d p) const { return static_cast<Vec3f>(scale_ * (p - centre_)); }
    /// How far the lowest point lies above (below: negative) the scaled scene's centre.
    float LowestPoint(Vec3f up) const;

    /// @pre direction is a unit vector
    bool Intersect(Vec3f origin, Vec3f direction, Hit& hit) const;
    /// Whether something that casts shadows lies within `reach`.
    bool IsOccluded(Vec3f origin, Vec3f direction, float reach) const;

  private:
    struct Impl;
    const SceneData& scene_;
    Vec3d centre_{};
    double scale_ = 1;
    float pixel_ = 0;  ///< size of a pixel at distance 1
    std::unique_ptr<Impl> impl_;
};

}  // namespace SolidSubdiv::Picture::Internal

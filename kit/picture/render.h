// SPDX-License-Identifier: Apache-2.0
// From a scene and a view to an image: ray tracing with soft light, shadows and antialiasing, on any machine, no
// display.
#pragma once

#include <solidsubdiv/kit/picture/camera.h>
#include <solidsubdiv/kit/picture/image.h>
#include <solidsubdiv/kit/picture/scene.h>
#include <solidsubdiv/sdc/progress.h>

namespace SolidSubdiv::Picture {

struct RenderOptions {
    int width = 1200, height = 900;       ///< pixels, [1, 32768]
    int samples = 16;                     ///< camera rays of a pixel at an edge, [1, 1024]; elsewhere 5 will do
    int light_rays = 8;                   ///< rays of a pixel to each light, [0, 4096]: 0 = no shadows at all
    bool ground_shadow = true;            ///< the shadow on the ground that the lowest point stands on
    Color background_top = {1, 1, 1};     ///< the background runs from this colour
    Color background_bottom = {1, 1, 1};  ///< to this one

    /// @throws InvalidInput naming the field and its range
    void Validate() const;
};

/// The picture; the same bits for any number of threads. An empty scene gives the background.
/// Cost: 5 + 2 light_rays rays a pixel, 3 samples more at edges; 1200 x 900 in a few seconds.
Image Render(const Scene& scene, const Camera& camera, const RenderOptions& options = {},
             const Progress& progress = {});

/// The same with a camera fitted to the scene.
Image Render(const Scene& scene, const View& view, const RenderOptions& options = {}, const Progress& progress = {});

}  // namespace SolidSubdiv::Picture

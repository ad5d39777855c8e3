// SPDX-License-Identifier: Apache-2.0
// The studio where scenes are photographed: lights that move with the camera, a ground that only takes shadows.
#pragma once

#include <solidsubdiv/kit/picture/internal/sampling.h>
#include <solidsubdiv/kit/picture/internal/traced_scene.h>
#include <solidsubdiv/kit/picture/render.h>

namespace SolidSubdiv::Picture::Internal {

/// What one camera ray met, before light. Colours are linear.
struct Fragment {
    enum class Kind {
        Background,
        Ground,
        Plain,
        Lit
    };  ///< Plain: drawn with a pen; Ground: background that takes shadows
    Kind kind = Kind::Background;
    Vec3f color;
    Vec3f position;        ///< of Ground and Lit
    Vec3f origin, normal;  ///< where rays towards the light start, and around what
    Vec3f direction;       ///< of the camera ray
    float gloss = 0;
    float fade = 1;  ///< of Ground: 1 near the shape, 0 far away, where no shadow is shown

    bool NeedsLight() const { return kind == Kind::Lit || (kind == Kind::Ground && fade > 0); }
};

/// Shares, 0 to 1, of the key light and of the sky that reach a point.
struct LightShare {
    float key = 1, sky = 1;
};

class Studio {
  public:
    Studio(const Scene& scene, const Camera& camera, const RenderOptions& options);

    /// The camera ray through a point of the picture, in pixels from its upper left corner.
    Fragment Look(float x, float y) const;
    /// Light at a fragment from `n_rays` rays to the key light and as many to the sky, from number `first` on.
    LightShare Gather(const Fragment& fragment, const PixelSequence& sequence, int first, int n_rays) const;
    /// Linear colour of a fragment in that light.
    Vec3f Develop(const Fragment& fragment, LightShare light) const;
    /// Size of a pixel at the fragment, in the scaled scene.
    float PixelSize(const Fragment& fragment) const;

  private:
    RenderOptions options_;
    TracedScene traced_;
    Vec3f eye_, right_, up_, forward_, sky_, key_, fill_;
    float half_width_ = 0, half_height_ = 0, ground_ = 0;
    bool has_ground_ = false;
};

}  // namespace SolidSubdiv::Picture::Internal

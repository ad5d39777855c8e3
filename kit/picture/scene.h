// SPDX-License-Identifier: Apache-2.0
// What is in a picture: surfaces, lines and points. Everything is copied; later changes to the caller's arrays don't
// matter.
//
//     Picture::Scene scene;
//     scene.Add(Picture::Surface{.positions = p, .triangles = t, .material = {.color = Picture::Palette::kSkin}});
//     scene.Add(Picture::Lines{.positions = lattice.positions, .edges = edges, .width = 2});
//     Picture::WritePng("part.png", Picture::Render(scene, Picture::View{.azimuth = 30}));
#pragma once

#include <memory>
#include <span>

#include <solidsubdiv/kit/picture/color.h>
#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Picture {

/// How a surface answers light.
struct Material {
    Color color = Palette::kSkin;
    bool smooth = true;        ///< normals vary over triangles; otherwise every triangle is flat
    double crease_angle = 40;  ///< degrees, [0, 180]: neighbours that meet at more than this stay apart when smooth
    double gloss = 0.25;       ///< [0, 1]: strength of the highlight
    int stripes = 0;  ///< [0, 1000]: reflection lines, so many dark ones from below to above. Where tangent planes jump
                      ///< the lines break, where curvature jumps they have corners
};

/// A triangle mesh. Which way triangles face does not matter, but neighbours should agree where shading is smooth.
struct Surface {
    std::span<const double> positions;  ///< (n, 3), finite
    std::span<const Index> triangles;   ///< (m, 3)
    Material material{};
    std::span<const Color> triangle_colors{};  ///< (m) or empty: instead of the material's colour
    std::span<const double> values{};          ///< (n) or empty: coloured by `map` instead; not finite = grey
    ColorMap map = ColorMap::Sequential;
    double low = 0, high = 0;  ///< values at the map's ends; equal: the least and greatest value
};

/// Straight lines between pairs of points, of the same width everywhere in the picture; what is behind a surface is
/// hidden.
struct Lines {
    std::span<const double> positions;  ///< (n, 3), finite
    std::span<const Index> edges;       ///< (m, 2)
    Color color = Palette::kInk;
    double width = 1.5;   ///< pixels, positive
    bool shaded = false;  ///< as lit tubes that cast shadows; otherwise plain colour, as drawn with a pen
};

/// Points as small balls of the same size everywhere in the picture.
struct Points {
    std::span<const double> positions;  ///< (n, 3), finite
    Color color = Palette::kInk;
    double diameter = 6;  ///< pixels, positive
    bool shaded = true;
};

namespace Internal {
struct SceneData;
}

class Scene {
  public:
    Scene();
    ~Scene();
    Scene(Scene&&) noexcept;
    Scene& operator=(Scene&&) noexcept;

    /// @throws InvalidInput naming the array, the place and the value that can't be used
    Scene& Add(const Surface& surface);
    Scene& Add(const Lines& lines);
    Scene& Add(const Points& points);

    bool IsEmpty() const;
    const Internal::SceneData& data() const { return *data_; }

  private:
    std::unique_ptr<Internal::SceneData> data_;
};

}  // namespace SolidSubdiv::Picture

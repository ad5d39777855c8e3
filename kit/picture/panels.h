// SPDX-License-Identifier: Apache-2.0
// Several pictures in one, side by side, with captions and colour bars.
//
//     const Picture::ScenePanel panels[] = {{&lattice, "control lattice"}, {&level_3, "level 3"}, {&cut, "cut"}};
//     Picture::WritePng("demo.png", Picture::RenderPanels(panels, {.azimuth = 20}, {.width = 600, .height = 520}));
#pragma once

#include <optional>
#include <span>
#include <string>

#include <solidsubdiv/kit/picture/render.h>
#include <solidsubdiv/kit/picture/text.h>

namespace SolidSubdiv::Picture {

/// What the colours of values mean.
struct ColorBar {
    ColorMap map = ColorMap::Sequential;
    double low = 0, high = 1;
    std::string title{};
};

struct Panel {
    Image image;
    std::string caption{};
    std::optional<ColorBar> color_bar{};  ///< stands under the caption
};

struct PanelOptions {
    int columns = 0;      ///< panels in a row, 0: all
    int gap = 8;          ///< pixels between panels and around them, [0, 1000]
    TextStyle caption{};  ///< captions stand centred under their panels
    Color background = {1, 1, 1};

    /// @throws InvalidInput naming the field and its range
    void Validate() const;
};

/// One image of all panels; each row is as high as its highest panel. @throws InvalidInput if there is none
Image Arrange(std::span<const Panel> panels, const PanelOptions& options = {});

/// Draws a colour bar from (x, y) to the right, a capital's height thick, with its numbers and title below: 2.6 times
/// the height of capitals in all.
void DrawColorBar(Image& image, int x, int y, int width, const ColorBar& bar, const TextStyle& style = {});

/// A panel still to be rendered.
struct ScenePanel {
    const Scene* scene = nullptr;
    std::string caption{};
    std::optional<ColorBar> color_bar{};  ///< low and high are those given to the surface
};

/// Renders every panel with one camera that sees all the scenes, so that they compare, and arranges them. `render`
/// tells the size of one panel.
Image RenderPanels(std::span<const ScenePanel> panels, const View& view, const RenderOptions& render = {},
                   const PanelOptions& options = {}, const Progress& progress = {});

}  // namespace SolidSubdiv::Picture

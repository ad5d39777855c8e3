// SPDX-License-Identifier: Apache-2.0
// Rows and columns of pictures; see panels.h.
#include <solidsubdiv/kit/picture/panels.h>
#include <solidsubdiv/sdc/errors.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace SolidSubdiv::Picture {
namespace {

/// Four digits are what a reader of a picture can use.
std::string ShortNumber(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", x);
    return text;
}

int Round(double x) { return static_cast<int>(std::lround(x)); }

}  // namespace

void PanelOptions::Validate() const {
    if (columns < 0)
        throw InvalidInput("panels: columns is " + std::to_string(columns) + "; must be 0 (all in a row) or more");
    if (gap < 0 || gap > 1000)
        throw InvalidInput("panels: gap is " + std::to_string(gap) + "; must be from 0 to 1000 pixels");
}

Image Arrange(std::span<const Panel> panels, const PanelOptions& options) {
    options.Validate();
    if (panels.empty()) throw InvalidInput("panels: there is none to arrange");
    const std::size_t n = panels.size();
    const std::size_t columns = options.columns == 0 ? n : std::min(n, static_cast<std::size_t>(options.columns));
    const std::size_t rows = (n + columns - 1) / columns;
    const double letter = options.caption.size;
    const int caption_height = Round(2.2 * letter), bar_height = Round(3.4 * letter);

    std::vector<int> widths(columns, 0), heights(rows, 0), captions(rows, 0), bars(rows, 0);
    for (std::size_t i = 0; i < n; ++i) {
        widths[i % columns] = std::max(widths[i % columns], panels[i].image.width());
        heights[i / columns] = std::max(heights[i / columns], panels[i].image.height());
        if (!panels[i].caption.empty()) captions[i / columns] = caption_height;
        if (panels[i].color_bar) bars[i / columns] = bar_height;
    }
    int width = options.gap, height = options.gap;
    for (int w : widths) width += w + options.gap;
    for (std::size_t row = 0; row < rows; ++row) height += heights[row] + captions[row] + bars[row] + options.gap;

    Image all(width, height, options.background);
    int y = options.gap;
    for (std::size_t row = 0; row < rows; ++row) {
        int x = options.gap;
        for (std::size_t column = 0; column < columns && row * columns + column < n; ++column) {
            const Panel& panel = panels[row * columns + column];
            all.Paste(panel.image, x + (widths[column] - panel.image.width()) / 2,
                      y + (heights[row] - panel.image.height()) / 2);
            const double middle = x + 0.5 * widths[column];
            DrawText(all, middle - 0.5 * TextWidth(panel.caption, options.caption),
                     y + heights[row] + 0.5 * (caption_height + letter), panel.caption, options.caption);
            if (panel.color_bar) {
                const int length = std::max(1, widths[column] * 3 / 5);
                DrawColorBar(all, x + (widths[column] - length) / 2, y + heights[row] + captions[row], length,
                             *panel.color_bar, options.caption);
            }
            x += widths[column] + options.gap;
        }
        y += heights[row] + captions[row] + bars[row] + options.gap;
    }
    return all;
}

void DrawColorBar(Image& image, int x, int y, int width, const ColorBar& bar, const TextStyle& style) {
    const int thick = Round(style.size);
    for (int i = 0; i < width; ++i) {
        const Color color = Lookup(bar.map, width > 1 ? static_cast<double>(i) / (width - 1) : 0.5);
        for (int j = 0; j < thick; ++j) image.Blend(x + i, y + j, color, 1);
    }
    const std::string low = ShortNumber(bar.low), high = ShortNumber(bar.high);
    const double base = y + 2.5 * style.size;
    DrawText(image, x, base, low, style);
    DrawText(image, x + width - TextWidth(high, style), base, high, style);
    DrawText(image, x + 0.5 * (width - TextWidth(bar.title, style)), base, bar.title, style);
}

Image RenderPanels(std::span<const ScenePanel> panels, const View& view, const RenderOptions& render,
                   const PanelOptions& options, const Progress& progress) {
    render.Validate();
    options.Validate();
    std::vector<const Scene*> scenes;
    for (const ScenePanel& panel : panels) {
        if (panel.scene == nullptr)
            throw InvalidInput("panels: panel " + std::to_string(scenes.size()) + " has no scene");
        scenes.push_back(panel.scene);
    }
    const Camera camera = FitCamera(view, render.width, render.height, scenes);
    std::vector<Panel> finished;
    for (const ScenePanel& panel : panels) {
        const auto part = [&](std::string_view stage, double fraction) {
            const double done = (static_cast<double>(finished.size()) + fraction) / static_cast<double>(panels.size());
            return !progress || progress(stage, done);
        };
        finished.push_back({Render(*panel.scene, camera, render, part), panel.caption, panel.color_bar});
    }
    return Arrange(finished, options);
}

}  // namespace SolidSubdiv::Picture

// SPDX-License-Identifier: Apache-2.0
// Short texts in pictures, in a small font of strokes of the project's own, readable at any size.
#pragma once

#include <string_view>

#include <solidsubdiv/kit/picture/image.h>

namespace SolidSubdiv::Picture {

struct TextStyle {
    double size = 14;  ///< height of capital letters in pixels, [4, 500]
    Color color = Palette::kInk;
    double weight = 0.13;  ///< thickness of strokes by size, [0.02, 0.4]
};

/// Pixels from the left of the first letter to the right of the last one. ASCII; other characters are boxes.
double TextWidth(std::string_view text, const TextStyle& style = {});

/// Draws one line of text that starts at x and stands on the line y (pixels from the upper left corner); what lies
/// outside the image is cut off. @throws InvalidInput for a style out of range
void DrawText(Image& image, double x, double y, std::string_view text, const TextStyle& style = {});

}  // namespace SolidSubdiv::Picture

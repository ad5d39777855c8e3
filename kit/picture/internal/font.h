// SPDX-License-Identifier: Apache-2.0
// The font: every ASCII letter as a few strokes on a grid.
#pragma once

#include <string_view>
#include <vector>

namespace SolidSubdiv::Picture::Internal {

struct Stroke {
    struct Point {
        double x, y;
    };
    std::vector<Point> points;  ///< a line through these; a single one is a dot
};

struct Glyph {
    std::vector<Stroke> strokes;  ///< y up from the base line, capitals 1 high
    double width = 0;
};

/// Letters of a text in UTF-8; what the font lacks is a box.
std::vector<const Glyph*> GlyphsOf(std::string_view text);

/// Space between two letters, by the height of capitals.
inline constexpr double kLetterGap = 0.27;

}  // namespace SolidSubdiv::Picture::Internal

// SPDX-License-Identifier: Apache-2.0
// Draws strokes as round-ended lines with soft edges; see text.h.
#include <solidsubdiv/kit/picture/internal/font.h>
#include <solidsubdiv/kit/picture/text.h>
#include <solidsubdiv/sdc/errors.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace SolidSubdiv::Picture {
namespace {

using Point = Internal::Stroke::Point;

void Check(const TextStyle& style) {
    if (!(style.size >= 4 && style.size <= 500)) {
        throw InvalidInput("text: size is " + std::to_string(style.size) + "; must be from 4 to 500 pixels");
    }
    if (!(style.weight >= 0.02 && style.weight <= 0.4)) {
        throw InvalidInput("text: weight is " + std::to_string(style.weight) + "; must be from 0.02 to 0.4");
    }
}

double DistanceToSegment(Point p, Point a, Point b) {
    const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
    const double t = length2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0, 1.0) : 0;
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

void DrawGlyph(Image& image, const Internal::Glyph& glyph, double x, double y, const TextStyle& style) {
    const double radius = std::max(0.5 * style.weight * style.size, 0.6);
    const int left = static_cast<int>(std::floor(x - radius - 1));
    const int right = static_cast<int>(std::ceil(x + glyph.width * style.size + radius + 1));
    const int top = static_cast<int>(std::floor(y - 1.2 * style.size - radius - 1));
    const int bottom = static_cast<int>(std::ceil(y + 0.4 * style.size + radius + 1));
    for (int py = std::max(0, top); py < std::min(bottom, image.height()); ++py) {
        for (int px = std::max(0, left); px < std::min(right, image.width()); ++px) {
            const Point p{px + 0.5, py + 0.5};
            double distance = HUGE_VAL;
            for (const Internal::Stroke& stroke : glyph.strokes) {
                for (std::size_t i = 0; i < stroke.points.size(); ++i) {
                    const Point a = stroke.points[i], b = stroke.points[std::min(i + 1, stroke.points.size() - 1)];
                    distance = std::min(distance, DistanceToSegment(p, {x + a.x * style.size, y - a.y * style.size},
                                                                    {x + b.x * style.size, y - b.y * style.size}));
                }
            }
            const double cover = std::clamp(radius + 0.5 - distance, 0.0, 1.0);
            if (cover > 0) image.Blend(px, py, style.color, static_cast<float>(cover));
        }
    }
}

}  // namespace

double TextWidth(std::string_view text, const TextStyle& style) {
    Check(style);
    double width = 0;
    for (const Internal::Glyph* glyph : Internal::GlyphsOf(text)) width += glyph->width + Internal::kLetterGap;
    return width > 0 ? (width - Internal::kLetterGap) * style.size : 0;
}

void DrawText(Image& image, double x, double y, std::string_view text, const TextStyle& style) {
    Check(style);
    for (const Internal::Glyph* glyph : Internal::GlyphsOf(text)) {
        DrawGlyph(image, *glyph, x, y, style);
        x += (glyph->width + Internal::kLetterGap) * style.size;
    }
}

}  // namespace SolidSubdiv::Picture

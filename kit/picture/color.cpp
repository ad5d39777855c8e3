// SPDX-License-Identifier: Apache-2.0
// Colour maps: anchors in OKLab, where equal steps look equal, joined by straight lines. See color.h.
#include <solidsubdiv/kit/picture/color.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include <solidsubdiv/kit/picture/internal/srgb.h>

namespace SolidSubdiv::Picture {
namespace {

/// Lightness, chroma and hue (degrees) of the polar form of OKLab.
struct Anchor {
    double lightness, chroma, hue;
};

// Equal steps of lightness; hues turn one way only.
constexpr std::array<Anchor, 6> kSequential{
    {{0.27, 0.12, 300}, {0.40, 0.13, 272}, {0.53, 0.11, 225}, {0.66, 0.13, 165}, {0.79, 0.18, 128}, {0.93, 0.17, 105}}};
constexpr std::array<Anchor, 7> kDiverging{{{0.38, 0.15, 262},
                                            {0.58, 0.13, 250},
                                            {0.78, 0.08, 235},
                                            {0.95, 0.01, 90},
                                            {0.79, 0.09, 55},
                                            {0.60, 0.16, 35},
                                            {0.40, 0.15, 25}}};

/// OKLab to linear sRGB: the inverse of the two 3x3 matrices and cube roots that define it (Ottosson 2020).
Color FromOklab(double lightness, double a, double b) {
    const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
    const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
    const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
    const auto encode = [](double x) { return Internal::EncodeSrgb(static_cast<float>(std::clamp(x, 0.0, 1.0))); };
    return {encode(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            encode(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            encode(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

Color Interpolate(std::span<const Anchor> anchors, double t) {
    const double place = t * static_cast<double>(anchors.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(place), anchors.size() - 2);
    const double f = place - static_cast<double>(i);
    // Straight in (lightness, a, b), so that hues of neighbouring anchors never take the long way round.
    const auto lab = [](const Anchor& x) {
        const double angle = x.hue * std::numbers::pi / 180;
        return std::array{x.lightness, x.chroma * std::cos(angle), x.chroma * std::sin(angle)};
    };
    const auto p = lab(anchors[i]), q = lab(anchors[i + 1]);
    return FromOklab(p[0] + f * (q[0] - p[0]), p[1] + f * (q[1] - p[1]), p[2] + f * (q[2] - p[2]));
}

}  // namespace

Color Lookup(ColorMap map, double t) {
    if (std::isnan(t)) return Color::Hex(0x808080);
    // Finer than the 256 steps of a pixel: a colour is asked for by every ray, and its powers are slow.
    constexpr int kSteps = 1024;
    using Table = std::array<Color, kSteps + 1>;
    const auto make = [](std::span<const Anchor> anchors) {
        Table table;
        for (int i = 0; i <= kSteps; ++i)
            table[static_cast<std::size_t>(i)] = Interpolate(anchors, static_cast<double>(i) / kSteps);
        return table;
    };
    static const Table sequential = make(kSequential), diverging = make(kDiverging);
    const auto step = static_cast<std::size_t>(std::lround(std::clamp(t, 0.0, 1.0) * kSteps));
    return (map == ColorMap::Diverging ? diverging : sequential)[step];
}

}  // namespace SolidSubdiv::Picture

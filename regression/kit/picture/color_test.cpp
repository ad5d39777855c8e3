// SPDX-License-Identifier: Apache-2.0
// Colour maps: what makes them honest is how their lightness runs.
#include <gtest/gtest.h>
#include <solidsubdiv/kit/picture/color.h>
#include <solidsubdiv/kit/picture/internal/srgb.h>

#include <cmath>
#include <limits>

namespace SolidSubdiv::Picture {
namespace {

/// CIE L*, 0 to 100, by another road than the maps are made.
double Lightness(Color c) {
    const double y = 0.2126 * static_cast<double>(Internal::DecodeSrgb(c.r)) +
                     0.7152 * static_cast<double>(Internal::DecodeSrgb(c.g)) +
                     0.0722 * static_cast<double>(Internal::DecodeSrgb(c.b));
    return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

TEST(ColorTest, HexReadsRedGreenBlue) { EXPECT_EQ(Color::Hex(0xff0080), (Color{1, 0, 128 / 255.f})); }

TEST(ColorTest, SrgbCodingIsItsOwnInverse) {
    for (float x = 0; x <= 1; x += 1 / 64.f) EXPECT_NEAR(Internal::EncodeSrgb(Internal::DecodeSrgb(x)), x, 1e-5);
    EXPECT_NEAR(Internal::EncodeSrgb(0.214041f), 0.5, 1e-5);  // the standard's own middle grey
}

TEST(ColorMapTest, SequentialLightnessGrowsEvenly) {
    const double first = Lightness(Lookup(ColorMap::Sequential, 0)), last = Lightness(Lookup(ColorMap::Sequential, 1));
    EXPECT_GT(last - first, 70);
    for (int i = 1; i <= 50; ++i) {
        const double t = i / 50.0;
        EXPECT_GT(Lightness(Lookup(ColorMap::Sequential, t)), Lightness(Lookup(ColorMap::Sequential, t - 0.02))) << t;
        // OKLab's lightness and CIE's disagree by a few units for saturated colours.
        EXPECT_NEAR(Lightness(Lookup(ColorMap::Sequential, t)), first + t * (last - first), 6) << t;
    }
}

TEST(ColorMapTest, DivergingIsLightestInTheMiddleAndAlikeAtBothSides) {
    EXPECT_GT(Lightness(Lookup(ColorMap::Diverging, 0.5)), 90);
    for (int i = 1; i <= 25; ++i) {
        const double t = i / 50.0;
        const double low = Lightness(Lookup(ColorMap::Diverging, 0.5 - t)),
                     high = Lightness(Lookup(ColorMap::Diverging, 0.5 + t));
        EXPECT_LT(low, Lightness(Lookup(ColorMap::Diverging, 0.52 - t))) << t;
        EXPECT_LT(high, Lightness(Lookup(ColorMap::Diverging, 0.48 + t))) << t;
        EXPECT_NEAR(low, high, 6) << t;
    }
    const Color cold = Lookup(ColorMap::Diverging, 0.1), warm = Lookup(ColorMap::Diverging, 0.9);
    EXPECT_GT(cold.b, cold.r + 0.3f);
    EXPECT_GT(warm.r, warm.b + 0.3f);
}

TEST(ColorMapTest, ValuesOutsideAreClampedAndNanIsGrey) {
    for (ColorMap map : {ColorMap::Sequential, ColorMap::Diverging}) {
        EXPECT_EQ(Lookup(map, -3), Lookup(map, 0));
        EXPECT_EQ(Lookup(map, std::numeric_limits<double>::infinity()), Lookup(map, 1));
        const Color nan = Lookup(map, std::numeric_limits<double>::quiet_NaN());
        EXPECT_EQ(nan.r, nan.g);
        EXPECT_EQ(nan.g, nan.b);
    }
}

}  // namespace
}  // namespace SolidSubdiv::Picture

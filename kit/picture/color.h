// SPDX-License-Identifier: Apache-2.0
// Colours as people write them, and colour maps that turn a number into one.
#pragma once

#include <cstdint>

namespace SolidSubdiv::Picture {

/// Red, green and blue in [0, 1], in the sRGB coding of web pages and image files.
struct Color {
    float r = 0, g = 0, b = 0;

    /// Color::Hex(0xff8000) is orange.
    static constexpr Color Hex(std::uint32_t rgb) {
        return {static_cast<float>((rgb >> 16) & 255) / 255.f, static_cast<float>((rgb >> 8) & 255) / 255.f,
                static_cast<float>(rgb & 255) / 255.f};
    }
    friend constexpr bool operator==(const Color&, const Color&) = default;
};

/// The palette of the project's own pictures.
namespace Palette {
inline constexpr Color kSkin = Color::Hex(0xb9c6d2);         ///< a solid's boundary
inline constexpr Color kTetrahedron = Color::Hex(0xf3bd7c);  ///< cells by kind
inline constexpr Color kOctahedron = Color::Hex(0x5b8fc7);
inline constexpr Color kHexahedron = Color::Hex(0x8fbf8a);
inline constexpr Color kWedge = Color::Hex(0xb59bd0);
inline constexpr Color kPyramid = Color::Hex(0xe08f86);
inline constexpr Color kPolyhedron = Color::Hex(0xe3d266);
inline constexpr Color kLattice = Color::Hex(0x9c3b2e);  ///< control lattices
inline constexpr Color kInk = Color::Hex(0x2b3440);      ///< lines and text
}  // namespace Palette

enum class ColorMap {
    Sequential,  ///< dark blue over green to light yellow: lightness grows evenly, readable without colour vision
    Diverging    ///< blue over near-white to red: for values with a natural middle (signed errors)
};

/// The colour of t in [0, 1]; t outside is clamped, NaN is grey.
Color Lookup(ColorMap map, double t);

}  // namespace SolidSubdiv::Picture

// SPDX-License-Identifier: Apache-2.0
// Letters written down: a point is a digit (x) and a letter (y: a = 2 below the base line, c on it, g the height of
// small letters, i of capitals); "~" marks the control point of a parabola; a space lifts the pen.
#include <solidsubdiv/kit/picture/internal/font.h>

#include <algorithm>
#include <array>

namespace SolidSubdiv::Picture::Internal {
namespace {

constexpr int kFirst = 32, kLast = 126;
constexpr std::array<std::string_view, kLast - kFirst + 2> kLetters{
    "",                                                        // space
    "0i0e 0c",                                                 // !
    "0i0g 1i1g",                                               // "
    "2i1c 4i3c 0g5g 0e5e",                                     // #
    "4h~4i2i~0i0h~0f2f~4f4d~4c2c~0c0d 2j2b",                   // $
    "4i0c 1i~0i0h~0g1g~2g2h~2i1i 3e~2e2d~2c3c~4c4d~4e3e",      // %
    "5c1g~0h1i2i~3h2g0e~0c2c~4c5f",                            // &
    "0i0g",                                                    // '
    "1i~0g0f0e~0d1b",                                          // (
    "0i~1g1f1e~1d0b",                                          // )
    "1i1f 0h2g 2h0g",                                          // *
    "2g2c 0e4e",                                               // +
    "1c0b",                                                    // ,
    "0e2e",                                                    // -
    "0c",                                                      // .
    "0b3i",                                                    // /
    "2i~4i4f~4c2c~0c0f~0i2i",                                  // 0
    "0h2i2c",                                                  // 1
    "0h~0i2i~4i4g~4f0c4c",                                     // 2
    "0h~0i2i~4i4h~4f2f~4f4d~4c2c~0c0d",                        // 3
    "3c3i0d4d",                                                // 4
    "4i0i0f~1g2g~4g4e~4c2c~0c0d",                              // 5
    "4h~4i2i~0i0f0e~0c2c~4c4e~4g2g~0g0e",                      // 6
    "0i4i1c",                                                  // 7
    "2f~0f0h~0i2i~4i4h~4f2f~0f0d~0c2c~4c4d~4f2f",              // 8
    "0d~0c2c~4c4f4g~4i2i~0i0g~0e2e~4e4g",                      // 9
    "0f 0c",                                                   // :
    "1f 1c0b",                                                 // ;
    "3g0e3c",                                                  // <
    "0f4f 0d4d",                                               // =
    "0g3e0c",                                                  // >
    "0h~0i2i~4i4h~4g2f2e 2c",                                  // ?
    "4e~4g3g~2g2e~2d3d~4d4e 4g4e~4d5d~6d6f~6i3i~0i0f~0b3b5b",  // @
    "0c2i4c 1e3e",                                             // A
    "0c0i2i~4i4h~4f2f0f 2f~4f4d~4c2c0c",                       // B
    "4h~4i2i~0i0f~0c2c~4c4d",                                  // C
    "0c0i1i~4i4f~4c1c0c",                                      // D
    "4i0i0c4c 0f3f",                                           // E
    "4i0i0c 0f3f",                                             // F
    "4h~4i2i~0i0f~0c2c~4c4d4f2f",                              // G
    "0i0c 4i4c 0f4f",                                          // H
    "0i0c",                                                    // I
    "3i3e~3c1c~0c0d",                                          // J
    "0i0c 4i0e 1f4c",                                          // K
    "0i0c3c",                                                  // L
    "0c0i3e6i6c",                                              // M
    "0c0i4c4i",                                                // N
    "2i3i~5i5f~5c3c2c~0c0f~0i2i",                              // O
    "0c0i2i~4i4h~4f2f0f",                                      // P
    "2i3i~5i5f~5c3c2c~0c0f~0i2i 3e5c",                         // Q
    "0c0i2i~4i4h~4f2f0f 2f4c",                                 // R
    "4h~4i2i~0i0h~0f2f~4f4d~4c2c~0c0d",                        // S
    "0i4i 2i2c",                                               // T
    "0i0e~0c2c~4c4e4i",                                        // U
    "0i2c4i",                                                  // V
    "0i1c3i5c6i",                                              // W
    "0i4c 4i0c",                                               // X
    "0i2f4i 2f2c",                                             // Y
    "0i4i0c4c",                                                // Z
    "1i0i0b1b",                                                // [
    "0i3b",                                                    // backslash
    "0i1i1b0b",                                                // ]
    "0g1i2g",                                                  // ^
    "0b4b",                                                    // _
    "0i1h",                                                    // `
    "4e~4g2g~0g0e~0c2c~4c4e 4g4c",                             // a
    "0i0c 0e~0g2g~4g4e~4c2c~0c0e",                             // b
    "4f~3g2g~0g0e~0c2c~3c4d",                                  // c
    "4i4c 4e~4g2g~0g0e~0c2c~4c4e",                             // d
    "0e4e~4g2g~0g0e~0c2c~3c4d",                                // e
    "3i2i~1i1h1c 0g3g",                                        // f
    "4g4c~4a2a~1a0b 4e~4g2g~0g0e~0c2c~4c4e",                   // g
    "0i0c 0e~0g2g~4g4e4c",                                     // h
    "0g0c 0i",                                                 // i
    "1g1b~1a0a 1i",                                            // j
    "0i0c 3g0e3c",                                             // k
    "0i0d~0c1c",                                               // l
    "0g0c 0e~0g2g~3g3e3c 3e~3g5g~6g6e6c",                      // m
    "0g0c 0e~0g2g~4g4e4c",                                     // n
    "2g~4g4e~4c2c~0c0e~0g2g",                                  // o
    "0g0a 0e~0g2g~4g4e~4c2c~0c0e",                             // p
    "4g4a 4e~4g2g~0g0e~0c2c~4c4e",                             // q
    "0g0c 0e~0g2g",                                            // r
    "4f~3g2g~0g0f~0e2e~4e4d~4c2c~1c0d",                        // s
    "1i1d~1c2c3c 0g3g",                                        // t
    "0g0e~0c2c~4c4e 4g4c",                                     // u
    "0g2c4g",                                                  // v
    "0g1c3g5c6g",                                              // w
    "0g3c 3g0c",                                               // x
    "0g2c 4g1a0a",                                             // y
    "0g3g0c3c",                                                // z
    "2i~1i1h1f~1e0e~1e1d1c~1b2b",                              // {
    "0i0b",                                                    // |
    "0i~1i1h1f~1e2e~1e1d1c~1b0b",                              // }
    "0e~1g2e~3c4e",                                            // ~
    "0c0g3g3c0c"                                               // any other: a box
};

constexpr double kX = 0.82 / 6, kY = 1.0 / 6;  // size of the grid's squares, capitals being 1 high
constexpr double kSpaceWidth = 0.30;

Glyph Draw(std::string_view letter) {
    Glyph glyph;
    if (letter.empty()) {
        glyph.width = kSpaceWidth;
        return glyph;
    }
    glyph.strokes.emplace_back();
    for (std::size_t i = 0; i < letter.size(); ++i) {
        if (letter[i] == ' ') {
            glyph.strokes.emplace_back();
            continue;
        }
        auto& points = glyph.strokes.back().points;
        const auto point = [&](std::size_t at) {
            return Stroke::Point{kX * (letter[at] - '0'), kY * (letter[at + 1] - 'c')};
        };
        if (letter[i] == '~') {
            const Stroke::Point a = points.back(), b = point(i + 1), c = point(i + 3);
            constexpr int pieces = 8;
            for (int k = 1; k <= pieces; ++k) {
                const double t = static_cast<double>(k) / pieces, s = 1 - t;
                points.push_back(
                    {s * s * a.x + 2 * s * t * b.x + t * t * c.x, s * s * a.y + 2 * s * t * b.y + t * t * c.y});
            }
            i += 4;
        } else {
            points.push_back(point(i));
            i += 1;
        }
    }
    for (const Stroke& stroke : glyph.strokes) {
        for (const Stroke::Point& p : stroke.points) glyph.width = std::max(glyph.width, p.x);
    }
    return glyph;
}

const Glyph& GlyphOf(int character) {
    static const auto glyphs = [] {
        std::vector<Glyph> all;
        for (std::string_view letter : kLetters) all.push_back(Draw(letter));
        return all;
    }();
    return character >= kFirst && character <= kLast ? glyphs[static_cast<std::size_t>(character - kFirst)]
                                                     : glyphs.back();
}

}  // namespace

std::vector<const Glyph*> GlyphsOf(std::string_view text) {
    std::vector<const Glyph*> glyphs;
    for (char c : text) {
        const int byte = static_cast<unsigned char>(c);
        if ((byte & 0xc0) != 0x80) glyphs.push_back(&GlyphOf(byte));  // one for the first byte of each character
    }
    return glyphs;
}

}  // namespace SolidSubdiv::Picture::Internal

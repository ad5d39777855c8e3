// SPDX-License-Identifier: Apache-2.0
// A report with something of everything, and how numbers and bytes are read back from its page.
#pragma once

#include "kit/picture/picture_testing.h"

#include <solidsubdiv/kit/picture/image.h>
#include <solidsubdiv/kit/picture/report_page.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace SolidSubdiv::Picture {

/// A sphere, a smaller one with its heights as values, and a box of lines around them.
struct ExampleShapes {
    Triangles target = MakeSphere(3), fitted = MakeSphere(2, 0.9);
    std::vector<double> heights;
    std::vector<double> corners;
    std::vector<Index> edges;

    ExampleShapes() {
        for (std::size_t v = 0; v < fitted.positions.size(); v += 3) heights.push_back(fitted.positions[v + 1]);
        for (Index v = 0; v < 8; ++v) {
            for (Index k = 0; k < 3; ++k) {
                corners.push_back((v >> k & 1) != 0 ? 1.2 : -1.2);
                const Index other = v ^ (1 << k);
                if (v < other) edges.insert(edges.end(), {v, other});
            }
        }
    }
};

inline Report ExampleReport(const ExampleShapes& shapes) {
    Report report{.title = "ball", .summary = "A ball in a box."};
    report.meshes.push_back(
        {.name = "target", .positions = shapes.target.positions, .triangles = shapes.target.triangles});
    report.meshes.push_back({.name = "fitted",
                             .positions = shapes.fitted.positions,
                             .triangles = shapes.fitted.triangles,
                             .values = shapes.heights,
                             .value_name = "height",
                             .unit = "mm"});
    report.meshes.push_back(
        {.name = "lattice", .positions = shapes.corners, .lines = shapes.edges, .color = Palette::kLattice});
    report.sections.push_back({.title = "Errors",
                               .text = "All of them.",
                               .rows = {{"largest", "0.1 mm"}, {"folded cells", "0"}},
                               .pictures = {{"a red square", EncodePng(Image(5, 4, {1, 0, 0}))}},
                               .plots = {{"a plot", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>"}}});
    return report;
}

/// What stands between `before` and the next `after`, from `start` on; empty where there is none.
inline std::string Between(std::string_view text, std::string_view before, std::string_view after,
                           std::size_t start = 0) {
    const std::size_t begin = text.find(before, start);
    if (begin == std::string_view::npos) return {};
    const std::size_t end = text.find(after, begin + before.size());
    if (end == std::string_view::npos) return {};
    return std::string(text.substr(begin + before.size(), end - begin - before.size()));
}

/// RFC 4648, written without a look at ours.
inline std::vector<std::uint8_t> FromBase64(std::string_view text) {
    std::vector<std::uint8_t> bytes;
    std::uint32_t bits = 0;
    int n_bits = 0;
    for (const char c : text) {
        int digit = 0;
        if (c >= 'A' && c <= 'Z') digit = c - 'A';
        if (c >= 'a' && c <= 'z') digit = c - 'a' + 26;
        if (c >= '0' && c <= '9') digit = c - '0' + 52;
        if (c == '+') digit = 62;
        if (c == '/') digit = 63;
        if (c == '=') break;
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        if ((n_bits += 6) >= 8) bytes.push_back(static_cast<std::uint8_t>(bits >> (n_bits -= 8) & 255));
    }
    return bytes;
}

}  // namespace SolidSubdiv::Picture

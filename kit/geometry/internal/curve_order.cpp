// SPDX-License-Identifier: Apache-2.0
// Hilbert keys, and a radix sort by them.
#include <solidsubdiv/kit/geometry/internal/curve_order.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace SolidSubdiv::Geometry::Internal {

namespace {

constexpr int kBits = 10;  // an axis
constexpr std::uint32_t kCells = 1u << kBits;

/// Ten bits, two zeros between each and the next.
std::uint32_t Spread(std::uint32_t x) {
    x = (x | x << 16) & 0x030000FFu;
    x = (x | x << 8) & 0x0300F00Fu;
    x = (x | x << 4) & 0x030C30C3u;
    return (x | x << 2) & 0x09249249u;
}

}  // namespace

std::uint32_t CurveKey(const float point[3]) {
    std::array<std::uint32_t, 3> x;
    for (std::size_t k = 0; k < 3; ++k) {
        const float t = std::clamp((point[k] + 1) * (kCells / 2), 0.f, static_cast<float>(kCells - 1));
        x[k] = static_cast<std::uint32_t>(t);
    }
    // Undo reflections and exchanges of axes, then a Gray code. Source: skilling2004.
    for (std::uint32_t bit = kCells >> 1; bit > 1; bit >>= 1) {
        for (std::uint32_t& axis : x) {
            if (axis & bit) {
                x[0] ^= bit - 1;
            } else {
                const std::uint32_t exchanged = (x[0] ^ axis) & (bit - 1);
                x[0] ^= exchanged;
                axis ^= exchanged;
            }
        }
    }
    x[1] ^= x[0];
    x[2] ^= x[1];
    std::uint32_t gray = 0;
    for (std::uint32_t bit = kCells >> 1; bit > 1; bit >>= 1) {
        if (x[2] & bit) gray ^= bit - 1;
    }
    return Spread(x[0] ^ gray) << 2 | Spread(x[1] ^ gray) << 1 | Spread(x[2] ^ gray);
}

std::vector<Index> OrderByKey(std::span<const std::uint32_t> keys) {
    struct Row {
        std::uint32_t key;
        Index number;
    };
    Array<Row> rows(keys.size()), sorted(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) rows[i] = {keys[i], static_cast<Index>(i)};
    for (int shift = 0; shift < 3 * kBits; shift += kBits) {
        std::array<std::size_t, kCells> next{};
        for (const Row& row : rows) ++next[row.key >> shift & (kCells - 1)];
        std::exclusive_scan(next.begin(), next.end(), next.begin(), std::size_t{0});
        for (const Row& row : rows) sorted[next[row.key >> shift & (kCells - 1)]++] = row;
        rows.swap(sorted);
    }
    std::vector<Index> order(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) order[i] = rows[i].number;
    return order;
}

}  // namespace SolidSubdiv::Geometry::Internal

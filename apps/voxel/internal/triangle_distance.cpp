// SPDX-License-Identifier: Apache-2.0
// A row of eight voxels at a time: along it everything but the clamped places on edges is linear.
#include <solidsubdiv/apps/voxel/internal/triangle_distance.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace SolidSubdiv::Voxel::Internal {

namespace {

using Vec = std::array<float, 3>;

Vec Minus(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
float Dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec Cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A triangle as rows ask for it. Source: ericson2005, section 5.1.5, with regions told apart by the signs of three
/// planes through the edges.
struct Triangle {
    std::array<Vec, 3> corner, edge, across;  ///< edges go from a corner to the next; `across` points inwards
    std::array<float, 3> inverse_square;      ///< of the edges' lengths; 0 where they have none
    Vec normal;                               ///< of length 1
    bool has_normal;

    explicit Triangle(const std::array<Vec, 3>& v) : corner(v) {
        for (std::size_t i = 0; i < 3; ++i) {
            edge[i] = Minus(v[(i + 1) % 3], v[i]);
            const float square = Dot(edge[i], edge[i]);
            inverse_square[i] = square > 0 ? 1 / square : 0;
        }
        normal = Cross(edge[0], edge[1]);
        const float length = std::sqrt(Dot(normal, normal));
        has_normal = length > 1e-12f;
        for (float& x : normal) x = has_normal ? x / length : 0;
        for (std::size_t i = 0; i < 3; ++i) across[i] = Cross(normal, edge[i]);
    }
};

typedef float Row __attribute__((vector_size(kTileSide * sizeof(float))));

/// One row: x and y are given, z is 0 to 7.
#if defined(__x86_64__)
__attribute__((target_clones("avx2", "default")))
#endif
void LowerRow(const Triangle& t, float x, float y, float* squares) {
    const Row zs = {0, 1, 2, 3, 4, 5, 6, 7}, zero{}, one = zero + 1.0f;
    Row best, before;
    std::memcpy(&before, squares, sizeof before);
    best = before;
    Row least_side = zero;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec &e = t.edge[i], &c = t.corner[i], &n = t.across[i];
        const float dx = x - c[0], dy = y - c[1];
        const Row dz = zs - c[2];
        Row s = (dx * e[0] + dy * e[1] + dz * e[2]) * t.inverse_square[i];
        s = s < zero ? zero : s;
        s = s > one ? one : s;
        const Row rx = dx - s * e[0], ry = dy - s * e[1], rz = dz - s * e[2];
        const Row square = rx * rx + ry * ry + rz * rz;
        best = square < best ? square : best;
        const Row side = dx * n[0] + dy * n[1] + dz * n[2];
        least_side = side < least_side ? side : least_side;
    }
    if (t.has_normal) {
        const Vec &n = t.normal, &c = t.corner[0];
        const Row height = (x - c[0]) * n[0] + (y - c[1]) * n[1] + (zs - c[2]) * n[2];
        const Row square = height * height;
        best = least_side < zero ? best : (square < before ? square : before);
    }
    std::memcpy(squares, &best, sizeof best);
}

}  // namespace

void LowerDistances(const std::array<std::array<float, 3>, 3>& corners, float reach,
                    std::span<float, kTileVoxels> squares) {
    constexpr float kLast = kTileSide - 1;
    int first[2], last[2];
    for (std::size_t c = 0; c < 3; ++c) {
        const float low = std::min({corners[0][c], corners[1][c], corners[2][c]}) - reach;
        const float high = std::max({corners[0][c], corners[1][c], corners[2][c]}) + reach;
        if (low > kLast || high < 0) return;
        if (c == 2) continue;
        first[c] = static_cast<int>(std::ceil(std::max(low, 0.0f)));
        last[c] = static_cast<int>(std::floor(std::min(high, kLast)));
    }
    const Triangle t(corners);
    // How far the middle of the tile, and of a row, may be from the plane.
    const auto height = [&](float x, float y, float z) {
        return std::abs((x - corners[0][0]) * t.normal[0] + (y - corners[0][1]) * t.normal[1] +
                        (z - corners[0][2]) * t.normal[2]);
    };
    constexpr float kMiddle = kLast / 2;
    // A ball around the triangle, from its middle, and all that is within reach.
    Vec middle;
    for (std::size_t c = 0; c < 3; ++c) middle[c] = (corners[0][c] + corners[1][c] + corners[2][c]) / 3;
    float square = 0;
    for (const Vec& v : corners) square = std::max(square, Dot(Minus(v, middle), Minus(v, middle)));
    const float dz = middle[2] - std::clamp(middle[2], 0.0f, kLast), radius = std::sqrt(square) + reach;
    const float around = radius * radius - dz * dz;  // as seen along rows
    if (height(kMiddle, kMiddle, kMiddle) > reach + kMiddle * 1.7321f) return;
    for (int x = first[0]; x <= last[0]; ++x) {
        for (int y = first[1]; y <= last[1]; ++y) {
            const auto fx = static_cast<float>(x), fy = static_cast<float>(y);
            const float dx = fx - middle[0], dy = fy - middle[1];
            if (dx * dx + dy * dy > around) continue;
            if (height(fx, fy, kMiddle) > reach + kMiddle * std::abs(t.normal[2])) continue;
            LowerRow(t, fx, fy, &squares[static_cast<std::size_t>(64 * x + 8 * y)]);
        }
    }
}

}  // namespace SolidSubdiv::Voxel::Internal

// SPDX-License-Identifier: Apache-2.0
// A row of eight voxels at a time: along it everything but the clamped places on edges is linear.
#include <solidsubdiv/apps/voxel/internal/triangle_distance.h>

#include <algorithm>
#include <cmath>

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

/// One row: x and y are given, z is 0 to 7.
#if defined(__x86_64__)
__attribute__((target_clones("avx2", "default")))
#endif
void LowerRow(const Triangle& t, float x, float y, float* squares) {
    float best[kTileSide], is_inside[kTileSide];
    for (int z = 0; z < kTileSide; ++z) {
        best[z] = squares[z];
        is_inside[z] = t.has_normal ? 1.0f : 0.0f;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec e = t.edge[i], c = t.corner[i], n = t.across[i];
        const float dx = x - c[0], dy = y - c[1], dz0 = -c[2], inverse = t.inverse_square[i];
        const float along = dx * e[0] + dy * e[1], over = dx * n[0] + dy * n[1];
        for (int z = 0; z < kTileSide; ++z) {
            const float dz = dz0 + static_cast<float>(z);
            float s = (along + dz * e[2]) * inverse;
            s = s < 0 ? 0 : s;
            s = s > 1 ? 1 : s;
            const float rx = dx - s * e[0], ry = dy - s * e[1], rz = dz - s * e[2];
            const float square = rx * rx + ry * ry + rz * rz;
            best[z] = square < best[z] ? square : best[z];
            is_inside[z] = over + dz * n[2] < 0 ? 0.0f : is_inside[z];
        }
    }
    const float height0 =
        (x - t.corner[0][0]) * t.normal[0] + (y - t.corner[0][1]) * t.normal[1] - t.corner[0][2] * t.normal[2];
    for (int z = 0; z < kTileSide; ++z) {
        const float height = height0 + static_cast<float>(z) * t.normal[2];
        const float square = is_inside[z] > 0 ? height * height : best[z];
        squares[z] = square < best[z] ? square : best[z];
    }
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
    // The circle around the triangle as seen along rows, from its middle.
    const float cx = (corners[0][0] + corners[1][0] + corners[2][0]) / 3;
    const float cy = (corners[0][1] + corners[1][1] + corners[2][1]) / 3;
    float radius = 0;
    for (const Vec& v : corners) radius = std::max(radius, std::hypot(v[0] - cx, v[1] - cy));
    const float around = (radius + reach) * (radius + reach);
    if (height(kMiddle, kMiddle, kMiddle) > reach + kMiddle * 1.7321f) return;
    for (int x = first[0]; x <= last[0]; ++x) {
        for (int y = first[1]; y <= last[1]; ++y) {
            const auto fx = static_cast<float>(x), fy = static_cast<float>(y);
            if ((fx - cx) * (fx - cx) + (fy - cy) * (fy - cy) > around) continue;
            if (height(fx, fy, kMiddle) > reach + kMiddle * std::abs(t.normal[2])) continue;
            LowerRow(t, fx, fy, &squares[static_cast<std::size_t>(64 * x + 8 * y)]);
        }
    }
}

}  // namespace SolidSubdiv::Voxel::Internal

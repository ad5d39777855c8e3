// SPDX-License-Identifier: Apache-2.0
// A row of eight voxels at a time: along it everything but the clamped places on edges is linear.
#include <solidsubdiv/apps/voxel/internal/triangle_distance.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace SolidSubdiv::Voxel::Internal {

namespace {

using Vec = std::array<float, 3>;
using Point = std::array<double, 3>;

Point Minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double Dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point Cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec Single(const Point& p) { return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])}; }

constexpr double kLast = kTileSide - 1, kMiddle = kLast / 2;

/// A triangle as rows ask for it. Source: ericson2005, section 5.1.5, with regions told apart by the signs of three
/// planes through the edges. Edges and plane are given by their points nearest to the tile's middle: so floats will do,
/// however long the triangle is.
struct Triangle {
    std::array<Vec, 3> base, edge, across;  ///< edges go from a corner to the next; `across` points inwards
    std::array<float, 3> first, last;       ///< where the edges' ends are, seen from `base`, in lengths of the edge
    std::array<float, 3> inverse_square;    ///< of the edges' lengths; 0 where they have none
    Vec plane, normal;                      ///< a point, and of length 1
    bool has_normal;

    explicit Triangle(const std::array<Point, 3>& v) {
        constexpr Point middle{kMiddle, kMiddle, kMiddle};
        std::array<Point, 3> edges;
        std::array<double, 3> squares;
        for (std::size_t i = 0; i < 3; ++i) {
            edges[i] = Minus(v[(i + 1) % 3], v[i]);
            squares[i] = Dot(edges[i], edges[i]);
        }
        Point n = Cross(edges[0], edges[1]);
        const double length = std::sqrt(Dot(n, n));
        has_normal = length > 1e-12 * std::max({squares[0], squares[1], squares[2]});
        for (double& x : n) x = has_normal ? x / length : 0;
        const double height = Dot(n, Minus(middle, v[0]));
        plane = Single({kMiddle - height * n[0], kMiddle - height * n[1], kMiddle - height * n[2]});
        normal = Single(n);
        for (std::size_t i = 0; i < 3; ++i) {
            const Point& e = edges[i];
            const double inverse = squares[i] > 0 ? 1 / squares[i] : 0;
            const double s = std::clamp(Dot(Minus(middle, v[i]), e) * inverse, 0.0, 1.0);
            base[i] = Single({v[i][0] + s * e[0], v[i][1] + s * e[1], v[i][2] + s * e[2]});
            first[i] = static_cast<float>(-s);
            last[i] = static_cast<float>(1 - s);
            edge[i] = Single(e);
            inverse_square[i] = static_cast<float>(inverse);
            across[i] = Single(Cross(n, e));
        }
    }
};

typedef float Row __attribute__((vector_size(kTileSide * sizeof(float))));

/// One row: x and y are given, z is 0 to 7.
#if defined(__x86_64__)
__attribute__((target_clones("avx2", "default")))
#endif
void LowerRow(const Triangle& t, float x, float y, float* squares) {
    const Row zs = {0, 1, 2, 3, 4, 5, 6, 7}, zero{};
    Row best, before;
    std::memcpy(&before, squares, sizeof before);
    best = before;
    Row least_side = zero;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec &e = t.edge[i], &c = t.base[i], &n = t.across[i];
        const Row first = zero + t.first[i], last = zero + t.last[i];
        const float dx = x - c[0], dy = y - c[1];
        const Row dz = zs - c[2];
        Row s = (dx * e[0] + dy * e[1] + dz * e[2]) * t.inverse_square[i];
        s = s < first ? first : s;
        s = s > last ? last : s;
        const Row rx = dx - s * e[0], ry = dy - s * e[1], rz = dz - s * e[2];
        const Row square = rx * rx + ry * ry + rz * rz;
        best = square < best ? square : best;
        const Row side = dx * n[0] + dy * n[1] + dz * n[2];
        least_side = side < least_side ? side : least_side;
    }
    if (t.has_normal) {
        const Vec &n = t.normal, &c = t.plane;
        const Row height = (x - c[0]) * n[0] + (y - c[1]) * n[1] + (zs - c[2]) * n[2];
        const Row square = height * height;
        best = least_side < zero ? best : (square < before ? square : before);
    }
    std::memcpy(squares, &best, sizeof best);
}

}  // namespace

void LowerDistances(const std::array<std::array<double, 3>, 3>& corners, float reach,
                    std::span<float, kTileVoxels> squares) {
    int first[2], last[2];
    for (std::size_t c = 0; c < 3; ++c) {
        const double low = std::min({corners[0][c], corners[1][c], corners[2][c]}) - reach;
        const double high = std::max({corners[0][c], corners[1][c], corners[2][c]}) + reach;
        if (low > kLast || high < 0) return;
        if (c == 2) continue;
        first[c] = static_cast<int>(std::ceil(std::max(low, 0.0)));
        last[c] = static_cast<int>(std::floor(std::min(high, kLast)));
    }
    const Triangle t(corners);
    // How far the middle of the tile, and of a row, may be from the plane.
    constexpr auto kHalf = static_cast<float>(kMiddle);
    const auto height = [&](float x, float y, float z) {
        return std::abs((x - t.plane[0]) * t.normal[0] + (y - t.plane[1]) * t.normal[1] +
                        (z - t.plane[2]) * t.normal[2]);
    };
    // A ball around the triangle, from its middle, and all that is within reach.
    Point middle;
    for (std::size_t c = 0; c < 3; ++c) middle[c] = (corners[0][c] + corners[1][c] + corners[2][c]) / 3;
    double square = 0;
    for (const Point& v : corners) square = std::max(square, Dot(Minus(v, middle), Minus(v, middle)));
    const double dz = middle[2] - std::clamp(middle[2], 0.0, kLast), radius = std::sqrt(square) + reach;
    const double around = radius * radius - dz * dz;  // as seen along rows
    if (height(kHalf, kHalf, kHalf) > reach + kHalf * 1.7321f) return;
    for (int x = first[0]; x <= last[0]; ++x) {
        for (int y = first[1]; y <= last[1]; ++y) {
            const double dx = x - middle[0], dy = y - middle[1];
            if (dx * dx + dy * dy > around) continue;
            const auto fx = static_cast<float>(x), fy = static_cast<float>(y);
            if (height(fx, fy, kHalf) > reach + kHalf * std::abs(t.normal[2])) continue;
            LowerRow(t, fx, fy, &squares[static_cast<std::size_t>(64 * x + 8 * y)]);
        }
    }
}

}  // namespace SolidSubdiv::Voxel::Internal

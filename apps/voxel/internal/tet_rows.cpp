// SPDX-License-Identifier: Apache-2.0
// A tet as the points on the inner side of four planes: the planes are found four at a time, and so are the ends of
// rows.
#include <solidsubdiv/apps/voxel/internal/tet_rows.h>

#include <algorithm>
#include <cmath>

namespace SolidSubdiv::Voxel::Internal {

namespace {

typedef double Four __attribute__((vector_size(4 * sizeof(double))));
typedef std::int32_t FourInts __attribute__((vector_size(4 * sizeof(std::int32_t))));

/// Of a tet that is all but flat points may be outside no farther than a thousandth of its height.
constexpr double kSlack = 1e-9, kSlackOfHeight = 1e-3;

// Clones stay in this file: clang 14 does not find them from others.
#if defined(__x86_64__)
__attribute__((target_clones("avx2", "default")))
#endif
std::size_t
FindRowsOf(const Tet& v, const PointGrid& grid, std::span<Row> rows) {
    const Four zero{};
    const double scale = 1 / grid.step;
    Four low = {v[0][0], v[0][1], v[0][2], 0}, high = low;
    for (std::size_t k = 1; k < 4; ++k) {
        const Four corner = {v[k][0], v[k][1], v[k][2], 0};
        low = corner < low ? corner : low;
        high = corner > high ? corner : high;
    }
    // Numbers of the points in its box: the first, and one after the last.
    const Four end = zero + grid.n;
    Four box_first = (low - grid.start) * scale - 1e-6, box_end = (high - grid.start) * scale + (1 + 1e-6);
    box_first = box_first > zero ? (box_first < end ? box_first : end) : zero;
    box_end = box_end > zero ? (box_end < end ? box_end : end) : zero;
    FourInts firsts = __builtin_convertvector(box_first, FourInts);
    firsts -= __builtin_convertvector(__builtin_convertvector(firsts, Four) < box_first, FourInts);
    const FourInts ends = __builtin_convertvector(box_end, FourInts);
    if (firsts[0] >= ends[0] || firsts[1] >= ends[1] || firsts[2] >= ends[2]) return 0;
    // Four planes: a point of each, two edges, and the corner on the inner side.
    std::array<Four, 3> point, p, q, inner;
    for (std::size_t c = 0; c < 3; ++c) {
        const double a = v[0][c], b = v[1][c], d = v[2][c], e = v[3][c];
        point[c] = Four{b, a, a, a};
        p[c] = Four{e, d, e, b} - point[c];
        q[c] = Four{d, e, b, d} - point[c];
        inner[c] = Four{a, b, d, e} - point[c];
    }
    std::array<Four, 3> n = {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
    const Four height = n[0] * inner[0] + n[1] * inner[1] + n[2] * inner[2];
    const double det = std::abs(height[3]);
    if (det == 0) return 0;
    Four size = zero;
    for (Four& x : n) {
        x = height < zero ? -x : x;
        const Four absolute = x < zero ? -x : x;
        size = absolute > size ? absolute : size;
    }
    size *= kSlack;
    const Four most = zero + kSlackOfHeight * det;
    const Four offset = (size < most ? size : most) - n[0] * point[0] - n[1] * point[1] - n[2] * point[2];
    // In z a plane is met at rest * inverse: rows begin there or end there. For an upright one that is at infinity, on
    // the side that leaves all or nothing, or nowhere (no number) where it holds the row itself.
    const Four inverse = -1 / (n[2] + 0.0);  // no -0
    const auto starts = n[2] >= zero;

    const int last_number = grid.n - 1;
    const Four least = zero + std::max(grid.start, low[2] - kSlack);
    const Four greatest = zero + std::min(grid.start + grid.step * last_number, high[2] + kSlack);
    std::size_t n_rows = 0;
    const Four ys = grid.start + grid.step * Four{0, 1, 2, 3};
    for (int x = firsts[0]; x < ends[0]; ++x) {
        const Four of_x = n[0] * (grid.start + grid.step * x) + offset;
        for (int y = firsts[1]; y < ends[1]; y += 4) {
            const Four at = ys + grid.step * y;
            Four first = least, last = greatest;
            for (int f = 0; f < 4; ++f) {
                const Four z = (of_x[f] + n[1][f] * at) * inverse[f];
                if (starts[f]) {
                    first = z > first ? z : first;
                } else {
                    last = z < last ? z : last;
                }
            }
            // Numbers of the first and last point, rounded inwards; what is beyond the grid stays empty.
            first = (first - grid.start) * scale;
            last = (last - grid.start) * scale + 1;
            first = first < end ? first : end;
            last = last > zero ? last : zero;
            FourInts from = __builtin_convertvector(first, FourInts);
            from -= __builtin_convertvector(__builtin_convertvector(from, Four) < first, FourInts);
            const FourInts to = __builtin_convertvector(last, FourInts) - 1;
            const int n_lanes = std::min(4, ends[1] - y);
            for (int k = 0; k < n_lanes; ++k) {
                rows[n_rows] = {static_cast<std::int8_t>(x), static_cast<std::int8_t>(y + k),
                                static_cast<std::int8_t>(from[k]), static_cast<std::int8_t>(to[k])};
                n_rows += from[k] <= to[k];
            }
        }
    }
    return n_rows;
}

}  // namespace

std::size_t FindRows(const Tet& tet, const PointGrid& grid, std::span<Row> rows) { return FindRowsOf(tet, grid, rows); }

}  // namespace SolidSubdiv::Voxel::Internal

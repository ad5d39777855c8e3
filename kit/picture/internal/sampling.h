// SPDX-License-Identifier: Apache-2.0
// Where rays go: sequences that fill the unit square evenly, the same in every run.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <solidsubdiv/kit/picture/internal/vec3.h>

namespace SolidSubdiv::Picture::Internal {

struct Pair {
    float u, v;
};

/// Point i of a sequence in the unit square whose first 4, 16, 64.. points have one in each of 4, 16, 64.. equal
/// squares, and as many in equal columns and rows (Sobol 1967), moved by half the spacing of 16 points in a row.
inline Pair EvenPoint(unsigned i) {
    unsigned x = 0, y = 0;
    unsigned x_bit = 1u << 31, y_bits = 1u << 31;
    for (; i != 0; i >>= 1, x_bit >>= 1, y_bits ^= y_bits >> 1) {
        if (i & 1) x ^= x_bit, y ^= y_bits;
    }
    const auto moved = [](unsigned bits) {
        const double place = bits / 4294967296.0 + 1.0 / 32;
        return static_cast<float>(place < 1 ? place : place - 1);
    };
    return {moved(x), moved(y)};
}

/// Pairs of numbers in [0, 1) for the rays of one pixel: steps of the plane's golden ratio. The 16 pixels of a 4 x 4
/// tile share one sequence, each taking a run of its own: averaged over a tile, every place sees the same rays, without
/// noise.
class PixelSequence {
  public:
    PixelSequence(int x, int y, int n_rays)
        : first_(kOrder[static_cast<std::size_t>(4 * (y & 3) + (x & 3))] * n_rays) {}

    /// Pair i < n_rays. `stream` keeps kinds of rays apart.
    Pair Get(int stream, int i) const {
        const double k = first_ + i + 0.5;
        return {Fraction(stream * 0.381966 + k * 0.7548776662466927),  // 1/p and 1/p^2, where p^3 = p + 1
                Fraction(stream * 0.618034 + k * 0.5698402909980532)};
    }

  private:
    static float Fraction(double x) { return static_cast<float>(x - std::floor(x)); }
    // Neighbours far apart in the sequence: ordered dither.
    static constexpr std::array<int, 16> kOrder{0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
    int first_;
};

/// A point of the unit disc, uniform if the pair is.
inline Pair OnDisc(Pair p) {
    const float radius = std::sqrt(p.u), angle = 2 * std::numbers::pi_v<float> * p.v;
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace SolidSubdiv::Picture::Internal

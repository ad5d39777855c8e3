// SPDX-License-Identifier: Apache-2.0
// Pseudo-random points, the same ones in every run and on every platform.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace SolidSubdiv::Validation {

/// `count` points of [-extent, extent]^3. mt19937_64 is the same everywhere, std's distributions are not.
inline std::vector<std::array<double, 3>> RandomPoints(int count, double extent, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<std::array<double, 3>> points(count);
    for (auto& p : points)
        for (double& c : p) c = extent * (2 * static_cast<double>(random() >> 11) * 0x1p-53 - 1);
    return points;
}

}  // namespace SolidSubdiv::Validation

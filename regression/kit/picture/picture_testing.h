// SPDX-License-Identifier: Apache-2.0
// Shapes with known pictures, and what is measured on a picture.
#pragma once

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <solidsubdiv/kit/picture/internal/srgb.h>
#include <solidsubdiv/kit/picture/render.h>

namespace SolidSubdiv::Picture {

struct Triangles {
    std::vector<double> positions;
    std::vector<Index> triangles;
};

/// A sphere as an octahedron whose triangles are cut into four `levels` times.
inline Triangles MakeSphere(int levels, double radius = 1) {
    Triangles s{{1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1},
                {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<Index, Index>, Index> middles;
        const auto middle = [&](Index a, Index b) {
            const auto [it, is_new] =
                middles.try_emplace(std::minmax(a, b), static_cast<Index>(s.positions.size() / 3));
            if (is_new) {
                double p[3], length = 0;
                for (std::size_t k = 0; k < 3; ++k) {
                    p[k] = s.positions[3 * static_cast<std::size_t>(a) + k] +
                           s.positions[3 * static_cast<std::size_t>(b) + k];
                    length = std::hypot(length, p[k]);
                }
                for (double x : p) s.positions.push_back(x / length);
            }
            return it->second;
        };
        std::vector<Index> finer;
        for (std::size_t t = 0; t < s.triangles.size(); t += 3) {
            const Index a = s.triangles[t], b = s.triangles[t + 1], c = s.triangles[t + 2];
            const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
        }
        s.triangles = std::move(finer);
    }
    for (double& x : s.positions) x *= radius;
    return s;
}

/// A square of the given half side at height z, at right angles to the z axis.
inline Triangles MakeSquare(double z, double half = 1) {
    return {{-half, -half, z, half, -half, z, half, half, z, -half, half, z}, {0, 1, 2, 0, 2, 3}};
}

/// Looks from (0, 0, distance) down the z axis.
inline Camera CameraOnZ(double distance, double half_width, double half_height) {
    return {.position = {0, 0, distance},
            .right = {1, 0, 0},
            .up = {0, 1, 0},
            .forward = {0, 0, -1},
            .half_width = half_width,
            .half_height = half_height,
            .world_up = {0, 1, 0}};
}

/// How much of the white light of the background is missing, summed over pixels: the area, in pixels, of what is black.
inline double Darkness(const Image& image) {
    double sum = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) sum += 1 - static_cast<double>(Internal::DecodeSrgb(image.At(x, y).g));
    }
    return sum;
}

inline int DifferentPixels(const Image& a, const Image& b) {
    int n = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) n += a.At(x, y) == b.At(x, y) ? 0 : 1;
    }
    return n;
}

inline constexpr Color kBlack{0, 0, 0};

}  // namespace SolidSubdiv::Picture

// SPDX-License-Identifier: Apache-2.0
// The slope of a scaled Jacobian by each edge: that of the determinant, less what a longer edge takes.
#include <solidsubdiv/apps/fit/internal/corner_shapes.h>

#include <cmath>

#include <solidsubdiv/apps/fit/internal/vec3.h>

namespace SolidSubdiv::Fit::Internal {

namespace {

struct Edges {
    std::array<Vec3, 3> e{};
    double lengths = 0;  ///< their product

    Edges(const std::array<Index, 4>& corner, std::span<const double> positions) {
        const Vec3 at = PointAt(positions, corner[0]);
        for (std::size_t k = 0; k < 3; ++k) e[k] = PointAt(positions, corner[k + 1]) - at;
        lengths = std::sqrt(Dot(e[0], e[0]) * Dot(e[1], e[1]) * Dot(e[2], e[2]));
    }
    double Quality() const { return lengths > 0 ? Dot(e[0], Cross(e[1], e[2])) / lengths : 0; }
};

}  // namespace

double CornerQuality(const std::array<Index, 4>& corner, std::span<const double> positions) {
    return Edges(corner, positions).Quality();
}

double CornerEnergy(std::span<const std::array<Index, 4>> corners, std::span<const double> enough,
                    std::span<const double> positions, double softness, double factor, std::span<double> slope) {
    const auto root_of = [softness](double q) { return std::sqrt(q * q + 4 * softness * softness); };
    const auto one_over_chi = [softness, root_of](double q) {
        // The second is the same, but has digits where q is negative.
        return q > 0 ? 2 / (q + root_of(q)) : (root_of(q) - q) / (2 * softness * softness);
    };
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto& corner = corners[i];
        const Edges edges(corner, positions);
        const double q = edges.Quality();
        if (q >= enough[i]) continue;
        const double steep = one_over_chi(q), off = steep - one_over_chi(enough[i]);
        sum += off * off;
        if (slope.empty() || !(edges.lengths > 0)) continue;
        const double by_quality = -2 * factor * off * steep / root_of(q);
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& e = edges.e[k];
            const Vec3 by_edge = by_quality * (1 / edges.lengths * Cross(edges.e[(k + 1) % 3], edges.e[(k + 2) % 3]) -
                                               q / Dot(e, e) * e);
            double* const end = &slope[3 * static_cast<std::size_t>(corner[k + 1])];
            double* const start = &slope[3 * static_cast<std::size_t>(corner[0])];
            for (std::size_t c = 0; c < 3; ++c) {
                end[c] += by_edge[c];
                start[c] -= by_edge[c];
            }
        }
    }
    return sum;
}

}  // namespace SolidSubdiv::Fit::Internal

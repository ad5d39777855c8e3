// SPDX-License-Identifier: Apache-2.0
// Exact sums of products in integers, and Jacobi's rotations.
#include <solidsubdiv/kit/geometry/internal/principal_axes.h>

#include <cstdint>
#include <numeric>
#include <vector>

#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Geometry::Internal {

namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

constexpr int kBits = 30;  // of coordinates in [-1, 1]: products have 60
constexpr std::size_t kTask = std::size_t{1} << 14;

/// Sums of coordinates and of products of two; the latter in two parts, so that 2^31 points overflow neither.
struct Sums {
    std::array<std::int64_t, 3> first{};
    std::array<std::array<std::int64_t, 2>, 6> second{};

    void Add(const std::array<std::int64_t, 3>& q) {
        std::size_t k = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            first[i] += q[i];
            for (std::size_t j = i; j < 3; ++j, ++k) {
                const std::int64_t product = q[i] * q[j];
                second[k][0] += product >> kBits;
                second[k][1] += product & ((std::int64_t{1} << kBits) - 1);
            }
        }
    }
    void Add(const Sums& other) {
        for (std::size_t i = 0; i < first.size(); ++i) first[i] += other.first[i];
        for (std::size_t k = 0; k < second.size(); ++k) {
            for (std::size_t part = 0; part < 2; ++part) second[k][part] += other.second[k][part];
        }
    }
};

Matrix CovarianceOf(std::span<const double> points, const Box& box, double half) {
    const std::size_t n_points = points.size() / 3, n_tasks = (n_points + kTask - 1) / kTask;
    std::vector<Sums> parts(n_tasks);
    Sdc::ParallelFor(static_cast<Offset>(n_tasks), 1, [&](Offset begin, Offset end) {
        for (Offset t = begin; t < end; ++t) {
            Sums sums;  // not in `parts`, which threads share
            const std::size_t first = static_cast<std::size_t>(t) * kTask, last = std::min(first + kTask, n_points);
            for (std::size_t i = first; i < last; ++i) {
                std::array<std::int64_t, 3> q;
                for (std::size_t k = 0; k < 3; ++k) {
                    const double x = (points[3 * i + k] - .5 * (box.low[k] + box.high[k])) / half;
                    q[k] = std::llround(std::ldexp(x, kBits));
                }
                sums.Add(q);
            }
            parts[static_cast<std::size_t>(t)] = sums;
        }
    });
    Sums all;
    for (const Sums& part : parts) all.Add(part);

    const double n = static_cast<double>(n_points);
    Matrix covariance;
    std::size_t k = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i; j < 3; ++j, ++k) {
            const double product = std::ldexp(static_cast<double>(all.second[k][0]), -kBits) +
                                   std::ldexp(static_cast<double>(all.second[k][1]), -2 * kBits);
            const double means = std::ldexp(static_cast<double>(all.first[i]) / n, -kBits) *
                                 std::ldexp(static_cast<double>(all.first[j]) / n, -kBits);
            covariance[i][j] = covariance[j][i] = product / n - means;
        }
    }
    return covariance;
}

/// Makes a symmetric matrix diagonal; the columns of the result are its eigenvectors.
Matrix Diagonalize(Matrix& a) {
    Matrix vectors{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (int sweep = 0; sweep < 50; ++sweep) {  // quadratic convergence: some five do
        if (a[0][1] == 0 && a[0][2] == 0 && a[1][2] == 0) break;
        for (std::size_t p = 0; p < 2; ++p) {
            for (std::size_t q = p + 1; q < 3; ++q) {
                if (a[p][q] == 0) continue;
                const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
                const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::hypot(theta, 1.));
                const double c = 1 / std::hypot(t, 1.), s = t * c;
                for (std::size_t k = 0; k < 3; ++k) {
                    const double x = a[k][p], y = a[k][q];
                    a[k][p] = c * x - s * y;
                    a[k][q] = s * x + c * y;
                }
                for (std::size_t k = 0; k < 3; ++k) {
                    const double x = a[p][k], y = a[q][k];
                    a[p][k] = c * x - s * y;
                    a[q][k] = s * x + c * y;
                    const double v = vectors[k][p], w = vectors[k][q];
                    vectors[k][p] = c * v - s * w;
                    vectors[k][q] = s * v + c * w;
                }
                a[p][q] = a[q][p] = 0;
            }
        }
    }
    return vectors;
}

}  // namespace

PrincipalAxes FindPrincipalAxes(std::span<const double> points, const Box& box) {
    PrincipalAxes found;
    const double half = .5 * std::max({box.Extent(0), box.Extent(1), box.Extent(2)});
    if (!(half > 0)) return found;
    Matrix covariance = CovarianceOf(points, box, half);
    const Matrix vectors = Diagonalize(covariance);
    std::array<std::size_t, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return covariance[i][i] > covariance[j][j]; });
    for (std::size_t k = 0; k < 3; ++k) {
        found.variances[k] = covariance[order[k]][order[k]];
        found.axes[k] = {vectors[0][order[k]], vectors[1][order[k]], vectors[2][order[k]]};
    }
    found.axes[2] = Cross(found.axes[0], found.axes[1]);
    return found;
}

}  // namespace SolidSubdiv::Geometry::Internal

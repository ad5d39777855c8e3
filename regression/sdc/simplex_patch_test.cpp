// SPDX-License-Identifier: Apache-2.0
// Laws of box splines in one cell: partition of unity, derivatives against differences, reproduction of linear
// functions, what is on a face seen alike from both sides. (Values: the validator box-spline-regular.)
#include <random>

#include <gtest/gtest.h>
#include <solidsubdiv/sdc/simplex_patch.h>

namespace SolidSubdiv::Sdc {
namespace {

std::vector<double> WeightsAt(const SimplexPatch& patch, const std::array<double, 3>& at, int order = 0) {
    const int n = 1 + SimplexPatch::NDerivatives(patch.dimension(), order);
    std::vector<double> weights(static_cast<std::size_t>(n * patch.n_points()));
    patch.Evaluate(at, order, weights.data());
    return weights;
}

std::array<double, 3> RandomPlace(int dimension, std::mt19937& random) {
    std::exponential_distribution<double> exponential;
    std::array<double, 3> at{};
    double sum = exponential(random);
    for (int i = 0; i < dimension; ++i) sum += at[static_cast<std::size_t>(i)] = exponential(random);
    for (double& x : at) x /= sum;
    return at;
}

class SimplexPatchLaws : public testing::TestWithParam<int> {
  protected:
    const SimplexPatch& patch() const { return GetParam() == 3 ? QuinticTet() : QuarticTriangle(); }
};

TEST_P(SimplexPatchLaws, Weights_SumToOneAndReproduceThePlace) {
    std::mt19937 random(1);
    const std::size_t n = static_cast<std::size_t>(patch().n_points());
    for (int trial = 0; trial < 100; ++trial) {
        const auto at = RandomPlace(GetParam(), random);
        const auto w = WeightsAt(patch(), at, 2);
        for (std::size_t k = 0; k < w.size() / n; ++k) {
            double sum = 0;
            for (std::size_t p = 0; p < n; ++p) sum += w[k * n + p];
            EXPECT_NEAR(sum, k == 0 ? 1 : 0, 1e-12) << k;  // sums of 32 terms below 100 in the second derivatives
        }
        for (std::size_t c = 0; c < static_cast<std::size_t>(GetParam()); ++c) {
            double point = 0, place = patch().corners()[0][c];
            for (std::size_t p = 0; p < n; ++p) point += w[p] * patch().points()[p][c];
            for (std::size_t k = 1; k < patch().corners().size(); ++k) {
                place += at[k - 1] * (patch().corners()[k][c] - patch().corners()[0][c]);
            }
            EXPECT_NEAR(point, place, 1e-13);
        }
    }
}

TEST_P(SimplexPatchLaws, Derivatives_AreDifferences) {
    std::mt19937 random(2);
    const std::size_t n = static_cast<std::size_t>(patch().n_points());
    const std::size_t d = static_cast<std::size_t>(GetParam());
    constexpr double kStep = 1e-5;  // errors: step^2 times third derivatives, about 100; round-off / step
    const auto at = RandomPlace(GetParam(), random);
    const auto w = WeightsAt(patch(), at, 2);
    std::size_t second = 1 + d;
    for (std::size_t a = 0; a < d; ++a) {
        auto plus = at, minus = at;
        plus[a] += kStep;
        minus[a] -= kStep;
        const auto above = WeightsAt(patch(), plus, 1), below = WeightsAt(patch(), minus, 1);
        for (std::size_t p = 0; p < n; ++p) {
            EXPECT_NEAR(w[(1 + a) * n + p], (above[p] - below[p]) / (2 * kStep), 1e-7);
            for (std::size_t b = a; b < d; ++b) {
                const std::size_t first = (1 + b) * n + p;
                EXPECT_NEAR(w[(second + b - a) * n + p], (above[first] - below[first]) / (2 * kStep), 1e-6);
            }
        }
        second += d - a;
    }
}

TEST_P(SimplexPatchLaws, Corners_HaveTheLimitMask) {
    const auto w = WeightsAt(patch(), {});
    EXPECT_NEAR(w[0], GetParam() == 3 ? 2.0 / 5 : 1.0 / 2, 1e-13);
    EXPECT_NEAR(w[1], GetParam() == 3 ? 1.0 / 30 : 1.0 / 12, 1e-13);  // of the tet: along a B edge
    EXPECT_NEAR(w[2], GetParam() == 3 ? 1.0 / 20 : 1.0 / 12, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, SimplexPatchLaws, testing::Values(2, 3));

}  // namespace
}  // namespace SolidSubdiv::Sdc

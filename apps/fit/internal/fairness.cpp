// SPDX-License-Identifier: Apache-2.0
// Four equations, the sum of weights and three coordinates, and as many unknowns as there are neighbours.
#include <solidsubdiv/apps/fit/internal/fairness.h>

#include <Eigen/Dense>

#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Fit::Internal {

namespace {

std::vector<double> WeightsOf(std::span<const double> positions, Index point, std::span<const Index> neighbors) {
    const auto at = [&](Index v) {
        return Eigen::Map<const Eigen::Vector3d>(&positions[3 * static_cast<std::size_t>(v)]);
    };
    const auto n = static_cast<Eigen::Index>(neighbors.size());
    Eigen::Matrix<double, 4, Eigen::Dynamic> equations(4, n);
    double size = 0;
    for (Eigen::Index k = 0; k < n; ++k) {
        const Eigen::Vector3d to = at(neighbors[static_cast<std::size_t>(k)]) - at(point);
        equations.col(k) << 1, to;
        size = std::max(size, to.norm());
    }
    if (!(size > 0)) return {};
    equations.bottomRows(3) /= size;
    const Eigen::Vector4d wanted(1, 0, 0, 0);
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver(equations.rows(), equations.cols());
    solver.setThreshold(1e-9);  // neighbours that lie in a plane but for rounding do
    solver.compute(equations);
    const Eigen::VectorXd weights = solver.solve(wanted);
    if (!((equations * weights - wanted).norm() < 1e-8)) return {};
    return {weights.data(), weights.data() + n};
}

}  // namespace

Far::StencilRows<double> AffineRows(std::span<const double> positions, std::span<const std::vector<Index>> neighbors) {
    const auto n = static_cast<Index>(neighbors.size());
    std::vector<std::vector<double>> weights(neighbors.size());
    Sdc::ParallelFor(n, 64, [&](Offset begin, Offset end) {
        for (Offset i = begin; i < end; ++i) {
            const auto place = static_cast<std::size_t>(i);
            if (neighbors[place].empty()) continue;
            weights[place] = WeightsOf(positions, static_cast<Index>(i), neighbors[place]);
        }
    });
    Far::StencilRows<double> rows;
    rows.n_sources = n;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        for (std::size_t k = 0; k < weights[i].size(); ++k) {
            rows.indices.push_back(neighbors[i][k]);
            rows.weights.push_back(weights[i][k]);
        }
        rows.offsets.push_back(static_cast<Offset>(rows.indices.size()));
    }
    return rows;
}

}  // namespace SolidSubdiv::Fit::Internal

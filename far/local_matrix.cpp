// SPDX-License-Identifier: Apache-2.0
// Local matrices by themselves, and the limit masks that are their left eigenvectors.
#include <solidsubdiv/far/local_matrix.h>

#include <algorithm>
#include <cmath>

#include <solidsubdiv/far/internal/local_matrix.h>
#include <solidsubdiv/far/internal/vertex_star.h>
#include <solidsubdiv/far/internal/with_rows.h>

namespace SolidSubdiv::Far {

namespace {

/// row * matrix
std::vector<double> Multiply(const std::vector<double>& row, const LocalMatrix& m) {
    const std::size_t n = row.size();
    std::vector<double> product(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) product[j] += row[i] * m.weights[i * n + j];
    }
    return product;
}

double LargestDifference(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

}  // namespace

std::optional<LocalMatrix> MakeLocalMatrix(const Level& level, const Sdc::Scheme& scheme, Index vertex) {
    std::optional<LocalMatrix> matrix;
    Internal::WithTetOctScheme(scheme, [&]<class Scheme>(const Scheme& s) {
        const Sharpness smooth;
        const Internal::Rows<Scheme> rows(level, smooth, s);
        matrix = Internal::MakeLocalMatrix(level, rows, vertex);
    });
    return matrix;
}

std::optional<LocalMatrix> MakeLocalMatrix(const Vtr::PolyhedralLevel& level, const Sdc::Scheme& scheme, Index vertex) {
    std::optional<LocalMatrix> matrix;
    Internal::WithPolyhedralScheme(scheme, [&](const auto& s) {
        matrix = Internal::VertexStar(level, {}, vertex).Matrix(s.polyhedral(), Internal::CreaseOptionsOf(s).method);
    });
    return matrix;
}

std::vector<double> LimitMaskOf(const LocalMatrix& m) {
    // In regular places it is known: neighbours with a link of six have 1/20, those with a link of four 1/30. A link of
    // four shows in the neighbour's own row, whose two ends weigh 1/4 then.
    const std::size_t n = m.ring.size();
    std::vector<double> row(n, 0.4);
    for (std::size_t i = 1; i < n; ++i) row[i] = m.weights[i * n] > 0.28 ? 1.0 / 20 : 1.0 / 30;
    if (n == 15 && LargestDifference(Multiply(row, m), row) < 1e-15) return row;

    constexpr int kMaxSteps = 5000;
    row.assign(n, 0.0);
    row[0] = 1;
    double change_before = 1;
    for (int step = 0; step < kMaxSteps; ++step) {
        std::vector<double> next = Multiply(row, m);
        const double change = LargestDifference(next, row);
        row = std::move(next);
        if (!(change < 1e6)) break;
        // Settled: what is left is round-off, which no longer shrinks.
        if (change == 0 || (change < 1e-14 && change >= change_before)) {
            double sum = 0;
            for (double w : row) sum += w;
            for (double& w : row) w /= sum;
            return row;
        }
        change_before = change;
    }
    return {};
}

}  // namespace SolidSubdiv::Far

// SPDX-License-Identifier: Apache-2.0
// Local matrices from the rows of the vertex, its edges and its octahedra.
#include <solidsubdiv/far/local_matrix.h>

#include <algorithm>
#include <cmath>

#include <solidsubdiv/far/internal/rows.h>

namespace SolidSubdiv::Far {

namespace {

template <class Scheme>
std::optional<LocalMatrix> Make(const Level& level, const Scheme& scheme, Index vertex) {
    const Internal::Rows<Scheme> rows(level, scheme);
    LocalMatrix m;
    Internal::RowBuffer<double> row;
    row.Read(rows, rows.ChildOfVertex(vertex));
    m.ring.assign(row.Indices().begin(), row.Indices().end());
    const std::size_t n = m.ring.size();
    m.weights.assign(n * n, 0.0);
    bool closed = true;

    const auto place = [&](Index v) {
        return static_cast<std::size_t>(std::find(m.ring.begin(), m.ring.end(), v) - m.ring.begin());
    };
    std::vector<bool> has_row(n, false);
    const auto set_row = [&](std::size_t i) {
        for (std::size_t k = 0; k < row.n; ++k) {
            const std::size_t column = place(row.indices[k]);
            if (column == n) {
                closed = false;
            } else {
                m.weights[i * n + column] += row.weights[k];
            }
        }
        has_row[i] = true;
    };
    set_row(0);

    for (Index e : level.vertex_edges[vertex]) {
        const auto ends = level.EdgeVertices(e);
        const std::size_t i = place(ends[0] + ends[1] - vertex);
        if (i == n) continue;  // an edge that the rule at the vertex does not see
        row.Read(rows, rows.ChildOfEdge(e));
        set_row(i);
    }
    // What is left are vertices opposite in octahedra; their successors are the centres.
    const auto octs = level.vertex_octs[vertex];
    const auto locals = level.vertex_octs.Locals(vertex);
    for (std::size_t k = 0; k < octs.size(); ++k) {
        const std::size_t i = place(level.OctVertices(octs[k])[Sdc::Oct::Opposite(locals[k])]);
        if (i == n || has_row[i]) continue;
        row.Read(rows, rows.ChildOfOct(octs[k]));
        set_row(i);
    }
    if (!closed || std::find(has_row.begin(), has_row.end(), false) != has_row.end()) return std::nullopt;
    return m;
}

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
    return std::visit([&](const auto& s) { return Make(level, s, vertex); }, scheme);
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

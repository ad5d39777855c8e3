// SPDX-License-Identifier: Apache-2.0
// Limit masks: closed forms where there are any, otherwise powers of the local matrix.
#include <solidsubdiv/far/limit_stencil_table.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <solidsubdiv/far/internal/rows.h>
#include <solidsubdiv/far/internal/scheme_check.h>
#include <solidsubdiv/far/local_matrix.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Far {

namespace {

struct MaskRow {
    std::vector<Index> indices;
    std::vector<double> weights;
};

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

/// The row that the vertex's row in powers of the matrix settles to; empty if it does not.
std::vector<double> LeftEigenvector(const LocalMatrix& m) {
    // In regular places it is known: neighbours with a link of six have 1/20, those with a link of four 1/30. A link of
    // four shows in the neighbour's own row, whose two ends weigh 1/4 then.
    const std::size_t n = m.ring.size();
    std::vector<double> row(n, 0.4);
    for (std::size_t i = 1; i < n; ++i) row[i] = m.weights[i * n] > 0.28 ? 1.0 / 20 : 1.0 / 30;
    constexpr double kSettled = 1e-17;
    if (n == 15 && LargestDifference(Multiply(row, m), row) < 1e-15) return row;

    constexpr int kMaxSteps = 5000;
    row.assign(n, 0.0);
    row[0] = 1;
    for (int step = 0; step < kMaxSteps; ++step) {
        std::vector<double> next = Multiply(row, m);
        const double change = LargestDifference(next, row);
        row = std::move(next);
        if (!(change < 1e6)) break;
        if (change < kSettled) {
            double sum = 0;
            for (double w : row) sum += w;
            for (double& w : row) w /= sum;
            return row;
        }
    }
    return {};
}

/// Whether every edge of v's surface is smooth: not so where a sheet meets a solid's boundary, whose edges follow the
/// curve rule there.
bool HasSmoothRing(const Level& level, Index v) {
    for (Index e : level.vertex_edges[v]) {
        const Vtr::Tag edge = level.edge_tags[e];
        if (edge.rule() == Vtr::Rule::Curve && edge.in_face()) return false;
    }
    return true;
}

template <class Scheme>
MaskRow LimitOf(const Level& level, const Scheme& scheme, Index v) {
    const Internal::Rows<Scheme> rows(level, scheme);
    MaskRow mask;
    mask.indices.resize(static_cast<std::size_t>(rows.VertexLength(v)));
    mask.weights.resize(mask.indices.size());
    rows.FillVertex(v, mask.indices.data(), mask.weights.data());
    const int n = static_cast<int>(mask.indices.size()) - 1;
    const auto set = [&](const Sdc::RingWeights& w) {
        std::fill(mask.weights.begin(), mask.weights.end(), w.neighbor);
        mask.weights[0] = w.self;
    };
    if (n == 0) return mask;
    const Vtr::Rule rule = level.vertex_tags[v].rule();
    if (rule == Vtr::Rule::Surface && HasSmoothRing(level, v)) {
        set(scheme.surface().Limit(n));
    } else if (rule == Vtr::Rule::Curve) {
        set(scheme.curve().Limit());
    } else {
        const auto m = MakeLocalMatrix(level, scheme, v);
        mask.weights = m ? LeftEigenvector(*m) : std::vector<double>{};
        if (mask.weights.empty()) mask.indices.clear();
    }
    return mask;
}

}  // namespace

LimitStencilTable LimitStencilTable::Create(const TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                                            const LimitStencilTableOptions& options) {
    Internal::CheckScheme(refiner.level(0), scheme);
    const int l = options.level < 0 ? refiner.max_level() : options.level;
    if (l > refiner.max_level() || !refiner.level(l).is_full) {
        throw InvalidInput("limits at level " + std::to_string(l) +
                           " need its full topology: refine with full_topology_in_last_level");
    }
    const Level& level = refiner.level(l);
    std::vector<MaskRow> masks(level.n_vertices);
    constexpr Offset kGrain = 256;
    Sdc::ParallelFor(level.n_vertices, kGrain, [&](Offset begin, Offset end) {
        for (Offset v = begin; v < end; ++v) {
            masks[v] = std::visit([&](const auto& s) { return LimitOf(level, s, static_cast<Index>(v)); }, scheme);
        }
    });

    LimitStencilTable table;
    table.rows_.n_sources = level.n_vertices;
    table.rows_.offsets.assign(1, 0);
    for (Index v = 0; v < level.n_vertices; ++v) {
        if (masks[v].indices.empty()) table.without_limit_.push_back(v);
        table.rows_.indices.insert(table.rows_.indices.end(), masks[v].indices.begin(), masks[v].indices.end());
        table.rows_.weights.insert(table.rows_.weights.end(), masks[v].weights.begin(), masks[v].weights.end());
        table.rows_.offsets.push_back(static_cast<Offset>(table.rows_.indices.size()));
    }
    return table;
}

}  // namespace SolidSubdiv::Far

// SPDX-License-Identifier: Apache-2.0
// Which closed form a scheme has, and its evaluation.
#include <solidsubdiv/far/internal/regular_patch.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include <solidsubdiv/sdc/simplex_patch.h>

namespace SolidSubdiv::Far::Internal {

namespace {

using At = std::array<double, 3>;

/// Adds a patch's weights to the block's rows.
void Scatter(const double* weights, std::span<const Index> vertices, LimitBlock& block) {
    const std::size_t n = vertices.size();
    for (std::size_t p = 0; p < n; ++p) {
        double* row = block.Row(vertices[p]);
        for (std::size_t c = 0; c < static_cast<std::size_t>(block.n_columns); ++c) row[c] += weights[c * n + p];
    }
}

std::size_t QuarterOf(const At& at) { return (at[1] < 0 ? 1u : 0u) + (at[2] < 0 ? 2u : 0u); }

/// Uniform cubic B-splines at x in [0, 1] and their two derivatives: weights of the points -1, 0, 1, 2. At an end the
/// point beyond is the last but one, reflected.
std::array<std::array<double, 4>, 3> CubicBasis(double x, const std::array<bool, 2>& ends) {
    const double y = 1 - x;
    std::array<std::array<double, 4>, 3> basis{
        {{y * y * y / 6, (4 - 3 * x * x * (2 - x)) / 6, (4 - 3 * y * y * (2 - y)) / 6, x * x * x / 6},
         {-y * y / 2, x * (3 * x - 4) / 2, y * (4 - 3 * y) / 2, x * x / 2},
         {y, 3 * x - 2, 3 * y - 2, x}}};
    for (auto& b : basis) {
        if (ends[0]) {
            b[1] += 2 * b[0];
            b[2] -= b[0];
            b[0] = 0;
        }
        if (ends[1]) {
            b[2] += 2 * b[3];
            b[1] -= b[3];
            b[3] = 0;
        }
    }
    return basis;
}

}  // namespace

std::vector<Index> InAxes(std::span<const Index> corners) {
    if (corners.size() == 4) return {corners[0], corners[1], corners[3], corners[2]};
    return {corners[0], corners[1], corners[3], corners[2], corners[4], corners[5], corners[7], corners[6]};
}

void ChangeCoordinates(const std::array<std::array<double, 3>, 3>& by, int dimension, int order, std::size_t n,
                       double* weights) {
    const std::size_t d = static_cast<std::size_t>(dimension);
    const auto second = [&](std::size_t a, std::size_t b) {  // column of the derivative by a and b
        if (a > b) std::swap(a, b);
        return 1 + d + (a == 0 ? b : a == 1 ? d + b - 1 : 2 * d - 1);
    };
    for (std::size_t p = 0; order >= 1 && p < n; ++p) {
        std::array<double, 10> old{}, fresh{};
        const std::size_t n_columns = static_cast<std::size_t>(1 + Sdc::SimplexPatch::NDerivatives(dimension, order));
        for (std::size_t c = 0; c < n_columns; ++c) old[c] = weights[c * n + p];
        fresh[0] = old[0];
        for (std::size_t a = 0; a < d; ++a) {
            for (std::size_t i = 0; i < d; ++i) fresh[1 + a] += by[i][a] * old[1 + i];
            for (std::size_t b = a; order >= 2 && b < d; ++b) {
                for (std::size_t i = 0; i < d; ++i) {
                    for (std::size_t k = 0; k < d; ++k) {
                        fresh[second(a, b)] += by[i][a] * by[k][b] * old[second(i, k)];
                    }
                }
            }
        }
        for (std::size_t c = 0; c < n_columns; ++c) weights[c * n + p] = fresh[c];
    }
}

RegularRule RegularRuleOf(const Sdc::Scheme& scheme, Elements elements) {
    return std::visit(
        [&]<class S>(const S& s) {
            if constexpr (std::is_same_v<S, Sdc::LinearSolid> || std::is_same_v<S, Sdc::LinearSurface>) {
                return RegularRule::Linear;
            } else if constexpr (requires { s.polyhedral(); }) {
                return RegularRule::Cubic;
            } else if constexpr (std::is_same_v<decltype(s.surface()), Sdc::LoopSurface>) {
                if (elements == Elements::BoundaryFaces) return RegularRule::BoxSpline;
                if constexpr (std::is_same_v<S, Sdc::BoxSpline>) {
                    const bool is_box_spline =
                        s.edge_rule == Sdc::EdgeRule::BoxSpline && s.diagonals == Sdc::Diagonals::Directional;
                    return is_box_spline ? RegularRule::BoxSpline : RegularRule::None;
                }
                return RegularRule::None;
            } else {
                return RegularRule::None;
            }
        },
        scheme);
}

int NDerivatives(Elements elements, int order) {
    return Sdc::SimplexPatch::NDerivatives(elements == Elements::Cells ? 3 : 2, order);
}

std::optional<RegularPatch> RegularPatch::Find(const Pocket& pocket, RegularRule rule) {
    const bool has_cells =
        !pocket.tets.empty() || !pocket.octs.empty() || !pocket.hexes.empty() || pocket.cell_offsets.size() > 1;
    if (pocket.root == RootKind::Face && has_cells) return std::nullopt;
    switch (rule) {
        case RegularRule::BoxSpline:
            return pocket.root == RootKind::Face ? FindTriangles(pocket) : FindTets(pocket);
        case RegularRule::Cubic:
            return FindGrid(pocket);
        case RegularRule::Linear:
            return FindLinear(pocket);
        default:
            return std::nullopt;
    }
}

std::optional<RegularPatch> RegularPatch::FindLinear(const Pocket& pocket) {
    RegularPatch patch;
    const auto take = [&](std::span<const Index> corners) {
        patch.points_.assign(corners.begin(), corners.end());
        const bool is_simplex = pocket.root == RootKind::Tet || corners.size() == 3;
        patch.kind_ = is_simplex ? Kind::LinearSimplex : Kind::LinearGrid;
        if (!is_simplex) patch.points_ = InAxes(corners);
    };
    if (pocket.root == RootKind::Tet) {
        take({pocket.tets.data(), 4});
    } else if (pocket.root == RootKind::Hex) {
        take({pocket.hexes.data(), 8});
    } else if (pocket.root == RootKind::Face && (pocket.n_root_vertices == 4 || pocket.is_tet_oct)) {
        take(pocket.faces[0]);
        patch.dimension_ = 2;
    } else {
        return std::nullopt;
    }
    return patch;
}

void RegularPatch::Evaluate(const At& at, int order, LimitBlock& block) const {
    const std::size_t n_columns = static_cast<std::size_t>(block.n_columns);
    switch (kind_) {
        case Kind::Tet:
        case Kind::Triangle: {
            std::array<double, 10 * 32> weights;
            (kind_ == Kind::Tet ? Sdc::QuinticTet() : Sdc::QuarticTriangle()).Evaluate(at, order, weights.data());
            return Scatter(weights.data(), points_, block);
        }
        case Kind::Oct:
            return EvaluateOct(at, order, block);
        case Kind::Grid:
        case Kind::LinearGrid:
            return EvaluateGrid(at, order, block);
        case Kind::LinearSimplex: {
            double rest = 1;
            for (std::size_t i = 1; i < points_.size(); ++i) {
                double* row = block.Row(points_[i]);
                row[0] += at[i - 1];
                rest -= at[i - 1];
                if (n_columns > 1) {
                    row[i] += 1;
                    block.Row(points_[0])[i] -= 1;
                }
            }
            block.Row(points_[0])[0] += rest;
        }
    }
}

/// In the quarter of the point the major diagonal's ends weigh (rest + u) / 2 and (rest - u) / 2, the others |v|, |w|.
void RegularPatch::EvaluateOct(const At& at, int order, LimitBlock& block) const {
    constexpr std::size_t kPoints = 32;
    const std::size_t q = QuarterOf(at);
    const double v = std::abs(at[1]), w = std::abs(at[2]);
    const double dv = at[1] < 0 ? -1 : 1, dw = at[2] < 0 ? -1 : 1;
    std::array<double, 10 * kPoints> weights;
    Sdc::QuinticTet().Evaluate({(1 - v - w - at[0]) / 2, v, w}, order, weights.data());
    // The tet's coordinates by the octahedron's.
    const std::array<std::array<double, 3>, 3> by{{{-0.5, -0.5 * dv, -0.5 * dw}, {0, dv, 0}, {0, 0, dw}}};
    ChangeCoordinates(by, 3, order, kPoints, weights.data());
    Scatter(weights.data(), {points_.data() + q * kPoints, kPoints}, block);
}

void RegularPatch::EvaluateGrid(const At& at, int order, LimitBlock& block) const {
    const std::size_t d = static_cast<std::size_t>(dimension_);
    const bool is_linear = kind_ == Kind::LinearGrid;
    const int n = is_linear ? 2 : 4;
    std::array<std::array<std::array<double, 4>, 3>, 3> basis{};  // of each axis and order
    for (std::size_t a = 0; a < 3; ++a) {
        if (a >= d) {
            basis[a][0][0] = 1;
        } else if (is_linear) {
            basis[a][0] = {1 - at[a], at[a], 0, 0};
            basis[a][1] = {-1, 1, 0, 0};
        } else {
            basis[a] = CubicBasis(at[a], ends_[a]);
        }
    }
    std::array<std::array<std::size_t, 3>, 10> columns{};  // orders along the axes
    std::size_t n_columns = 1;
    for (std::size_t a = 0; order >= 1 && a < d; ++a) ++columns[n_columns++][a];
    for (std::size_t a = 0; order >= 2 && a < d; ++a) {
        for (std::size_t b = a; b < d; ++b) ++columns[n_columns][a], ++columns[n_columns++][b];
    }
    std::size_t point = 0;
    const int depth = d == 3 ? n : 1;
    for (int k = 0; k < depth; ++k) {
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i, ++point) {
                if (points_[point] == kNoIndex) continue;
                double* row = block.Row(points_[point]);
                for (std::size_t c = 0; c < n_columns; ++c) {
                    row[c] += basis[0][columns[c][0]][i] * basis[1][columns[c][1]][j] * basis[2][columns[c][2]][k];
                }
            }
        }
    }
}

}  // namespace SolidSubdiv::Far::Internal

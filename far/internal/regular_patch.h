// SPDX-License-Identifier: Apache-2.0
// Limits in closed form: what a scheme makes of an element whose pocket is a piece of its regular lattice.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <solidsubdiv/far/internal/pocket.h>

namespace SolidSubdiv::Far::Internal {

/// Weights of a pocket's vertices: for each vertex its weight in the point, then in the derivatives, 1 + n numbers.
struct LimitBlock {
    int n_columns = 1;
    std::vector<double> weights;

    void Reset(Index n_vertices, int columns) {
        n_columns = columns;
        weights.assign(static_cast<std::size_t>(n_vertices) * static_cast<std::size_t>(columns), 0.0);
    }
    /// Leaves the first columns alone.
    void Keep(int columns) {
        if (columns == n_columns) return;
        const std::size_t n = weights.size() / static_cast<std::size_t>(n_columns);
        std::vector<double> kept;
        for (std::size_t i = 0; i < n; ++i) {
            const double* row = Row(static_cast<Index>(i));
            kept.insert(kept.end(), row, row + columns);
        }
        weights = std::move(kept);
        n_columns = columns;
    }
    double* Row(Index vertex) {
        return weights.data() + static_cast<std::size_t>(vertex) * static_cast<std::size_t>(n_columns);
    }
    const double* Row(Index vertex) const { return const_cast<LimitBlock*>(this)->Row(vertex); }
};

/// What a scheme is on its regular lattice.
enum class RegularRule { None, BoxSpline, Cubic, Linear };
RegularRule RegularRuleOf(const Sdc::Scheme& scheme, Elements elements);

/// Derivatives by all coordinates: 0, d, d + d (d + 1) / 2 of them for the orders 0, 1, 2 in dimension d.
int NDerivatives(Elements elements, int order);

/// Turns n weights and, after them, n a derivative (as Sdc::SimplexPatch lists them) by old coordinates into those by
/// new ones: by[i][a] is the derivative of old coordinate i by new coordinate a.
void ChangeCoordinates(const std::array<std::array<double, 3>, 3>& by, int dimension, int order, std::size_t n,
                       double* weights);

/// Corners of a quadrilateral or a hexahedron in the order of axes: bit a of the place is coordinate a.
std::vector<Index> InAxes(std::span<const Index> corners);

/// The four tets of an octahedron around its major diagonal, by which of (v2, v3) and (v4, v5) they have.
constexpr std::size_t kQuarters = 4;

class RegularPatch {
  public:
    /// Nothing where the pocket is not regular.
    static std::optional<RegularPatch> Find(const Pocket& pocket, RegularRule rule);

    /// Fills block, made for the pocket: its point and derivatives up to `order` at a place of the root.
    void Evaluate(const std::array<double, 3>& at, int order, LimitBlock& block) const;

  private:
    enum class Kind { Tet, Oct, Triangle, Grid, LinearSimplex, LinearGrid };
    static std::optional<RegularPatch> FindTets(const Pocket& pocket);
    static std::optional<RegularPatch> FindTriangles(const Pocket& pocket);
    static std::optional<RegularPatch> FindGrid(const Pocket& pocket);
    static std::optional<RegularPatch> FindLinear(const Pocket& pocket);

    void EvaluateOct(const std::array<double, 3>& at, int order, LimitBlock& block) const;
    void EvaluateGrid(const std::array<double, 3>& at, int order, LimitBlock& block) const;

    Kind kind_ = Kind::Tet;
    int dimension_ = 3;
    /// The pocket's vertices by the patch's points: of an octahedron, of its four tets, one after another; of a grid,
    /// 4^d of them, kNoIndex where the mesh has ended.
    std::vector<Index> points_;
    std::array<std::array<bool, 2>, 3> ends_{};  ///< grids: sides of the root where the mesh ends
};

}  // namespace SolidSubdiv::Far::Internal

// SPDX-License-Identifier: Apache-2.0
// Builds the octet truss from unit cubes: each cube is six tets around its diagonal (1,1,1), one per order of the axes.
#include "octet_truss.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace SolidSubdiv::Validation {
namespace {

LatticePoint Plus(const LatticePoint& a, const LatticePoint& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
LatticePoint Minus(const LatticePoint& a, const LatticePoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
LatticePoint Unit(int axis) { return kDirections[axis]; }
constexpr LatticePoint kOnes = {1, 1, 1};

// A B edge of the lattice, from `base` to `base + (1,1,1) - e_axis`. Tells which of them are diagonals of octahedra.
class DiagonalChoice {
  public:
    DiagonalChoice(const LatticePoint& size, TrussCells cells, int diagonal_axis)
        : size_(size), cells_(cells), diagonal_axis_(diagonal_axis) {}

    bool IsDiagonal(const LatticePoint& base, int axis) const {
        if (cells_ == TrussCells::Tets) return false;
        // The octahedron reaches from base - e_axis to base + (1,1,1).
        for (int i = 0; i < 3; ++i)
            if (base[i] + 1 > size_[i] || base[i] < (i == axis ? 1 : 0)) return false;
        if (cells_ == TrussCells::ParallelDiagonals) return axis == diagonal_axis_;
        // A tet of the coarse block runs 0, 2 e_p, 2 (e_p + e_q), (2,2,2) from an even point. The midpoints of its B
        // edges, first to third and second to fourth vertex, are e_p + e_q and (1,1,1) + e_p: base has two odd
        // coordinates, p and q, and the diagonal is (1,1,1) - e_q.
        const int odd = (base[0] & 1) + (base[1] & 1) + (base[2] & 1);
        return odd == 2 && (base[axis] & 1) == 1;
    }

  private:
    LatticePoint size_;
    TrussCells cells_;
    int diagonal_axis_;
};

void AddCube(TrussBlock& block, const LatticePoint& corner, const DiagonalChoice& choice) {
    std::array<int, 3> axes = {0, 1, 2};
    do {
        const auto [p, q, r] = axes;
        const LatticePoint first = Plus(corner, Unit(p)), second = Plus(first, Unit(q)), last = Plus(corner, kOnes);
        // Three steps corner, first, second, last; the B edges skip one: corner-second lacks e_r, first-last lacks e_p.
        if (choice.IsDiagonal(corner, r) || choice.IsDiagonal(first, p)) continue;
        std::array<int, 4> tet = {block.VertexAt(corner), block.VertexAt(second), block.VertexAt(first),
                                  block.VertexAt(last)};
        if (SixVolumes(corner, second, first, last) < 0) std::swap(tet[2], tet[3]);
        block.tets.push_back(tet);
    } while (std::next_permutation(axes.begin(), axes.end()));
}

void AddOctahedron(TrussBlock& block, const LatticePoint& base, int axis) {
    // (axis + 1, axis + 2, axis) is an even permutation: this order of the ring is positive for all three directions.
    const LatticePoint i = Unit((axis + 1) % 3), j = Unit((axis + 2) % 3), k = Unit(axis);
    const std::array<LatticePoint, 6> corners = {base,          Plus(Plus(base, i), j), Plus(base, i),
                                                 Plus(base, j), Minus(base, k),         Plus(base, kOnes)};
    std::array<int, 6> oct{};
    for (int v = 0; v < 6; ++v) oct[v] = block.VertexAt(corners[v]);
    block.octs.push_back(oct);
}

}  // namespace

EdgeKind ClassifyEdge(const LatticePoint& a, const LatticePoint& b) {
    // Homogeneous coordinates (d1, d2, d3, 0): a step along u_k or back raises one of the four or lowers it, u_i + u_j
    // raises two.
    const LatticePoint d = Minus(b, a);
    const auto [low, high] = std::minmax({d[0], d[1], d[2], 0});
    if (high - low != 1) return EdgeKind::None;
    const int raised = static_cast<int>(std::count(d.begin(), d.end(), high)) + (high == 0 ? 1 : 0);
    return raised == 2 ? EdgeKind::B : EdgeKind::A;
}

int TrussBlock::VertexAt(const LatticePoint& p) const { return p[0] + (size[0] + 1) * (p[1] + (size[1] + 1) * p[2]); }

bool TrussBlock::Contains(const LatticePoint& p) const {
    for (int i = 0; i < 3; ++i)
        if (p[i] < 0 || p[i] > size[i]) return false;
    return true;
}

TrussBlock MakeTrussBlock(const LatticePoint& size, TrussCells cells, int diagonal_axis) {
    for (int i = 0; i < 3; ++i) {
        if (size[i] < 1)
            throw std::invalid_argument("octet truss: size " + std::to_string(size[i]) + ", give at least 1");
        if (cells == TrussCells::RefinedOnce && size[i] % 2 != 0)
            throw std::invalid_argument("octet truss: size " + std::to_string(size[i]) +
                                        ", a refined block has even sizes");
    }
    if (diagonal_axis < 0 || diagonal_axis > 2)
        throw std::invalid_argument("octet truss: axis " + std::to_string(diagonal_axis) + ", give 0, 1 or 2");

    TrussBlock block;
    block.size = size;
    for (int z = 0; z <= size[2]; ++z)
        for (int y = 0; y <= size[1]; ++y)
            for (int x = 0; x <= size[0]; ++x) block.vertices.push_back({x, y, z});

    const DiagonalChoice choice(size, cells, diagonal_axis);
    for (const LatticePoint& p : block.vertices) {
        if (p[0] < size[0] && p[1] < size[1] && p[2] < size[2]) AddCube(block, p, choice);
        for (int axis = 0; axis < 3; ++axis)
            if (choice.IsDiagonal(p, axis)) AddOctahedron(block, p, axis);
    }
    return block;
}

std::vector<std::array<int, 4>> TetrahedralView(const TrussBlock& block) {
    std::vector<std::array<int, 4>> tets = block.tets;
    for (const auto& v : block.octs) {
        const std::array<int, 4> ring = {v[2], v[4], v[3], v[5]};
        for (int i = 0; i < 4; ++i) tets.push_back({v[0], v[1], ring[i], ring[(i + 1) % 4]});
    }
    return tets;
}

int SixVolumes(const LatticePoint& v0, const LatticePoint& v1, const LatticePoint& v2, const LatticePoint& v3) {
    const LatticePoint a = Minus(v1, v0), b = Minus(v2, v0), c = Minus(v3, v0);
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

std::array<double, 3> BccPosition(const std::array<double, 3>& p) {
    return {p[0] + p[1] - p[2], p[0] - p[1] + p[2], p[0] - p[1] - p[2]};
}

}  // namespace SolidSubdiv::Validation

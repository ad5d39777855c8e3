// SPDX-License-Identifier: Apache-2.0
// Barycentric coordinates where the origin is inside, the nearest of four triangles where it is not.
#include <solidsubdiv/kit/geometry/internal/nearest_in_tet.h>

#include <solidsubdiv/kit/geometry/internal/nearest_in_triangle.h>
#include <solidsubdiv/sdc/cells.h>

namespace SolidSubdiv::Geometry::Internal {

namespace {

/// Solves for the origin's weights by Cramer's rule.
class Solver {
  public:
    explicit Solver(const TetCorners& corners)
        : corners_(corners), e1_(corners[1] - corners[0]), e2_(corners[2] - corners[0]), e3_(corners[3] - corners[0]) {
        normals_ = {Cross(e2_, e3_), Cross(e3_, e1_), Cross(e1_, e2_)};
        det_ = Dot(e1_, normals_[0]);
    }
    double det() const { return det_; }
    /// Determinants of `r` in place of an edge: the weights times det().
    Vec3 Scaled(const Vec3& r) const { return {Dot(r, normals_[0]), Dot(r, normals_[1]), Dot(r, normals_[2])}; }
    Vec3 PointOf(const Vec3& at) const { return corners_[0] + at.x * e1_ + at.y * e2_ + at.z * e3_; }

    /// Whether the origin certainly lies further than reach beyond the plane of a face.
    bool IsBeyondFace(const Vec3& scaled, double reach) const {
        const double sign = det_ < 0 ? -1 : 1;
        // Products of three differences, each off by half an epsilon, and their sums: of thin tets they say little.
        const double size = SumOfSizes(corners_[0]) + SumOfSizes(e1_) + SumOfSizes(e2_) + SumOfSizes(e3_);
        const double rounding = 16 * std::numeric_limits<double>::epsilon() * size * size * size;
        const double b[] = {sign * scaled.x, sign * scaled.y, sign * scaled.z};
        for (std::size_t i = 0; i < 3; ++i) {
            if (b[i] < -rounding - 2 * reach * SumOfSizes(normals_[i])) return true;
        }
        const double b0 = sign * det_ - b[0] - b[1] - b[2];
        return b0 < -rounding - 2 * reach * SumOfSizes(normals_[0] + normals_[1] + normals_[2]);
    }

  private:
    /// At least the length, and cheaper.
    static double SumOfSizes(const Vec3& a) { return std::abs(a.x) + std::abs(a.y) + std::abs(a.z); }

    const TetCorners& corners_;
    Vec3 e1_, e2_, e3_;
    std::array<Vec3, 3> normals_;
    double det_ = 0;
};

/// The nearest place with weights of at least 0 on a line from `at`: for what round-off puts outside.
Vec3 Clamped(const Vec3& at) {
    Vec3 c{std::max(at.x, 0.0), std::max(at.y, 0.0), std::max(at.z, 0.0)};
    const double sum = c.x + c.y + c.z;
    return sum > 1 ? (1 / sum) * c : c;
}

/// The origin's place by Cramer's rule and, while its point is further off than `enough`, corrections: of a tet that is
/// almost flat each brings but a few digits.
Nearest Solve(const Solver& solver, const Vec3& scaled, double enough) {
    constexpr int kMostCorrections = 8;
    const double inverse = 1 / solver.det();
    const auto measured = [&](const Vec3& at) { return Nearest{at, Length(solver.PointOf(at))}; };
    Nearest best = measured(Clamped(inverse * scaled));
    for (int i = 0; i < kMostCorrections && best.distance > enough; ++i) {
        const Nearest next = measured(Clamped(best.at + inverse * solver.Scaled(-solver.PointOf(best.at))));
        if (!(next.distance < best.distance)) break;
        best = next;
    }
    return best;
}

Nearest NearestOnFaces(const TetCorners& corners) {
    Nearest best;
    for (const auto& face : Sdc::Tet::faces) {
        const Vec3 &a = corners[face[0]], &b = corners[face[1]], &c = corners[face[2]];
        const auto [v, w] = NearestInTriangle(a, b, c);
        const double distance = Length(a + v * (b - a) + w * (c - a));
        if (!(distance < best.distance)) continue;
        double weights[4] = {};
        weights[face[0]] = std::max(0.0, 1 - v - w);
        weights[face[1]] = v;
        weights[face[2]] = w;
        best = {{weights[1], weights[2], weights[3]}, distance};
    }
    return best;
}

}  // namespace

Nearest NearestInTet(const TetCorners& corners) {
    const Solver solver(corners);
    const Nearest on_face = NearestOnFaces(corners);
    const Vec3 scaled = solver.Scaled(-corners[0]);
    if (solver.det() == 0 || solver.IsBeyondFace(scaled, 0)) return on_face;
    const Nearest inside = Solve(solver, scaled, 0);
    return inside.distance <= on_face.distance ? inside : on_face;
}

Nearest HoldInTet(const TetCorners& corners, double reach) {
    const Solver solver(corners);
    const Vec3 scaled = solver.Scaled(-corners[0]);
    if (solver.det() != 0) {
        if (solver.IsBeyondFace(scaled, reach)) return {};
        const Nearest inside = Solve(solver, scaled, reach / 16);
        if (inside.distance <= reach) return inside;
    }
    return NearestOnFaces(corners);  // flat, or so thin that the determinants say little
}

}  // namespace SolidSubdiv::Geometry::Internal

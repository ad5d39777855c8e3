// SPDX-License-Identifier: Apache-2.0
// Laws of the box spline, each checked with the true constants and with faulty ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "validation/box_spline_oracle.h"
#include "validation/lattice_convolution.h"
#include "validation_math/random_points.h"

namespace SolidSubdiv::Validation {
namespace {

/// What the laws are asked of: the oracle, or the oracle with a fault.
using Spline = std::function<BoxSplineJet(const Point3&)>;

double Largest(double a, double b) { return std::max(a, std::abs(b)); }

double Difference(const BoxSplineJet& a, const BoxSplineJet& b) {
    double worst = std::abs(a.value - b.value);
    for (int i = 0; i < 3; ++i) {
        worst = Largest(worst, a.gradient[i] - b.gradient[i]);
        for (int j = 0; j < 3; ++j) worst = Largest(worst, a.hessian[i][j] - b.hessian[i][j]);
    }
    return worst;
}

// Sum over all lattice points i of N(x - i) weight(i), with derivatives.
template <class Weight>
BoxSplineJet LatticeSum(const Point3& x, const Spline& n, Weight weight) {
    BoxSplineJet sum;
    const std::array<int, 3> corner = {static_cast<int>(x[0]), static_cast<int>(x[1]), static_cast<int>(x[2])};
    for (int i = -2; i <= 2; ++i)
        for (int j = -2; j <= 2; ++j)
            for (int k = -2; k <= 2; ++k) {
                const LatticePoint p = {corner[0] + i, corner[1] + j, corner[2] + k};
                const BoxSplineJet jet = n({x[0] - p[0], x[1] - p[1], x[2] - p[2]});
                const double w = weight(p);
                sum.value += w * jet.value;
                for (int a = 0; a < 3; ++a) {
                    sum.gradient[a] += w * jet.gradient[a];
                    for (int b = 0; b < 3; ++b) sum.hessian[a][b] += w * jet.hessian[a][b];
                }
            }
    return sum;
}

// x^e and its derivative of the given orders along the three axes.
double Monomial(const Point3& x, const std::array<int, 3>& exponent, const std::array<int, 3>& order) {
    double result = 1;
    for (int k = 0; k < 3; ++k) {
        for (int d = 0; d < order[k]; ++d) result *= exponent[k] - d;
        if (exponent[k] < order[k]) return 0;
        result *= std::pow(x[k], exponent[k] - order[k]);
    }
    return result;
}

// The sum over the four directions of the second derivatives of a monomial along u_k.
double SumOfSecondDerivatives(const Point3& x, const std::array<int, 3>& e) {
    double sum = 0;
    for (const LatticePoint& u : kDirections)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                std::array<int, 3> order{};
                ++order[i];
                ++order[j];
                sum += u[i] * u[j] * Monomial(x, e, order);
            }
    return sum;
}

// Largest error with which the quasi-interpolant p(i) - 1/12 sum_k p_{u_k u_k}(i) gives back the monomials of one
// degree.
double QuasiInterpolationError(const Spline& n, int degree) {
    double worst = 0;
    for (const Point3& x : RandomPoints(20, 1.5, 11))
        for (int a = 0; a <= degree; ++a)
            for (int b = 0; a + b <= degree; ++b) {
                const std::array<int, 3> e = {a, b, degree - a - b};
                const BoxSplineJet sum = LatticeSum(x, n, [&e](const LatticePoint& i) {
                    const Point3 p = {1.0 * i[0], 1.0 * i[1], 1.0 * i[2]};
                    return Monomial(p, e, {}) - SumOfSecondDerivatives(p, e) / 12;
                });
                BoxSplineJet exact;
                exact.value = Monomial(x, e, {});
                for (int i = 0; i < 3; ++i) {
                    std::array<int, 3> order{};
                    ++order[i];
                    exact.gradient[i] = Monomial(x, e, order);
                    for (int j = 0; j < 3; ++j) {
                        std::array<int, 3> second = order;
                        ++second[j];
                        exact.hessian[i][j] = Monomial(x, e, second);
                    }
                }
                worst = Largest(worst, Difference(sum, exact));
            }
    return worst;
}

// 60 T at integer coordinates, T the truncated power of the derivation, all in integers.
std::int64_t SixtyTruncatedPowers(const std::array<std::int64_t, 3>& y) {
    const std::int64_t m = std::min({y[0], y[1], y[2]});
    if (m <= 0) return 0;
    const std::int64_t e1 = y[0] + y[1] + y[2], e2 = y[0] * y[1] + y[0] * y[2] + y[1] * y[2], e3 = y[0] * y[1] * y[2];
    return m * m * (30 * e3 - 20 * e2 * m + 15 * e1 * m * m - 12 * m * m * m);
}

// 60 scale^5 N(point/scale): all 81 shifts of the truncated power, no symmetry used, no rounding.
std::int64_t SixtyBoxSplines(const LatticePoint& point, std::int64_t scale) {
    const std::array<int, 3> second_difference = {1, -2, 1};
    std::int64_t sum = 0;
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
            for (int c = 0; c < 3; ++c)
                for (int d = 0; d < 3; ++d)
                    sum += second_difference[a] * second_difference[b] * second_difference[c] * second_difference[d] *
                           SixtyTruncatedPowers({point[0] + scale * (2 - a - d), point[1] + scale * (2 - b - d),
                                                 point[2] + scale * (2 - c - d)});
    return sum;
}

// The box spline with direction u_k taken m_k times, not centred, by de Boor's recurrence. For points off the knot
// planes.
double DeBoor(const std::array<int, 4>& multiplicity, const Point3& x) {
    const int total = multiplicity[0] + multiplicity[1] + multiplicity[2] + multiplicity[3];
    const auto missing = std::count(multiplicity.begin(), multiplicity.end(), 0);
    if (missing > 1) return 0;  // carried by a plane
    // x = sum of t_k u_k over three directions that are there.
    const int left_out =
        static_cast<int>(std::find(multiplicity.begin(), multiplicity.end(), 0) - multiplicity.begin()) % 4;
    const std::array<double, 4> homogeneous = {x[0], x[1], x[2], 0};
    std::array<double, 4> t{};
    for (int k = 0; k < 4; ++k) t[k] = homogeneous[k] - homogeneous[left_out];
    if (total == 3) {
        const bool inside = std::all_of(t.begin(), t.end(), [](double s) { return s >= 0 && s < 1; });
        return inside ? 1 : 0;
    }
    double sum = 0;
    for (int k = 0; k < 4; ++k) {
        if (multiplicity[k] == 0) continue;
        std::array<int, 4> fewer = multiplicity;
        --fewer[k];
        const LatticePoint& u = kDirections[k];
        sum +=
            t[k] * DeBoor(fewer, x) + (multiplicity[k] - t[k]) * DeBoor(fewer, {x[0] - u[0], x[1] - u[1], x[2] - u[2]});
    }
    return sum / (total - 3);
}

double PartitionOfUnity(const Spline& n) {
    BoxSplineJet one;
    one.value = 1;
    double worst = 0;
    for (const Point3& x : RandomPoints(300, 1, 1))
        worst = Largest(worst, Difference(LatticeSum(x, n, [](const LatticePoint&) { return 1.0; }), one));
    return worst;
}

double CubicReproduction(const Spline& n) {
    double worst = 0;
    for (int degree = 0; degree <= 3; ++degree) worst = Largest(worst, QuasiInterpolationError(n, degree));
    return worst;
}

double Symmetry(const Spline& n) {
    double worst = 0;
    for (const Point3& x : RandomPoints(100, 2, 2)) {
        const BoxSplineJet jet = n(x);
        std::array<int, 4> permutation = {0, 1, 2, 3};
        do {
            for (const double sign : {1.0, -1.0}) {
                // The map u_k -> sign u_permutation(k); row i of the matrix holds the images' coordinates i.
                Matrix3 map{};
                Point3 image{};
                for (int i = 0; i < 3; ++i)
                    for (int k = 0; k < 3; ++k) {
                        map[i][k] = sign * kDirections[permutation[k]][i];
                        image[i] += map[i][k] * x[k];
                    }
                const BoxSplineJet there = n(image);
                BoxSplineJet back;
                back.value = there.value;
                for (int k = 0; k < 3; ++k)
                    for (int i = 0; i < 3; ++i) {
                        back.gradient[k] += there.gradient[i] * map[i][k];
                        for (int l = 0; l < 3; ++l)
                            for (int j = 0; j < 3; ++j)
                                back.hessian[k][l] += map[i][k] * there.hessian[i][j] * map[j][l];
                    }
                worst = Largest(worst, Difference(jet, back));
            }
        } while (std::next_permutation(permutation.begin(), permutation.end()));
    }
    return worst;
}

double TwoScaleRelation(const Spline& n) {
    double worst = 0;
    for (const Point3& x : RandomPoints(300, 2.2, 3)) {
        BoxSplineJet sum;
        for (const auto& [offset, weight] : BoxSplineMask()) {
            const BoxSplineJet fine = n({2 * x[0] - offset[0], 2 * x[1] - offset[1], 2 * x[2] - offset[2]});
            sum.value += weight * fine.value;
            for (int i = 0; i < 3; ++i) {
                sum.gradient[i] += 2 * weight * fine.gradient[i];
                for (int j = 0; j < 3; ++j) sum.hessian[i][j] += 4 * weight * fine.hessian[i][j];
            }
        }
        worst = Largest(worst, Difference(sum, n(x)));
    }
    return worst;
}

double LatticeValuesAreLimitMask(const Spline& n) {
    double worst = 0;
    for (int i = -3; i <= 3; ++i)
        for (int j = -3; j <= 3; ++j)
            for (int k = -3; k <= 3; ++k) {
                const EdgeKind kind = ClassifyEdge({0, 0, 0}, {i, j, k});
                const bool centre = i == 0 && j == 0 && k == 0;
                const double expected = centre                ? 2.0 / 5
                                        : kind == EdgeKind::A ? 1.0 / 20
                                        : kind == EdgeKind::B ? 1.0 / 30
                                                              : 0;
                worst = Largest(worst, n({1.0 * i, 1.0 * j, 1.0 * k}).value - expected);
            }
    return worst;
}

double ExactAtDyadicPoints(const Spline& n) {
    double worst = 0;
    const int scale = 64;
    const double unit = 60.0 * scale * scale * scale * scale * scale;
    for (const Point3& x : RandomPoints(5000, 2 * scale, 4)) {
        // Every third point is moved to a knot plane, every seventh to a coarser lattice: ties are where folding can go
        // wrong.
        LatticePoint p = {static_cast<int>(x[0]), static_cast<int>(x[1]), static_cast<int>(x[2])};
        if (p[0] % 3 == 0) p[1] = p[2];
        if (p[1] % 7 == 0) p = {p[0] / 16 * 16, p[1] / 16 * 16, p[2] / 16 * 16};
        const double exact = static_cast<double>(SixtyBoxSplines(p, scale)) / unit;
        const Point3 at = {1.0 * p[0] / scale, 1.0 * p[1] / scale, 1.0 * p[2] / scale};
        worst = Largest(worst, n(at).value - exact);
    }
    return worst;
}

double EqualsDeBoorsRecurrence(const Spline& n) {
    double worst = 0;
    for (const Point3& x : RandomPoints(300, 2, 5)) worst = Largest(worst, n(x).value - DeBoor({2, 2, 2, 2}, x));
    return worst;
}

// Whether x is nearer than `gap` to a plane where the polynomial changes.
bool NearKnotPlane(const Point3& x, double gap) {
    const std::array<double, 6> heights = {x[0], x[1], x[2], x[0] - x[1], x[0] - x[2], x[1] - x[2]};
    return std::any_of(heights.begin(), heights.end(), [gap](double h) { return std::abs(h - std::round(h)) < gap; });
}

double DerivativesMatchDifferences(const Spline& n) {
    const double h = 1e-4;
    double worst = 0;
    for (const Point3& x : RandomPoints(500, 1.8, 6)) {
        if (NearKnotPlane(x, 2 * h)) continue;
        const BoxSplineJet at = n(x);
        for (int i = 0; i < 3; ++i) {
            Point3 before = x, after = x;
            before[i] -= h;
            after[i] += h;
            const BoxSplineJet a = n(before), b = n(after);
            worst = Largest(worst, (b.value - a.value) / (2 * h) - at.gradient[i]);
            for (int j = 0; j < 3; ++j)
                worst = Largest(worst, (b.gradient[j] - a.gradient[j]) / (2 * h) - at.hessian[i][j]);
        }
    }
    return worst;
}

struct Law {
    std::string name;
    double (*violation)(const Spline&);
    double tolerance;
};

// Sums of at most 125 terms, in total about 1 for values and 10 for Hessians, each exact to a few 1e-16.
constexpr double kRoundOff = 2e-14;

const std::vector<Law>& Laws() {
    static const std::vector<Law> laws = {
        {"PartitionOfUnity", PartitionOfUnity, kRoundOff},
        {"CubicReproduction", CubicReproduction, 1e-12},  // cubics reach 64 at lattice points 4 away
        {"Symmetry", Symmetry, kRoundOff},
        {"TwoScaleRelation", TwoScaleRelation, kRoundOff},
        {"LatticeValuesAreLimitMask", LatticeValuesAreLimitMask, 1e-15},
        {"ExactAtDyadicPoints", ExactAtDyadicPoints, 3e-15},
        {"EqualsDeBoorsRecurrence", EqualsDeBoorsRecurrence, kRoundOff},
        // h^2/6 = 1.7e-9 times the third and fourth derivatives, at most about 30
        {"DerivativesMatchDifferences", DerivativesMatchDifferences, 1e-7},
    };
    return laws;
}

struct Fault {
    std::string name;
    Spline spline;
};

// One constant off by 1e-6, a bent direction, a derivative off by 1e-6 of itself.
std::vector<Fault> Faults() {
    std::vector<Fault> faults;
    for (int which = 0; which < 8; ++which) {
        BoxSplineCoefficients faulty;
        (which < 4 ? faulty.shifts[which] : faulty.powers[which - 4]) += 1e-6;
        faults.push_back({(which < 4 ? "shift " : "power ") + std::to_string(which % 4),
                          [faulty](const Point3& x) { return EvaluateBoxSpline(x, faulty); }});
    }
    faults.push_back({"bent direction", [](const Point3& x) {
                          return EvaluateBoxSpline({x[0], x[1] + 1e-6 * x[0], x[2]});
                      }});
    faults.push_back({"gradient", [](const Point3& x) {
                          BoxSplineJet jet = EvaluateBoxSpline(x);
                          jet.gradient[1] *= 1 + 1e-6;
                          return jet;
                      }});
    faults.push_back({"hessian", [](const Point3& x) {
                          BoxSplineJet jet = EvaluateBoxSpline(x);
                          jet.hessian[0][2] *= 1 + 1e-6;
                          return jet;
                      }});
    return faults;
}

TEST(BoxSpline, ObeysEveryLaw) {
    const Spline oracle = [](const Point3& x) { return EvaluateBoxSpline(x); };
    for (const Law& law : Laws()) {
        const double violation = law.violation(oracle);
        EXPECT_LE(violation, law.tolerance) << law.name;
        RecordProperty(law.name, std::to_string(violation / law.tolerance) + " of the tolerance");
    }
}

TEST(BoxSpline, QuasiInterpolantDoesNotReproduceQuartics) {
    // The law of cubics must be able to fail.
    EXPECT_GT(QuasiInterpolationError([](const Point3& x) { return EvaluateBoxSpline(x); }, 4), 0.01);
}

TEST(BoxSplineFault, EveryFaultIsCaughtAndEveryLawCatchesOne) {
    std::vector<int> catches(Laws().size(), 0);
    for (const Fault& fault : Faults()) {
        int caught = 0;
        for (std::size_t i = 0; i < Laws().size(); ++i)
            if (Laws()[i].violation(fault.spline) > 2 * Laws()[i].tolerance) {
                ++caught;
                ++catches[i];
            }
        EXPECT_GE(caught, 1) << fault.name;
    }
    for (std::size_t i = 0; i < Laws().size(); ++i) EXPECT_GE(catches[i], 1) << Laws()[i].name;
}

}  // namespace
}  // namespace SolidSubdiv::Validation

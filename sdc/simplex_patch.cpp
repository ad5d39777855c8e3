// SPDX-License-Identifier: Apache-2.0
// Nets are found from values: three subdivisions of one control point and the limit mask give the spline at eighths of
// the lattice, enough of them in one cell to interpolate its polynomial.
#include <solidsubdiv/sdc/simplex_patch.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace SolidSubdiv::Sdc {

namespace {

using Point = SimplexPatch::Point;
using Exponents = std::array<int, 4>;

/// All exponents of a degree, of dimension + 1 barycentric coordinates.
std::vector<Exponents> ExponentsOf(int degree, int dimension) {
    std::vector<Exponents> all;
    for (int i = degree; i >= 0; --i) {
        for (int j = degree - i; j >= 0; --j) {
            if (dimension == 2) {
                all.push_back({i, j, degree - i - j, 0});
                continue;
            }
            for (int k = degree - i - j; k >= 0; --k) all.push_back({i, j, k, degree - i - j - k});
        }
    }
    return all;
}

double Factorial(int n) { return n < 2 ? 1 : n * Factorial(n - 1); }

double Bernstein(int degree, const Exponents& e, const std::array<double, 4>& barycentric) {
    double value = Factorial(degree);
    for (std::size_t i = 0; i < 4; ++i) {
        value /= Factorial(e[i]);
        for (int k = 0; k < e[i]; ++k) value *= barycentric[i];
    }
    return value;
}

/// Values on lattice points, in coordinates of the lattice's own axes.
class Lattice {
  public:
    static constexpr int kRadius = 18,  ///< three subdivisions reach 14, the limit 16
        kSide = 2 * kRadius + 1;

    explicit Lattice(int dimension) : dimension_(dimension), values_(kSide * kSide * (dimension == 3 ? kSide : 1)) {}

    double& operator[](const Point& p) { return values_[Number(p)]; }
    double operator[](const Point& p) const { return values_[Number(p)]; }
    bool Has(const Point& p) const {
        return std::all_of(p.begin(), p.end(), [](int x) { return std::abs(x) <= kRadius; });
    }

    template <class Body>
    void ForPoints(int radius, Body&& body) const {
        const int depth = dimension_ == 3 ? radius : 0;
        for (int k = -depth; k <= depth; ++k) {
            for (int j = -radius; j <= radius; ++j) {
                for (int i = -radius; i <= radius; ++i) body(Point{i, j, k});
            }
        }
    }

  private:
    std::size_t Number(const Point& p) const {
        const int depth = dimension_ == 3 ? p[2] + kRadius : 0;
        return static_cast<std::size_t>((depth * kSide + p[1] + kRadius) * kSide + p[0] + kRadius);
    }

    int dimension_;
    std::vector<double> values_;
};

Point Sum(const Point& a, const Point& b, int factor = 1) {
    return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

std::vector<Point> Directions(int dimension) {
    if (dimension == 2) return {{1, 0, 0}, {0, 1, 0}, {-1, -1, 0}};
    return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, -1, -1}};
}

/// Multiplies by z^-u + 2 + z^u.
Lattice Smooth(const Lattice& values, const Point& u, int dimension) {
    Lattice smooth(dimension);
    values.ForPoints(Lattice::kRadius - 1, [&](const Point& p) {
        smooth[p] += 2 * values[p];
        smooth[Sum(p, u)] += values[p];
        smooth[Sum(p, u, -1)] += values[p];
    });
    return smooth;
}

constexpr int kLevels = 3, kUnits = 1 << kLevels;

/// The spline at the points of the lattice divided by kUnits.
Lattice SplineValues(int dimension) {
    const auto directions = Directions(dimension);
    Lattice values(dimension);
    values[{0, 0, 0}] = 1;
    for (int level = 0; level < kLevels; ++level) {
        Lattice finer(dimension);
        values.ForPoints(Lattice::kRadius / 2, [&](const Point& p) {
            finer[{2 * p[0], 2 * p[1], 2 * p[2]}] = values[p];
        });
        for (const Point& u : directions) finer = Smooth(finer, u, dimension);
        finer.ForPoints(Lattice::kRadius, [&](const Point& p) { values[p] = finer[p] / (dimension == 3 ? 32 : 16); });
    }
    // The limit: rules.md section 2; Loop's is (1/2, 1/12).
    Lattice limits(dimension);
    const double self = dimension == 3 ? 2.0 / 5 : 1.0 / 2, neighbor = dimension == 3 ? 1.0 / 20 : 1.0 / 12;
    values.ForPoints(Lattice::kRadius - 2, [&](const Point& p) {
        limits[p] += self * values[p];
        for (std::size_t a = 0; a < directions.size(); ++a) {
            for (int sign : {1, -1}) limits[Sum(p, directions[a], sign)] += neighbor * values[p];
            for (std::size_t b = a + 1; dimension == 3 && b < directions.size(); ++b) {
                limits[Sum(p, Sum(directions[a], directions[b]))] += values[p] / 30;
            }
        }
    });
    return limits;
}

/// Coordinates along the lattice's axes; in three dimensions those are (1, 1, 1), (1, -1, -1), (-1, 1, -1).
Point InLattice(const Point& p, int dimension) {
    if (dimension == 2) return p;
    return {(p[0] + p[1]) / 2, (p[0] - p[2]) / 2, (p[1] - p[2]) / 2};
}

/// Solves matrix * x = right sides, in place. Matrix (n, n), sides (n, m), row-major.
void Solve(std::vector<double>& matrix, std::vector<double>& sides, std::size_t n) {
    const std::size_t m = sides.size() / n;
    for (std::size_t c = 0; c < n; ++c) {
        std::size_t pivot = c;
        for (std::size_t r = c; r < n; ++r) {
            if (std::abs(matrix[r * n + c]) > std::abs(matrix[pivot * n + c])) pivot = r;
        }
        for (std::size_t k = 0; k < n; ++k) std::swap(matrix[c * n + k], matrix[pivot * n + k]);
        for (std::size_t k = 0; k < m; ++k) std::swap(sides[c * m + k], sides[pivot * m + k]);
        for (std::size_t r = 0; r < n; ++r) {
            if (r == c) continue;
            const double factor = matrix[r * n + c] / matrix[c * n + c];
            for (std::size_t k = c; k < n; ++k) matrix[r * n + k] -= factor * matrix[c * n + k];
            for (std::size_t k = 0; k < m; ++k) sides[r * m + k] -= factor * sides[c * m + k];
        }
    }
    for (std::size_t r = 0; r < n; ++r) {
        for (std::size_t k = 0; k < m; ++k) sides[r * m + k] /= matrix[r * n + r];
    }
}

}  // namespace

SimplexPatch::SimplexPatch(int dimension) : dimension_(dimension) {
    const int degree = dimension == 3 ? 5 : 4;
    if (dimension == 3) {
        corners_ = {{0, 0, 0}, {2, 0, 0}, {1, 1, -1}, {1, 1, 1}};
    } else {
        corners_ = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    }
    // A principal lattice of the polynomials' degree, near corner 0.
    const std::vector<Exponents> exponents = ExponentsOf(degree, dimension);
    const std::size_t n = exponents.size();
    std::vector<Point> nodes(n);
    std::vector<double> matrix(n * n);
    for (std::size_t i = 0; i < n; ++i) {
        Exponents steps = exponents[i];
        steps[0] += kUnits - degree;
        std::array<double, 4> barycentric{};
        for (std::size_t k = 0; k < corners_.size(); ++k) {
            nodes[i] = Sum(nodes[i], corners_[k], steps[k]);
            barycentric[k] = static_cast<double>(steps[k]) / kUnits;
        }
        for (std::size_t k = 0; k < n; ++k) matrix[i * n + k] = Bernstein(degree, exponents[k], barycentric);
    }
    const Lattice spline = SplineValues(dimension);
    const auto value = [&](const Point& node, const Point& control) {
        const Point p = InLattice(Sum(node, control, -kUnits), dimension);
        return spline.Has(p) ? spline[p] : 0.0;
    };
    points_ = corners_;
    constexpr int kReach = 4;
    const auto add_if_seen = [&](const Point& p) {
        const bool is_lattice = dimension == 2 || (((p[0] ^ p[1]) | (p[0] ^ p[2])) & 1) == 0;
        if (!is_lattice || std::find(corners_.begin(), corners_.end(), p) != corners_.end()) return;
        if (std::any_of(nodes.begin(), nodes.end(), [&](const Point& node) { return value(node, p) > 1e-14; })) {
            points_.push_back(p);
        }
    };
    for (int x = -kReach; x <= kReach; ++x) {
        for (int y = -kReach; y <= kReach; ++y) {
            if (dimension == 2) {
                add_if_seen({x, y, 0});
                continue;
            }
            for (int z = -kReach; z <= kReach; ++z) add_if_seen({x, y, z});
        }
    }
    assert(n_points() == (dimension == 3 ? 32 : 12));  // and so a multiple of four

    Net net{degree, {}};
    for (const Point& node : nodes) {
        for (const Point& p : points_) net.coefficients.push_back(value(node, p));
    }
    Solve(matrix, net.coefficients, n);
    // They are multiples of 1 / degree!, far from one another: rounded they are exact.
    for (double& c : net.coefficients) c = std::round(c * Factorial(degree)) / Factorial(degree);
    nets_.push_back(std::move(net));
    for (int a = 0; a < dimension; ++a) nets_.push_back(Derivative(nets_[0], a));
    for (int a = 0; a < dimension; ++a) {
        for (int b = a; b < dimension; ++b) nets_.push_back(Derivative(nets_[static_cast<std::size_t>(1 + a)], b));
    }
}

SimplexPatch::Net SimplexPatch::Derivative(const Net& net, int axis) const {
    const std::size_t m = points_.size();
    const std::vector<Exponents> higher = ExponentsOf(net.degree, dimension_);
    Net derivative{net.degree - 1, {}};
    for (const Exponents& e : ExponentsOf(net.degree - 1, dimension_)) {
        const auto row_of = [&](std::size_t raised) {
            Exponents h = e;
            ++h[raised];
            return static_cast<std::size_t>(std::find(higher.begin(), higher.end(), h) - higher.begin());
        };
        const std::size_t up = row_of(static_cast<std::size_t>(axis) + 1), down = row_of(0);
        for (std::size_t p = 0; p < m; ++p) {
            derivative.coefficients.push_back(net.degree *
                                              (net.coefficients[up * m + p] - net.coefficients[down * m + p]));
        }
    }
    return derivative;
}

namespace {

/// Bernstein polynomials of a degree, in the order of ExponentsOf; returns how many.
std::size_t FillBernstein(int degree, int dimension, const std::array<double, 4>& barycentric, double* values) {
    // Powers of the coordinates over factorials, to multiply.
    std::array<std::array<double, 6>, 4> powers;
    for (std::size_t i = 0; i < 4; ++i) {
        powers[i][0] = 1;
        for (std::size_t k = 1; k < 6; ++k) powers[i][k] = powers[i][k - 1] * barycentric[i] / static_cast<double>(k);
    }
    constexpr std::array<double, 6> kFactorials{1, 1, 2, 6, 24, 120};
    std::size_t n = 0;
    for (int i = degree; i >= 0; --i) {
        for (int j = degree - i; j >= 0; --j) {
            const double first_two = kFactorials[degree] * powers[0][i] * powers[1][j];
            if (dimension == 2) {
                values[n++] = first_two * powers[2][degree - i - j];
                continue;
            }
            for (int k = degree - i - j; k >= 0; --k) {
                values[n++] = first_two * powers[2][k] * powers[3][degree - i - j - k];
            }
        }
    }
    return n;
}

}  // namespace

void SimplexPatch::Fill(const Net& net, const std::array<double, 4>& barycentric, double* weights) const {
    std::array<double, 56> bernstein;
    const std::size_t n = FillBernstein(net.degree, dimension_, barycentric, bernstein.data()), m = points_.size();
    // Sums of a few points at a time stay in registers.
    constexpr std::size_t kBlock = 4;
    for (std::size_t p = 0; p < m; p += kBlock) {
        std::array<double, kBlock> sums{};
        const double* row = net.coefficients.data() + p;
        for (std::size_t i = 0; i < n; ++i, row += m) {
            for (std::size_t k = 0; k < kBlock; ++k) sums[k] += bernstein[i] * row[k];
        }
        std::copy(sums.begin(), sums.end(), weights + p);
    }
}

void SimplexPatch::Evaluate(const std::array<double, 3>& at, int order, double* weights) const {
    const std::array<double, 4> barycentric{1 - at[0] - at[1] - (dimension_ == 3 ? at[2] : 0.0), at[0], at[1],
                                            dimension_ == 3 ? at[2] : 0.0};
    const std::size_t n_nets = static_cast<std::size_t>(1 + NDerivatives(dimension_, order)), m = points_.size();
    for (std::size_t i = 0; i < n_nets; ++i) Fill(nets_[i], barycentric, weights + i * m);
}

const SimplexPatch& QuinticTet() {
    static const SimplexPatch patch(3);
    return patch;
}

const SimplexPatch& QuarticTriangle() {
    static const SimplexPatch patch(2);
    return patch;
}

}  // namespace SolidSubdiv::Sdc

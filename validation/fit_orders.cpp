// SPDX-License-Identifier: Apache-2.0
// Validator fit-orders: errors fall with the order of approximation of the surfaces.
//
// Loop's regular surface is the quartic box spline N(2,2,2), Catmull-Clark's the
// bicubic B-spline. Both spaces hold all polynomials of degree 3 locally, so the best fit to a smooth map is of order
// h^4. At extraordinary vertices only linear polynomials are sure: there the error is of order h^2, in a part of the
// surface that shrinks as h^2, which leaves an RMS error of order h^3.
#include "fit_orders.h"

#include <cmath>
#include <cstdio>
#include <numbers>

#include "fit_shapes.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

std::array<double, 3> TorusPoint(double u, double v) {
    const double a = 2 * std::numbers::pi * u, b = 2 * std::numbers::pi * v, r = 1 + 0.4 * std::cos(b);
    return {r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b)};
}

Fit::ControlMesh MakeTorus(TorusMesh kind, int n, int m) {
    Fit::ControlMesh mesh;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < m; ++j) {
            const auto p = TorusPoint(static_cast<double>(i) / n, static_cast<double>(j) / m);
            mesh.positions.insert(mesh.positions.end(), p.begin(), p.end());
            const auto at = [&](int u, int v) { return static_cast<Index>(u % n * m + v % m); };
            const Index a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
            if (kind == TorusMesh::Quads) {
                mesh.quads.insert(mesh.quads.end(), {a, b, c, d});
            } else {
                mesh.triangles.insert(mesh.triangles.end(), {a, b, c, a, c, d});
            }
        }
    }
    return mesh;
}

/// The parameter of a row: regular schemes give linear functions back, so it is the sum of those of the control points,
/// taken around the ring to where the first is.
double ParameterOf(std::span<const Index> indices, std::span<const double> weights, const auto& parameter) {
    const double first = parameter(indices[0]);
    double sum = first;
    for (std::size_t k = 1; k < indices.size(); ++k) {
        const double gap = parameter(indices[k]) - first;
        sum += weights[k] * (gap - std::round(gap));
    }
    return sum;
}

const Fit::Options kPlain{.max_rounds = 6, .fairness = 0, .least_fairness = 0, .barrier = 0, .least_change = 1e-6};

}  // namespace

double TorusError(TorusMesh kind, int n, int m) {
    const Sdc::Scheme scheme = kind == TorusMesh::Quads ? Sdc::Scheme(Sdc::CatmullClark{}) : Sdc::Scheme(Sdc::Loop{});
    Fit::Problem problem = Fit::MakeProblem(MakeTorus(kind, n, m), scheme, {}, 4);
    const auto& rows = problem.surface.rows;
    for (Index i = 0; i < rows.n_rows(); ++i) {
        const double u =
            ParameterOf(rows.Indices(i), rows.Weights(i), [&](Index p) { return static_cast<double>(p / m) / n; });
        const double v =
            ParameterOf(rows.Indices(i), rows.Weights(i), [&](Index p) { return static_cast<double>(p % m) / m; });
        const auto p = TorusPoint(u, v);
        problem.partners.insert(problem.partners.end(), p.begin(), p.end());
    }
    const std::vector<double> points = problem.surface.Positions(FitControlPoints(problem, kPlain).control);
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); i += 3) {
        const double d = std::hypot(std::hypot(points[i], points[i + 1]) - 1, points[i + 2]) - 0.4;
        sum += d * d;
    }
    return std::sqrt(3 * sum / static_cast<double>(points.size()));
}

double SphereError(int n) {
    const auto project = [](std::vector<double> points) {
        for (std::size_t i = 0; i < points.size(); i += 3) {
            const double length = std::hypot(points[i], points[i + 1], points[i + 2]);
            for (std::size_t c = 0; c < 3; ++c) points[i + c] /= length;
        }
        return points;
    };
    const FitTarget ball = MakeFitBall(n);
    Fit::Problem problem =
        Fit::MakeProblem({.positions = project(ball.positions), .triangles = ball.triangles}, Sdc::Loop{}, {}, 4);
    // Nearest points of the sphere itself, so that no facet limits the result.
    for (int round = 0; round < 10; ++round) {
        problem.partners = project(problem.surface.Positions(problem.control));
        problem.control = FitControlPoints(problem, kPlain).control;
    }
    const std::vector<double> points = problem.surface.Positions(problem.control);
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); i += 3) {
        const double d = std::hypot(points[i], points[i + 1], points[i + 2]) - 1;
        sum += d * d;
    }
    return std::sqrt(3 * sum / static_cast<double>(points.size()));
}

void CompareOrders(const std::vector<double>& errors, double expected, Findings& findings) {
    std::string text;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        char number[40];
        std::snprintf(number, sizeof number, "%.3g", errors[i]);
        text += (i == 0 ? "RMS " : ", ") + std::string(number);
        if (i == 0) continue;
        const double order = std::log2(errors[i - 1] / errors[i]);
        std::snprintf(number, sizeof number, " (order %.2f)", order);
        text += number;
        findings.Error(std::isnan(order) ? order : std::max(0.0, expected - order),
                       [&] { return "from size " + std::to_string(i - 1) + " to the next"; });
    }
    findings.notes.push_back(text);
}

Findings ValidateFitOrders(const Context& context) {
    Findings findings;
    const std::vector<int> sizes = context.is_quick ? std::vector{10, 20} : std::vector{10, 20, 40};
    const auto compare = [&](const std::string& name, double expected, const auto& error_of) {
        std::vector<double> errors;
        for (int n : sizes) errors.push_back(error_of(n));
        Findings found;
        CompareOrders(errors, expected, found);
        findings.Merge(found, name);
    };
    compare("torus of triangles", 4, [](int n) { return TorusError(TorusMesh::Triangles, n, n / 2); });
    compare("torus of quads", 4, [](int n) { return TorusError(TorusMesh::Quads, n, n / 2); });
    compare("sphere of triangles", 3, [](int n) { return SphereError(2 * n / 5); });
    return findings;
}

}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
// Tensor products along three axes, and a breadth-first search.
#include "ffd_oracle.h"

#include <algorithm>
#include <cmath>

namespace SolidSubdiv::Validation {

namespace {

using Steps = ControlBlock::Steps;
using Point = ControlBlock::Point;

/// The uniform cubic B-spline at x, its support [-2, 2].
double CubicSpline(double x) {
    const double t = std::abs(x);
    if (t >= 2) return 0;
    if (t >= 1) return (2 - t) * (2 - t) * (2 - t) / 6;
    return 2.0 / 3 - t * t + t * t * t / 2;
}

/// Weights of P0 .. Pn at x, with what the points beyond the ends weigh.
std::vector<double> SplineRow(double x, int n) {
    std::vector<double> row;
    for (int i = 0; i <= n; ++i) row.push_back(CubicSpline(x - i));
    const std::size_t last = row.size() - 1;
    const double before = CubicSpline(x + 1), behind = CubicSpline(x - n - 1);
    row[0] += 2 * before;
    row[1] -= before;
    row[last] += 2 * behind;
    row[last - 1] -= behind;
    return row;
}

std::vector<double> LinearRow(double x, int n) {
    std::vector<double> row;
    for (int i = 0; i <= n; ++i) row.push_back(std::max(0.0, 1 - std::abs(x - i)));
    return row;
}

template <class Row>
Point TensorProduct(const ControlBlock& block, const Point& u, Row&& row) {
    const std::vector<double> x = row(u[0], block.n[0]), y = row(u[1], block.n[1]), z = row(u[2], block.n[2]);
    Point sum{};
    auto point = block.points.begin();
    for (double wz : z) {
        for (double wy : y) {
            for (double wx : x) {
                for (std::size_t c = 0; c < 3; ++c) sum[c] += wx * wy * wz * (*point)[c];
                ++point;
            }
        }
    }
    return sum;
}

Point Sum(double wa, const Point& a, double wb, const Point& b) {
    return {wa * a[0] + wb * b[0], wa * a[1] + wb * b[1], wa * a[2] + wb * b[2]};
}

ControlBlock InsertKnotsAlong(const ControlBlock& block, std::size_t axis) {
    ControlBlock fine{block.n, {}};
    fine.n[axis] *= 2;
    Steps at;
    for (at[2] = 0; at[2] <= fine.n[2]; ++at[2]) {
        for (at[1] = 0; at[1] <= fine.n[1]; ++at[1]) {
            for (at[0] = 0; at[0] <= fine.n[0]; ++at[0]) {
                const int i = at[axis] / 2;
                const auto coarse = [&](int k) {
                    Steps there = at;
                    there[axis] = k;
                    return block.At(there);
                };
                if (at[axis] % 2 == 1) {
                    fine.points.push_back(Sum(0.5, coarse(i), 0.5, coarse(i + 1)));
                } else if (i == 0 || i == block.n[axis]) {
                    fine.points.push_back(coarse(i));
                } else {
                    fine.points.push_back(Sum(0.75, coarse(i), 1, Sum(0.125, coarse(i - 1), 0.125, coarse(i + 1))));
                }
            }
        }
    }
    return fine;
}

}  // namespace

Point SplineAt(const ControlBlock& block, const Point& u) { return TensorProduct(block, u, SplineRow); }

Point TrilinearAt(const ControlBlock& block, const Point& u) { return TensorProduct(block, u, LinearRow); }

ControlBlock InsertKnots(const ControlBlock& block) {
    return InsertKnotsAlong(InsertKnotsAlong(InsertKnotsAlong(block, 0), 1), 2);
}

std::vector<int> StepsByCells(const std::vector<std::vector<int>>& cells, int n_points, int from) {
    std::vector<int> steps(static_cast<std::size_t>(n_points), -1);
    steps[static_cast<std::size_t>(from)] = 0;
    bool grows = true;
    for (int k = 0; grows; ++k) {
        grows = false;
        for (const std::vector<int>& cell : cells) {
            const auto is_here = [&](int v) { return steps[static_cast<std::size_t>(v)] == k; };
            if (std::none_of(cell.begin(), cell.end(), is_here)) continue;
            for (int v : cell) {
                int& step = steps[static_cast<std::size_t>(v)];
                if (step >= 0) continue;
                step = k + 1;
                grows = true;
            }
        }
    }
    return steps;
}

}  // namespace SolidSubdiv::Validation

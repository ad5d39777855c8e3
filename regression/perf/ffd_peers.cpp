// SPDX-License-Identifier: Apache-2.0
// Loops of fixed lengths that compilers make vectors of: a block of points at a time, or the control points of a line.
// GCC makes them for newer processors too and picks when the program starts, so peers have the widest vectors there
// are.
#include "perf/ffd_peers.h"

#include <algorithm>
#include <cmath>

#include <solidsubdiv/sdc/parallel.h>

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#define SOLIDSUBDIV_WIDEST __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define SOLIDSUBDIV_WIDEST
#endif

namespace SolidSubdiv::Perf {

namespace {

constexpr int kLanes = 16;
constexpr Offset kGrain = 4096;  // points: some tens of microseconds

/// Weights of four control points, cubic Bernstein polynomials, of a block of coordinates.
inline void Bernstein(const float* u, float weights[4][kLanes]) {
    for (int i = 0; i < kLanes; ++i) {
        const float t = u[i], s = 1 - t;
        weights[0][i] = s * s * s;
        weights[1][i] = 3 * t * s * s;
        weights[2][i] = 3 * t * t * s;
        weights[3][i] = t * t * t;
    }
}

/// Blocks [begin, end) of points: along x, then y, then z.
SOLIDSUBDIV_WIDEST void DeformBernstein(const float* control, const float* u, Offset begin, Offset end, Offset n_points,
                                        float* points) {
    for (Offset block = begin; block < end; ++block) {
        const float* const at = u + 3 * kLanes * block;
        float x[4][kLanes], y[4][kLanes], z[4][kLanes];
        Bernstein(at, x);
        Bernstein(at + kLanes, y);
        Bernstein(at + 2 * kLanes, z);
        float sum[3][kLanes] = {};
        for (int k = 0; k < 4; ++k) {
            float plane[3][kLanes] = {};
            for (int j = 0; j < 4; ++j) {
                const float* const c = control + 12 * (j + 4 * k);
                for (int axis = 0; axis < 3; ++axis) {
                    for (int i = 0; i < kLanes; ++i) {
                        const float line =
                            x[0][i] * c[axis] + x[1][i] * c[3 + axis] + x[2][i] * c[6 + axis] + x[3][i] * c[9 + axis];
                        plane[axis][i] += y[j][i] * line;
                    }
                }
            }
            for (int axis = 0; axis < 3; ++axis) {
                for (int i = 0; i < kLanes; ++i) sum[axis][i] += z[k][i] * plane[axis][i];
            }
        }
        const int n = static_cast<int>(std::min<Offset>(kLanes, n_points - kLanes * block));
        float* const to = points + 3 * kLanes * block;
        for (int i = 0; i < n; ++i) {
            for (int axis = 0; axis < 3; ++axis) to[3 * i + axis] = sum[axis][i];
        }
    }
}

/// Points [begin, end): lines of four control points, 16 floats each, weighed along y and z; then along x.
SOLIDSUBDIV_WIDEST void DeformSpline(const float* control, Offset line, const Index* begins, const float* weights,
                                     Offset begin, Offset end, float* points) {
    for (Offset p = begin; p < end; ++p) {
        const float* const w = weights + 12 * p;
        float sum[16] = {};
        for (int k = 0; k < 4; ++k) {
            const float* const c0 = control + 4 * (begins[p] + line * line * k);
            const float *const c1 = c0 + 4 * line, *const c2 = c1 + 4 * line, *const c3 = c2 + 4 * line;
            for (int i = 0; i < 16; ++i) {
                sum[i] += w[8 + k] * (w[4] * c0[i] + w[5] * c1[i] + w[6] * c2[i] + w[7] * c3[i]);
            }
        }
        for (int axis = 0; axis < 3; ++axis) {
            points[3 * p + axis] =
                w[0] * sum[axis] + w[1] * sum[4 + axis] + w[2] * sum[8 + axis] + w[3] * sum[12 + axis];
        }
    }
}

}  // namespace

FfdBox::FfdBox(std::span<const float> points) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        float high = low[axis] = points[axis];
        for (std::size_t i = axis; i < points.size(); i += 3) {
            low[axis] = std::min(low[axis], points[i]);
            high = std::max(high, points[i]);
        }
        size[axis] = high - low[axis];
    }
}

BernsteinFfd::BernsteinFfd(std::span<const float> points) : box_(points), n_(points.size() / 3) {
    u_.assign(3 * kLanes * ((n_ + kLanes - 1) / kLanes), 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t point = i / 3, axis = i % 3;
        u_[kLanes * (3 * (point / kLanes) + axis) + point % kLanes] = (points[i] - box_.low[axis]) / box_.size[axis];
    }
}

Array<float> BernsteinFfd::ControlPoints() const {
    Array<float> control;
    for (int i = 0; i < 64; ++i) {
        const int at[] = {i % 4, i / 4 % 4, i / 16};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            control.push_back(box_.low[axis] + box_.size[axis] * static_cast<float>(at[axis]) / 3);
        }
    }
    return control;
}

void BernsteinFfd::Deform(std::span<const float> control, std::span<float> points) const {
    const Offset n = static_cast<Offset>(n_), n_blocks = (n + kLanes - 1) / kLanes;
    Sdc::ParallelFor(n_blocks, kGrain / kLanes, [&](Offset begin, Offset end) {
        DeformBernstein(control.data(), u_.data(), begin, end, n, points.data());
    });
}

SplineFfd::SplineFfd(std::span<const float> points, int n_cells) : box_(points), n_cells_(n_cells) {
    const int n_line = n_cells + 3;
    begins_.resize(points.size() / 3);
    weights_.resize(4 * points.size());
    for (std::size_t p = 0; p < begins_.size(); ++p) {
        std::array<int, 3> cell;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float x = (points[3 * p + axis] - box_.low[axis]) / box_.size[axis] * static_cast<float>(n_cells);
            cell[axis] = std::clamp(static_cast<int>(x), 0, n_cells - 1);
            const float t = x - static_cast<float>(cell[axis]), s = 1 - t;
            float* const w = &weights_[12 * p + 4 * axis];
            w[0] = s * s * s / 6;
            w[1] = (3 * t * t * t - 6 * t * t + 4) / 6;
            w[2] = (3 * s * s * s - 6 * s * s + 4) / 6;
            w[3] = t * t * t / 6;
        }
        begins_[p] = cell[0] + n_line * (cell[1] + n_line * cell[2]);
    }
}

Array<float> SplineFfd::ControlPoints() const {
    const int n_line = n_cells_ + 3;
    Array<float> control;
    for (int i = 0; i < n_line * n_line * n_line; ++i) {
        const int at[] = {i % n_line, i / n_line % n_line, i / n_line / n_line};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            control.push_back(box_.low[axis] +
                              box_.size[axis] * static_cast<float>(at[axis] - 1) / static_cast<float>(n_cells_));
        }
        control.push_back(0);
    }
    return control;
}

void SplineFfd::Deform(std::span<const float> control, std::span<float> points) const {
    Sdc::ParallelFor(static_cast<Offset>(begins_.size()), kGrain, [&](Offset begin, Offset end) {
        DeformSpline(control.data(), n_cells_ + 3, begins_.data(), weights_.data(), begin, end, points.data());
    });
}

}  // namespace SolidSubdiv::Perf

// SPDX-License-Identifier: Apache-2.0
// Plain convolutions on boxes of Z^3; nothing here knows of meshes.
#include "lattice_convolution.h"

#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

namespace SolidSubdiv::Validation {
namespace {

using LatticeRow = std::map<LatticePoint, double>;

int ParityClass(const LatticePoint& p) { return (p[0] & 1) + 2 * (p[1] & 1) + 4 * (p[2] & 1); }

// The mask by the parity of its exponents: fine - 2 q runs through one class only.
std::array<std::vector<LatticeWeight>, 8> MaskByParity() {
    std::array<std::vector<LatticeWeight>, 8> classes;
    for (const auto& [offset, weight] : BoxSplineMask()) classes[ParityClass(offset)].push_back({offset, weight});
    return classes;
}

LatticePoint ParentAt(const LatticePoint& fine, const LatticePoint& offset) {
    return {(fine[0] - offset[0]) / 2, (fine[1] - offset[1]) / 2, (fine[2] - offset[2]) / 2};
}

// Calls visit(p) for every point of the box, x fastest.
template <class Visit>
void ForEachPoint(const LatticePoint& lo, const LatticePoint& hi, Visit visit) {
    for (int z = lo[2]; z <= hi[2]; ++z)
        for (int y = lo[1]; y <= hi[1]; ++y)
            for (int x = lo[0]; x <= hi[0]; ++x) visit(LatticePoint{x, y, z});
}

}  // namespace

std::vector<LatticeWeight> BoxSplineMask() {
    LatticeRow mask = {{LatticePoint{0, 0, 0}, 1.0 / 32}};
    for (const LatticePoint& u : kDirections) {
        LatticeRow product;
        for (const auto& [p, weight] : mask)
            for (int step = -1; step <= 1; ++step)
                product[{p[0] + step * u[0], p[1] + step * u[1], p[2] + step * u[2]}] += (step == 0 ? 2 : 1) * weight;
        mask = product;
    }
    return {mask.begin(), mask.end()};
}

std::vector<LatticeWeight> SubdivisionRow(const LatticePoint& fine, int level) {
    const std::array<std::vector<LatticeWeight>, 8> mask = MaskByParity();
    LatticeRow row = {{fine, 1.0}};
    for (; level > 0; --level) {
        LatticeRow coarser;
        for (const auto& [p, weight] : row)
            for (const auto& [offset, mask_weight] : mask[ParityClass(p)])
                coarser[ParentAt(p, offset)] += weight * mask_weight;
        row = coarser;
    }
    return {row.begin(), row.end()};
}

bool LatticeValues::Contains(const LatticePoint& p) const {
    for (int i = 0; i < 3; ++i)
        if (p[i] < lo[i] || p[i] > hi[i]) return false;
    return true;
}

int LatticeValues::Offset(const LatticePoint& p) const {
    const int nx = hi[0] - lo[0] + 1, ny = hi[1] - lo[1] + 1;
    return width * (p[0] - lo[0] + nx * (p[1] - lo[1] + ny * (p[2] - lo[2])));
}

LatticeValues ValuesOnBlock(const LatticePoint& size, int width, std::vector<double> values) {
    LatticeValues result{{0, 0, 0}, size, width, std::move(values)};
    const std::size_t needed = static_cast<std::size_t>(width) * (size[0] + 1) * (size[1] + 1) * (size[2] + 1);
    if (result.values.size() != needed)
        throw std::invalid_argument("lattice values: " + std::to_string(result.values.size()) +
                                    " numbers, the block needs " + std::to_string(needed));
    return result;
}

LatticeValues Subdivide(const LatticeValues& coarse) {
    LatticeValues fine;
    fine.width = coarse.width;
    std::size_t points = 1;
    for (int i = 0; i < 3; ++i) {
        fine.lo[i] = 2 * coarse.lo[i] + 1;
        fine.hi[i] = 2 * coarse.hi[i] - 1;
        if (fine.lo[i] > fine.hi[i]) throw std::invalid_argument("lattice values: the box is too thin to subdivide");
        points *= static_cast<std::size_t>(fine.hi[i] - fine.lo[i] + 1);
    }
    fine.values.assign(points * fine.width, 0.0);
    const std::array<std::vector<LatticeWeight>, 8> mask = MaskByParity();
    ForEachPoint(fine.lo, fine.hi, [&](const LatticePoint& p) {
        double* const to = &fine.values[fine.Offset(p)];
        for (const auto& [offset, weight] : mask[ParityClass(p)]) {
            const double* const from = &coarse.values[coarse.Offset(ParentAt(p, offset))];
            for (int i = 0; i < fine.width; ++i) to[i] += weight * from[i];
        }
    });
    return fine;
}

ExpectedValues ExpectedAtLevel(const LatticeValues& control, int level, const std::vector<LatticePoint>& fine_points) {
    LatticeValues fine = control;
    for (int i = 0; i < level; ++i) fine = Subdivide(fine);
    ExpectedValues expected;
    expected.values.assign(fine_points.size() * fine.width, 0.0);
    for (std::size_t row = 0; row < fine_points.size(); ++row) {
        expected.known.push_back(fine.Contains(fine_points[row]));
        if (!expected.known.back()) continue;
        for (int i = 0; i < fine.width; ++i)
            expected.values[row * fine.width + i] = fine.values[fine.Offset(fine_points[row]) + i];
    }
    return expected;
}

std::vector<BoxSplineJet> ExpectedLimit(const LatticeValues& control, const Point3& x,
                                        const BoxSplineCoefficients& coefficients) {
    LatticePoint lo{}, hi{};
    for (int i = 0; i < 3; ++i) {
        if (!(x[i] >= control.lo[i] + 1 && x[i] <= control.hi[i] - 1))
            throw std::invalid_argument("lattice values: coordinate " + std::to_string(x[i]) +
                                        " is nearer than 1 to a side, the limit is not known there");
        // |x_i - p_i| < 2 in the support; a point at distance 2 exactly has weight 0 and may lie outside the box.
        lo[i] = static_cast<int>(std::floor(x[i])) - 1;
        hi[i] = static_cast<int>(std::ceil(x[i])) + 1;
    }
    std::vector<BoxSplineJet> limit(control.width);
    ForEachPoint(lo, hi, [&](const LatticePoint& p) {
        const BoxSplineJet n = EvaluateBoxSpline({x[0] - p[0], x[1] - p[1], x[2] - p[2]}, coefficients);
        const double* const v = &control.values[control.Offset(p)];
        for (int w = 0; w < control.width; ++w) {
            limit[w].value += v[w] * n.value;
            for (int i = 0; i < 3; ++i) {
                limit[w].gradient[i] += v[w] * n.gradient[i];
                for (int j = 0; j < 3; ++j) limit[w].hessian[i][j] += v[w] * n.hessian[i][j];
            }
        }
    });
    return limit;
}

}  // namespace SolidSubdiv::Validation

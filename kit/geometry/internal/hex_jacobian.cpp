// SPDX-License-Identifier: Apache-2.0
// Products of bilinear edges in Bernstein form, and branch and bound.
#include <solidsubdiv/kit/geometry/internal/hex_jacobian.h>

#include <limits>
#include <tuple>
#include <vector>

namespace SolidSubdiv::Geometry::Internal {

namespace {

constexpr std::array<std::size_t, 3> kStride{1, 3, 9};

/// A part of the cube on the way, and its polynomial.
struct Part {
    TriquadraticBernstein polynomial;
    Vec3 low{0, 0, 0}, size{1, 1, 1};
    double lower_bound = 0;
    int depth = 0;
};

/// Parts with the least lower bound come first in the heap; of equal ones the order is that of their places.
bool IsLater(const Part& a, const Part& b) {
    if (a.lower_bound != b.lower_bound) return a.lower_bound > b.lower_bound;
    return std::tie(a.low.x, a.low.y, a.low.z) > std::tie(b.low.x, b.low.y, b.low.z);
}

/// Takes in the corners' values.
void LookAtCorners(const Part& part, JacobianMinimum& found) {
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const std::size_t i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
        const double value = part.polynomial.coefficients[2 * i + 6 * j + 18 * k];
        if (!(value < found.least)) continue;
        found.least = value;
        found.at = part.low + Vec3{static_cast<double>(i) * part.size.x, static_cast<double>(j) * part.size.y,
                                   static_cast<double>(k) * part.size.z};
    }
}

}  // namespace

std::array<TriquadraticBernstein, 2> TriquadraticBernstein::Halves(int axis) const {
    std::array<TriquadraticBernstein, 2> halves{*this, *this};
    const std::size_t step = kStride[static_cast<std::size_t>(axis)];
    for (std::size_t i = 0; i < 27; ++i) {
        if (i / step % 3 != 0) continue;
        const double a = coefficients[i], b = coefficients[i + step], c = coefficients[i + 2 * step];
        const double ab = 0.5 * (a + b), bc = 0.5 * (b + c), middle = 0.5 * (ab + bc);
        halves[0].coefficients[i + step] = ab;
        halves[0].coefficients[i + 2 * step] = halves[1].coefficients[i] = middle;
        halves[1].coefficients[i + step] = bc;
    }
    return halves;
}

TriquadraticBernstein JacobianOf(const Trilinear& hex) {
    // Edge along an axis, at the end or not of the two other axes: edges[axis][bits of the low corner].
    std::array<std::array<Vec3, 8>, 3> edges;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t corner = 0; corner < 8; ++corner) {
            const std::size_t bit = std::size_t{1} << axis;
            edges[axis][corner] = hex.corners[corner | bit] - hex.corners[corner & ~bit];
        }
    }
    // The derivative along u is linear in v and w, that along v in u and w, and so on: each coordinate is in two of the
    // three factors. A product of two linear Bernstein polynomials has (a0 b0, (a0 b1 + a1 b0)/2, a1 b1).
    TriquadraticBernstein result;
    for (unsigned bits = 0; bits < 64; ++bits) {
        // Ends in u of the factors v and w, in v of those of u and w, in w of those of u and v.
        const std::size_t uv = bits & 1, uw = bits >> 1 & 1, vu = bits >> 2 & 1, vw = bits >> 3 & 1, wu = bits >> 4 & 1,
                          wv = bits >> 5 & 1;
        const double det = Det(edges[0][vu << 1 | wu << 2], edges[1][uv | wv << 2], edges[2][uw | vw << 1]);
        const std::size_t i = uv + uw, j = vu + vw, k = wu + wv;
        const int n_middle = (i == 1) + (j == 1) + (k == 1);
        result.coefficients[i + 3 * j + 9 * k] += det / static_cast<double>(1 << n_middle);
    }
    return result;
}

JacobianMinimum FindJacobianMinimum(const Trilinear& hex, double near_enough, double rounding, int most_parts) {
    JacobianMinimum found{.least = std::numeric_limits<double>::infinity(), .lower_bound = 0, .at = {}};
    Part whole{.polynomial = JacobianOf(hex)};
    whole.lower_bound = whole.polynomial.Least();
    LookAtCorners(whole, found);
    std::vector<Part> heap;  // made only where the corners are not the least coefficients
    for (Part part = whole;;) {
        found.lower_bound = std::min(part.lower_bound, found.least);
        const bool is_sign_known = found.lower_bound > rounding || found.least < -rounding;
        const bool is_near = found.least - found.lower_bound <= near_enough;
        // Rounding can't be told from zero by more parts.
        const bool is_flat = found.least - found.lower_bound <= rounding;
        if ((is_near && is_sign_known) || is_flat) return found;
        if (static_cast<int>(heap.size()) + 1 >= most_parts) return found;
        const int axis = part.depth % 3;
        const auto halves = part.polynomial.Halves(axis);
        double Vec3::*const coordinate = axis == 0 ? &Vec3::x : axis == 1 ? &Vec3::y : &Vec3::z;
        for (std::size_t half = 0; half < 2; ++half) {
            Part child{halves[half], part.low, part.size, halves[half].Least(), part.depth + 1};
            child.size.*coordinate *= 0.5;
            if (half == 1) child.low.*coordinate += child.size.*coordinate;
            LookAtCorners(child, found);
            heap.push_back(child);
            std::push_heap(heap.begin(), heap.end(), IsLater);
        }
        std::pop_heap(heap.begin(), heap.end(), IsLater);
        part = heap.back();
        heap.pop_back();
    }
}

}  // namespace SolidSubdiv::Geometry::Internal

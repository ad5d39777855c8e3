// SPDX-License-Identifier: Apache-2.0
// Coordinates inside the elements that are split again and again: where corners lie, how far inside a place is.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <solidsubdiv/far/internal/pocket.h>

namespace SolidSubdiv::Far::Internal {

using Coordinates = std::array<double, 3>;
using Matrix3 = std::array<std::array<double, 3>, 3>;

/// Where the vertices of an element lie in its own coordinates (place.h). @param n of a face, its vertices: 3 or 4
std::vector<Coordinates> CornersOf(RootKind kind, Index n);

/// How far inside an element a place is: at least 0 inside.
double Depth(RootKind kind, Index n, const Coordinates& at);

/// Origin and axes of an element's coordinates, given where its vertices lie.
std::array<Coordinates, 4> FrameOf(RootKind kind, std::span<const Coordinates> corners);

/// Weights of an element's corners at a place, linear as place.h says.
struct CornerWeights {
    std::array<double, 8> weights{};
    std::size_t n = 0;

    CornerWeights(std::initializer_list<double> list) : n(list.size()) {
        std::copy(list.begin(), list.end(), weights.begin());
    }
    std::span<const double> View() const { return {weights.data(), n}; }
};
CornerWeights WeightsOfCorners(RootKind kind, Index n, const Coordinates& at);

/// Ends of an element's edges at one of its corners: three (of a face two) that are independent first.
std::vector<Index> NeighborsOf(RootKind kind, Index n, Index corner);

Matrix3 Inverse(const Matrix3& matrix);
/// The product of two changes of coordinates, the first applied first.
Matrix3 Multiply(const Matrix3& second, const Matrix3& first);

}  // namespace SolidSubdiv::Far::Internal

// SPDX-License-Identifier: Apache-2.0
// The inner loops of a deformation: cells that move their points, rows that are summed. Positions lie at distances of
// four numbers, so that one load brings one; maps of hexahedra are taken as polynomials, whose coefficients their
// points share.
#pragma once

#include <cstring>

#include <solidsubdiv/apps/deform/embedding.h>
#include <solidsubdiv/apps/deform/internal/grouped_rows.h>

namespace SolidSubdiv::Deform::Internal {

template <class To, class From>
Array<To> Converted(const Array<From>& from) {
    return Array<To>(from.begin(), from.end());
}

/// EmbeddedCells with coordinates of Real.
template <class Real, int kCorners>
struct Cells {
    Array<Index> corners;
    Array<Index> offsets;
    Array<Index> points;
    Array<Real> at;

    explicit Cells(const EmbeddedCells<kCorners>& cells)
        : corners(cells.corners),
          offsets(Converted<Index>(cells.offsets)),
          points(cells.points),
          at(Converted<Real>(cells.at)) {}
    Index n_cells() const { return static_cast<Index>(offsets.size()) - 1; }
    Offset Bytes() const {
        return static_cast<Offset>((corners.size() + offsets.size() + points.size()) * sizeof(Index) +
                                   at.size() * sizeof(Real));
    }
};

template <class Real>
struct Four {
    typedef Real Type __attribute__((vector_size(4 * sizeof(Real))));
};

/// In halves: compilers without AVX keep vectors of 32 bytes in memory.
template <>
struct Four<double> {
    typedef double Half __attribute__((vector_size(16)));
    struct Type {
        Half low, high;
        double operator[](int i) const { return i < 2 ? low[i] : high[i - 2]; }
        friend Type operator+(const Type& a, const Type& b) { return {a.low + b.low, a.high + b.high}; }
        friend Type operator-(const Type& a, const Type& b) { return {a.low - b.low, a.high - b.high}; }
        friend Type operator*(double w, const Type& a) { return {w * a.low, w * a.high}; }
        friend Type operator*(const Type& a, double w) { return w * a; }
        Type& operator+=(const Type& a) { return *this = *this + a; }
    };
};

/// Reads the positions of a cell's corners.
template <class Real, int kCorners>
inline void Load(const Real* patch, const Index* corners, typename Four<Real>::Type* x) {
    for (int i = 0; i < kCorners; ++i) std::memcpy(&x[i], patch + 4 * static_cast<Offset>(corners[i]), sizeof x[i]);
}

template <class Real>
inline void Store(const typename Four<Real>::Type& x, Index point, Real* points) {
    Real* const to = points + 3 * static_cast<Offset>(point);
    to[0] = x[0];
    to[1] = x[1];
    to[2] = x[2];
}

/// Moves points [begin, end) of a cell.
template <class Real>
inline void MoveCell(const Cells<Real, 8>& cells, Index cell, const Real* patch, Index begin, Index end, Real* points) {
    using Vector = typename Four<Real>::Type;
    Vector x[8];
    Load<Real, 8>(patch, &cells.corners[8 * static_cast<std::size_t>(cell)], x);
    // Corners in VTK's order; the map is x0 + u a + v b + w c + uv ab + uw ac + vw bc + uvw abc.
    const Vector a = x[1] - x[0], b = x[3] - x[0], c = x[4] - x[0];
    const Vector ab = (x[2] - x[3]) - a, ac = (x[5] - x[4]) - a, bc = (x[7] - x[4]) - b;
    const Vector abc = ((x[6] - x[7]) - (x[5] - x[4])) - ab;
    for (Index i = begin; i < end; ++i) {
        const Real* const at = &cells.at[3 * static_cast<std::size_t>(i)];
        const Vector point =
            (x[0] + at[1] * b + at[2] * (c + at[1] * bc)) + at[0] * ((a + at[1] * ab) + at[2] * (ac + at[1] * abc));
        Store<Real>(point, cells.points[i], points);
    }
}

template <class Real>
inline void MoveCell(const Cells<Real, 4>& cells, Index cell, const Real* patch, Index begin, Index end, Real* points) {
    using Vector = typename Four<Real>::Type;
    Vector x[4];
    Load<Real, 4>(patch, &cells.corners[4 * static_cast<std::size_t>(cell)], x);
    const Vector a = x[1] - x[0], b = x[2] - x[0], c = x[3] - x[0];
    for (Index i = begin; i < end; ++i) {
        const Real* const at = &cells.at[3 * static_cast<std::size_t>(i)];
        Store<Real>(x[0] + at[0] * a + at[1] * b + at[2] * c, cells.points[i], points);
    }
}

/// A row's terms in its order, each product rounded before it is added: the bits of the backends.
template <class Real>
inline void SumRow(const Far::StencilRows<Real>& rows, Index row, const Real* source, typename Four<Real>::Type& sum) {
    typename Four<Real>::Type x;
    sum = typename Four<Real>::Type{};
    for (Offset k = rows.offsets[row]; k < rows.offsets[row + 1]; ++k) {
        std::memcpy(&x, source + 4 * static_cast<Offset>(rows.indices[k]), sizeof x);
        sum += x * rows.weights[k];
    }
}
template <class Real>
inline void SumRow(const GroupedRows<Real>& rows, Index row, const Real* source, typename Four<Real>::Type& sum) {
    sum = typename Four<Real>::Type{};
    rows.ForEachTerm(row, [&](Index i, Real weight) {
        typename Four<Real>::Type x;
        std::memcpy(&x, source + 4 * static_cast<Offset>(i), sizeof x);
        sum += x * weight;
    });
}

}  // namespace SolidSubdiv::Deform::Internal

// SPDX-License-Identifier: Apache-2.0
// The inner loops of the cpu backend; see kernels.h.
//
// One template does all the work: an element's values are held in vectors of kLanes numbers. Where the length is no
// multiple of that, the last vector overlaps the one before it (values 0-3 and 1-4 of five): what is computed twice is
// the same, and nothing outside the element is read or written, so neighbours may change meanwhile. Vectors are the
// compilers' own (GCC, clang): no instruction is named here; everything is inlined into functions that say which
// instructions they may use.
#include <solidsubdiv/osd/cpu/internal/kernels.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#if defined(__x86_64__)
#define SOLIDSUBDIV_HAS_AVX2 1
#endif
// A function for the instructions of its caller.
#define SOLIDSUBDIV_INLINE inline __attribute__((always_inline))

namespace SolidSubdiv::Osd::Internal {

namespace {

/// How many bytes of a table are asked for before they are used: what arrives in the time that memory takes to answer.
constexpr int kPrefetchBytes = 1024;

template <class Real, int kLanes>
struct VectorOf {
    typedef Real Type __attribute__((vector_size(kLanes * sizeof(Real))));
};
template <class Real>
struct VectorOf<Real, 1> {
    using Type = Real;
};

template <class Real, int kLanes>
SOLIDSUBDIV_INLINE void Load(typename VectorOf<Real, kLanes>::Type& vector, const Real* from) {
    std::memcpy(&vector, from, sizeof vector);
}

/// Three values and a 0, in as few steps as compilers find.
template <class Real>
SOLIDSUBDIV_INLINE void LoadThree(typename VectorOf<Real, 4>::Type& vector, const Real* from) {
    using Vector = typename VectorOf<Real, 4>::Type;
    if constexpr (sizeof(Real) == sizeof(float)) {
        typedef std::int64_t Pair __attribute__((vector_size(16)));
        std::int64_t two;
        std::memcpy(&two, from, sizeof two);
        vector = reinterpret_cast<Vector>(Pair{two, 0});
        vector[2] = from[2];
    } else {
        vector = Vector{from[0], from[1], from[2], 0};
    }
}

/// The arrays of a call, from its first row and first value on.
template <class Real>
struct Arrays {
    const Far::StencilRows<Real>& rows;
    const Real* source;
    Offset source_stride;
    Real* destination;
    Offset destination_stride;
};

/// How the values of an element are spread over vectors, known when this is compiled. The last vector starts kUsed
/// values before the element's end, and only so many of it are written.
template <int kLanesOf, int kVectorsOf, int kUsedOf = kLanesOf, bool kIsPaddedOf = false>
struct Layout {
    static constexpr int kLanes = kLanesOf, kVectors = kVectorsOf, kUsed = kUsedOf;
    static constexpr bool kIsPadded = kIsPaddedOf;  ///< what follows the used values may be read
};

/// Sums rows [begin, end).
template <class Real, class Layout>
SOLIDSUBDIV_INLINE void SumRows(const Arrays<Real>& arrays, int length, Index begin, Index end) {
    using Vector = typename VectorOf<Real, Layout::kLanes>::Type;
    const Offset* const offsets = arrays.rows.offsets.data();
    const Index* const indices = arrays.rows.indices.data();
    const Real* const weights = arrays.rows.weights.data();
    const int last = length - Layout::kUsed;
    const auto place = [last](int i) __attribute__((always_inline)) {
        return i < Layout::kVectors - 1 ? i * Layout::kLanes : last;
    };

    Offset k = offsets[begin];
    for (Index row = begin; row < end; ++row) {
        __builtin_prefetch(reinterpret_cast<const char*>(indices + k) + kPrefetchBytes);
        __builtin_prefetch(reinterpret_cast<const char*>(weights + k) + kPrefetchBytes);
        Vector sums[Layout::kVectors];
        for (int i = 0; i < Layout::kVectors; ++i) sums[i] = Vector{};
        for (const Offset row_end = offsets[row + 1]; k < row_end; ++k) {
            const Real* const element = arrays.source + indices[k] * arrays.source_stride;
            for (int i = 0; i < Layout::kVectors; ++i) {
                Vector values;
                if constexpr (Layout::kUsed == 3 && !Layout::kIsPadded) {
                    LoadThree<Real>(values, element);
                } else {
                    Load<Real, Layout::kLanes>(values, element + place(i));
                }
                sums[i] += values * weights[k];
            }
        }
        Real* const element = arrays.destination + row * arrays.destination_stride;
        for (int i = 0; i < Layout::kVectors; ++i) {
            const Vector sum = sums[i];
            if constexpr (Layout::kUsed == 3) {
                for (int c = 0; c < 3; ++c) element[c] = sum[c];
            } else {
                std::memcpy(element + place(i), &sum, sizeof sum);
            }
        }
    }
}

/// What every processor of the architecture can do.
struct Baseline {
    template <class Real, class Layout>
    static void Sum(const Arrays<Real>& arrays, int length, Index begin, Index end) {
        SumRows<Real, Layout>(arrays, length, begin, end);
    }
};

#if SOLIDSUBDIV_HAS_AVX2
struct Avx2 {
    template <class Real, class Layout>
    __attribute__((target("avx2"))) static void Sum(const Arrays<Real>& arrays, int length, Index begin, Index end) {
        SumRows<Real, Layout>(arrays, length, begin, end);
    }
};
#endif

template <class Instructions, class Real>
void EvalRows(const Far::StencilRows<Real>& rows, const BufferView<const Real>& source,
              const BufferView<Real>& destination, Index begin, Index end) {
    const int length = destination.descriptor.length;
    constexpr int kLongest = 16;  // values summed in one pass over a row
    for (int first = 0; first < length; first += kLongest) {
        // The last pass of several overlaps the one before, as vectors do.
        const int at = length > kLongest ? std::min(first, length - kLongest) : 0;
        const int n = std::min(length, kLongest);
        const Arrays<Real> arrays{rows, source.Element(0) + at, source.descriptor.stride, destination.Element(0) + at,
                                  destination.descriptor.stride};
        if (n == 1) {
            Instructions::template Sum<Real, Layout<1, 1>>(arrays, n, begin, end);
        } else if (n == 2) {
            Instructions::template Sum<Real, Layout<2, 1>>(arrays, n, begin, end);
        } else if (n == 3 && source.descriptor.length == 4) {
            Instructions::template Sum<Real, Layout<4, 1, 3, true>>(arrays, n, begin, end);
        } else if (n == 3) {
            Instructions::template Sum<Real, Layout<4, 1, 3>>(arrays, n, begin, end);
        } else if (n == 4) {
            Instructions::template Sum<Real, Layout<4, 1>>(arrays, n, begin, end);
        } else if (n <= 8) {
            Instructions::template Sum<Real, Layout<4, 2>>(arrays, n, begin, end);
        } else if (n <= 12) {
            Instructions::template Sum<Real, Layout<4, 3>>(arrays, n, begin, end);
        } else {
            Instructions::template Sum<Real, Layout<4, 4>>(arrays, n, begin, end);
        }
    }
}

}  // namespace

template <class Real>
void EvalRowsBaseline(const Far::StencilRows<Real>& rows, const BufferView<const Real>& source,
                      const BufferView<Real>& destination, Index begin, Index end) {
    EvalRows<Baseline>(rows, source, destination, begin, end);
}

template <class Real>
EvalRowsFunction<Real> BestEvalRows() {
#if SOLIDSUBDIV_HAS_AVX2
    if (__builtin_cpu_supports("avx2")) return &EvalRows<Avx2, Real>;
#endif
    return &EvalRowsBaseline<Real>;
}

template void EvalRowsBaseline(const Far::StencilRows<float>&, const BufferView<const float>&, const BufferView<float>&,
                               Index, Index);
template void EvalRowsBaseline(const Far::StencilRows<double>&, const BufferView<const double>&,
                               const BufferView<double>&, Index, Index);
template EvalRowsFunction<float> BestEvalRows();
template EvalRowsFunction<double> BestEvalRows();

}  // namespace SolidSubdiv::Osd::Internal

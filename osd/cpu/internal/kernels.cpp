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

/// Reads and writes the first kUsed lanes; the others become 0.
template <class Real, int kLanes, int kUsed>
struct Lanes {
    using Vector = typename VectorOf<Real, kLanes>::Type;

    static SOLIDSUBDIV_INLINE void Load(Vector& vector, const Real* from) { std::memcpy(&vector, from, sizeof vector); }
    static SOLIDSUBDIV_INLINE void Store(const Vector& vector, Real* to) { std::memcpy(to, &vector, sizeof vector); }
};
template <class Real>
struct Lanes<Real, 4, 3> {
    using Vector = typename VectorOf<Real, 4>::Type;

    static SOLIDSUBDIV_INLINE void Load(Vector& vector, const Real* from) {
        if constexpr (sizeof(Real) == sizeof(float)) {  // the first two in one step: compilers don't see it themselves
            std::int64_t two;
            std::memcpy(&two, from, sizeof two);
            const Pair low = {two, 0};
            const Vector high = {from[2]};
            vector = __builtin_shufflevector(reinterpret_cast<Vector>(low), high, 0, 1, 4, 5);
        } else {
            vector = Vector{from[0], from[1], from[2], 0};
        }
    }
    static SOLIDSUBDIV_INLINE void Store(const Vector& vector, Real* to) {
        for (int i = 0; i < 3; ++i) to[i] = vector[i];
    }

  private:
    typedef std::int64_t Pair __attribute__((vector_size(16)));
};

/// The arrays of a call, from its first row and first value on.
template <class Real>
struct Arrays {
    const Far::StencilRows<Real>& rows;
    const Real* source;
    Offset source_stride;
    Real* destination;
    Offset destination_stride;
};

/// Sums rows [begin, end) for the kVectors vectors that cover values [0, length) of each element.
/// kStride: the source's stride, where it is known when this is compiled; or 0.
template <class Real, int kLanes, int kVectors, int kUsed = kLanes, int kStride = 0>
SOLIDSUBDIV_INLINE void SumRows(const Arrays<Real>& arrays, int length, Index begin, Index end) {
    using Access = Lanes<Real, kLanes, kUsed>;
    using Vector = typename Access::Vector;
    constexpr int kUnrolled = kVectors == 1 ? 4 : 1;
    const Offset* const offsets = arrays.rows.offsets.data();
    const Index* index = arrays.rows.indices.data() + offsets[begin];
    const Real* weight = arrays.rows.weights.data() + offsets[begin];
    const Offset stride = kStride > 0 ? kStride : arrays.source_stride;
    const int last = length - kUsed;  // where the last vector starts

    for (Index row = begin; row < end; ++row) {
        __builtin_prefetch(reinterpret_cast<const char*>(index) + kPrefetchBytes);
        __builtin_prefetch(reinterpret_cast<const char*>(weight) + kPrefetchBytes);
        Vector sums[kVectors];
        for (int i = 0; i < kVectors; ++i) sums[i] = Vector{};
        const auto add = [&](const Real* element, Real w) __attribute__((always_inline)) {
            for (int i = 0; i < kVectors; ++i) {
                Vector values;
                Access::Load(values, element + (i < kVectors - 1 ? i * kLanes : last));
                sums[i] += values * w;
            }
        };
        Offset n = offsets[row + 1] - offsets[row];
        for (; n >= kUnrolled; n -= kUnrolled, index += kUnrolled, weight += kUnrolled) {
            for (int j = 0; j < kUnrolled; ++j) add(arrays.source + index[j] * stride, weight[j]);
        }
        for (; n > 0; --n, ++index, ++weight) add(arrays.source + *index * stride, *weight);

        Real* const element = arrays.destination + row * arrays.destination_stride;
        for (int i = 0; i < kVectors; ++i) {
            const Vector sum = sums[i];
            Access::Store(sum, element + (i < kVectors - 1 ? i * kLanes : last));
        }
    }
}

template <class Real>
SOLIDSUBDIV_INLINE void EvalRows(const Far::StencilRows<Real>& rows, const BufferView<const Real>& source,
                                 const BufferView<Real>& destination, Index begin, Index end) {
    const int length = source.descriptor.length;
    constexpr int kLongest = 16;  // values summed in one pass over a row
    for (int first = 0; first < length; first += kLongest) {
        // The last pass of several overlaps the one before, as vectors do.
        const int at = length > kLongest ? std::min(first, length - kLongest) : 0;
        const int n = std::min(length, kLongest);
        const Arrays<Real> arrays{rows, source.Element(0) + at, source.descriptor.stride, destination.Element(0) + at,
                                  destination.descriptor.stride};
        if (n == 1) {
            SumRows<Real, 1, 1>(arrays, n, begin, end);
        } else if (n == 2) {
            SumRows<Real, 2, 1>(arrays, n, begin, end);
        } else if (n == 3 && source.descriptor.stride == 3) {
            SumRows<Real, 4, 1, 3, 3>(arrays, n, begin, end);
        } else if (n == 3) {
            SumRows<Real, 4, 1, 3>(arrays, n, begin, end);
        } else if (n == 4) {
            SumRows<Real, 4, 1>(arrays, n, begin, end);
        } else if (n <= 8) {
            SumRows<Real, 4, 2>(arrays, n, begin, end);
        } else if (n <= 12) {
            SumRows<Real, 4, 3>(arrays, n, begin, end);
        } else {
            SumRows<Real, 4, 4>(arrays, n, begin, end);
        }
    }
}

#if SOLIDSUBDIV_HAS_AVX2
template <class Real>
__attribute__((target("avx2"))) void EvalRowsAvx2(const Far::StencilRows<Real>& rows,
                                                  const BufferView<const Real>& source,
                                                  const BufferView<Real>& destination, Index begin, Index end) {
    EvalRows<Real>(rows, source, destination, begin, end);
}
#endif

}  // namespace

template <class Real>
void EvalRowsBaseline(const Far::StencilRows<Real>& rows, const BufferView<const Real>& source,
                      const BufferView<Real>& destination, Index begin, Index end) {
    EvalRows<Real>(rows, source, destination, begin, end);
}

template <class Real>
EvalRowsFunction<Real> BestEvalRows() {
#if SOLIDSUBDIV_HAS_AVX2
    if (__builtin_cpu_supports("avx2")) return &EvalRowsAvx2<Real>;
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

// SPDX-License-Identifier: Apache-2.0
// Rows made, applied and forgotten.
#include <solidsubdiv/far/primvar_refiner.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include <solidsubdiv/far/internal/row_buffer.h>
#include <solidsubdiv/far/internal/rows.h>
#include <solidsubdiv/far/internal/scheme_check.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Far {

namespace {

constexpr Offset kGrain = 2048;

/// Elements of three values at distances of four, which are loaded at once.
template <class Real>
Array<Real> PadToFour(const Real* source, Index n) {
    Array<Real> padded(4 * static_cast<std::size_t>(n));
    Sdc::ParallelFor(n, kGrain, [&](Offset begin, Offset end) {
        for (Offset i = begin; i < end; ++i) {
            std::copy(source + 3 * i, source + 3 * i + 3, padded.data() + 4 * i);
            padded[4 * i + 3] = 0;
        }
    });
    return padded;
}

/// Vectors are the compilers' own (GCC, clang): left to themselves they handle two of three values at once.
template <class Real>
struct VectorOfFour {
    typedef Real Type __attribute__((vector_size(4 * sizeof(Real))));
};

/// The sum of a row's values, of which three are wanted. @param padded see PadToFour
template <class Real>
void SumThree(const Internal::RowBuffer<Real>& row, const Real* padded, Real* destination) {
    using Vector = typename VectorOfFour<Real>::Type;
    Vector sum{};
    for (std::size_t k = 0; k < row.n; ++k) {
        Vector values;
        std::memcpy(&values, padded + 4 * static_cast<Offset>(row.indices[k]), sizeof values);
        sum += row.weights[k] * values;
    }
    for (int c = 0; c < 3; ++c) destination[c] = sum[c];
}

/// The same for any width, in room for it.
template <class Real>
void Sum(const Internal::RowBuffer<Real>& row, const Real* source, std::span<Real> sum, Real* destination) {
    std::fill(sum.begin(), sum.end(), Real{0});
    for (std::size_t k = 0; k < row.n; ++k) {
        const Real* const from = source + static_cast<std::size_t>(row.indices[k]) * sum.size();
        for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += row.weights[k] * from[c];
    }
    std::copy(sum.begin(), sum.end(), destination);
}

template <class Real, class Scheme>
void InterpolateLevel(const Level& parent, const Sharpness& sharpness, const Scheme& scheme, const Real* source,
                      Real* destination, int width) {
    const Internal::Rows<Scheme> rows(parent, sharpness, scheme);
    Index first = 0;
    if constexpr (rows.kVerticesStay) {
        first = parent.n_vertices;
        Sdc::ParallelFor(static_cast<Offset>(first) * width, kGrain, [&](Offset begin, Offset end) {
            std::copy(source + begin, source + end, destination + begin);
        });
    }
    const Array<Real> padded = width == 3 ? PadToFour(source, parent.n_vertices) : Array<Real>{};
    Sdc::ParallelFor(rows.n_children() - first, kGrain, [&](Offset begin, Offset end) {
        Internal::RowBuffer<Real> row;
        std::vector<Real> sum(static_cast<std::size_t>(width));
        for (Offset child = first + begin; child < first + end; ++child) {
            row.Read(rows, static_cast<Index>(child));
            Real* const to = destination + child * width;
            if (width == 3) {
                SumThree(row, padded.data(), to);
            } else {
                Sum<Real>(row, source, sum, to);
            }
        }
    });
}

}  // namespace

PrimvarRefiner::PrimvarRefiner(const TopologyRefiner& refiner, const Sdc::Scheme& scheme)
    : refiner_(refiner), scheme_(scheme) {
    Internal::CheckScheme(refiner, scheme);
}

template <class Real>
void PrimvarRefiner::Interpolate(int level, std::span<const Real> source, std::span<Real> destination,
                                 int width) const {
    if (level < 1 || level > refiner_.max_level()) {
        throw InvalidInput("values of level " + std::to_string(level) + " are asked for; levels are 1 to " +
                           std::to_string(refiner_.max_level()));
    }
    const Level& parent = refiner_.level(level - 1);
    const auto require = [&](std::size_t size, Index n, const char* name) {
        if (width < 1 || size != static_cast<std::size_t>(n) * static_cast<std::size_t>(width)) {
            throw InvalidInput(std::string(name) + " has " + std::to_string(size) + " numbers; " + std::to_string(n) +
                               " vertices of width " + std::to_string(width) + " are needed");
        }
    };
    require(source.size(), parent.n_vertices, "the source");
    require(destination.size(), refiner_.level(level).n_vertices, "the destination");
    const Sharpness sharpness = Internal::SharpnessOfLevels(refiner_, scheme_, level).back();
    std::visit(
        [&](const auto& s) { InterpolateLevel<Real>(parent, sharpness, s, source.data(), destination.data(), width); },
        scheme_);
}

template void PrimvarRefiner::Interpolate(int, std::span<const double>, std::span<double>, int) const;
template void PrimvarRefiner::Interpolate(int, std::span<const float>, std::span<float>, int) const;

}  // namespace SolidSubdiv::Far

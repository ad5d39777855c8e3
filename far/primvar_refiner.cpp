// SPDX-License-Identifier: Apache-2.0
// Rows made, applied and forgotten.
#include <solidsubdiv/far/primvar_refiner.h>

#include <algorithm>
#include <string>
#include <vector>

#include <solidsubdiv/far/internal/row_buffer.h>
#include <solidsubdiv/far/internal/rows.h>
#include <solidsubdiv/far/internal/scheme_check.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Far {

namespace {

constexpr Offset kGrain = 2048;

/// Writes the sum of the row's values. @tparam kWidth numbers a value, where it is known; or 0
template <int kWidth, class Real>
void Apply(const Internal::RowBuffer<Real>& row, const Real* source, int width, Real* sum, Real* destination) {
    if constexpr (kWidth > 0) width = kWidth;
    std::fill(sum, sum + width, Real{0});
    for (std::size_t k = 0; k < row.n; ++k) {
        const Real* const from = source + static_cast<Offset>(row.indices[k]) * width;
        for (int c = 0; c < width; ++c) sum[c] += row.weights[k] * from[c];
    }
    std::copy(sum, sum + width, destination);
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
    Sdc::ParallelFor(rows.n_children() - first, kGrain, [&](Offset begin, Offset end) {
        Internal::RowBuffer<Real> row;
        std::vector<Real> sum(static_cast<std::size_t>(width));
        for (Offset child = first + begin; child < first + end; ++child) {
            row.Read(rows, static_cast<Index>(child));
            Real* const to = destination + child * width;
            if (width == 3) {
                Real point[3];
                Apply<3>(row, source, width, point, to);
            } else {
                Apply<0>(row, source, width, sum.data(), to);
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

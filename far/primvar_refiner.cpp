// SPDX-License-Identifier: Apache-2.0
// Rows made, applied and forgotten.
#include <solidsubdiv/far/primvar_refiner.h>

#include <string>

#include <solidsubdiv/far/internal/rows.h>
#include <solidsubdiv/far/internal/scheme_check.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Far {

namespace {

constexpr Offset kGrain = 2048;

template <class Real, class Scheme>
void InterpolateLevel(const Level& parent, const Scheme& scheme, const Real* source, Real* destination, int width) {
    const Internal::Rows<Scheme> rows(parent, scheme);
    // length(i) and fill(i, ...) of the rows of one kind of parent, whose points start at `first`.
    const auto apply = [&](Offset n, Offset first, auto&& length, auto&& fill) {
        Sdc::ParallelFor(n, kGrain, [&](Offset begin, Offset end) {
            std::vector<Index> indices;
            std::vector<double> weights;
            for (Offset i = begin; i < end; ++i) {
                const std::size_t count = static_cast<std::size_t>(length(static_cast<Index>(i)));
                indices.resize(count);
                weights.resize(count);
                fill(static_cast<Index>(i), indices.data(), weights.data());
                for (int c = 0; c < width; ++c) {
                    Real sum = 0;
                    for (std::size_t k = 0; k < count; ++k) {
                        sum += static_cast<Real>(weights[k]) * source[static_cast<Offset>(indices[k]) * width + c];
                    }
                    destination[(first + i) * width + c] = sum;
                }
            }
        });
    };
    apply(
        parent.n_vertices, 0, [&](Index v) { return rows.VertexLength(v); },
        [&](Index v, Index* i, double* w) { rows.FillVertex(v, i, w); });
    apply(
        parent.n_edges, parent.n_vertices, [&](Index e) { return rows.EdgeLength(e); },
        [&](Index e, Index* i, double* w) { rows.FillEdge(e, i, w); });
    apply(
        parent.n_octs, static_cast<Offset>(parent.n_vertices) + parent.n_edges, [&](Index) { return rows.kOctLength; },
        [&](Index o, Index* i, double* w) { rows.FillOct(o, i, w); });
}

}  // namespace

PrimvarRefiner::PrimvarRefiner(const TopologyRefiner& refiner, const Sdc::Scheme& scheme)
    : refiner_(refiner), scheme_(scheme) {
    Internal::CheckScheme(refiner.level(0), scheme);
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
    std::visit([&](const auto& s) { InterpolateLevel<Real>(parent, s, source.data(), destination.data(), width); },
               scheme_);
}

template void PrimvarRefiner::Interpolate(int, std::span<const double>, std::span<double>, int) const;
template void PrimvarRefiner::Interpolate(int, std::span<const float>, std::span<float>, int) const;

}  // namespace SolidSubdiv::Far

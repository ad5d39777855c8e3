// SPDX-License-Identifier: Apache-2.0
// Cascaded tables: count, scan, fill; rows that must be made to be counted are made once, a chunk at a time.
#include <solidsubdiv/far/stencil_table.h>

#include <string>

#include <solidsubdiv/far/internal/compose.h>
#include <solidsubdiv/far/internal/row_maker.h>
#include <solidsubdiv/far/internal/scheme_check.h>
#include <solidsubdiv/far/internal/with_rows.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Far {

namespace {

constexpr Offset kGrain = 4096;

/// Rows whose lengths are known beforehand.
template <class Real, class Scheme>
StencilRows<Real> MakeCountedRows(const Level& parent, const Internal::Rows<Scheme>& rows) {
    const Offset first_edge = parent.n_vertices, first_oct = first_edge + parent.n_edges, n = first_oct + parent.n_octs;

    StencilRows<Real> table;
    table.n_sources = parent.n_vertices;
    table.offsets.resize(static_cast<std::size_t>(n) + 1);
    Offset* const offsets = table.offsets.data();
    Sdc::ParallelFor(parent.n_vertices, kGrain, [&](Offset begin, Offset end) {
        for (Offset v = begin; v < end; ++v) offsets[v] = rows.VertexLength(static_cast<Index>(v));
    });
    Sdc::ParallelFor(parent.n_edges, kGrain, [&](Offset begin, Offset end) {
        for (Offset e = begin; e < end; ++e) offsets[first_edge + e] = rows.EdgeLength(static_cast<Index>(e));
    });
    Sdc::ParallelFor(parent.n_octs, kGrain, [&](Offset begin, Offset end) {
        for (Offset o = begin; o < end; ++o) offsets[first_oct + o] = rows.OctLength();
    });
    const Offset n_weights = Sdc::ScanLengths(table.offsets);

    table.indices.resize(static_cast<std::size_t>(n_weights));
    table.weights.resize(static_cast<std::size_t>(n_weights));
    Index* const indices = table.indices.data();
    Real* const weights = table.weights.data();
    Sdc::ParallelFor(parent.n_vertices, kGrain, [&](Offset begin, Offset end) {
        for (Offset v = begin; v < end; ++v)
            rows.FillVertex(static_cast<Index>(v), indices + offsets[v], weights + offsets[v]);
    });
    Sdc::ParallelFor(parent.n_edges, kGrain, [&](Offset begin, Offset end) {
        Internal::RowScratch scratch;
        for (Offset e = begin; e < end; ++e) {
            const Offset at = offsets[first_edge + e];
            rows.FillEdge(static_cast<Index>(e), indices + at, weights + at, scratch);
        }
    });
    Sdc::ParallelFor(parent.n_octs, kGrain, [&](Offset begin, Offset end) {
        Internal::RowScratch scratch;
        for (Offset o = begin; o < end; ++o) {
            const Offset at = offsets[first_oct + o];
            rows.FillOct(static_cast<Index>(o), indices + at, weights + at, scratch);
        }
    });
    return table;
}

template <class Real>
StencilRows<Real> MakeRows(const TopologyRefiner& refiner, int parent, const Sharpness& sharpness,
                           const Sdc::Scheme& scheme) {
    StencilRows<Real> table;
    Internal::WithRows(refiner, parent, sharpness, scheme, [&]<class Rows>(const Rows& rows) {
        if constexpr (Rows::kHasLengths) {
            table = MakeCountedRows<Real>(refiner.level(parent), rows);
        } else {
            table = Internal::RowMaker<Real, Internal::RowScratch>(rows.n_children(), refiner.n_vertices(parent), {})
                        .Make([&](Index child) { return rows.MaxLength(child); },
                              [&](Index child, Internal::RowScratch& scratch, Index* indices, Real* weights) {
                                  return rows.Fill(child, indices, weights, scratch);
                              });
        }
    });
    return table;
}

}  // namespace

template <class Real>
StencilTableReal<Real> StencilTableReal<Real>::Create(const TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                                                      const StencilTableOptions& options) {
    Internal::CheckScheme(refiner, scheme);
    const int max_level = options.max_level < 0 ? refiner.max_level() : options.max_level;
    if (max_level > refiner.max_level()) {
        throw InvalidInput("stencils of level " + std::to_string(max_level) +
                           " are asked for; the refiner's last level is " + std::to_string(refiner.max_level()));
    }
    StencilTableReal table;
    table.n_control_vertices_ = refiner.n_vertices(0);
    const std::vector<Sharpness> sharpness = Internal::SharpnessOfLevels(refiner, scheme, max_level);
    for (int i = 1; i <= max_level; ++i) {
        Report(options.progress, "stencils", static_cast<double>(i - 1) / max_level);
        table.levels_.push_back(MakeRows<Real>(refiner, i - 1, sharpness[i - 1], scheme));
    }
    Report(options.progress, "stencils", 1.0);
    return table;
}

template <class Real>
StencilTableReal<Real> StencilTableReal<Real>::CreateComposite(const TopologyRefiner& refiner,
                                                               const Sdc::Scheme& scheme,
                                                               std::span<const CompositeRows> requests,
                                                               const Progress& progress) {
    Internal::CheckScheme(refiner, scheme);
    for (const CompositeRows& r : requests) {
        if (r.level < 0 || r.level > refiner.max_level()) {
            throw InvalidInput("composite rows of level " + std::to_string(r.level) +
                               " are asked for; levels are 0 to " + std::to_string(refiner.max_level()));
        }
    }
    StencilTableReal table;
    table.n_control_vertices_ = refiner.n_vertices(0);
    table.levels_.push_back(Internal::Compose<Real>(refiner, scheme, requests, progress));
    return table;
}

template <class Real>
Offset StencilTableReal<Real>::Bytes() const {
    Offset bytes = 0;
    for (const auto& level : levels_) bytes += level.Bytes();
    return bytes;
}

template <class Real>
StencilTableReal<Real> StencilTableReal<Real>::FromRows(Index n_control_vertices,
                                                        std::vector<StencilRows<Real>> levels) {
    StencilTableReal table;
    table.n_control_vertices_ = n_control_vertices;
    table.levels_ = std::move(levels);
    return table;
}

template class StencilTableReal<double>;
template class StencilTableReal<float>;

}  // namespace SolidSubdiv::Far

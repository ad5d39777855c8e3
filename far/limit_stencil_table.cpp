// SPDX-License-Identifier: Apache-2.0
// Limit masks: closed forms where there are any, otherwise powers of the local matrix.
#include <solidsubdiv/far/limit_stencil_table.h>

#include <algorithm>
#include <string>

#include <solidsubdiv/far/internal/local_matrix.h>
#include <solidsubdiv/far/internal/polyhedral_limits.h>
#include <solidsubdiv/far/internal/scheme_check.h>
#include <solidsubdiv/far/internal/with_rows.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Far {

namespace {

using Internal::MaskRow;

/// Whether every edge of v's surface is smooth: not so where a sheet meets a solid's boundary, whose edges follow the
/// curve rule there.
bool HasSmoothRing(const Level& level, Index v) {
    for (Index e : level.vertex_edges[v]) {
        const Vtr::Tag edge = level.edge_tags[e];
        if (edge.rule() == Vtr::Rule::Curve && edge.in_face()) return false;
    }
    return true;
}

template <class Scheme>
MaskRow LimitOf(const Level& level, const Scheme& scheme, const Internal::Rows<Scheme>& rows, Index v) {
    if (rows.IsFading(v)) return {};
    MaskRow mask;
    mask.indices.resize(rows.MaxVertexLength(v));
    mask.weights.resize(mask.indices.size());
    const std::size_t length = static_cast<std::size_t>(rows.FillVertex(v, mask.indices.data(), mask.weights.data()));
    mask.indices.resize(length);
    mask.weights.resize(length);
    const int n = static_cast<int>(mask.indices.size()) - 1;
    const auto set = [&](const Sdc::RingWeights& w) {
        std::fill(mask.weights.begin(), mask.weights.end(), w.neighbor);
        mask.weights[0] = w.self;
    };
    if (n == 0) return mask;
    const bool is_sharp = rows.IsSharp(v);
    const Vtr::Rule rule = is_sharp && n == 2 ? Vtr::Rule::Curve : level.vertex_tags[v].rule();
    if (rule == Vtr::Rule::Surface && !is_sharp && HasSmoothRing(level, v)) {
        if constexpr (!decltype(scheme.surface())::kVerticesStay) set(scheme.surface().Limit(n));
    } else if (rule == Vtr::Rule::Curve) {
        if constexpr (!decltype(scheme.curve())::kVerticesStay) set(scheme.curve().Limit());
    } else {
        const auto m = Internal::MakeLocalMatrix(level, rows, v);
        mask.weights = m ? LimitMaskOf(*m) : std::vector<double>{};
        if (mask.weights.empty()) mask.indices.clear();
    }
    return mask;
}

/// limit_of(v) for every vertex.
template <class LimitOfVertex>
std::vector<MaskRow> LimitsOf(Index n_vertices, LimitOfVertex&& limit_of) {
    constexpr Offset kGrain = 256;
    std::vector<MaskRow> masks(static_cast<std::size_t>(n_vertices));
    Sdc::ParallelFor(n_vertices, kGrain, [&](Offset begin, Offset end) {
        for (Offset v = begin; v < end; ++v) masks[v] = limit_of(static_cast<Index>(v));
    });
    return masks;
}

}  // namespace

LimitStencilTable LimitStencilTable::Create(const TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                                            const LimitStencilTableOptions& options) {
    Internal::CheckScheme(refiner, scheme);
    const int l = options.level < 0 ? refiner.max_level() : options.level;
    if (l > refiner.max_level() || !refiner.is_full(l)) {
        throw InvalidInput("limits at level " + std::to_string(l) +
                           " need its full topology: refine with full_topology_in_last_level");
    }
    const Index n_vertices = refiner.n_vertices(l);
    const Sharpness sharpness = Internal::SharpnessOfLevels(refiner, scheme, l + 1).back();
    std::vector<MaskRow> masks;
    if (refiner.is_polyhedral()) {
        Internal::WithPolyhedralScheme(scheme, [&](const auto& s) {
            const Internal::PolyhedralLimits limits(refiner.polyhedral_level(l), sharpness, s.polyhedral(),
                                                    Internal::CreaseOptionsOf(s).method);
            masks = LimitsOf(n_vertices, [&](Index v) { return limits.Of(v); });
        });
    } else {
        Internal::WithTetOctScheme(scheme, [&]<class Scheme>(const Scheme& s) {
            const Level& level = refiner.level(l);
            const Internal::Rows<Scheme> rows(level, sharpness, s);
            masks = LimitsOf(n_vertices, [&](Index v) { return LimitOf(level, s, rows, v); });
        });
    }

    LimitStencilTable table;
    table.rows_.n_sources = n_vertices;
    table.rows_.offsets.assign(1, 0);
    for (Index v = 0; v < n_vertices; ++v) {
        if (masks[v].indices.empty()) table.without_limit_.push_back(v);
        table.rows_.indices.insert(table.rows_.indices.end(), masks[v].indices.begin(), masks[v].indices.end());
        table.rows_.weights.insert(table.rows_.weights.end(), masks[v].weights.begin(), masks[v].weights.end());
        table.rows_.offsets.push_back(static_cast<Offset>(table.rows_.indices.size()));
    }
    return table;
}

}  // namespace SolidSubdiv::Far

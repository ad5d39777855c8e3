// SPDX-License-Identifier: Apache-2.0
// Limit masks: closed forms where there are any, otherwise powers of the local matrix.
#include <solidsubdiv/far/limit_stencil_table.h>

#include <algorithm>
#include <string>

#include <solidsubdiv/far/internal/local_matrix.h>
#include <solidsubdiv/far/internal/scheme_check.h>
#include <solidsubdiv/far/internal/with_rows.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Far {

namespace {

struct MaskRow {
    std::vector<Index> indices;
    std::vector<double> weights;
};

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

template <class Scheme>
std::vector<MaskRow> LimitsOf(const Level& level, const Sharpness& sharpness, const Scheme& scheme) {
    constexpr Offset kGrain = 256;
    const Internal::Rows<Scheme> rows(level, sharpness, scheme);
    std::vector<MaskRow> masks(level.n_vertices);
    Sdc::ParallelFor(level.n_vertices, kGrain, [&](Offset begin, Offset end) {
        for (Offset v = begin; v < end; ++v) masks[v] = LimitOf(level, scheme, rows, static_cast<Index>(v));
    });
    return masks;
}

}  // namespace

LimitStencilTable LimitStencilTable::Create(const TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                                            const LimitStencilTableOptions& options) {
    Internal::CheckScheme(refiner, scheme);
    if (refiner.is_polyhedral()) {
        throw InvalidInput("limits are there for the tet/oct split only; refine once more instead");
    }
    const int l = options.level < 0 ? refiner.max_level() : options.level;
    if (l > refiner.max_level() || !refiner.level(l).is_full) {
        throw InvalidInput("limits at level " + std::to_string(l) +
                           " need its full topology: refine with full_topology_in_last_level");
    }
    const Level& level = refiner.level(l);
    const Sharpness sharpness = Internal::SharpnessOfLevels(refiner, scheme, l + 1).back();
    std::vector<MaskRow> masks;
    Internal::WithTetOctScheme(scheme, [&](const auto& s) { masks = LimitsOf(level, sharpness, s); });

    LimitStencilTable table;
    table.rows_.n_sources = level.n_vertices;
    table.rows_.offsets.assign(1, 0);
    for (Index v = 0; v < level.n_vertices; ++v) {
        if (masks[v].indices.empty()) table.without_limit_.push_back(v);
        table.rows_.indices.insert(table.rows_.indices.end(), masks[v].indices.begin(), masks[v].indices.end());
        table.rows_.weights.insert(table.rows_.weights.end(), masks[v].weights.begin(), masks[v].weights.end());
        table.rows_.offsets.push_back(static_cast<Offset>(table.rows_.indices.size()));
    }
    return table;
}

}  // namespace SolidSubdiv::Far

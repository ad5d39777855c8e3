// SPDX-License-Identifier: Apache-2.0
// Refines level by level: inherits what is sharp, makes each level's rows, applies and composes them.
#include "butterfly_oracle.h"

#include <algorithm>

#include <stdexcept>
#include <string>

#include "butterfly_stencils_oracle.h"
#include "osd_topology_oracle.h"

namespace SolidSubdiv::Validation {

namespace {

namespace Theirs = OpenSubdiv::Far;

void MarkUnsharedEdges(TaggedLevel& level) {
    for (int e = 0; e < level.topology.GetNumEdges(); ++e) {
        if (level.topology.GetEdgeFaces(e).size() != 2) level.is_crease[e] = true;
    }
}

TaggedLevel Unmarked(const Theirs::TopologyLevel& topology) {
    return {topology, std::vector<bool>(static_cast<std::size_t>(topology.GetNumEdges())),
            std::vector<bool>(static_cast<std::size_t>(topology.GetNumVertices()))};
}

TaggedLevel Mark(const Theirs::TopologyLevel& topology, const ControlSurface& surface) {
    TaggedLevel level = Unmarked(topology);
    const SurfaceTags& tags = surface.tags;
    const auto is_finite = [](float sharpness) { return sharpness < 10; };
    if (std::any_of(tags.crease_sharpness.begin(), tags.crease_sharpness.end(), is_finite) ||
        std::any_of(tags.corner_sharpness.begin(), tags.corner_sharpness.end(), is_finite)) {
        throw std::runtime_error("butterflies know infinite sharpness only");
    }
    for (const auto& [a, b] : tags.creases) {
        const int edge = topology.FindEdge(a, b);
        if (edge < 0) throw std::runtime_error("no edge " + std::to_string(a) + " " + std::to_string(b) + " to crease");
        level.is_crease[edge] = true;
    }
    for (const int v : tags.corners) {
        if (v < 0 || v >= topology.GetNumVertices()) throw std::runtime_error("no vertex " + std::to_string(v));
        level.is_corner[v] = true;
    }
    MarkUnsharedEdges(level);
    return level;
}

TaggedLevel Inherit(const TaggedLevel& from, const Theirs::TopologyLevel& topology) {
    TaggedLevel level = Unmarked(topology);
    for (int e = 0; e < from.topology.GetNumEdges(); ++e) {
        if (!from.is_crease[e]) continue;
        for (const int child : from.topology.GetEdgeChildEdges(e)) level.is_crease[child] = true;
    }
    for (int v = 0; v < from.topology.GetNumVertices(); ++v) {
        if (from.is_corner[v]) level.is_corner[from.topology.GetVertexChildVertex(v)] = true;
    }
    MarkUnsharedEdges(level);
    return level;
}

void Append(const Stencil& stencil, std::vector<int>& indices, std::vector<double>& weights) {
    for (const auto& [index, weight] : stencil) {
        if (weight == 0) continue;  // the ring of four has two of them
        indices.push_back(index);
        weights.push_back(weight);
    }
}

SparseRows MakeStep(const TaggedLevel& level, const ButterflyRule& rule, int n_fine) {
    std::vector<Stencil> stencils(static_cast<std::size_t>(n_fine));
    for (int v = 0; v < level.topology.GetNumVertices(); ++v) {
        stencils[level.topology.GetVertexChildVertex(v)] = {{v, 1.0}};
    }
    for (int e = 0; e < level.topology.GetNumEdges(); ++e) {
        stencils[level.topology.GetEdgeChildVertex(e)] = ButterflyStencil(level, rule, e);
    }
    SparseRows rows;
    for (const Stencil& stencil : stencils) {
        if (stencil.empty()) throw std::runtime_error("butterfly oracle: a vertex that is nobody's child");
        Append(stencil, rows.indices, rows.weights);
        rows.offsets.push_back(static_cast<std::int64_t>(rows.indices.size()));
    }
    return rows;
}

/// Rows of `fine` over the control vertices, from those of the level before (none: it is the control level).
void Compose(const SparseRows& step, const SurfaceLevel& coarse, SurfaceLevel& fine) {
    fine.row_offsets = {0};
    for (std::size_t r = 0; r + 1 < step.offsets.size(); ++r) {
        Stencil row;
        for (std::int64_t k = step.offsets[r]; k < step.offsets[r + 1]; ++k) {
            const int v = step.indices[k];
            if (coarse.row_offsets.empty()) {
                row[v] += step.weights[k];
                continue;
            }
            for (std::int64_t j = coarse.row_offsets[v]; j < coarse.row_offsets[v + 1]; ++j) {
                row[coarse.row_indices[j]] += step.weights[k] * coarse.row_weights[j];
            }
        }
        Append(row, fine.row_indices, fine.row_weights);
        fine.row_offsets.push_back(static_cast<std::int64_t>(fine.row_indices.size()));
    }
}

}  // namespace

ButterflyRefinement RefineByButterflyOracle(const ControlSurface& surface, const ButterflyRule& rule, int max_level,
                                            int max_row_level) {
    const auto refiner = MakeOpenSubdivRefiner(surface, max_level);
    ButterflyRefinement result;
    result.levels.resize(static_cast<std::size_t>(max_level) + 1);
    result.levels[0].positions = surface.positions;
    std::vector<TaggedLevel> tagged;
    for (int l = 0; l <= max_level; ++l) {
        const Theirs::TopologyLevel& topology = refiner->GetLevel(l);
        SurfaceLevel& level = result.levels[l];
        CopyTopology(topology, l == max_level, level);
        tagged.push_back(l == 0 ? Mark(topology, surface) : Inherit(tagged.back(), topology));
        if (l == 0) continue;
        const SurfaceLevel& coarse = result.levels[l - 1];
        result.steps.push_back(MakeStep(tagged[l - 1], rule, level.n_vertices));
        level.positions = Apply(result.steps.back(), coarse.positions);
        if (l <= max_row_level) Compose(result.steps.back(), coarse, level);
    }
    return result;
}

}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
// Matching with OpenSubdiv and comparing.
#include "surface_compare.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <solidsubdiv/osd/evaluator.h>

#include "points.h"

namespace SolidSubdiv::Validation {

namespace {

std::string Name(const char* kind, std::int64_t i, int level) {
    return std::string(kind) + " " + std::to_string(i) + " of level " + std::to_string(level);
}

/// The same triangle, its least vertex first.
Triangle FromLeast(Triangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

}  // namespace

TaggedMesh::TaggedMesh(const Far::TopologyDescriptor& mesh, const SurfaceTags& tags) : descriptor(mesh) {
    for (const auto& ends : tags.creases) crease_edges.insert(crease_edges.end(), ends.begin(), ends.end());
    descriptor.crease_edges = crease_edges;
    descriptor.crease_sharpness = tags.crease_sharpness;
    descriptor.corner_vertices = tags.corners;
    descriptor.corner_sharpness = tags.corner_sharpness;
}

SurfaceOfMesh TakeSurface(const std::vector<Triangle>& triangles, std::span<const double> positions,
                          const SurfaceTags& tags) {
    SurfaceOfMesh result;
    std::set<int> used;
    for (const Triangle& t : triangles) used.insert(t.begin(), t.end());
    std::map<int, int> number;
    for (int v : used) {
        number[v] = result.surface.n_vertices++;
        result.mesh_vertices.push_back(v);
        const auto p = positions.subspan(3 * static_cast<std::size_t>(v), 3);
        result.surface.positions.insert(result.surface.positions.end(), p.begin(), p.end());
    }
    for (const Triangle& t : triangles) result.surface.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
    result.surface.tags = tags;
    for (auto& [a, b] : result.surface.tags.creases) {
        a = number.at(a);
        b = number.at(b);
    }
    for (int& v : result.surface.tags.corners) v = number.at(v);
    return result;
}

Match FollowChildren(const Far::TopologyRefiner& refiner, const SurfaceOfMesh& start,
                     const std::vector<SurfaceLevel>& oracle, Findings& findings) {
    Match match = {start.mesh_vertices};
    for (int l = 0; l + 1 < static_cast<int>(oracle.size()); ++l) {
        const SurfaceLevel& theirs = oracle[l];
        const Far::Level& ours = refiner.level(l);
        std::vector<Index> next(static_cast<std::size_t>(oracle[l + 1].n_vertices), kNoIndex);
        for (std::size_t v = 0; v < theirs.children_of_vertices.size(); ++v) {
            next[theirs.children_of_vertices[v]] = match[l][v];  // the child of vertex v is vertex v
        }
        for (std::size_t e = 0; e < theirs.edges.size(); ++e) {
            const auto [a, b] = theirs.edges[e];
            const Index edge = ours.FindEdge(match[l][a], match[l][b]);
            if (edge == kNoIndex) {
                findings.Fault(Name("OpenSubdiv's edge", static_cast<std::int64_t>(e), l) + " is no edge of ours");
                return match;
            }
            next[theirs.children_of_edges[e]] = ours.n_vertices + edge;  // the child of edge e is vertex V + e
        }
        match.push_back(std::move(next));
    }
    return match;
}

void CompareTriangles(const Far::TopologyRefiner& refiner, const std::vector<SurfaceLevel>& oracle, const Match& match,
                      Findings& findings) {
    for (int l = 0; l < static_cast<int>(match.size()); ++l) {
        std::vector<Triangle> theirs, ours;
        for (Triangle t : oracle[l].triangles) {
            for (int& v : t) v = match[l][v];
            theirs.push_back(FromLeast(t));
        }
        const Far::Level& level = refiner.level(l);
        for (Index b = 0; b < level.n_boundary_faces; ++b) {
            const auto v = level.BoundaryVertices(b);
            ours.push_back(FromLeast({v[0], v[1], v[2]}));
        }
        std::sort(theirs.begin(), theirs.end());
        std::sort(ours.begin(), ours.end());
        if (theirs != ours) {
            std::vector<Triangle> missing;
            std::set_difference(theirs.begin(), theirs.end(), ours.begin(), ours.end(), std::back_inserter(missing));
            findings.Fault("level " + std::to_string(l) + ": " + std::to_string(ours.size()) + " boundary triangles, " +
                           std::to_string(theirs.size()) + " by OpenSubdiv; " + std::to_string(missing.size()) +
                           " of those are not among ours");
        }
    }
}

void ComparePositions(const Far::StencilTable& cascaded, std::span<const double> positions,
                      const std::vector<SurfaceLevel>& oracle, const Match& match, Findings& findings) {
    const double size = SizeOf(positions);
    std::vector<double> values(positions.begin(), positions.end()), finer;
    Osd::Evaluator evaluator(cascaded, Osd::Backend::Reference());
    for (int l = 1; l < static_cast<int>(match.size()); ++l) {
        const Index n = cascaded.level(l).n_rows();
        finer.resize(3 * static_cast<std::size_t>(n));
        evaluator.EvaluateRange(l, Osd::BufferView<const double>(values, 3), Osd::BufferView<double>(finer, 3), 0, n);
        std::swap(values, finer);
        for (std::size_t v = 0; v < match[l].size(); ++v) {
            const Index ours = match[l][v];
            if (ours < 0 || ours >= n) {
                findings.Fault(Name("OpenSubdiv's vertex", static_cast<std::int64_t>(v), l) + " has none of ours");
                continue;
            }
            double distance = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const double d = values[3 * static_cast<std::size_t>(ours) + i] - oracle[l].positions[3 * v + i];
                distance += d * d;
            }
            findings.Error(std::sqrt(distance) / size, [&] { return "position of " + Name("vertex", ours, l); });
        }
    }
}

void CompareRows(const Far::StencilRows<double>& rows, int level, const SurfaceOfMesh& start,
                 const std::vector<SurfaceLevel>& oracle, Findings& findings) {
    const SurfaceLevel& theirs = oracle[level];
    if (rows.n_rows() != theirs.n_vertices) {
        findings.Fault("level " + std::to_string(level) + ": " + std::to_string(rows.n_rows()) + " rows, " +
                       std::to_string(theirs.n_vertices) + " by OpenSubdiv");
        return;
    }
    std::map<Index, double> difference;
    for (Index r = 0; r < rows.n_rows(); ++r) {
        difference.clear();
        const auto indices = rows.Indices(r);
        const auto weights = rows.Weights(r);
        for (std::size_t k = 0; k < indices.size(); ++k) difference[indices[k]] += weights[k];
        for (std::int64_t k = theirs.row_offsets[r]; k < theirs.row_offsets[r + 1]; ++k) {
            difference[start.mesh_vertices[theirs.row_indices[k]]] -= theirs.row_weights[k];
        }
        for (const auto& entry : difference) {
            findings.Error(std::abs(entry.second), [&] {
                return Name("row", r, level) + ", weight of control vertex " + std::to_string(entry.first);
            });
        }
    }
}

Findings CompareWithLevels(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                           std::span<const double> positions, const SurfaceOfMesh& start,
                           const std::vector<SurfaceLevel>& oracle, int max_row_level) {
    Findings findings;
    const Match match = FollowChildren(refiner, start, oracle, findings);
    CompareTriangles(refiner, oracle, match, findings);
    ComparePositions(Far::StencilTable::Create(refiner, scheme), positions, oracle, match, findings);
    for (int l = 1; l <= max_row_level && l < static_cast<int>(match.size()); ++l) {
        const auto table = Far::StencilTable::CreateComposite(refiner, scheme, {Far::CompositeRows{l, match[l]}});
        CompareRows(table.level(1), l, start, oracle, findings);
    }
    return findings;
}

Findings CompareWithLoop(const Far::TopologyDescriptor& mesh, const Sdc::Scheme& scheme,
                         const std::vector<Triangle>& triangles, std::span<const double> positions,
                         const SurfaceTags& tags, const ComparedLevels& levels,
                         const std::optional<SurfaceTags>& oracle_tags) {
    const TaggedMesh tagged(mesh, tags);
    auto refiner = Far::TopologyRefiner::Create(tagged.descriptor, Sdc::Split::TetOct);
    refiner.RefineUniform({.max_level = levels.positions});
    const SurfaceOfMesh start = TakeSurface(triangles, positions, oracle_tags.value_or(tags));
    const auto oracle = RefineByOpenSubdiv(start.surface, levels.positions, levels.rows);
    return CompareWithLevels(refiner, scheme, positions, start, oracle, levels.rows);
}

}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
// Matching faces, edges and vertices of polygons with OpenSubdiv's.
#include "polygon_compare.h"

#include <algorithm>
#include <map>
#include <set>

namespace SolidSubdiv::Validation {

namespace {

std::vector<Index> Ascending(std::vector<Index> v) {
    std::sort(v.begin(), v.end());
    return v;
}

/// The same face, its least vertex first.
std::vector<Index> FromLeast(std::vector<Index> v) {
    std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
    return v;
}

std::vector<Index> Mapped(const Polygon& face, const std::vector<Index>& map) {
    std::vector<Index> v;
    for (int i : face) v.push_back(map[static_cast<std::size_t>(i)]);
    return v;
}

/// Ours for each of theirs, level by level: the child of vertex v is vertex v, that of edge e V + e, of face f V + E +
/// f.
Match Follow(const Far::TopologyRefiner& refiner, const std::vector<Index>& start,
             const std::vector<SurfaceLevel>& oracle, Findings& findings) {
    Match match = {start};
    for (int l = 0; l + 1 < static_cast<int>(oracle.size()); ++l) {
        const SurfaceLevel& theirs = oracle[static_cast<std::size_t>(l)];
        const Vtr::PolyhedralLevel& ours = refiner.polyhedral_level(l);
        std::map<std::vector<Index>, Index> faces;
        for (Index f : ours.boundary_faces) {
            const auto v = ours.FaceVertices(f);
            faces[Ascending({v.begin(), v.end()})] = f;
        }
        const std::vector<Index>& at = match[static_cast<std::size_t>(l)];
        std::vector<Index> next(static_cast<std::size_t>(oracle[static_cast<std::size_t>(l) + 1].n_vertices), kNoIndex);
        for (std::size_t v = 0; v < theirs.children_of_vertices.size(); ++v) {
            next[static_cast<std::size_t>(theirs.children_of_vertices[v])] = at[v];
        }
        for (std::size_t e = 0; e < theirs.edges.size(); ++e) {
            const auto [a, b] = theirs.edges[e];
            const Index edge = ours.FindEdge(at[static_cast<std::size_t>(a)], at[static_cast<std::size_t>(b)]);
            if (edge == kNoIndex) {
                findings.Fault("OpenSubdiv's edge " + std::to_string(e) + " of level " + std::to_string(l) +
                               " is no edge of ours");
                return match;
            }
            next[static_cast<std::size_t>(theirs.children_of_edges[e])] = ours.n_vertices + edge;
        }
        for (std::size_t f = 0; f < theirs.faces.size(); ++f) {
            const auto face = faces.find(Ascending(Mapped(theirs.faces[f], at)));
            if (face == faces.end()) {
                findings.Fault("OpenSubdiv's face " + std::to_string(f) + " of level " + std::to_string(l) +
                               " is no boundary face of ours");
                return match;
            }
            next[static_cast<std::size_t>(theirs.children_of_faces[f])] = ours.n_vertices + ours.n_edges + face->second;
        }
        match.push_back(std::move(next));
    }
    return match;
}

void CompareFaces(const Far::TopologyRefiner& refiner, const std::vector<SurfaceLevel>& oracle, const Match& match,
                  Findings& findings) {
    for (std::size_t l = 0; l < match.size(); ++l) {
        std::multiset<std::vector<Index>> theirs, ours;
        for (const Polygon& face : oracle[l].faces) theirs.insert(FromLeast(Mapped(face, match[l])));
        const Vtr::PolyhedralLevel& level = refiner.polyhedral_level(static_cast<int>(l));
        for (Index b = 0; b < level.n_boundary_faces; ++b) {
            const auto v = level.BoundaryVertices(b);
            ours.insert(FromLeast({v.begin(), v.end()}));
        }
        if (theirs != ours) {
            findings.Fault("level " + std::to_string(l) + ": " + std::to_string(ours.size()) +
                           " boundary faces are not OpenSubdiv's " + std::to_string(theirs.size()));
        }
    }
}

}  // namespace

PolygonSurfaceOfMesh TakePolygons(const std::vector<Polygon>& faces, std::span<const double> positions,
                                  const SurfaceTags& tags) {
    PolygonSurfaceOfMesh result;
    PolygonSurface& surface = result.surface;
    std::set<int> used;
    for (const Polygon& face : faces) used.insert(face.begin(), face.end());
    std::map<int, int> number;
    for (int v : used) {
        number[v] = surface.n_vertices++;
        result.start.mesh_vertices.push_back(v);
        const auto p = positions.subspan(3 * static_cast<std::size_t>(v), 3);
        surface.positions.insert(surface.positions.end(), p.begin(), p.end());
    }
    for (const Polygon& face : faces) {
        Polygon& mine = surface.faces.emplace_back();
        for (int v : face) mine.push_back(number[v]);
    }
    surface.tags = tags;
    for (auto& [a, b] : surface.tags.creases) {
        a = number.at(a);
        b = number.at(b);
    }
    for (int& v : surface.tags.corners) v = number.at(v);
    return result;
}

Findings CompareWithCatmark(const Far::TopologyDescriptor& mesh, const Sdc::Scheme& scheme,
                            const PolygonSurfaceOfMesh& surface, std::span<const double> positions,
                            const SurfaceTags& our_tags, const ComparedLevels& levels) {
    Findings findings;
    const TaggedMesh tagged(mesh, our_tags);
    auto refiner = Far::TopologyRefiner::Create(tagged.descriptor, Sdc::Split::Polyhedral);
    refiner.RefineUniform({.max_level = levels.positions});
    const auto oracle = RefineByOpenSubdiv(surface.surface, levels.positions, levels.rows);
    const Match match = Follow(refiner, surface.start.mesh_vertices, oracle, findings);
    CompareFaces(refiner, oracle, match, findings);
    ComparePositions(Far::StencilTable::Create(refiner, scheme), positions, oracle, match, findings);
    for (int l = 1; l <= levels.rows && l < static_cast<int>(match.size()); ++l) {
        const auto table = Far::StencilTable::CreateComposite(
            refiner, scheme, {Far::CompositeRows{l, match[static_cast<std::size_t>(l)]}});
        CompareRows(table.level(1), l, surface.start, oracle, findings);
    }
    return findings;
}

}  // namespace SolidSubdiv::Validation

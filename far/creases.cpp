// SPDX-License-Identifier: Apache-2.0
// How sharpness passes from level to level, and the blends of rules where it fades.
#include <solidsubdiv/far/internal/sharpness.h>

#include <algorithm>

#include <solidsubdiv/far/creases.h>

namespace SolidSubdiv::Far::Internal {

namespace {

bool IsAnySharp(const Sharpness& sharpness) {
    const auto is_sharp = [](const Array<float>& values) {
        return std::any_of(values.begin(), values.end(), Sdc::IsSharp);
    };
    return is_sharp(sharpness.edges) || is_sharp(sharpness.vertices);
}

Sharpness MakeSmooth(Offset n_edges, Offset n_vertices) {
    Sharpness smooth;
    smooth.edges.assign(static_cast<std::size_t>(n_edges), 0.0f);
    smooth.vertices.assign(static_cast<std::size_t>(n_vertices), 0.0f);
    return smooth;
}

/// Vertices of surfaces that are in one face become corners.
void SharpenCorners(const Vtr::EdgeGraph& level, Sharpness& sharpness) {
    for (Index v = 0; v < level.n_vertices; ++v) {
        const auto edges = level.vertex_edges[v];
        const bool is_corner = edges.size() == 2 && level.edge_faces.Count(edges[0]) == 1 &&
                               level.edge_faces.Count(edges[1]) == 1 &&
                               level.edge_faces[edges[0]][0] == level.edge_faces[edges[1]][0];
        if (is_corner) sharpness.vertices[v] = Sdc::kInfinitelySharp;
    }
}

/// Edges and vertices of solids that are in one cell become creases and corners.
void SharpenCells(const Vtr::EdgeGraph& level, Sharpness& sharpness) {
    for (Index e = 0; e < level.n_edges; ++e) {
        const Vtr::Tag tag = level.edge_tags[e];
        if (tag.one_cell() && tag.rule() == Vtr::Rule::Surface) sharpness.edges[e] = Sdc::kInfinitelySharp;
    }
    for (Index v = 0; v < level.n_vertices; ++v) {
        if (level.vertex_tags[v].one_cell()) sharpness.vertices[v] = Sdc::kInfinitelySharp;
    }
}

}  // namespace

Sharpness ChildrenSharpness(const Vtr::EdgeGraph& level, Index n_edges, Index n_vertices, const Sharpness& parent,
                            Sdc::CreasingMethod method) {
    if (parent.empty()) return {};
    Sharpness child = MakeSmooth(n_edges, n_vertices);
    for (Index e = 0; e < level.n_edges; ++e) {
        if (!Sdc::IsSharp(parent.edges[e])) continue;
        for (int s = 0; s < 2; ++s) {
            child.edges[2 * static_cast<std::size_t>(e) + s] =
                ChildSharpness(level, parent, method, e, level.EdgeVertices(e)[s]);
        }
    }
    std::transform(parent.vertices.begin(), parent.vertices.end(), child.vertices.begin(), Sdc::Decay);
    return IsAnySharp(child) ? child : Sharpness{};
}

float ChildSharpness(const Vtr::EdgeGraph& level, const Sharpness& sharpness, Sdc::CreasingMethod method, Index e,
                     Index v) {
    const float mine = sharpness.edges[e];
    if (method == Sdc::CreasingMethod::Uniform || Sdc::IsInfinitelySharp(mine) || !Sdc::IsSharp(mine)) {
        return Sdc::Decay(mine);
    }
    float sum = 0;
    int n = 0;
    ForSurfaceEdges(level, sharpness, v, [&](Index, float s) {
        if (!Sdc::IsSharp(s) || Sdc::IsInfinitelySharp(s)) return;
        sum += s;
        ++n;
    });
    return Sdc::DecayByChaikin(mine, sum, n);
}

Sharpness TakeSharpness(const TopologyDescriptor& d, const Vtr::EdgeGraph& level, DefectList& defects) {
    if (d.crease_edges.empty() && d.corner_vertices.empty()) return {};
    Sharpness sharpness = MakeSmooth(level.n_edges, level.n_vertices);
    for (std::size_t i = 0; i < d.crease_sharpness.size(); ++i) {
        const Index a = d.crease_edges[2 * i], b = d.crease_edges[2 * i + 1], e = level.FindEdge(a, b);
        if (!Sdc::IsSharp(d.crease_sharpness[i])) continue;
        if (e == kNoIndex || level.edge_tags[e].rule() == Vtr::Rule::Solid || !level.edge_tags[e].in_face()) {
            defects.Add(DefectCode::UnusedSharpness, static_cast<Offset>(i), d.crease_sharpness[i],
                        "crease " + std::to_string(i) + " (" + std::to_string(a) + " " + std::to_string(b) +
                            ") is no edge of a surface, and is ignored");
        } else if (level.edge_tags[e].rule() == Vtr::Rule::Surface) {
            sharpness.edges[e] = std::max(sharpness.edges[e], d.crease_sharpness[i]);
        }
    }
    for (std::size_t i = 0; i < d.corner_sharpness.size(); ++i) {
        float& s = sharpness.vertices[d.corner_vertices[i]];
        s = std::max(s, d.corner_sharpness[i]);
    }
    return IsAnySharp(sharpness) ? sharpness : Sharpness{};
}

std::vector<Sharpness> SharpnessOfLevels(const TopologyRefiner& refiner, const Sdc::CreaseOptions& options,
                                         int n_levels) {
    std::vector<Sharpness> levels(static_cast<std::size_t>(std::max(n_levels, 1)));
    levels[0] = refiner.sharpness();
    if (options.sharp_corners || options.sharp_cells) {
        const Vtr::EdgeGraph base = refiner.graph(0);
        if (levels[0].empty()) levels[0] = MakeSmooth(base.n_edges, base.n_vertices);
        if (options.sharp_corners) SharpenCorners(base, levels[0]);
        if (options.sharp_cells) SharpenCells(base, levels[0]);
        if (!IsAnySharp(levels[0])) levels[0] = {};
    }
    for (int l = 1; l < n_levels; ++l) {
        if (levels[l - 1].empty()) break;
        levels[l] = ChildrenSharpness(refiner.graph(l - 1), refiner.n_edges(l), refiner.n_vertices(l), levels[l - 1],
                                      options.method);
    }
    return levels;
}

std::vector<Sharpness> SharpnessOfLevels(const TopologyRefiner& refiner, const Sdc::Scheme& scheme, int n_levels) {
    return SharpnessOfLevels(refiner, std::visit([](const auto& s) { return CreaseOptionsOf(s); }, scheme), n_levels);
}

double SharpRules::CreaseShare(Index e) const {
    const float s = sharpness_.edges[e];
    const auto ends = graph_.EdgeVertices(e);
    const auto goes_on = [&](Index v) { return Sdc::IsSharp(ChildSharpness(graph_, sharpness_, method_, e, v)); };
    // A crease while both halves are sharp still. Chaikin's mean may leave less than nothing of a sharpness above 1:
    // then this goes past the crease's point, as in OpenSubdiv (docs/decisions/0008).
    return goes_on(ends[0]) && goes_on(ends[1]) ? 1.0 : static_cast<double>(s);
}

bool SharpRules::HasSharpEdgeOrIsSharp(Index v) const {
    const Vtr::Rule rule = graph_.vertex_tags[v].rule();
    if (rule != Vtr::Rule::Surface && rule != Vtr::Rule::Curve) return false;
    if (Sdc::IsSharp(sharpness_.vertices[v])) return true;
    for (Index e : graph_.vertex_edges[v]) {
        if (ChangesEdge(e)) return true;
    }
    return false;
}

bool SharpRules::IsFading(Index v) const {
    if (!ChangesVertex(v)) return false;
    const auto fades = [](float s) { return Sdc::IsSharp(s) && !Sdc::IsInfinitelySharp(s); };
    bool is_fading = fades(sharpness_.vertices[v]);
    ForSurfaceEdges(graph_, sharpness_, v, [&](Index, float s) { is_fading = is_fading || fades(s); });
    return is_fading;
}

std::array<SharpRules::Part, 2> SharpRules::VertexParts(Index v) const {
    std::array<Part, 2> parts;
    std::array<int, 2> n_sharp{0, 0};
    const float mine = sharpness_.vertices[v], my_child = Sdc::Decay(mine);
    float fading_sum = 0;
    int n_fading = 0;
    if (Sdc::IsSharp(mine) && !Sdc::IsSharp(my_child)) {
        fading_sum = mine;
        n_fading = 1;
    }
    const auto add = [&](int part, Index e) {
        if (n_sharp[part] < 2) parts[part].crease[n_sharp[part]] = e;
        ++n_sharp[part];
    };
    ForSurfaceEdges(graph_, sharpness_, v, [&](Index e, float s) {
        if (!Sdc::IsSharp(s)) return;
        add(0, e);
        const float child = Sdc::IsInfinitelySharp(s) ? s : ChildSharpness(graph_, sharpness_, method_, e, v);
        if (Sdc::IsSharp(child)) {
            add(1, e);
        } else {
            fading_sum += s;
            ++n_fading;
        }
    });
    if (!graph_.vertex_tags[v].in_face()) {  // on a curve in no surface: it goes on in both directions
        for (Index e : graph_.vertex_edges[v]) {
            for (int part : {0, 1}) add(part, e);
        }
    }
    parts[0].rule = Sdc::SharpRuleOf(mine, n_sharp[0]);
    parts[1].rule = Sdc::SharpRuleOf(my_child, n_sharp[1]);
    const bool is_smooth = parts[0].rule == Sdc::SharpRule::Smooth || parts[0].rule == Sdc::SharpRule::Dart;
    if (is_smooth || parts[0].rule == parts[1].rule) {
        parts[0].share = 1;
        return parts;
    }
    const float fraction = n_fading == 0 ? 0.0f : std::min(fading_sum / static_cast<float>(n_fading), 1.0f);
    parts[0].share = fraction;
    parts[1].share = 1.0 - parts[0].share;
    return parts;
}

}  // namespace SolidSubdiv::Far::Internal

namespace SolidSubdiv::Far {

Creases CreasesAt(const TopologyRefiner& refiner, const Sdc::Scheme& scheme, int level) {
    Sdc::CreaseOptions options = std::visit([](const auto& s) { return Internal::CreaseOptionsOf(s); }, scheme);
    Sharpness sharpness = Internal::SharpnessOfLevels(refiner, options, level + 1).back();
    if (options.sharp_cells && !sharpness.empty()) {
        // A solid's own are found again wherever it is refined on; but the means of Chaikin's method know them.
        options.sharp_cells = false;
        const Sharpness given = Internal::SharpnessOfLevels(refiner, options, level + 1).back();
        const auto take_out = [](Array<float>& all, const Array<float>& mine) {
            for (std::size_t i = 0; i < all.size(); ++i) {
                const float s = mine.empty() ? 0.0f : mine[i];
                if (Sdc::IsInfinitelySharp(all[i]) && !Sdc::IsInfinitelySharp(s)) all[i] = s;
            }
        };
        take_out(sharpness.edges, given.edges);
        take_out(sharpness.vertices, given.vertices);
    }
    Creases creases;
    const auto add = [&](Index a, Index b, float s) {
        if (!Sdc::IsSharp(s)) return;
        creases.edges.insert(creases.edges.end(), {a, b});
        creases.edge_sharpness.push_back(s);
    };
    if (level == 0) {
        for (Index e = 0; e < static_cast<Index>(sharpness.edges.size()); ++e) {
            const auto ends = refiner.graph(0).EdgeVertices(e);
            add(ends[0], ends[1], sharpness.edges[e]);
        }
    } else if (!sharpness.empty()) {
        // A sharp edge is half of an edge of the level before, which is full.
        const Vtr::EdgeGraph parent = refiner.graph(level - 1);
        for (Index e = 0; e < parent.n_edges; ++e) {
            const auto ends = parent.EdgeVertices(e);
            const Index point = parent.n_vertices + e;
            add(ends[0], point, sharpness.edges[2 * static_cast<std::size_t>(e)]);
            add(point, ends[1], sharpness.edges[2 * static_cast<std::size_t>(e) + 1]);
        }
    }
    for (std::size_t v = 0; v < sharpness.vertices.size(); ++v) {
        if (!Sdc::IsSharp(sharpness.vertices[v])) continue;
        creases.vertices.push_back(static_cast<Index>(v));
        creases.vertex_sharpness.push_back(sharpness.vertices[v]);
    }
    return creases;
}

}  // namespace SolidSubdiv::Far

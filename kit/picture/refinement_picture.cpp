// SPDX-License-Identifier: Apache-2.0
// Puts scenes of several levels together; see refinement_picture.h.
#include <solidsubdiv/kit/picture/internal/picture_parts.h>
#include <solidsubdiv/kit/picture/refinement_picture.h>
#include <solidsubdiv/kit/picture/slice.h>
#include <solidsubdiv/sdc/errors.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace SolidSubdiv::Picture {
namespace {

using Internal::CutPlane;
using Internal::LineWidth;

/// The triangles that are seen of a mesh: a solid's boundary, and its surface elements.
std::vector<Index> VisibleTriangles(const Io::Mesh& mesh) {
    std::vector<Index> triangles;
    if (mesh.topology.n_cells() > 0) {
        triangles = SolidBoundary(mesh).triangles;
    } else {
        const Io::Topology& t = mesh.topology;
        triangles = t.triangles;
        const auto add = [&](std::span<const Index> face) {
            for (std::size_t i = 2; i < face.size(); ++i) {
                triangles.insert(triangles.end(), {face[0], face[i - 1], face[i]});
            }
        };
        for (std::size_t q = 0; q + 4 <= t.quads.size(); q += 4) add(std::span(t.quads).subspan(q, 4));
        for (Offset p = 0; p < t.n_polygons(); ++p) {
            const Offset first = t.polygon_offsets[p], end = t.polygon_offsets[p + 1];
            add(std::span(t.polygon_vertices).subspan(first, end - first));
        }
    }
    return triangles;
}

/// Edges, as pairs of ends, that are in both lists.
std::vector<Index> CommonEdges(const std::vector<Index>& a, const std::vector<Index>& b) {
    using Pair = std::pair<Index, Index>;
    const auto pairs = [](const std::vector<Index>& ends) {
        std::vector<Pair> sorted;
        for (std::size_t i = 0; i < ends.size(); i += 2) sorted.push_back(std::minmax(ends[i], ends[i + 1]));
        std::sort(sorted.begin(), sorted.end());
        return sorted;
    };
    const auto first = pairs(a), second = pairs(b);
    std::vector<Pair> common;
    std::set_intersection(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(common));
    std::vector<Index> edges;
    for (const auto& [low, high] : common) edges.insert(edges.end(), {low, high});
    return edges;
}

/// The edges that are seen of a mesh from outside.
std::vector<Index> VisibleEdges(const Io::Mesh& mesh, const std::vector<Index>& triangles) {
    if (mesh.topology.n_cells() > 0) {
        Io::Topology skin;
        skin.triangles = triangles;
        return CommonEdges(ElementEdges(skin), ElementEdges(mesh.topology));  // not the diagonals of quadrilaterals
    }
    Io::Topology seen;
    seen.triangles = mesh.topology.triangles;
    seen.quads = mesh.topology.quads;
    seen.polygon_offsets = mesh.topology.polygon_offsets;
    seen.polygon_vertices = mesh.topology.polygon_vertices;
    seen.edges = mesh.topology.edges;
    return ElementEdges(seen);
}

Scene LatticeScene(const Io::Mesh& lattice, const Io::Mesh& shape, const RenderOptions& render) {
    const std::vector<Index> skin = VisibleTriangles(shape), lattice_skin = VisibleTriangles(lattice);
    const std::vector<Index> edges = VisibleEdges(lattice, lattice_skin);
    const double width = LineWidth(edges.size() / 2, render, 4);
    std::vector<Index> ends = edges;
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::vector<double> points;
    for (Index v : ends) {
        const double* p = &lattice.positions[3 * static_cast<std::size_t>(v)];
        points.insert(points.end(), {p[0], p[1], p[2]});
    }
    Scene scene;
    scene.Add(Surface{.positions = shape.positions, .triangles = skin});
    scene.Add(Lines{
        .positions = lattice.positions, .edges = edges, .color = Palette::kLattice, .width = width, .shaded = true});
    scene.Add(Points{.positions = points, .color = Palette::kLattice, .diameter = 2.7 * width});
    return scene;
}

Scene WireframeScene(const Io::Mesh& mesh, const RenderOptions& render) {
    const std::vector<Index> skin = VisibleTriangles(mesh), edges = VisibleEdges(mesh, skin);
    Scene scene;
    scene.Add(Surface{.positions = mesh.positions, .triangles = skin, .material = {.smooth = false}});
    scene.Add(Lines{.positions = mesh.positions, .edges = edges, .width = LineWidth(edges.size() / 2, render, 1.2)});
    return scene;
}

Scene CellsScene(const Io::Mesh& mesh, const SolidFaces& cut, const RenderOptions& render) {
    const std::vector<Color> colors = cut.ColorsByKind(Palette::kSkin);
    Scene scene;
    scene.Add(Surface{.positions = mesh.positions,
                      .triangles = cut.triangles,
                      .material = {.crease_angle = 30},
                      .triangle_colors = colors});
    scene.Add(
        Lines{.positions = mesh.positions, .edges = cut.edges, .width = LineWidth(cut.edges.size() / 2, render, 1.2)});
    return scene;
}

/// The least and greatest finite number.
std::pair<double, double> Range(const std::vector<double>& values) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (double x : values) {
        if (std::isfinite(x)) low = std::min(low, x), high = std::max(high, x);
    }
    return {low, high};
}

const Io::Attribute* ChooseAttribute(const Io::Mesh& mesh, const std::string& name) {
    for (const Io::Attribute& a : mesh.point_data) {
        const auto [low, high] = Range(a.values);
        if (a.width == 1 && (name.empty() ? low < high : a.name == name)) return &a;
    }
    if (name.empty()) return nullptr;
    throw InvalidInput("picture: the mesh has no point attribute '" + name + "' of one number a point");
}

Scene SliceScene(const Io::Mesh& mesh, const Plane& plane, const Io::Attribute* attribute,
                 std::pair<double, double> range, const RenderOptions& render) {
    const SolidSlice slice =
        SliceSolid(mesh, plane, attribute == nullptr ? std::span<const double>() : attribute->values);
    const std::vector<Color> colors = slice.CapColorsByKind();
    Scene scene;
    scene.Add(Surface{.positions = slice.positions, .triangles = slice.skin});
    Surface cap{.positions = slice.positions, .triangles = slice.cap, .material = {.smooth = false, .gloss = 0}};
    if (attribute != nullptr) {
        cap.values = slice.values;
        cap.low = range.first;
        cap.high = range.second;
    } else {
        cap.triangle_colors = colors;
        scene.Add(Lines{.positions = slice.positions,
                        .edges = slice.cap_edges,
                        .width = LineWidth(slice.cap_edges.size() / 2, render, 1.2)});
    }
    scene.Add(cap);
    return scene;
}

constexpr int kStripes = 20;

/// What the colours of a cut tell apart, if anything: ": tets and octahedra".
std::string KindsCaption(const SolidFaces& cut) {
    constexpr std::pair<CellKind, const char*> kinds[] = {
        {CellKind::Tet, "tets"},     {CellKind::Oct, "octahedra"},    {CellKind::Hex, "hexahedra"},
        {CellKind::Wedge, "wedges"}, {CellKind::Pyramid, "pyramids"}, {CellKind::Polyhedron, "polyhedra"}};
    std::vector<std::string> names;
    for (const auto& kind : kinds) {
        bool is_seen = false;
        for (std::size_t t = 0; t < cut.kinds.size(); ++t) {
            is_seen = is_seen || (cut.opened[t] != 0 && cut.kinds[t] == kind.first);
        }
        if (is_seen) names.push_back(kind.second);
    }
    if (names.size() < 2) return "";
    std::string text = ": " + names[0];
    for (std::size_t i = 1; i < names.size(); ++i) text += (i + 1 < names.size() ? ", " : " and ") + names[i];
    return text;
}

std::string LevelName(std::size_t level) { return "level " + std::to_string(level); }

}  // namespace

Image RefinementPicture(std::span<const Io::Mesh* const> levels, const RefinementPictureOptions& options,
                        const Progress& progress) {
    if (levels.empty()) throw InvalidInput("picture: there is no level to show");
    const std::size_t last = levels.size() - 1;
    std::vector<Scene> scenes;
    std::vector<std::string> captions;
    std::optional<ColorBar> bar;

    scenes.push_back(LatticeScene(*levels[0], *levels[last], options.render));
    captions.push_back(levels[0]->topology.n_cells() > 0 ? "control lattice and its shape"
                                                         : "control mesh and its shape");
    if (last >= 1) {
        scenes.push_back(WireframeScene(*levels[1], options.render));
        captions.push_back(LevelName(1));
    }
    if (levels[last]->topology.n_cells() > 0) {
        const Plane plane = CutPlane(*levels[0], options.view);
        const std::size_t middle = std::min<std::size_t>(2, last);
        const SolidFaces cut = CutSolid(*levels[middle], plane);
        scenes.push_back(CellsScene(*levels[middle], cut, options.render));
        captions.push_back(LevelName(middle) + ", cut" + KindsCaption(cut));
        const Io::Attribute* attribute = ChooseAttribute(*levels[last], options.attribute);
        std::pair<double, double> range{0, 0};
        if (attribute != nullptr) {
            range = Range(attribute->values);
            bar = ColorBar{.low = range.first, .high = range.second, .title = attribute->name};
        }
        scenes.push_back(SliceScene(*levels[last], plane, attribute, range, options.render));
        captions.push_back(LevelName(last) + ", sliced");
    } else if (last >= 2) {
        const std::vector<Index> skin = VisibleTriangles(*levels[last]);
        scenes.emplace_back().Add(Surface{.positions = levels[last]->positions, .triangles = skin});
        captions.push_back(LevelName(last));
        scenes.emplace_back().Add(Surface{
            .positions = levels[last]->positions, .triangles = skin, .material = {.gloss = 0, .stripes = kStripes}});
        captions.push_back(LevelName(last) + ", reflection lines");
    }

    std::vector<ScenePanel> panels;
    for (std::size_t i = 0; i < scenes.size(); ++i) panels.push_back({&scenes[i], captions[i], {}});
    panels.back().color_bar = bar;
    return RenderPanels(panels, options.view, options.render, options.panels, progress);
}

}  // namespace SolidSubdiv::Picture

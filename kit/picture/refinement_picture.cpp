// SPDX-License-Identifier: Apache-2.0
// Puts scenes of several levels together; see refinement_picture.h.
#include <solidsubdiv/kit/picture/internal/picture_parts.h>
#include <solidsubdiv/kit/picture/refinement_picture.h>
#include <solidsubdiv/kit/picture/slice.h>
#include <solidsubdiv/sdc/errors.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace SolidSubdiv::Picture {
namespace {

using Internal::CutPlane;
using Internal::LineWidth;
using Internal::VisibleEdges;
using Internal::VisibleTriangles;

/// The lattice from outside, around its shape.
Scene LatticeScene(const Io::Mesh& lattice, const Io::Mesh& shape, const RenderOptions& render) {
    const std::vector<Index> skin = VisibleTriangles(shape);
    Scene scene;
    scene.Add(Surface{.positions = shape.positions, .triangles = skin});
    Internal::AddLattice(scene, lattice, VisibleEdges(lattice, VisibleTriangles(lattice)), render);
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

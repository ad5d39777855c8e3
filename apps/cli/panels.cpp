// SPDX-License-Identifier: Apache-2.0
// The picture of a refinement.
#include <solidsubdiv/apps/cli/panels.h>

#include <vector>

#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/kit/picture/camera.h>
#include <solidsubdiv/kit/picture/cut.h>
#include <solidsubdiv/kit/picture/image.h>
#include <solidsubdiv/kit/picture/render.h>
#include <solidsubdiv/kit/picture/scene.h>

namespace SolidSubdiv::Cli {

namespace {

constexpr int kPanelWidth = 800, kPanelHeight = 700, kColumns = 2;
constexpr std::size_t kMostCutEdges = 20000;

std::vector<Index> EdgesOf(std::span<const Index> triangles) {
    Io::Topology topology;
    topology.triangles.assign(triangles.begin(), triangles.end());
    return Picture::ElementEdges(topology);
}

/// A level from outside: its boundary, with the edges on it if asked for, and its curves.
void AddSkin(Picture::Scene& scene, const Vtr::Level& level, std::span<const double> positions, bool smooth,
             const Picture::Lines& edge_style, bool edges) {
    const std::span<const Index> skin = level.boundary_vertices;
    scene.Add(Picture::Surface{.positions = positions, .triangles = skin, .material = {.smooth = smooth}});
    if (!edges) return;
    const std::vector<Index> on_skin = EdgesOf(skin);
    Picture::Lines lines = edge_style;
    lines.positions = positions;
    lines.edges = on_skin;
    scene.Add(lines);
}

void AddCurves(Picture::Scene& scene, const Io::Mesh& mesh) {
    if (mesh.topology.edges.empty()) return;
    scene.Add(Picture::Lines{
        .positions = mesh.positions, .edges = mesh.topology.edges, .color = Picture::Palette::kLattice, .width = 3});
}

void AddCut(Picture::Scene& scene, const Io::Mesh& mesh) {
    const Geometry::Box box = Geometry::BoundingBox(mesh.positions);
    std::array<double, 3> centre{};
    for (int axis = 0; axis < 3; ++axis) centre[axis] = (box.low[axis] + box.high[axis]) / 2;
    // The half towards the viewer is taken away: the default view comes mostly from +z.
    const Picture::SolidFaces cut = Picture::CutSolid(mesh, {.point = centre, .normal = {0, 0, 1}});
    const std::vector<Picture::Color> colors = cut.ColorsByKind(Picture::Palette::kSkin);
    scene.Add(Picture::Surface{.positions = mesh.positions,
                               .triangles = cut.triangles,
                               .material = {.smooth = false},
                               .triangle_colors = colors});
    // Where cells are a few pixels small, lines would hide them.
    if (cut.edges.size() < kMostCutEdges) {
        scene.Add(Picture::Lines{.positions = mesh.positions, .edges = cut.edges, .width = 0.8});
    }
}

}  // namespace

void WriteRefinementPicture(const std::filesystem::path& path, const PanelInput& input, const Progress& progress) {
    const Far::TopologyRefiner& refiner = input.refiner;
    const int last = refiner.max_level();
    const Picture::Lines lattice{.positions = {}, .edges = {}, .color = Picture::Palette::kLattice, .width = 2};
    const Picture::Lines fine{.positions = {}, .edges = {}, .color = Picture::Palette::kInk, .width = 1};

    std::vector<Picture::Scene> scenes(1);
    AddSkin(scenes[0], refiner.level(0), input.control_positions, false, lattice, true);
    if (last > 1) {
        scenes.emplace_back();
        AddSkin(scenes.back(), refiner.level(1), input.first_positions, false, fine, true);
    }
    if (last > 0) {
        scenes.emplace_back();
        AddSkin(scenes.back(), refiner.level(last), input.last.positions, true, fine, last == 1);
        AddCurves(scenes.back(), input.last);
    }
    if (input.last.topology.n_cells() > 0) {
        scenes.emplace_back();
        AddCut(scenes.back(), input.last);
    }
    if (refiner.level(0).n_boundary_faces == 0) AddCurves(scenes[0], input.last);

    std::vector<const Picture::Scene*> all;
    for (const Picture::Scene& scene : scenes) all.push_back(&scene);
    const Picture::Camera camera = Picture::FitCamera(Picture::View{}, kPanelWidth, kPanelHeight, all);
    const int n = static_cast<int>(scenes.size()), n_rows = (n + kColumns - 1) / kColumns;
    Picture::Image image(kPanelWidth * std::min(n, kColumns), kPanelHeight * n_rows);
    for (int i = 0; i < n; ++i) {
        Picture::RenderOptions options;
        options.width = kPanelWidth;
        options.height = kPanelHeight;
        const auto panel_progress = [&](std::string_view, double fraction) {
            return !progress || progress("picture", (i + fraction) / n);
        };
        image.Paste(Picture::Render(scenes[static_cast<std::size_t>(i)], camera, options, panel_progress),
                    kPanelWidth * (i % kColumns), kPanelHeight * (i / kColumns));
    }
    Picture::WritePng(path, image);
}

}  // namespace SolidSubdiv::Cli

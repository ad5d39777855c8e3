// SPDX-License-Identifier: Apache-2.0
// One limit as triangles of a rate, as triangles by tolerance, and as tets.
#include "sampling_pictures.h"

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include <solidsubdiv/kit/geometry/tessellation.h>
#include <solidsubdiv/kit/geometry/tessellation_inside.h>
#include <solidsubdiv/kit/io/mesh.h>
#include <solidsubdiv/kit/picture/cut.h>
#include <solidsubdiv/kit/picture/panels.h>
#include <solidsubdiv/osd/evaluator.h>

namespace SolidSubdiv::Picture {

namespace {

/// Eight hexahedra around a hole.
Io::Mesh Frame() {
    Io::Mesh mesh;
    constexpr std::array<double, 4> steps{0, 1, 4, 5};
    for (const double y : {0., 1.2}) {
        for (const double z : steps) {
            for (const double x : steps) mesh.positions.insert(mesh.positions.end(), {x, y, -z});
        }
    }
    mesh.topology.n_vertices = 32;
    for (Index row = 0; row < 3; ++row) {
        for (Index column = 0; column < 3; ++column) {
            if (row == 1 && column == 1) continue;
            const Index v = 4 * row + column;
            mesh.topology.hexes.insert(mesh.topology.hexes.end(),
                                       {v, v + 4, v + 5, v + 1, v + 16, v + 20, v + 21, v + 17});
        }
    }
    for (std::size_t h = 0; h < mesh.topology.hexes.size(); h += 8) {  // the bottom counterclockwise from above
        std::swap(mesh.topology.hexes[h + 1], mesh.topology.hexes[h + 3]);
        std::swap(mesh.topology.hexes[h + 5], mesh.topology.hexes[h + 7]);
    }
    return mesh;
}

Scene Wireframe(const Geometry::Tessellation& t, const Io::Mesh& control) {
    const std::vector<double> positions = t.Positions(control.positions);
    Io::Topology topology;
    topology.triangles = t.triangles;
    const std::vector<Index> edges = ElementEdges(topology);
    Scene scene;
    scene.Add(Surface{.positions = positions, .triangles = t.triangles, .material = {.smooth = false, .gloss = 0}});
    scene.Add(Lines{.positions = positions, .edges = edges, .width = 1});
    return scene;
}

std::string Caption(const std::string& what, const Geometry::Tessellation& t, double error) {
    char text[128];
    std::snprintf(text, sizeof text, "%s: %lld triangles, error %.2g", what.c_str(),
                  static_cast<long long>(t.n_facets()), error);
    return text;
}

}  // namespace

Image TessellationsOfAFrame() {
    const Io::Mesh control = Frame();
    auto refiner = Far::TopologyRefiner::Create(control.topology, Sdc::Split::Polyhedral);
    constexpr int kLevels = 2;
    refiner.RefineUniform({.max_level = kLevels, .full_topology_in_last_level = true});
    const Sdc::Scheme scheme = Sdc::CatmullClarkSolid{};

    const auto fine = Geometry::TessellateBoundary(refiner, scheme, {.rate = 32});
    const std::vector<double> positions = fine.Positions(control.positions);
    const std::vector<Index> edges = ElementEdges(control.topology);
    Scene limit;
    limit.Add(Surface{.positions = positions, .triangles = fine.triangles});
    limit.Add(
        Lines{.positions = control.positions, .edges = edges, .color = Palette::kLattice, .width = 3, .shaded = true});

    const auto at_rate = Geometry::TessellateBoundary(refiner, scheme, {.rate = 8});
    const double error = Geometry::MeasureError(refiner, scheme, at_rate, control.positions).largest;
    const auto close = Geometry::TessellateBoundary(refiner, scheme, control.positions, {.tolerance = error});
    const Scene rate_scene = Wireframe(at_rate, control), close_scene = Wireframe(close, control);

    const auto inside = Geometry::TessellateInside(refiner, scheme, kLevels);
    Io::Mesh tets;
    tets.topology.n_vertices = refiner.n_vertices(kLevels);
    tets.topology.tets = inside.tets;
    tets.positions.resize(3 * static_cast<std::size_t>(tets.topology.n_vertices));
    Osd::Evaluator(inside.table, Osd::Backend::Best()).Evaluate(control.positions, tets.positions);
    const SolidFaces cut = CutSolid(tets, {{2.5, 0.6, -2.2}, {0.3, 0.4, 0.85}});
    const std::vector<Color> colors = cut.ColorsByKind(Palette::kSkin);
    Scene cut_scene;
    cut_scene.Add(Surface{.positions = tets.positions,
                          .triangles = cut.triangles,
                          .material = {.smooth = false, .gloss = 0},
                          .triangle_colors = colors});
    cut_scene.Add(Lines{.positions = tets.positions, .edges = cut.edges, .width = 1});

    const ScenePanel panels[] = {
        {&limit, "control mesh and its limit", {}},
        {&rate_scene, Caption("rate 8", at_rate, error), {}},
        {&close_scene, Caption("its error as tolerance", close, close.error), {}},
        {&cut_scene, "rate 4, inside, cut: " + std::to_string(inside.tets.size() / 4) + " tets", {}}};
    return RenderPanels(panels, View{.azimuth = 25, .elevation = 38},
                        {.width = 560, .height = 380, .ground_shadow = false}, {.columns = 2});
}

}  // namespace SolidSubdiv::Picture

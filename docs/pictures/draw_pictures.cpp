// SPDX-License-Identifier: Apache-2.0
// Draws the pictures of the documentation that one run of solidsubdiv can't: the same mesh under several schemes.
//
//     solidsubdiv-draw-pictures regression/shapes/demo docs/pictures [MODELS]
//
// With a folder of models from elsewhere (README.md) also those of deformations.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "catmull_clark_pictures.h"
#include "deformation_pictures.h"
#include "quality_pictures.h"
#include "sampling_pictures.h"

#include <solidsubdiv/far/choose_diagonals.h>
#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/kit/picture/cut.h>
#include <solidsubdiv/kit/picture/panels.h>
#include <solidsubdiv/kit/picture/slice.h>

namespace {

using namespace SolidSubdiv;
using namespace SolidSubdiv::Picture;

/// The mesh after so many steps, with its point data.
Io::Mesh Refined(const Io::Mesh& control, const Sdc::Scheme& scheme, int n_levels) {
    auto refiner = Far::TopologyRefiner::Create(control.topology, Sdc::Split::TetOct);
    refiner.RefineUniform({.max_level = n_levels});
    const Far::PrimvarRefiner primvars(refiner, scheme);
    Io::Mesh fine = control;
    const auto refine = [&](std::vector<double>& values, int width) {
        for (int l = 1; l <= n_levels; ++l) {
            std::vector<double> finer(static_cast<std::size_t>(width) *
                                      static_cast<std::size_t>(refiner.level(l).n_vertices));
            primvars.Interpolate<double>(l, values, finer, width);
            values = std::move(finer);
        }
    };
    refine(fine.positions, 3);
    for (Io::Attribute& a : fine.point_data) refine(a.values, a.width);
    const auto& level = refiner.level(n_levels);
    fine.topology = {};
    fine.topology.n_vertices = level.n_vertices;
    fine.topology.tets.assign(level.tet_vertices.begin(), level.tet_vertices.end());
    fine.topology.octs.assign(level.oct_vertices.begin(), level.oct_vertices.end());
    if (level.n_cells() == 0) {
        fine.topology.triangles.assign(level.boundary_vertices.begin(), level.boundary_vertices.end());
    }
    return fine;
}

/// n equal sectors of triangles around vertex 0, so many rings of them, at heights over a plane in which the sectors'
/// rays have steps of 1.
template <class Height>
Io::Mesh Fan(int n, int n_rings, const Height& height) {
    Io::Mesh mesh;
    std::map<std::array<int, 2>, Index> numbers;
    const auto vertex = [&](int ring, int i) {
        i = ring == 0 ? 0 : i % (n * ring);
        const auto [it, is_new] = numbers.try_emplace({ring, i}, mesh.topology.n_vertices);
        if (is_new) {
            const int sector = ring == 0 ? 0 : i / ring, j = ring == 0 ? 0 : i % ring;
            const double a = 2 * std::numbers::pi * sector / n, b = 2 * std::numbers::pi * (sector + 1) / n;
            const double x = (ring - j) * std::cos(a) + j * std::cos(b);
            const double y = (ring - j) * std::sin(a) + j * std::sin(b);
            mesh.positions.insert(mesh.positions.end(), {x, height(x, y), -y});
            ++mesh.topology.n_vertices;
        }
        return it->second;
    };
    vertex(0, 0);
    for (int ring = 0; ring < n_rings; ++ring) {
        for (int sector = 0; sector < n; ++sector) {
            for (int j = 0; j <= ring; ++j) {
                const int inner = sector * ring + j, outer = sector * (ring + 1) + j;
                const Index a = vertex(ring, inner), b = vertex(ring + 1, outer), c = vertex(ring + 1, outer + 1);
                mesh.topology.triangles.insert(mesh.topology.triangles.end(), {a, b, c});
                if (j < ring) {
                    mesh.topology.triangles.insert(mesh.topology.triangles.end(), {a, c, vertex(ring, inner + 1)});
                }
            }
        }
    }
    return mesh;
}

/// The triangles of a refined mesh that descend from those at vertex 0 of level 1.
std::vector<Index> NearVertex0(const Io::Mesh& control, const Io::Mesh& fine) {
    const Io::Mesh coarse = Refined(control, Sdc::LinearSurface{}, 1);
    const std::vector<Index>& all = fine.topology.triangles;
    const std::vector<Index>& parents = coarse.topology.triangles;
    const std::size_t n_children = all.size() / parents.size();
    std::vector<Index> near;
    for (std::size_t t = 0; t < parents.size(); t += 3) {
        if (parents[t] != 0 && parents[t + 1] != 0 && parents[t + 2] != 0) continue;
        const auto first = all.begin() + static_cast<std::ptrdiff_t>(t * n_children);
        near.insert(near.end(), first, first + static_cast<std::ptrdiff_t>(3 * n_children));
    }
    return near;
}

constexpr RenderOptions kPanel{.width = 420, .height = 320, .ground_shadow = false};

/// A row of panels: the control mesh, and what two schemes make around its vertex 0.
void AddValence(std::vector<Panel>& panels, const Io::Mesh& control, const std::string& name, const View& view) {
    constexpr int kLevels = 7;
    const Io::Mesh plain = Refined(control, Sdc::Butterfly{}, kLevels);
    const Io::Mesh modified = Refined(control, Sdc::ModifiedButterfly{}, kLevels);
    const std::vector<Index> edges = ElementEdges(control.topology);
    Scene whole;
    whole.Add(Surface{
        .positions = control.positions, .triangles = control.topology.triangles, .material = {.smooth = false}});
    whole.Add(Lines{.positions = control.positions, .edges = edges, .color = Palette::kLattice, .width = 2.5});
    panels.push_back({Render(whole, view, kPanel), name, {}});
    for (const Io::Mesh* mesh : {&plain, &modified}) {
        const std::vector<Index> near = NearVertex0(control, *mesh);
        Scene zoom;
        zoom.Add(Surface{.positions = mesh->positions, .triangles = near, .material = {.gloss = 0, .stripes = 20}});
        panels.push_back({Render(zoom, view, kPanel), mesh == &plain ? "butterfly" : "modified butterfly", {}});
    }
}

Image ButterflyValence() {
    std::vector<Panel> panels;
    const auto spike = [](double x, double y) { return 1.2 * std::exp(-(x * x + y * y) / 2); };
    const auto saddle = [](double x, double y) { return 0.3 * (x * x - y * y); };
    const View view{.azimuth = 20, .elevation = 40};
    AddValence(panels, Fan(3, 3, spike), "valence 3", view);
    AddValence(panels, Fan(9, 3, saddle), "valence 9", view);
    return Arrange(panels, {.columns = 3});
}

/// An octahedron with a tet on each of its faces.
Io::Mesh Star() {
    Io::Mesh mesh;
    mesh.topology.octs = {0, 1, 2, 3, 5, 4};
    mesh.positions = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
    for (Index corner = 0; corner < 8; ++corner) {
        const Index x = corner & 1, y = 2 + (corner >> 1 & 1), z = 4 + (corner >> 2);
        for (Index v : {x, y, z}) mesh.positions.push_back(v % 2 == 0 ? 1.1 : -1.1);
        const bool is_turned = (x + y + z) % 2 != 0;
        mesh.topology.tets.insert(mesh.topology.tets.end(), {x, is_turned ? z : y, is_turned ? y : z, 6 + corner});
    }
    mesh.topology.n_vertices = 14;
    return mesh;
}

/// A row of panels: what three tensions make of a lattice, with its control points if asked for.
void AddTensions(std::vector<Panel>& panels, const Io::Mesh& control, int n_levels, bool has_points) {
    const std::pair<double, const char*> tensions[] = {
        {0, "tension 0"}, {1.0 / 16, "tension 1/16"}, {0.09, "tension 0.09"}};
    Scene scenes[3];
    for (std::size_t i = 0; i < 3; ++i) {
        const Io::Mesh mesh = Refined(control, Sdc::Interpolatory{.tension = tensions[i].first}, n_levels);
        const std::vector<Index> skin = SolidBoundary(mesh).triangles;
        scenes[i].Add(Surface{.positions = mesh.positions, .triangles = skin});
        if (has_points) {
            scenes[i].Add(Points{.positions = control.positions, .color = Palette::kLattice, .diameter = 9});
        }
    }
    const Scene* all[] = {&scenes[0], &scenes[1], &scenes[2]};
    const Camera camera = FitCamera(View{.azimuth = 20, .elevation = 14}, kPanel.width, kPanel.height, all);
    for (std::size_t i = 0; i < 3; ++i) {
        panels.push_back({Render(scenes[i], camera, kPanel), tensions[i].second, {}});
    }
}

Image InterpolatoryTensions(const std::filesystem::path& shapes) {
    Io::Mesh bunny = Io::ReadSolid(shapes / "bunny_lattice.vtu");
    bunny.topology.tets = Far::ChooseDiagonals(bunny.topology, Far::DiagonalPolicy::Matched).tets;
    std::vector<Panel> panels;
    AddTensions(panels, Star(), 6, true);
    AddTensions(panels, bunny, 3, false);
    return Arrange(panels, {.columns = 3});
}

/// n tets around an edge, sliced across its middle, under two schemes.
Image TetsAroundEdge(int n) {
    Io::Mesh control;
    control.positions = {0, 0, -1.3, 0, 0, 1.3};
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        control.positions.insert(control.positions.end(), {std::cos(angle), std::sin(angle), 0});
        control.topology.tets.insert(control.topology.tets.end(), {0, 1, 2 + i, 2 + (i + 1) % n});
    }
    control.topology.n_vertices = n + 2;
    const std::pair<Sdc::Scheme, const char*> schemes[] = {{Sdc::BoxSpline{}, "box-spline"},
                                                           {Sdc::SmoothTet{}, "smooth-tet"}};
    std::vector<Scene> scenes(2);
    std::vector<ScenePanel> panels;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const Io::Mesh fine = Refined(control, schemes[i].first, 4);
        const SolidSlice slice = SliceSolid(fine, {{0, 0, 1e-3}, {0, 0, 1}});
        const std::vector<Color> colors = slice.CapColorsByKind();
        scenes[i].Add(Surface{.positions = slice.positions, .triangles = slice.skin});
        scenes[i].Add(Surface{
            .positions = slice.positions, .triangles = slice.cap, .material = {.gloss = 0}, .triangle_colors = colors});
        scenes[i].Add(Lines{.positions = slice.positions, .edges = slice.cap_edges, .width = 1});
        panels.push_back({&scenes[i], schemes[i].second, {}});
    }
    return RenderPanels(panels, View{.azimuth = 0, .elevation = 12},
                        {.width = 420, .height = 400, .ground_shadow = false});
}

}  // namespace

int main(int n_arguments, char** arguments) {
    if (n_arguments != 3 && n_arguments != 4) {
        std::fprintf(stderr, "usage: solidsubdiv-draw-pictures SHAPES OUT [MODELS]\n");
        return 2;
    }
    try {
        const std::filesystem::path out = arguments[2];
        WritePng(out / "catmull_clark_solid.png", CatmullClarkSolid());
        WritePng(out / "catmull_clark_features.png", CatmullClarkFeatures());
        WritePng(out / "mlca.png", SpikeAlongEdge());
        WritePng(out / "quality.png", QualityOfATwistedBar());
        WritePng(out / "sampling.png", TessellationsOfAFrame());
        WritePng(out / "smooth_tet.png", TetsAroundEdge(5));
        WritePng(out / "butterfly_valence.png", ButterflyValence());
        WritePng(out / "interpolatory.png", InterpolatoryTensions(arguments[1]));
        if (n_arguments == 4) {
            DrawDeformations(arguments[3], out);
        } else {
            std::printf("skipped deformation_*.png: name a folder with the models that README.md lists\n");
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 1;
    }
    return 0;
}

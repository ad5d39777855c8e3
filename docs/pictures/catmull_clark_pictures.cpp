// SPDX-License-Identifier: Apache-2.0
// Pictures of solids of any cells, whose lattices are made here.
#include "catmull_clark_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/kit/picture/cut.h>
#include <solidsubdiv/kit/picture/panels.h>
#include <solidsubdiv/kit/picture/slice.h>

namespace SolidSubdiv::Picture {

namespace {

/// A lattice that numbers its vertices by their places.
class Lattice {
  public:
    using Place = std::array<double, 3>;

    Index At(const Place& place) {
        const auto [it, is_new] = numbers_.try_emplace(place, mesh_.topology.n_vertices);
        if (is_new) {
            mesh_.positions.insert(mesh_.positions.end(), place.begin(), place.end());
            ++mesh_.topology.n_vertices;
        }
        return it->second;
    }
    void Add(std::vector<Index> Io::Topology::*kind, std::initializer_list<Place> corners) {
        for (const Place& corner : corners) (mesh_.topology.*kind).push_back(At(corner));
    }
    void AddCube(double x, double y, double z) {
        Add(&Io::Topology::hexes, {{x, y, z},
                                   {x + 1, y, z},
                                   {x + 1, y + 1, z},
                                   {x, y + 1, z},
                                   {x, y, z + 1},
                                   {x + 1, y, z + 1},
                                   {x + 1, y + 1, z + 1},
                                   {x, y + 1, z + 1}});
    }
    const Io::Mesh& mesh() const { return mesh_; }

  private:
    Io::Mesh mesh_;
    std::map<Place, Index> numbers_;
};

/// Three by two cubes, wedges at both ends, a pyramid on each cube, and between those tets and a pyramid upside down.
Io::Mesh MixedLattice() {
    Lattice lattice;
    for (double z : {0.0, 1.0}) {
        for (double x : {0.0, 1.0, 2.0}) {
            lattice.AddCube(x, 0, z);
            lattice.Add(&Io::Topology::pyramids,
                        {{x, 1, z}, {x, 1, z + 1}, {x + 1, 1, z + 1}, {x + 1, 1, z}, {x + .5, 2, z + .5}});
        }
        lattice.Add(&Io::Topology::wedges,
                    {{0, 0, z}, {0, 1, z}, {-1, 0, z}, {0, 0, z + 1}, {0, 1, z + 1}, {-1, 0, z + 1}});
        lattice.Add(&Io::Topology::wedges,
                    {{3, 1, z}, {3, 0, z}, {4, 0, z}, {3, 1, z + 1}, {3, 0, z + 1}, {4, 0, z + 1}});
        for (double x : {1.0, 2.0}) {
            lattice.Add(&Io::Topology::tets, {{x, 1, z}, {x, 1, z + 1}, {x - .5, 2, z + .5}, {x + .5, 2, z + .5}});
        }
    }
    for (double x : {0.0, 1.0, 2.0}) {
        lattice.Add(&Io::Topology::tets, {{x + 1, 1, 1}, {x, 1, 1}, {x + .5, 2, .5}, {x + .5, 2, 1.5}});
    }
    for (double x : {1.0, 2.0}) {
        lattice.Add(&Io::Topology::pyramids,
                    {{x - .5, 2, .5}, {x + .5, 2, .5}, {x + .5, 2, 1.5}, {x - .5, 2, 1.5}, {x, 1, 1}});
    }
    return lattice.mesh();
}

/// Six layers of three hexahedra around an edge along x, with a point datum: 1 on the edge, 0 elsewhere.
Io::Mesh ExtrudedSpike() {
    constexpr int kCells = 3, kLayers = 6, kRing = 2 * kCells;
    Io::Mesh mesh;
    std::vector<double> spike;
    for (int layer = 0; layer <= kLayers; ++layer) {
        mesh.positions.insert(mesh.positions.end(), {1.0 * layer, 0.0, 0.0});
        spike.push_back(1);
        for (int i = 0; i < kRing; ++i) {
            const double angle = 2 * std::numbers::pi * i / kRing, radius = i % 2 == 0 ? 1.2 : 1.5;
            mesh.positions.insert(mesh.positions.end(),
                                  {1.0 * layer, radius * std::cos(angle), radius * std::sin(angle)});
            spike.push_back(0);
        }
    }
    for (int layer = 0; layer < kLayers; ++layer) {
        for (int i = 0; i < kCells; ++i) {
            for (int at : {layer * (kRing + 1), (layer + 1) * (kRing + 1)}) {
                mesh.topology.hexes.insert(mesh.topology.hexes.end(),
                                           {at, at + 1 + 2 * i, at + 2 + 2 * i, at + 1 + (2 * i + 2) % kRing});
            }
        }
    }
    mesh.topology.n_vertices = static_cast<Index>(spike.size());
    mesh.point_data = {{"spike", 1, spike}};
    return mesh;
}

/// Levels 0 to n of a solid of any cells, with their point data.
std::vector<Io::Mesh> Levels(const Io::Mesh& control, const Sdc::Scheme& scheme, int n) {
    auto refiner = Far::TopologyRefiner::Create(control.topology, Sdc::Split::Polyhedral);
    refiner.RefineUniform({.max_level = n});
    const Far::PrimvarRefiner primvars(refiner, scheme);
    std::vector<Io::Mesh> levels{control};
    for (int l = 1; l <= n; ++l) {
        const Vtr::PolyhedralLevel& level = refiner.polyhedral_level(l);
        Io::Mesh mesh;
        Io::Topology& t = mesh.topology;
        t.n_vertices = level.n_vertices;
        t.hexes.assign(level.hex_vertices.begin(), level.hex_vertices.end());
        const Vtr::Polyhedra& p = level.polyhedra;
        t.polyhedron_offsets.assign(p.offsets.begin(), p.offsets.end());
        t.polyhedron_face_offsets.assign(p.face_vertex_offsets.begin(), p.face_vertex_offsets.end());
        t.polyhedron_vertices.assign(p.face_vertices.begin(), p.face_vertices.end());
        mesh.positions.resize(3 * static_cast<std::size_t>(level.n_vertices));
        primvars.Interpolate<double>(l, levels.back().positions, mesh.positions, 3);
        mesh.point_data = control.point_data;
        for (std::size_t i = 0; i < mesh.point_data.size(); ++i) {
            Io::Attribute& fine = mesh.point_data[i];
            fine.values.resize(static_cast<std::size_t>(fine.width) * static_cast<std::size_t>(level.n_vertices));
            primvars.Interpolate<double>(l, levels.back().point_data[i].values, fine.values, fine.width);
        }
        levels.push_back(std::move(mesh));
    }
    return levels;
}

/// Edges of the faces that are seen, but for those that triangles alone have.
std::vector<Index> EdgesOf(const SolidFaces& seen, const Io::Mesh& mesh) {
    using Ends = std::pair<Index, Index>;
    const auto pairs = [](const Io::Topology& topology) {
        const std::vector<Index> flat = ElementEdges(topology);
        std::vector<Ends> all;
        for (std::size_t i = 0; i < flat.size(); i += 2) all.emplace_back(flat[i], flat[i + 1]);
        return all;
    };
    Io::Topology skin;
    skin.triangles = seen.triangles;
    const std::vector<Ends> a = pairs(skin), b = pairs(mesh.topology);
    std::vector<Ends> common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    std::vector<Index> edges;
    for (const auto& [low, high] : common) edges.insert(edges.end(), {low, high});
    return edges;
}

/// Faces in the colours of their cells, and their edges.
void AddCells(const Io::Mesh& mesh, const SolidFaces& seen, double width, Scene& scene) {
    const std::vector<Color> colors = seen.ColorsByKind();
    scene.Add(Surface{.positions = mesh.positions,
                      .triangles = seen.triangles,
                      .material = {.crease_angle = 12, .gloss = 0.1},
                      .triangle_colors = colors});
    scene.Add(Lines{.positions = mesh.positions, .edges = EdgesOf(seen, mesh), .width = width});
}

}  // namespace

Image CatmullClarkSolid() {
    constexpr RenderOptions kPanel{.width = 340, .height = 215, .ground_shadow = false};
    const View view{.azimuth = 24, .elevation = 24};
    const std::vector<Io::Mesh> levels = Levels(MixedLattice(), Sdc::CatmullClarkSolid{}, 2);
    std::vector<Scene> scenes(2 * levels.size());
    for (std::size_t l = 0; l < levels.size(); ++l) {
        const Io::Mesh& mesh = levels[l];
        const double width = 1.6 - 0.4 * static_cast<double>(l);
        AddCells(mesh, SolidBoundary(mesh), width, scenes[l]);
        AddCells(mesh, CutSolid(mesh, {{0, 0, .52}, {0, 0, 1}}), width, scenes[levels.size() + l]);
    }
    std::vector<ScenePanel> panels;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const std::string name = "level " + std::to_string(i % levels.size());
        panels.push_back({&scenes[i], i < levels.size() ? name : name + ", cut", {}});
    }
    return RenderPanels(panels, view, kPanel, {.columns = 3});
}

Image SpikeAlongEdge() {
    constexpr RenderOptions kPanel{.width = 480, .height = 240, .ground_shadow = false};
    const Io::Mesh control = ExtrudedSpike();
    const std::pair<Sdc::Scheme, const char*> schemes[] = {{Sdc::CatmullClarkSolid{}, "catmull-clark-solid"},
                                                           {Sdc::Mlca{}, "mlca"}};
    const ColorBar bar{.low = 0, .high = 0.5};
    std::vector<Scene> scenes(2);
    std::vector<ScenePanel> panels;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const Io::Mesh fine = Levels(control, schemes[i].first, 4).back();
        const SolidSlice slice = SliceSolid(fine, {{0, 0, 1e-4}, {0, 0, 1}}, fine.point_data[0].values);
        scenes[i].Add(Surface{.positions = slice.positions, .triangles = slice.skin});
        scenes[i].Add(Surface{.positions = slice.positions,
                              .triangles = slice.cap,
                              .material = {.gloss = 0},
                              .values = slice.values,
                              .map = bar.map,
                              .low = bar.low,
                              .high = bar.high});
        panels.push_back({&scenes[i], schemes[i].second, bar});
    }
    return RenderPanels(panels, View{.azimuth = 12, .elevation = 16}, kPanel);
}

Image CatmullClarkFeatures() {
    constexpr RenderOptions kPanel{.width = 340, .height = 300, .samples = 64, .ground_shadow = false};
    Lattice lattice;
    for (const auto& [x, y] : {std::array{0., 0.}, std::array{1., 0.}, std::array{0., 1.}}) lattice.AddCube(x, y, 0);
    const std::vector<Index> edges = ElementEdges(lattice.mesh().topology);
    const auto add_lattice = [&](Scene& scene) {
        scene.Add(Lines{.positions = lattice.mesh().positions,
                        .edges = edges,
                        .color = Palette::kLattice,
                        .width = 3.5,
                        .shaded = true});
        scene.Add(Points{.positions = lattice.mesh().positions, .color = Palette::kLattice, .diameter = 9});
    };
    std::vector<Scene> scenes(2);
    const Sdc::Features features[] = {Sdc::Features::Sharp, Sdc::Features::Smooth};
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const Io::Mesh fine = Levels(lattice.mesh(), Sdc::CatmullClarkSolid{.features = features[i]}, 5).back();
        const std::vector<Index> skin = SolidBoundary(fine).triangles;
        scenes[i].Add(Surface{.positions = fine.positions, .triangles = skin});
        add_lattice(scenes[i]);
    }
    const ScenePanel panels[] = {{&scenes[0], "--features sharp", {}}, {&scenes[1], "--features smooth", {}}};
    return RenderPanels(panels, View{.azimuth = 28, .elevation = 20}, kPanel);
}

}  // namespace SolidSubdiv::Picture

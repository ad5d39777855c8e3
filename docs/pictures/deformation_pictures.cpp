// SPDX-License-Identifier: Apache-2.0
// Models of others in lattices of ours, before and after.
#include "deformation_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <solidsubdiv/apps/deform/deformer.h>
#include <solidsubdiv/apps/deform/direct_manipulation.h>
#include <solidsubdiv/apps/deform/editing_session.h>
#include <solidsubdiv/apps/deform/octree_lattices.h>
#include <solidsubdiv/apps/deform/tet_lattice.h>
#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/kit/io/creases.h>
#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/kit/picture/cut.h>
#include <solidsubdiv/kit/picture/deformation_picture.h>

namespace SolidSubdiv::Picture {

namespace {

using Point = std::array<double, 3>;
using Map = std::function<Point(const Point&)>;

std::vector<double> Moved(std::vector<double> positions, const Map& map) {
    for (std::size_t i = 0; i < positions.size(); i += 3) {
        const Point moved = map({positions[i], positions[i + 1], positions[i + 2]});
        std::copy(moved.begin(), moved.end(), positions.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return positions;
}

Point Turned(Point p, const Point& about, std::size_t axis, double angle) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double x = p[u] - about[u], y = p[v] - about[v];
    p[u] = about[u] + std::cos(angle) * x - std::sin(angle) * y;
    p[v] = about[v] + std::sin(angle) * x + std::cos(angle) * y;
    return p;
}

/// Bends the axis `along` towards `across` by `angle` between the two places on it, as an arc; beyond them stiffly.
Map Bend(std::size_t along, std::size_t across, double from, double to, double middle, double angle) {
    return [=](Point p) {
        const double radius = (to - from) / angle, t = std::clamp((p[along] - from) / (to - from), 0.0, 1.0);
        const double a = t * angle, beyond = p[along] - (from + t * (to - from)), r = radius - (p[across] - middle);
        p[along] = from + r * std::sin(a) + beyond * std::cos(a);
        p[across] = middle + radius - r * std::cos(a) + beyond * std::sin(a);
        return p;
    };
}

Io::Mesh MeshOf(const Deform::ControlLattice& lattice, std::vector<double> positions) {
    Io::Mesh mesh;
    mesh.topology.n_vertices = lattice.n_control_points();
    mesh.topology.hexes = lattice.hexes;
    mesh.topology.tets = lattice.tets;
    mesh.topology.octs = lattice.octs;
    mesh.positions = std::move(positions);
    return mesh;
}

Io::Mesh Deformed(Io::Mesh model, const Deform::ControlLattice& lattice, const std::vector<double>& moved,
                  const Deform::EmbedOptions& options) {
    const auto embedding = Deform::Embedding::Create(lattice.View(), lattice.positions, model.positions, options);
    Deform::Deformer(embedding).Deform(moved, model.positions);
    return model;
}

constexpr RenderOptions kPanel{.width = 360, .height = 300, .light_rays = 16, .ground_shadow = false};

struct Before {
    const Io::Mesh& model;
    const Deform::ControlLattice& lattice;
    std::string caption;  ///< of the model in the lattice
};

/// Three panels: the model in its lattice, both deformed, and the deformed model alone.
Image Row(const Before& before, const Map& map, const std::string& caption, const View& view,
          const Deform::EmbedOptions& options = {}, const RenderOptions& render = kPanel) {
    const std::vector<double> moved = Moved(before.lattice.positions, map);
    const Io::Mesh lattice = MeshOf(before.lattice, before.lattice.positions), after = MeshOf(before.lattice, moved);
    const Io::Mesh deformed = Deformed(before.model, before.lattice, moved, options);
    const DeformationState states[] = {
        {&before.model, &lattice, before.caption}, {&deformed, &after, caption}, {&deformed, nullptr, ""}};
    return DeformationPicture(states, {.view = view, .render = render});
}

Image Rows(std::vector<Image> rows) {
    std::vector<Panel> panels;
    for (Image& row : rows) panels.push_back({std::move(row), {}, {}});
    return Arrange(panels, {.columns = 1, .gap = 0});
}

Deform::ControlLattice Octree(const Io::Mesh& model, const Deform::OctreeOptions& options) {
    return Deform::MakeOctreeLattices(model.positions, model.topology.triangles, options).levels.back().lattice;
}

Image Spot(const Io::Mesh& spot) {
    const auto lattice = Octree(spot, {.levels = 3, .cut = Deform::Cut::Triangles, .padding = .02});
    return Row({spot, lattice, "level 3 of the octree"},
               [](const Point& p) { return Turned(p, {}, 1, 1.5 * (p[1] + .737) / 1.69); }, "twisted",
               {.azimuth = 205, .elevation = 14});
}

Image Koala(const Io::Mesh& koala) {
    const auto lattice = Octree(koala, {.levels = 2, .padding = .02, .shrink = true, .offset = .1});
    return Row({koala, lattice, "level 2, shrunken"}, Bend(2, 0, -3.5, 3, 0, 1.3), "bent",
               {.azimuth = 80, .elevation = 32});
}

Image Bison(const Io::Mesh& bison) {
    const auto lattice = Octree(bison, {.levels = 3, .cut = Deform::Cut::Triangles, .padding = .02});
    const Map bend = Bend(2, 1, -.6, .9, .4, .9);
    const auto rear = [&](Point p) {
        p[2] = -p[2];  // it looks to -z
        p = bend(p);
        p[2] = -p[2];
        return p;
    };
    return Row({bison, lattice, "51 open surfaces, level 3"}, rear, "bent", {.azimuth = 125, .elevation = 10});
}

Image PartRow(const Io::Mesh& part) {
    const auto lattice = Octree(part, {.levels = 4, .cut = Deform::Cut::Triangles, .padding = .02});
    const auto taper = [](Point p) {
        const double scale = 1.7 - 1.4 * (p[2] - .1) / .8;
        for (std::size_t c = 0; c < 2; ++c) p[c] = .5 + scale * (p[c] - .5);
        return p;
    };
    return Row({part, lattice, "genus 3, level 4"}, taper, "tapered", {.azimuth = 55, .elevation = 22});
}

/// The shape of a surface's control mesh after two steps.
Io::Mesh Refined(const Io::Mesh& control) {
    constexpr int kLevels = 2;
    const Io::Creases creases = Io::CreasesOf(control);
    auto descriptor = control.topology.View();
    creases.AddTo(descriptor);
    auto refiner = Far::TopologyRefiner::Create(descriptor, Sdc::Split::Polyhedral);
    refiner.RefineUniform({.max_level = kLevels});
    const Far::PrimvarRefiner primvars(refiner, Sdc::CatmullClark{});
    Io::Mesh fine;
    fine.positions = control.positions;
    for (int l = 1; l <= kLevels; ++l) {
        std::vector<double> finer(3 * static_cast<std::size_t>(refiner.n_vertices(l)));
        primvars.Interpolate<double>(l, fine.positions, finer, 3);
        fine.positions = std::move(finer);
    }
    const Vtr::PolyhedralLevel& level = refiner.polyhedral_level(kLevels);
    fine.topology.n_vertices = level.n_vertices;
    for (Index b = 0; b < level.n_boundary_faces; ++b) {
        const auto v = level.BoundaryVertices(b);
        fine.topology.triangles.insert(fine.topology.triangles.end(), {v[0], v[1], v[2], v[0], v[2], v[3]});
    }
    return fine;
}

Image Car(const Io::Mesh& control) {
    const Io::Mesh car = Refined(control);
    const auto hierarchy = Deform::MakeOctreeLattices(car.positions, car.topology.triangles,
                                                      {.levels = 3, .cut = Deform::Cut::Triangles, .padding = .02});
    const Deform::LatticeLevel& level = hierarchy.levels.back();
    const auto tets = Deform::MakeTetLattice(level.lattice, level.cells);
    const auto grow = [](Point p) {
        const double scale = .6 + .3 * (p[1] + 3.8);
        return Point{.62 + scale * (p[0] - .62), p[1], scale * p[2]};
    };
    RenderOptions panel = kPanel;
    panel.height = 190;
    return Row({car, tets.lattice, "31 surfaces, tets and octahedra"}, grow, "grown towards the rear",
               {.azimuth = 60, .elevation = 22, .up = UpAxis::Z}, {.scheme = Sdc::BoxSpline{}}, panel);
}

/// The head turns, in a block of 8^3 cells whose two outer layers of control points stay; the cells inside are drawn.
Image Local(const Io::Mesh& koala) {
    constexpr Point low{-3.2, -.7, .6}, high{3.2, 5.7, 7};
    const auto lattice =
        Octree(koala, {.levels = 3, .cut = Deform::Cut::None, .region = Geometry::Box{.low = low, .high = high}});
    const auto layer = [&](const Point& p) {
        double least = 4;
        for (std::size_t c = 0; c < 3; ++c) least = std::min({least, (p[c] - low[c]) / .8, (high[c] - p[c]) / .8});
        return least;
    };
    const std::vector<double> turned = Moved(lattice.positions, [&](const Point& p) {
        return Turned(p, {0, 0, 3}, 1, .8 * std::clamp((layer(p) - 1) / 2, 0.0, 1.0));
    });
    Deform::ControlLattice inside = lattice;
    inside.hexes.clear();
    for (std::size_t h = 0; h < lattice.hexes.size(); h += 8) {
        const auto corner = [&](std::size_t i) {
            return &lattice.positions[3 * static_cast<std::size_t>(lattice.hexes[h + i])];
        };
        const double *const a = corner(0), *const b = corner(6);
        if (std::min(layer({a[0], a[1], a[2]}), layer({b[0], b[1], b[2]})) < 1.9) continue;
        inside.hexes.insert(inside.hexes.end(), &lattice.hexes[h], &lattice.hexes[h] + 8);
    }
    const Io::Mesh after = Deformed(koala, lattice, turned, {.outside = Deform::Outside::Leave});
    const Io::Mesh at_rest = MeshOf(inside, inside.positions), moved = MeshOf(inside, turned);
    const DeformationState states[] = {
        {&koala, &at_rest, "inside of a block of 512 cells"}, {&after, &moved, "turned"}, {&after, nullptr, ""}};
    return DeformationPicture(states, {.view = {.azimuth = 62, .elevation = 20}, .render = kPanel});
}

/// A ring of eight cells around the shaft, twice: the shaft is in its hole.
Image HoleRow(const Io::Mesh& part) {
    const std::array<double, 4> steps{.5 - .19, .5 - .101, .5 + .101, .5 + .19};
    const std::array<double, 3> heights{.36, .5, .64};
    Deform::ControlLattice ring;
    for (const double z : heights) {
        for (const double y : steps) {
            for (const double x : steps) ring.positions.insert(ring.positions.end(), {x, y, z});
        }
    }
    for (Index cell = 0; cell < 18; ++cell) {
        if (cell % 9 == 4) continue;
        const Index v = 16 * (cell / 9) + 4 * (cell % 9 / 3) + cell % 3;
        ring.hexes.insert(ring.hexes.end(), {v, v + 1, v + 5, v + 4, v + 16, v + 17, v + 21, v + 20});
    }
    const auto widen = [](Point p) {
        if (std::max(std::abs(p[0] - .5), std::abs(p[1] - .5)) < .15) return p;
        for (std::size_t c = 0; c < 2; ++c) p[c] = .5 + (1.7 - .9 * (p[2] - .36) / .28) * (p[c] - .5);
        return p;
    };
    return Row({part, ring, "a lattice with a hole"}, widen, "the shaft, in the hole, stays",
               {.azimuth = 55, .elevation = 22}, {.outside = Deform::Outside::Leave});
}

Index NearestVertex(const Io::Mesh& model, const Point& place) {
    Index nearest = 0;
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < model.positions.size(); i += 3) {
        const double d = std::hypot(model.positions[i] - place[0], model.positions[i + 1] - place[1],
                                    model.positions[i + 2] - place[2]);
        if (d >= least) continue;
        least = d;
        nearest = static_cast<Index>(i / 3);
    }
    return nearest;
}

/// Vertices of the arms are dragged: one arm up, one down.
Image Drag(const Io::Mesh& human) {
    const auto lattice = Octree(human, {.levels = 3,
                                        .cut = Deform::Cut::Triangles,
                                        .region = Geometry::Box{.low = {-.9, -.03, -.45}, .high = {.9, 1.72, .45}}});
    std::vector<Deform::DragTarget> targets;
    for (const double x : {-.8, -.65, -.5, -.35, .35, .5, .65, .8}) {
        for (const double up : {-.05, .05}) {
            const Index v = NearestVertex(human, {x, 1.35 + up, 0});
            const double* const p = &human.positions[3 * static_cast<std::size_t>(v)];
            targets.push_back({v, Turned({p[0], p[1], p[2]}, {std::copysign(.2, x), 1.32, 0}, 2, .7)});
        }
    }
    std::vector<Index> locked;
    for (Index i = 0; i < lattice.n_control_points(); ++i) {
        if (std::abs(lattice.positions[3 * static_cast<std::size_t>(i)]) < .2) locked.push_back(i);
    }
    const auto embedding = Deform::Embedding::Create(lattice.View(), lattice.positions, human.positions, {});
    const auto drag = Deform::Drag(embedding, lattice.positions, targets, {.locked = locked});
    Io::Mesh dragged = human;
    Deform::Deformer(embedding).Deform(drag.control_points, dragged.positions);

    std::vector<double> at, to;
    std::vector<Index> ways;
    for (std::size_t t = 0; t < targets.size(); ++t) {
        const double* const p = &human.positions[3 * static_cast<std::size_t>(targets[t].point)];
        at.insert(at.end(), p, p + 3);
        to.insert(to.end(), targets[t].position.begin(), targets[t].position.end());
        ways.insert(ways.end(), {static_cast<Index>(t), static_cast<Index>(t + targets.size())});
    }
    std::vector<double> ends = at;
    ends.insert(ends.end(), to.begin(), to.end());
    const Io::Mesh moved = MeshOf(lattice, drag.control_points);
    const std::vector<Index> edges = ElementEdges(moved.topology);
    std::vector<Scene> scenes(3);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const Io::Mesh& model = i == 0 ? human : dragged;
        scenes[i].Add(Surface{.positions = model.positions, .triangles = model.topology.triangles});
    }
    scenes[0].Add(Lines{.positions = ends, .edges = ways, .color = Palette::kOctahedron, .width = 3, .shaded = true});
    scenes[0].Add(Points{.positions = at, .color = Palette::kOctahedron, .diameter = 9});
    scenes[0].Add(Points{.positions = to, .color = Palette::kTetrahedron, .diameter = 9});
    scenes[1].Add(
        Lines{.positions = moved.positions, .edges = edges, .color = Palette::kLattice, .width = 1, .shaded = true});
    const ScenePanel panels[] = {
        {&scenes[0], "vertices dragged", {}}, {&scenes[1], "the control points follow", {}}, {&scenes[2], "", {}}};
    return RenderPanels(panels, View{.azimuth = 12, .elevation = 8}, kPanel);
}

/// Coarse, then fine, then coarse again.
Image Session(const Io::Mesh& fish) {
    const auto hierarchy = Deform::MakeOctreeLattices(fish.positions, fish.topology.triangles,
                                                      {.levels = 4, .cut = Deform::Cut::Triangles, .padding = .02});
    std::vector<Deform::SessionLevel> levels;
    for (const auto& level : hierarchy.levels) {
        levels.push_back({.lattice = &level.lattice, .octree_rule = level.octree_rule});
    }
    Deform::EditingSession session(levels, fish.positions);
    std::vector<Io::Mesh> models{fish}, lattices{MeshOf(*levels[1].lattice, levels[1].lattice->positions)};
    const auto edit = [&](int level, const auto& moved_to) {
        session.SetLevel(level);
        const std::vector<double>& rest = levels[static_cast<std::size_t>(level)].lattice->positions;
        const std::vector<double> now(session.control_points().begin(), session.control_points().end());
        std::vector<Index> moved;
        std::vector<double> to;
        for (std::size_t i = 0; i < rest.size(); i += 3) {
            const Point p = moved_to(Point{rest[i], rest[i + 1], rest[i + 2]}, Point{now[i], now[i + 1], now[i + 2]});
            moved.push_back(static_cast<Index>(i / 3));
            to.insert(to.end(), p.begin(), p.end());
        }
        session.Move(moved, to);
        models.push_back(fish);
        models.back().positions.assign(session.points().begin(), session.points().end());
        lattices.push_back(MeshOf(*levels[static_cast<std::size_t>(level)].lattice, session.ControlPoints(level)));
    };
    edit(1, [](const Point& rest, const Point&) { return Bend(2, 1, -1.9, 1, .2, .9)(rest); });
    edit(3, [](const Point& rest, Point now) {
        now[1] += 1.2 * std::max(0.0, rest[1] - .6);  // the fin
        now[2] += .9 * std::max(0.0, rest[2] - .5);   // the snout
        return now;
    });
    edit(1, [](const Point& rest, const Point&) { return Bend(2, 1, -1.9, 1, .2, -.9)(rest); });
    const DeformationState states[] = {{&models[0], &lattices[0], "at rest"},
                                       {&models[1], &lattices[1], "level 1: bent"},
                                       {&models[2], &lattices[2], "level 3: fin, snout"},
                                       {&models[3], &lattices[3], "level 1 again"}};
    RenderOptions panel = kPanel;
    panel.width = 268;
    return DeformationPicture(states, {.view = {.azimuth = 75, .elevation = 12}, .render = panel});
}

/// Where the file is, or an empty path.
std::filesystem::path Find(const std::filesystem::path& folder, const std::string& name) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().filename() == name) return entry.path();
    }
    return {};
}

}  // namespace

void DrawDeformations(const std::filesystem::path& models, const std::filesystem::path& out) {
    const auto draw = [&](const std::string& picture, const std::vector<std::string>& names, const auto& drawn) {
        std::vector<Io::Mesh> meshes;
        for (const std::string& name : names) {
            const std::filesystem::path path = Find(models, name);
            if (path.empty()) {
                std::printf("skipped %s: %s is not in %s\n", picture.c_str(), name.c_str(), models.string().c_str());
                return;
            }
            meshes.push_back(Io::ReadMesh(path));
        }
        WritePng(out / picture, drawn(meshes));
    };
    using Meshes = std::vector<Io::Mesh>;
    const std::string spot = "c3d_spot.obj", koala = "ode_koala.obj", part = "hoppe_mechpart.recon.obj";
    draw("deformation_spot.png", {spot}, [](const Meshes& m) { return Spot(m[0]); });
    draw("deformation_koala.png", {koala}, [](const Meshes& m) { return Koala(m[0]); });
    draw("deformation_bison.png", {"assimp_WusonOBJ.obj"}, [](const Meshes& m) { return Bison(m[0]); });
    draw("deformation_parts.png", {part}, [](const Meshes& m) { return Rows({PartRow(m[0]), HoleRow(m[0])}); });
    draw("deformation_tets.png", {"catmark_car.obj"}, [](const Meshes& m) { return Car(m[0]); });
    draw("deformation_local.png", {koala}, [](const Meshes& m) { return Local(m[0]); });
    draw("deformation_editing.png", {"ode_human_woman.obj", "cino_blub_triangulated.obj"}, [](const Meshes& m) {
        return Rows({Drag(m[0]), Session(m[1])});
    });
}

}  // namespace SolidSubdiv::Picture

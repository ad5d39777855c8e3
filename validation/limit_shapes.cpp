// SPDX-License-Identifier: Apache-2.0
// The validators' shapes as owned meshes.
#include "limit_shapes.h"

#include <algorithm>

#include "cell_shapes.h"
#include "polygon_shapes.h"
#include "solid_shapes.h"
#include "surface_shapes.h"

namespace SolidSubdiv::Validation {

namespace {

/// Cells of tets and octahedra.
std::vector<Sdc::Scheme> TetOctSchemes() {
    return {Sdc::BoxSpline{},
            Sdc::BoxSpline{.diagonals = Sdc::Diagonals::Averaged, .loop_weights = Sdc::LoopWeights::Warren},
            Sdc::BoxSpline{.edge_rule = Sdc::EdgeRule::Printed2002},
            Sdc::BoxSpline{.features = Sdc::Features::Sharp},
            Sdc::SmoothTet{},
            Sdc::Interpolatory{},
            Sdc::Interpolatory{.tension = 0.03, .boundary = Sdc::ButterflyKind::Plain},
            Sdc::LinearSolid{}};
}
std::vector<Sdc::Scheme> PolyhedralSchemes() {
    return {Sdc::CatmullClarkSolid{},
            Sdc::CatmullClarkSolid{.features = Sdc::Features::Smooth},
            Sdc::Mlca{},
            Sdc::Mlca{.features = Sdc::Features::Smooth},
            Sdc::Mlca{.surface = Sdc::BoundarySurface::CatmullClark},
            Sdc::LinearSolid{}};
}
std::vector<Sdc::Scheme> TriangleSchemes() {
    return {Sdc::Loop{},
            Sdc::Loop{.loop_weights = Sdc::LoopWeights::Warren, .features = Sdc::Features::Sharp},
            Sdc::Butterfly{},
            Sdc::ModifiedButterfly{},
            Sdc::ModifiedButterfly{.far_weight = 0.02},
            Sdc::LinearSurface{}};
}
std::vector<Sdc::Scheme> PolygonSchemes() {
    return {Sdc::CatmullClark{}, Sdc::CatmullClark{.features = Sdc::Features::Sharp},
            Sdc::CatmullClark{.triangles = Sdc::TriangleWeights::Smooth}, Sdc::LinearSurface{}};
}

LimitShape Start(std::string name, const std::vector<double>& positions, Sdc::Split split) {
    LimitShape shape{.name = std::move(name), .mesh = {}, .positions = positions, .split = split};
    shape.mesh.n_vertices = static_cast<Index>(positions.size() / 3);
    return shape;
}

LimitShape Of(const SolidShape& solid) {
    LimitShape shape = Start(solid.name, solid.positions, Sdc::Split::TetOct);
    for (const auto& t : solid.complex.tets) shape.mesh.tets.insert(shape.mesh.tets.end(), t.begin(), t.end());
    for (const auto& o : solid.complex.octs) shape.mesh.octs.insert(shape.mesh.octs.end(), o.begin(), o.end());
    shape.schemes = TetOctSchemes();
    return shape;
}

LimitShape Of(const CellShape& cells) {
    LimitShape shape = Start(cells.name, cells.positions, Sdc::Split::Polyhedral);
    OwnedMesh& mesh = shape.mesh;
    for (const auto& hex : cells.hexes) mesh.hexes.insert(mesh.hexes.end(), hex.begin(), hex.end());
    for (const auto& cell : cells.cells) {
        for (const Polygon& face : cell) {
            mesh.polyhedron_vertices.insert(mesh.polyhedron_vertices.end(), face.begin(), face.end());
            mesh.polyhedron_face_offsets.push_back(static_cast<Offset>(mesh.polyhedron_vertices.size()));
        }
        mesh.polyhedron_offsets.push_back(static_cast<Offset>(mesh.polyhedron_face_offsets.size()) - 1);
    }
    shape.schemes = PolyhedralSchemes();
    return shape;
}

LimitShape Of(const SurfaceShape& surface) {
    LimitShape shape = Start(surface.name, surface.positions, Sdc::Split::TetOct);
    for (const Triangle& t : surface.triangles) {
        shape.mesh.triangles.insert(shape.mesh.triangles.end(), t.begin(), t.end());
    }
    shape.schemes = TriangleSchemes();
    return shape;
}

LimitShape Of(const PolygonShape& surface) {
    LimitShape shape = Start(surface.name, surface.positions, Sdc::Split::Polyhedral);
    for (const Polygon& face : surface.faces) {
        shape.mesh.polygon_vertices.insert(shape.mesh.polygon_vertices.end(), face.begin(), face.end());
        shape.mesh.polygon_offsets.push_back(static_cast<Offset>(shape.mesh.polygon_vertices.size()));
    }
    shape.schemes = PolygonSchemes();
    return shape;
}

/// With random tags. Semi-sharp ones are for schemes that let them fade, and smooth features: how sharp ones change
/// Chaikin's means of what is tagged too, CreasesAt leaves out.
LimitShape Tagged(LimitShape shape, const std::vector<Polygon>& faces, std::uint32_t seed, bool infinite,
                  bool chaikin = false) {
    const SurfaceTags tags = RandomTags(faces, seed, infinite);
    Far::Creases& creases = shape.mesh.creases;
    for (const auto& ends : tags.creases) creases.edges.insert(creases.edges.end(), ends.begin(), ends.end());
    creases.edge_sharpness = tags.crease_sharpness;
    creases.vertices = tags.corners;
    creases.vertex_sharpness = tags.corner_sharpness;
    shape.name += infinite ? ", infinite tags" : chaikin ? ", tags, Chaikin" : ", tags";
    if (infinite) return shape;
    std::vector<Sdc::Scheme> fading;
    for (Sdc::Scheme& scheme : shape.schemes) {
        std::visit(
            [&](auto& s) {
                if constexpr (requires { s.creasing; }) {
                    if (chaikin) s.creasing = Sdc::CreasingMethod::Chaikin;
                    if (s.features == Sdc::Features::Smooth) fading.push_back(s);
                }
            },
            scheme);
    }
    shape.schemes = fading;
    return shape;
}

/// With a triangle and a rod on an edge.
LimitShape Mixed(LimitShape shape, Index a, Index b) {
    shape.name += " with a membrane and a rod";
    const Index n = shape.mesh.n_vertices;
    shape.mesh.triangles = {a, b, n};
    shape.mesh.edges = {n, n + 1};
    shape.mesh.n_vertices += 2;
    shape.positions.insert(shape.positions.end(), {-1, -1, -1, -2, -1, -3});
    return shape;
}

std::vector<Polygon> AsPolygons(const std::vector<Triangle>& triangles) {
    std::vector<Polygon> faces;
    for (const Triangle& t : triangles) faces.emplace_back(t.begin(), t.end());
    return faces;
}

/// The shape of that name.
template <class Shape>
const Shape& Named(const std::vector<Shape>& shapes, const std::string& name) {
    return *std::find_if(shapes.begin(), shapes.end(), [&](const Shape& s) { return s.name == name; });
}

}  // namespace

std::vector<LimitShape> LimitShapes() {
    std::vector<LimitShape> shapes;
    const auto add = [&](LimitShape shape, int n_in_cells, int n_on_faces) {
        shape.n_in_cells = n_in_cells;
        shape.n_on_faces = n_on_faces;
        shapes.push_back(std::move(shape));
    };
    const auto solids = ManifoldShapes(), touching = NonManifoldShapes();
    for (const char* name : {"octet-truss", "oct-and-tets", "split-block", "spindle-5"}) {
        add(Of(Named(solids, name)), 12, 6);
    }
    add(Of(Named(touching, "edge-contacts")), 6, 6);
    const SolidShape& oct = Named(solids, "oct-and-tets");
    add(Mixed(Of(oct), oct.complex.octs[0][0], oct.complex.octs[0][2]), 6, 12);
    for (const char* name : {"octet-truss", "spindle-7"}) {
        const SolidShape& solid = Named(solids, name);
        const std::vector<Polygon> faces = AsPolygons(BoundaryTriangles(solid.complex));
        add(Tagged(Of(solid), faces, 1, true), 6, 6);
        add(Tagged(Of(solid), faces, 2, false), 6, 6);
        add(Tagged(Of(solid), faces, 3, false, true), 6, 6);
    }
    const auto cells = CellShapes();
    const auto hexes = HexShapes();
    for (const char* name : {"block", "5 hexahedra around an edge", "3 wedges around an edge",
                             "six pyramids under a cube", "pentagonal prism with pyramids", "meeting in an edge"}) {
        add(Of(Named(cells, name)), 8, 4);
    }
    const CellShape& prism = Named(cells, "pentagonal prism with pyramids");
    add(Mixed(Of(prism), prism.cells[0][0][0], prism.cells[0][0][1]), 6, 12);
    const HexShape& step = Named(hexes, "step");
    const CellShape step_cells{step.name, step.cells, {}, step.positions};
    add(Tagged(Of(step_cells), BoundaryOf(step), 4, true), 6, 6);
    add(Tagged(Of(step_cells), BoundaryOf(step), 5, false, true), 6, 6);
    const auto surfaces = AllSurfaces();
    for (const char* name : {"sheet", "disc-5", "disc-3", "fan-4", "boundary of ring"}) {
        add(Of(Named(surfaces, name)), 0, 24);
    }
    const SurfaceShape& annulus = Named(surfaces, "annulus");
    add(Tagged(Of(annulus), AsPolygons(annulus.triangles), 6, true), 0, 12);
    add(Tagged(Of(annulus), AsPolygons(annulus.triangles), 7, false), 0, 12);
    const auto polygons = PolygonShapes();
    for (const char* name : {"mixed torus", "mixed sheet", "quad-disc-5", "quad-fan-1", "boundary of l"}) {
        add(Of(Named(polygons, name)), 0, 24);
    }
    const PolygonShape& mixed = Named(polygons, "mixed sheet");
    add(Tagged(Of(mixed), mixed.faces, 8, true), 0, 12);
    add(Tagged(Of(mixed), mixed.faces, 9, false, true), 0, 12);
    return shapes;
}

}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
// Cut solids: what is left has a closed boundary around exactly the volume of the cells that are left.
#include "kit/picture/solid_testing.h"

#include <gtest/gtest.h>
#include <solidsubdiv/kit/picture/cut.h>
#include <solidsubdiv/sdc/errors.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

namespace SolidSubdiv::Picture {
namespace {

TEST(SolidBoundaryTest, EncloseTheVolumeOfEveryKindOfCell) {
    const Io::Mesh all = OneOfEach();
    const auto only = [&](auto Io::Topology::*kind) {
        Io::Mesh mesh = all;
        mesh.topology = {};
        mesh.topology.n_vertices = all.topology.n_vertices;
        mesh.topology.*kind = all.topology.*kind;
        return SixVolumes(mesh.positions, SolidBoundary(mesh).triangles);
    };
    EXPECT_NEAR(only(&Io::Topology::hexes), 6, 1e-14);
    EXPECT_NEAR(only(&Io::Topology::pyramids), 2, 1e-14);
    EXPECT_NEAR(only(&Io::Topology::wedges), 3, 1e-14);
    EXPECT_NEAR(only(&Io::Topology::octs), 8, 1e-14);
    EXPECT_NEAR(only(&Io::Topology::tets), 2, 1e-14);
    EXPECT_NEAR(SixVolumes(all.positions, SolidBoundary(all).triangles), 21,
                1e-13);  // shared faces are gone, what remains closes
}

TEST(CutSolidTest, BoundaryClosesAroundTheCellsThatAreLeft) {
    const Io::Mesh mesh = TetBlock(4);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> x(-1, 1);
    for (int trial = 0; trial < 20; ++trial) {
        const Plane plane{{2 + x(random), 2 + x(random), 2 + x(random)}, {x(random), x(random), x(random)}};
        int kept = 0;  // cells, counted here by their centroids
        for (std::size_t c = 0; c < mesh.topology.tets.size(); c += 4) {
            double side = 0;
            for (std::size_t i = 0; i < 4; ++i) {
                for (std::size_t k = 0; k < 3; ++k) {
                    side += plane.normal[k] *
                            (mesh.positions[3 * static_cast<std::size_t>(mesh.topology.tets[c + i]) + k] / 4 -
                             plane.point[k] / 4);
                }
            }
            kept += side <= 0 ? 1 : 0;
        }
        ASSERT_GT(kept, 0);
        const SolidFaces cut = CutSolid(mesh, plane);
        EXPECT_NEAR(SixVolumes(mesh.positions, cut.triangles), kept, 1e-9);  // each tet has volume 1/6
        EXPECT_EQ(cut.kinds.size() * 3, cut.triangles.size());
        EXPECT_EQ(cut.opened.size() * 3, cut.triangles.size());
    }
}

TEST(CutSolidTest, OpenedFacesAreThoseInsideTheSolid) {
    const Io::Mesh mesh = TetBlock(3);
    const SolidFaces cut = CutSolid(mesh, {{1.5, 1.5, 1.5}, {1, 0.3, 0.2}});
    std::set<std::pair<Index, Index>> sides;
    int opened = 0;
    for (std::size_t t = 0; t < cut.opened.size(); ++t) {
        const Index* v = &cut.triangles[3 * t];
        bool on_block = false;  // all three vertices on one side of the block
        for (std::size_t k = 0; k < 3; ++k) {
            for (double wall : {0.0, 3.0}) {
                on_block |= std::all_of(
                    v, v + 3, [&](Index i) { return mesh.positions[3 * static_cast<std::size_t>(i) + k] == wall; });
            }
        }
        EXPECT_EQ(cut.opened[t] != 0, !on_block);
        if (cut.opened[t] == 0) continue;
        ++opened;
        for (int i = 0; i < 3; ++i) sides.insert(std::minmax(v[i], v[(i + 1) % 3]));
    }
    EXPECT_GT(opened, 10);
    std::set<std::pair<Index, Index>> edges;
    for (std::size_t e = 0; e < cut.edges.size(); e += 2) edges.insert({cut.edges[e], cut.edges[e + 1]});
    EXPECT_EQ(edges, sides);
    EXPECT_EQ(edges.size() * 2, cut.edges.size());
}

TEST(CutSolidTest, ColoursTellKindsApart) {
    const Io::Mesh mesh = OneOfEach();
    const SolidFaces all = SolidBoundary(mesh);
    const std::vector<Color> colors = all.ColorsByKind();
    for (std::size_t t = 0; t < colors.size(); ++t) {
        const std::map<CellKind, Color> expected{
            {CellKind::Tet, Palette::kTetrahedron}, {CellKind::Oct, Palette::kOctahedron},
            {CellKind::Hex, Palette::kHexahedron},  {CellKind::Wedge, Palette::kWedge},
            {CellKind::Pyramid, Palette::kPyramid}, {CellKind::Polyhedron, Palette::kPolyhedron}};
        EXPECT_EQ(colors[t], expected.at(all.kinds[t]));
        EXPECT_EQ(all.ColorsByKind({1, 0, 0})[t], (Color{1, 0, 0}));  // nothing is opened
    }
    // Take the octahedron's neighbour away: the face between them opens and is the octahedron's.
    const SolidFaces cut = CutSolid(mesh, {{6.4, 0, 0}, {1, 0, 0}});
    ASSERT_EQ(std::count(cut.opened.begin(), cut.opened.end(), 1), 1);
    const auto t = static_cast<std::size_t>(std::find(cut.opened.begin(), cut.opened.end(), 1) - cut.opened.begin());
    EXPECT_EQ(cut.kinds[t], CellKind::Oct);
    EXPECT_EQ(cut.ColorsByKind({1, 0, 0})[t], Palette::kOctahedron);
}

TEST(CutSolidTest, PolyhedraAreCutAsTheCellsThatTheyCouldBe) {
    const Io::Mesh mesh = OneOfEach(), polyhedra = AsPolyhedra(mesh);
    EXPECT_EQ(ElementEdges(polyhedra.topology), ElementEdges(mesh.topology));
    for (double x : {0.45, 0.6, 1.1, 6.4, 9.0}) {
        const Plane plane{{x, 0, 0}, {1, 0.1, 0.05}};
        const SolidFaces expected = CutSolid(mesh, plane), cut = CutSolid(polyhedra, plane);
        EXPECT_EQ(cut.triangles, expected.triangles) << x;
        EXPECT_EQ(cut.opened, expected.opened) << x;
        EXPECT_EQ(cut.edges, expected.edges) << x;
        for (CellKind kind : cut.kinds) EXPECT_EQ(kind, CellKind::Polyhedron);
    }
}

TEST(CutSolidTest, FacesOfManyCornersClose) {
    // A prism over a hexagon of side 1, and a copy on top of it.
    Io::Mesh mesh;
    Io::Topology& t = mesh.topology;
    for (int layer = 0; layer < 3; ++layer) {
        for (int i = 0; i < 6; ++i) {
            const double angle = i * std::acos(-1.0) / 3;
            mesh.positions.insert(mesh.positions.end(), {std::cos(angle), std::sin(angle), 1.0 * layer});
        }
    }
    t.n_vertices = 18;
    t.polyhedron_offsets = t.polyhedron_face_offsets = {0};
    for (Index low : {0, 6}) {
        const auto add = [&](const std::vector<Index>& face) {
            for (Index v : face) t.polyhedron_vertices.push_back(low + v);
            t.polyhedron_face_offsets.push_back(static_cast<Offset>(t.polyhedron_vertices.size()));
        };
        add({5, 4, 3, 2, 1, 0});
        add({8, 9, 10, 11, 6, 7});
        for (Index i = 0; i < 6; ++i) add({i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6});
        t.polyhedron_offsets.push_back(static_cast<Offset>(t.polyhedron_face_offsets.size()) - 1);
    }
    const double six_areas = 6 * 1.5 * std::sqrt(3.0);
    EXPECT_NEAR(SixVolumes(mesh.positions, SolidBoundary(mesh).triangles), 2 * six_areas, 1e-12);
    const SolidFaces below = CutSolid(mesh, {{0, 0, 1}, {0, 0, 1}});
    EXPECT_NEAR(SixVolumes(mesh.positions, below.triangles), six_areas, 1e-12);
    EXPECT_EQ(std::count(below.opened.begin(), below.opened.end(), 1), 4) << "the hexagon between them";
    EXPECT_EQ(below.edges.size(), 2u * 6);
}

TEST(CutSolidTest, PlanesWithoutADirectionAreRefused) {
    const Io::Mesh mesh = OneOfEach();
    EXPECT_THROW(CutSolid(mesh, {{0, 0, 0}, {0, 0, 0}}), InvalidInput);
    EXPECT_THROW(CutSolid(mesh, {{0, 0, 0}, {0, NAN, 0}}), InvalidInput);
}

TEST(ElementEdgesTest, EveryEdgeOfEveryElementOnce) {
    const Io::Mesh mesh = OneOfEach();
    // Hex 12, pyramid 4 more, wedge 5 more, octahedron 12, tet 3 more.
    EXPECT_EQ(ElementEdges(mesh.topology).size(), 2u * (12 + 4 + 5 + 12 + 3));
    Io::Topology faces;
    faces.triangles = {0, 1, 2};
    faces.quads = {1, 2, 3, 4};
    faces.polygon_offsets = {0, 5};
    faces.polygon_vertices = {5, 6, 7, 8, 9};
    faces.edges = {1, 0, 10, 9};
    EXPECT_EQ(ElementEdges(faces),
              (std::vector<Index>{0, 1, 0, 2, 1, 2, 1, 4, 2, 3, 3, 4, 5, 6, 5, 9, 6, 7, 7, 8, 8, 9, 9, 10}));
}

}  // namespace
}  // namespace SolidSubdiv::Picture

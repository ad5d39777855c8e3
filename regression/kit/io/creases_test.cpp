// SPDX-License-Identifier: Apache-2.0
// Creases and corners of a mesh: gathered from its elements, put there, and through every format that carries them.
#include <cmath>
#include <limits>

#include <solidsubdiv/kit/io/creases.h>

#include "kit/io/support.h"

namespace SolidSubdiv::Io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// One tet, one triangle, edges and single vertices, whose sharpness are the given numbers.
Mesh MeshWith(const std::vector<Index>& edges, const std::vector<Index>& vertices, std::vector<double> sharpness) {
    Mesh mesh;
    mesh.topology.n_vertices = 12;
    mesh.positions = AwkwardPositions();
    mesh.topology.tets = {0, 1, 2, 3};
    mesh.topology.triangles = {0, 1, 2};
    mesh.topology.edges = edges;
    mesh.topology.vertices = vertices;
    mesh.cell_data = {{"sharpness", 1, {0, 0}}};
    mesh.cell_data[0].values.insert(mesh.cell_data[0].values.end(), sharpness.begin(), sharpness.end());
    return mesh;
}

std::string RefusalOf(const std::function<void()>& call) {
    try {
        call();
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return {};
}

void ExpectSameCreases(const Creases& a, const Creases& b) {
    EXPECT_EQ(a.edge_vertices, b.edge_vertices);
    EXPECT_EQ(a.edge_sharpness, b.edge_sharpness);
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.vertex_sharpness, b.vertex_sharpness);
}

TEST(CreasesOf, EdgesAndVerticesOfPositiveSharpnessAreGatheredInOrder) {
    const Creases creases = CreasesOf(MeshWith({0, 1, 4, 3, 2, 0}, {7, 3, 0}, {2.5, 0, 0.1, 10, 0, 1}));
    EXPECT_THAT(creases.edge_vertices, ElementsAre(0, 1, 2, 0));
    EXPECT_THAT(creases.edge_sharpness, ElementsAre(2.5f, 0.1f));
    EXPECT_THAT(creases.vertices, ElementsAre(7, 0));
    EXPECT_THAT(creases.vertex_sharpness, ElementsAre(10.f, 1.f));
    EXPECT_FALSE(creases.empty());
}

TEST(CreasesOf, MeshWithoutSharpnessHasNone) {
    Mesh mesh = MeshWith({0, 1}, {2}, {3, 3});
    mesh.cell_data[0].name = "sharp";
    EXPECT_TRUE(CreasesOf(mesh).empty());
    EXPECT_TRUE(CreasesOf(Mesh()).empty());
    EXPECT_TRUE(CreasesOf(MeshWith({0, 1}, {2}, {0, 0})).empty());
}

TEST(CreasesOf, LargestSharpnessCountsWhereSeveralHaveTheSameVertices) {
    const Creases creases = CreasesOf(MeshWith({0, 1, 1, 0, 2, 3, 0, 1, 3, 2}, {5, 5, 0}, {2, 4, 6, 3, 5, 1, 2, 7}));
    EXPECT_THAT(creases.edge_vertices, ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(creases.edge_sharpness, ElementsAre(4.f, 6.f));
    EXPECT_THAT(creases.vertices, ElementsAre(5, 0));
    EXPECT_THAT(creases.vertex_sharpness, ElementsAre(2.f, 7.f));
}

TEST(CreasesOf, TenStandsForAllAboveAndWhatIsTooSmallForAFloatIsZero) {
    const double huge = std::numeric_limits<double>::infinity();
    const Creases creases = CreasesOf(MeshWith({0, 1, 1, 2, 2, 3, 3, 4}, {0}, {10.5, huge, 1e300, 1e-300, 9.5}));
    EXPECT_THAT(creases.edge_vertices, ElementsAre(0, 1, 1, 2, 2, 3));
    EXPECT_THAT(creases.edge_sharpness, ElementsAre(10.f, 10.f, 10.f));
    EXPECT_THAT(creases.vertex_sharpness, ElementsAre(9.5f));
}

TEST(CreasesOf, WhatIsNoSharpnessIsRefusedByElementAndValue) {
    EXPECT_EQ(RefusalOf([] {
                  CreasesOf(MeshWith({0, 1, 1, 2}, {}, {1, -0.5}));
              }),
              "edge 1 has the sharpness -0.5; it must be 0 (no crease) or greater, 10 for infinitely sharp");
    EXPECT_EQ(RefusalOf([] {
                  CreasesOf(MeshWith({0, 1}, {3, 4, 5}, {1, 0, 0, std::nan("")}));
              }),
              "single vertex 2 has the sharpness nan; it must be 0 (no crease) or greater, 10 for infinitely sharp");
    // What tets and faces have is not asked.
    Mesh mesh = MeshWith({0, 1}, {}, {1});
    mesh.cell_data[0].values[0] = mesh.cell_data[0].values[1] = -1;
    EXPECT_EQ(CreasesOf(mesh).edge_sharpness.size(), 1u);
}

TEST(CreasesOf, WrongShapeOfTheAttributeIsRefused) {
    Mesh mesh = MeshWith({0, 1}, {2}, {1, 1});
    mesh.cell_data[0].values.pop_back();
    EXPECT_EQ(RefusalOf([&] { CreasesOf(mesh); }), "cell data 'sharpness' has 3 numbers, in rows of 1, for 4 elements");
    mesh.cell_data[0] = {"sharpness", 2, std::vector<double>(8, 1)};
    EXPECT_THAT(RefusalOf([&] { CreasesOf(mesh); }), HasSubstr("has rows of 2 numbers; it needs one number"));
    EXPECT_EQ(FindSharpness(mesh), nullptr);
}

TEST(SetCreases, AppendsElementsAndZerosForOtherData) {
    Mesh mesh = MeshWith({0, 1}, {2}, {1, 1});
    mesh.cell_data = {{"label", 1, {1, 2, 3, 4}}, {"pair", 2, {1, -1, 2, -2, 3, -3, 4, -4}}};
    SetCreases(mesh,
               {.edge_vertices = {3, 1, 2, 1}, .edge_sharpness = {5, 0.5}, .vertices = {0}, .vertex_sharpness = {2}});
    EXPECT_THAT(mesh.topology.edges, ElementsAre(0, 1, 3, 1, 2, 1));
    EXPECT_THAT(mesh.topology.vertices, ElementsAre(2, 0));
    EXPECT_THAT(mesh.FindCellData("sharpness")->values, ElementsAre(0, 0, 0, 5, 0.5, 0, 2));
    EXPECT_THAT(mesh.FindCellData("label")->values, ElementsAre(1, 2, 3, 0, 0, 4, 0));
    EXPECT_THAT(mesh.FindCellData("pair")->values, ElementsAre(1, -1, 2, -2, 3, -3, 0, 0, 0, 0, 4, -4, 0, 0));
}

TEST(SetCreases, ElementsThatAreThereAreUsedAndOldCreasesEnd) {
    Mesh mesh = MeshWith({0, 1, 1, 2}, {2, 3}, {1, 2, 3, 4});
    SetCreases(mesh,
               {.edge_vertices = {2, 1, 1, 2}, .edge_sharpness = {5, 4}, .vertices = {3}, .vertex_sharpness = {6}});
    EXPECT_THAT(mesh.topology.edges, ElementsAre(0, 1, 1, 2));
    EXPECT_THAT(mesh.topology.vertices, ElementsAre(2, 3));
    EXPECT_THAT(mesh.FindCellData("sharpness")->values, ElementsAre(0, 0, 0, 5, 0, 6));
    EXPECT_EQ(mesh.cell_data.size(), 1u);
}

TEST(SetCreases, WithoutCreasesThereIsNoAttribute) {
    Mesh mesh = MeshWith({0, 1}, {2}, {1, 1});
    SetCreases(mesh, {.edge_vertices = {3, 4}, .edge_sharpness = {0}});
    EXPECT_THAT(mesh.topology.edges, ElementsAre(0, 1));
    EXPECT_THAT(mesh.cell_data, IsEmpty());
}

TEST(SetCreases, OnesOwnCreasesChangeNothing) {
    const Mesh mesh = MeshWith({0, 1, 1, 2}, {2, 3}, {1, 0, 3, 0.5});
    Mesh again = mesh;
    SetCreases(again, CreasesOf(mesh));
    ExpectSameMesh(again, mesh);
}

TEST(SetCreases, WhatIsWrongIsNamedAndTheMeshLeftAsItWas) {
    const Mesh mesh = MeshWith({0, 1}, {}, {1});
    const struct {
        Creases creases;
        const char* says;
    } cases[] = {
        {{.edge_vertices = {0, 1, 2}, .edge_sharpness = {1}}, "creases to set: 3 vertices for 1 values of sharpness"},
        {{.edge_vertices = {0, 1}, .edge_sharpness = {1, 2}}, "creases to set: 2 vertices for 2 values of sharpness"},
        {{.vertices = {0}}, "corners to set: 1 vertex for 0 values of sharpness"},
        {{.edge_vertices = {0, 1, 1, 12}, .edge_sharpness = {1, 2}},
         "crease 1 names vertex 12; the mesh has 12 vertices"},
        {{.vertices = {-1}, .vertex_sharpness = {1}}, "corner 0 names vertex -1; the mesh has 12 vertices"},
        {{.edge_vertices = {0, 2}, .edge_sharpness = {-2}}, "crease 0 has the sharpness -2; it must be 0"},
        {{.edge_vertices = {0, 2}, .edge_sharpness = {1}, .vertices = {3}, .vertex_sharpness = {std::nanf("")}},
         "corner 0 has the sharpness nan; it must be 0"}};
    for (const auto& c : cases) {
        Mesh changed = mesh;
        EXPECT_THAT(RefusalOf([&] { SetCreases(changed, c.creases); }), testing::StartsWith(c.says));
        ExpectSameMesh(changed, mesh);
    }
    Mesh damaged = mesh;
    damaged.cell_data = {{"label", 1, {1, 2}}};
    EXPECT_THAT(RefusalOf([&] { SetCreases(damaged, {.vertices = {3}, .vertex_sharpness = {1}}); }),
                HasSubstr("'label' has 2 numbers, in rows of 1, for 3 elements"));
    EXPECT_THAT(damaged.topology.vertices, IsEmpty());
}

// ---- Through files ----

struct Way {
    std::string extension;
    std::string kinds;  // as in MeshOf
    bool binary, corners, infinite;
};

class CreasesThrough : public testing::TestWithParam<Way> {};

/// Creases on an edge, on another element's edge and on none; corners; numbers that only floats tell apart.
TEST_P(CreasesThrough, FileAndBackAreTheSame) {
    const Way& way = GetParam();
    Mesh mesh = MeshOf(way.kinds);
    mesh.point_data.clear();
    mesh.cell_data.clear();
    const auto sharpness = [&](float finite) { return way.infinite ? kInfinitelySharp : finite; };
    Creases creases;
    creases.edge_vertices = {0, 1, 2, 1, 10, 3};
    creases.edge_sharpness = {sharpness(0.1f), 10, sharpness(std::nextafter(2.f, 3.f))};
    if (way.corners) {
        creases.vertices = {11, 0};
        creases.vertex_sharpness = {10, sharpness(1.f / 3)};
    }
    SetCreases(mesh, creases);
    TemporaryFolder folder;
    const auto path = folder / ("a" + way.extension);
    EXPECT_THAT(AttributesLeftOut(path, mesh), IsEmpty());
    WriteMesh(path, mesh, {.keep_octahedra = true, .binary = way.binary});
    const Mesh back = ReadMesh(path);
    ExpectSameMesh(back, mesh);
    ExpectSameCreases(CreasesOf(back), creases);
}

INSTANTIATE_TEST_SUITE_P(
    Formats, CreasesThrough,
    testing::Values(Way{".vtu", "tohTPE", true, true, false}, Way{".vtu", "tohTPE", false, true, false},
                    Way{".vtk", "tohTPE", true, true, false}, Way{".vtk", "tohTPE", false, true, false},
                    Way{".msh", "thTE", false, true, false}, Way{".obj", "TQPEV", false, true, false},
                    Way{".obj", "T", false, true, false}, Way{".ply", "TQPE", true, false, false},
                    Way{".ply", "T", false, false, false}, Way{".mesh", "thTE", false, true, true},
                    Way{".mesh", "T", false, false, true}),
    [](const auto& way) {
        return way.param.extension.substr(1) + "_" + way.param.kinds + (way.param.binary ? "_binary" : "");
    });

/// Octahedra that are cut become more cells; the rows of the creases stay theirs.
TEST(Creases, StayWithTheirElementsWhenOctahedraAreCut) {
    Mesh mesh = MeshOf("toT");
    mesh.cell_data.clear();
    SetCreases(mesh, {.edge_vertices = {0, 2}, .edge_sharpness = {3}, .vertices = {5}, .vertex_sharpness = {10}});
    TemporaryFolder folder;
    for (const char* name : {"a.vtu", "a.vtk", "a.msh"}) {
        WriteMesh(folder / name, mesh);
        const Mesh back = ReadMesh(folder / name);
        EXPECT_EQ(back.topology.n_octs(), 0);
        ExpectSameCreases(CreasesOf(back), CreasesOf(mesh));
    }
}

TEST(Creases, CornersAreRefusedByFormatsWithoutSingleVertices) {
    Mesh mesh = MeshOf("T");
    mesh.cell_data.clear();
    SetCreases(mesh, {.vertices = {5}, .vertex_sharpness = {3}});
    TemporaryFolder folder;
    for (const char* name : {"a.ply", "a.stl", "a.mesh", "a.node"}) {
        EXPECT_THAT(ErrorOf([&] { WriteMesh(folder / name, mesh); }), HasSubstr("files can't hold ")) << name;
    }
    EXPECT_THAT(folder.Files(), IsEmpty());
}

}  // namespace
}  // namespace SolidSubdiv::Io

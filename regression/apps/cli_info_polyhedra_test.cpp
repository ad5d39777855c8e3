// SPDX-License-Identifier: Apache-2.0
// What info says of hexahedra, mixed cells and polygons whose answers are known.
#include "apps/cli_testing.h"
#include "polyhedral_shapes.h"

namespace SolidSubdiv::CliTesting {
namespace {

using testing::HasSubstr;
using testing::Not;

using CliInfoPolyhedra = CliTest;

/// The hexahedra of a shape over the vertices that they have.
Io::Mesh HexMesh(const TestShapes::PolyhedralShape& shape) {
    Io::Mesh mesh;
    std::map<Index, Index> place;
    for (Index v : shape.hexes) place.emplace(v, 0);
    for (auto& [vertex, number] : place) {
        number = mesh.topology.n_vertices++;
        const auto first = shape.positions.begin() + 3 * vertex;
        mesh.positions.insert(mesh.positions.end(), first, first + 3);
    }
    for (Index v : shape.hexes) mesh.topology.hexes.push_back(place.at(v));
    return mesh;
}

template <class Keep>
Io::Mesh Cubes(int nx, int ny, int nz, Keep&& keep) {
    return HexMesh(TestShapes::HexBlock(nx, ny, nz, keep));
}

/// The only piece of the boundary, which must be closed, manifold and of this genus.
void ExpectClosed(const nlohmann::json& json, int n_faces, int euler, int genus) {
    EXPECT_EQ(json["analysis"], "complete");
    ASSERT_EQ(json["boundary"]["count"], 1);
    const auto& piece = json["boundary"]["components"][0];
    EXPECT_EQ(piece["faces"], n_faces);
    EXPECT_EQ(piece["euler_characteristic"], euler);
    EXPECT_EQ(piece["genus"], genus);
    EXPECT_EQ(piece["manifold"], true);
    EXPECT_EQ(piece["closed"], true);
    EXPECT_EQ(json["defects"].size(), 0u);
    EXPECT_EQ(json["cells_meeting_only_in"]["edges"]["count"], 0);
    EXPECT_EQ(json["cells_meeting_only_in"]["vertices"]["count"], 0);
}

TEST_F(CliInfoPolyhedra, ABlockIsRegularInside) {
    WriteMesh("block.vtu", HexMesh(TestShapes::HexBlock(2)));
    const auto json = Json("info block.vtu");
    ExpectClosed(json, 24, 2, 0);
    EXPECT_EQ(json["valence"]["adjacent_inside_solids"], (nlohmann::json{{"6", 1}}));
    EXPECT_EQ(json["valence"]["edges_on_surfaces"], (nlohmann::json{{"3", 8}, {"4", 18}}));
    EXPECT_EQ(json["valence"]["edges_at_vertices"], (nlohmann::json{{"3", 8}, {"4", 12}, {"5", 6}, {"6", 1}}));
    EXPECT_EQ(json["links"], (nlohmann::json{{"4", 6}}));
    EXPECT_EQ(json["regular"]["links"], nlohmann::json::array({4}));
    EXPECT_FALSE(json.contains("matched_faces"));
    const std::string text = MustRun("info block.vtu").out;
    EXPECT_THAT(text, HasSubstr("24 faces, 26 vertices, Euler characteristic 2, closed, genus 0"));
    EXPECT_THAT(text, HasSubstr("4: 6  (cells around an inner edge; regular: 4)"));
    EXPECT_THAT(text, HasSubstr("6: 1  (adjacent vertices; regular: 6)"));
    EXPECT_THAT(text, Not(HasSubstr("note")));
}

TEST_F(CliInfoPolyhedra, AnLHasAnEdgeWithFiveEdgesOnItsSurface) {
    WriteMesh("l.vtu", Cubes(2, 2, 1, [](int x, int y, int) { return x == 0 || y == 0; }));
    const auto json = Json("info l.vtu");
    ExpectClosed(json, 14, 2, 0);
    // Of the outline's eight vertices five are corners, two lie flat, one is the bend; each stands twice.
    EXPECT_EQ(json["valence"]["edges_on_surfaces"], (nlohmann::json{{"3", 10}, {"4", 4}, {"5", 2}}));
    EXPECT_TRUE(json["links"].empty()) << "no edge lies inside";
}

TEST_F(CliInfoPolyhedra, ATorusOfHexahedraHasOneHandle) {
    WriteMesh("torus.vtu", Cubes(3, 3, 1, [](int x, int y, int) { return x != 1 || y != 1; }));
    ExpectClosed(Json("info torus.vtu"), 8 + 8 + 12 + 4, 0, 1);
    EXPECT_THAT(MustRun("info torus.vtu").out, HasSubstr("Euler characteristic 0, closed, genus 1"));
}

TEST_F(CliInfoPolyhedra, AHollowBlockHasTwoBoundaries) {
    WriteMesh("hollow.vtu", Cubes(3, 3, 3, [](int x, int y, int z) { return x != 1 || y != 1 || z != 1; }));
    const auto json = Json("info hollow.vtu");
    ASSERT_EQ(json["boundary"]["count"], 2);
    EXPECT_EQ(json["boundary"]["components"][0]["faces"], 54);
    EXPECT_EQ(json["boundary"]["components"][1]["faces"], 6);
    EXPECT_EQ(json["boundary"]["components"][1]["genus"], 0);
}

TEST_F(CliInfoPolyhedra, CubesThatMeetInAnEdgeOnlyAreReported) {
    WriteMesh("edge.vtu", Cubes(2, 2, 1, [](int x, int y, int) { return x == y; }));
    const auto json = Json("info edge.vtu");
    const Index low = 3, high = 10;  // (1, 1, 0) and (1, 1, 1) among the vertices in use
    EXPECT_EQ(json["cells_meeting_only_in"]["edges"]["count"], 1);
    EXPECT_EQ(json["cells_meeting_only_in"]["edges"]["first"], nlohmann::json::parse("[[3, 10]]"));
    EXPECT_EQ(json["cells_meeting_only_in"]["vertices"]["count"], 0) << "the edge joins them at its ends";
    EXPECT_EQ(json["boundary"]["components"][0]["manifold"], false);
    EXPECT_EQ(json["boundary"]["components"][0]["genus"], nullptr);
    EXPECT_EQ(json["defects"][0]["code"], "non-manifold edge");
    EXPECT_EQ(json["defects"][0]["count"], 1);
    EXPECT_THAT(MustRun("info edge.vtu").out, HasSubstr("cells meet only in: 1 edge: 3-10"));
    const Io::Mesh mesh = ReadMesh("edge.vtu");
    for (Index v : {low, high}) EXPECT_EQ(mesh.positions[3 * static_cast<std::size_t>(v)], 1);
}

TEST_F(CliInfoPolyhedra, CubesThatMeetInAVertexOnlyAreReported) {
    WriteMesh("vertex.vtu", Cubes(2, 2, 2, [](int x, int y, int z) { return x == y && y == z; }));
    const auto json = Json("info vertex.vtu");
    EXPECT_EQ(json["cells_meeting_only_in"]["edges"]["count"], 0);
    EXPECT_EQ(json["cells_meeting_only_in"]["vertices"]["first"], nlohmann::json::array({7}));
    EXPECT_EQ(json["defects"][0]["code"], "non-manifold vertex");
    EXPECT_THAT(MustRun("info vertex.vtu").out, HasSubstr("cells meet only in: 1 vertex: 7"));
}

TEST_F(CliInfoPolyhedra, MixedCellsAndPolygonsCountTogether) {
    // A cube with a pyramid on it, and a pentagon and a triangle that share an edge beside them.
    Io::Mesh mesh = HexMesh(TestShapes::HexBlock(1));
    mesh.positions.insert(mesh.positions.end(),
                          {.5, .5, 2, 4, 0, 0, 5, 0, 0, 5.5, 1, 0, 4.5, 2, 0, 3.5, 1, 0, 4, -1, 0});
    Io::Topology& t = mesh.topology;
    t.n_vertices = 15;
    t.pyramids = {4, 5, 7, 6, 8};  // the lattice's order of vertices, rows one after another
    t.polygon_offsets = {0, 5};
    t.polygon_vertices = {9, 10, 11, 12, 13};
    t.triangles = {10, 9, 14};
    WriteMesh("mixed.vtu", mesh);
    const auto json = Json("info mixed.vtu");
    ASSERT_EQ(json["boundary"]["count"], 1);
    EXPECT_EQ(json["boundary"]["components"][0]["faces"], 5 + 4);
    EXPECT_EQ(json["boundary"]["components"][0]["euler_characteristic"], 2);
    ASSERT_EQ(json["surface"]["count"], 1);
    EXPECT_EQ(json["surface"]["components"][0]["faces"], 2);
    EXPECT_EQ(json["surface"]["components"][0]["border_loops"], 1);
    EXPECT_EQ(json["surface"]["components"][0]["euler_characteristic"], 1);
}

}  // namespace
}  // namespace SolidSubdiv::CliTesting

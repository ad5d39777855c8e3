// SPDX-License-Identifier: Apache-2.0
// What info says of meshes whose answers are known.
#include "apps/cli_testing.h"

namespace SolidSubdiv::CliTesting {
namespace {

using testing::HasSubstr;

using CliInfo = CliTest;

TEST_F(CliInfo, CountsBoxVolumeAndBoundaryOfASolid) {
    WriteMesh("lattice.vtu", TwentyEightTets());
    const auto json = Json("info lattice.vtu");
    EXPECT_EQ(json["counts"]["vertices"], 16);
    EXPECT_EQ(json["counts"]["tetrahedra"], 28);
    EXPECT_EQ(json["bounding_box"]["low"], nlohmann::json::array({-1.0, -1.0, -1.0}));
    EXPECT_EQ(json["bounding_box"]["high"], nlohmann::json::array({4.0, 4.0, 4.0}));
    // 64/6 of the large tet; three tets of height 1 on faces of area 8; a third of the large face times its cap:
    // det of two sides and the shift (1,1,1) from the mean is 48, a third of it, over six.
    EXPECT_NEAR(json["volume"]["sum"].get<double>(), 64.0 / 6 + 3 * 8.0 / 3 + 48.0 / 3 / 6, 1e-12);
    EXPECT_EQ(json["volume"]["negative_cells"], 0);
    ASSERT_EQ(json["boundary"]["count"], 1);
    const auto& piece = json["boundary"]["components"][0];
    EXPECT_EQ(piece["faces"], 3 * 3 + 2 + 3);
    EXPECT_EQ(piece["euler_characteristic"], 2);
    EXPECT_EQ(piece["genus"], 0);
    EXPECT_EQ(json["defects"].size(), 0u);
    EXPECT_EQ(json["matched_faces"]["inner_faces"], (4 * 28 - 14) / 2);
    EXPECT_GE(json["matched_faces"]["matched"].get<double>(), json["matched_faces"]["as_ordered"].get<double>());
    EXPECT_FALSE(json["matched_faces"].contains("given"));
    Offset n_vertices = 0;
    for (const auto& [valence, count] : json["valence"]["edges_at_vertices"].items()) n_vertices += count.get<int>();
    EXPECT_EQ(n_vertices, 16);
    EXPECT_THAT(MustRun("info lattice.vtu").out, HasSubstr("Euler characteristic 2, closed, genus 0"));
}

TEST_F(CliInfo, ListsWhatIsWrongWithoutFailing) {
    Io::Mesh mesh = TetMesh({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0, 9, 9, 9, 1, 0, 0}, {0, 1, 3, 2, 0, 1, 2, 4});
    mesh.topology.tets.insert(mesh.topology.tets.end(), {0, 1, 2, 3});
    WriteMesh("bad.vtu", mesh);
    const auto json = Json("info bad.vtu");
    EXPECT_EQ(json["inverted"]["tetrahedra"]["first"], nlohmann::json::array({0}));
    EXPECT_EQ(json["zero_volume"]["tetrahedra"]["first"], nlohmann::json::array({1}));
    EXPECT_EQ(json["coincident_vertices"]["first"], nlohmann::json::array({6}));
    ASSERT_GE(json["defects"].size(), 1u);
    EXPECT_EQ(json["defects"][0]["code"], "duplicate element");
    EXPECT_EQ(json["defects"][0]["fatal"], true);
    EXPECT_EQ(json["defects"][0]["first"][0]["element"], 2);
    EXPECT_THAT(json["analysis"].get<std::string>(), HasSubstr("fatal"));
    const std::string text = MustRun("info bad.vtu").out;
    EXPECT_THAT(text, HasSubstr("duplicate element (fatal): 1"));
    EXPECT_THAT(text, HasSubstr("tet 2 has the same vertices as tet 0"));
    EXPECT_THAT(text, HasSubstr("inverted: 1 tetrahedron: 0"));
}

TEST_F(CliInfo, NonManifoldIsolatedAndCoincidentAreCounted) {
    // Two tets that meet in vertex 0; vertex 7 is in no element; a triangle on a face; an edge on an edge.
    Io::Mesh mesh =
        TetMesh({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, -1, 0, 0, 0, -1, 0, 0, 0, -1, 5, 5, 5}, {0, 1, 2, 3, 0, 4, 5, 6});
    mesh.topology.triangles = {1, 2, 3};
    mesh.topology.edges = {0, 4};
    WriteMesh("odd.vtu", mesh);
    const auto json = Json("info odd.vtu");
    std::map<std::string, int> codes;
    for (const auto& defect : json["defects"]) codes[defect["code"]] = defect["count"];
    EXPECT_EQ(codes["non-manifold vertex"], 1);
    EXPECT_EQ(codes["isolated vertex"], 1);
    EXPECT_EQ(codes["coincident element"], 2);
    EXPECT_EQ(json["inverted"]["tetrahedra"]["count"], 1);
    EXPECT_EQ(json["boundary"]["components"][0]["manifold"], false);
    EXPECT_EQ(json["cells_meeting_only_in"]["vertices"]["first"], nlohmann::json::array({0}));
}

TEST_F(CliInfo, SurfacesAreDescribedByTheirPieces) {
    WriteText("two.obj",
              "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"
              "v 5 0 0\nv 6 0 0\nv 5 1 0\nf 5 6 7\n");
    const auto json = Json("info two.obj");
    EXPECT_FALSE(json.contains("boundary"));
    EXPECT_FALSE(json.contains("volume"));
    ASSERT_EQ(json["surface"]["count"], 2);
    EXPECT_EQ(json["surface"]["components"][0]["genus"], 0);
    EXPECT_EQ(json["surface"]["components"][0]["closed"], true);
    EXPECT_EQ(json["surface"]["components"][1]["border_loops"], 1);
}

TEST_F(CliInfo, AHexahedronIsMeasured) {
    Io::Mesh mesh;
    mesh.topology.n_vertices = 8;
    mesh.positions = {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 0, 0, 2, 2, 0, 2, 2, 2, 2, 0, 2, 2};
    mesh.topology.hexes = {0, 1, 2, 3, 4, 5, 6, 7};
    mesh.point_data.push_back({"flow", 2, {1, -1, 2, -2, 3, -3, 4, -4, 5, -5, 6, -6, 7, -7, 8, -8}});
    WriteMesh("hex.vtu", mesh);
    const auto json = Json("info hex.vtu");
    EXPECT_EQ(json["counts"]["hexahedra"], 1);
    EXPECT_NEAR(json["volume"]["sum"].get<double>(), 8, 1e-14);
    EXPECT_EQ(json["point_data"][0]["low"], nlohmann::json::array({1.0, -8.0}));
    EXPECT_EQ(json["point_data"][0]["high"], nlohmann::json::array({8.0, -1.0}));
    EXPECT_EQ(json["analysis"], "complete");
}

TEST_F(CliInfo, GivenDiagonalsAreCompared) {
    WriteMesh("lattice.vtu", TwentyEightTets());
    MustRun("refine lattice.vtu -o matched.vtu --levels 0");
    const auto json = Json("info matched.vtu");
    EXPECT_EQ(json["matched_faces"]["given"], json["matched_faces"]["matched"]);
}

}  // namespace
}  // namespace SolidSubdiv::CliTesting

// SPDX-License-Identifier: Apache-2.0
// What info says of volumes and points.
#include "apps/cli_testing.h"

namespace SolidSubdiv::CliTesting {
namespace {

using testing::HasSubstr;

using CliInfoVolumes = CliTest;

TEST_F(CliInfoVolumes, SizePlaceValuesAndLabels) {
    WriteText("labels.nrrd",
              "NRRD0004\ntype: short\ndimension: 3\nsizes: 3 2 2\nencoding: text\nspace: right-anterior-superior\n"
              "space directions: (2,0,0) (0,3,0) (0,0,0.5)\nspace origin: (10,20,30)\n\n"
              "0 0 5\n0 5 5\n-1 0 0\n0 0 0\n");
    const auto json = Json("info labels.nrrd");
    EXPECT_EQ(json["format"], "NRRD");
    EXPECT_EQ(json["dims"], nlohmann::json::array({3, 2, 2}));
    EXPECT_EQ(json["voxels"], 12);
    EXPECT_EQ(json["spacing"], nlohmann::json::array({2.0, 3.0, 0.5}));
    EXPECT_EQ(json["bounding_box"]["low"], nlohmann::json::array({10.0, 20.0, 30.0}));
    EXPECT_EQ(json["bounding_box"]["high"], nlohmann::json::array({14.0, 23.0, 30.5}));
    EXPECT_EQ(json["least"], -1);
    EXPECT_EQ(json["greatest"], 5);
    EXPECT_EQ(json["labels"]["count"], 3);
    EXPECT_EQ(json["labels"]["first"], nlohmann::json::array({-1.0, 0.0, 5.0}));
    EXPECT_THAT(MustRun("info labels.nrrd").out, HasSubstr("3 whole numbers: -1, 0, 5"));
}

TEST_F(CliInfoVolumes, GreyValuesHaveNoLabels) {
    WriteText("grey.nrrd",
              "NRRD0004\ntype: float\ndimension: 3\nsizes: 2 2 2\nencoding: text\nspacings: 1 1 1\n\n"
              "0 0.5 1 1 1 1 1 1\n");
    EXPECT_FALSE(Json("info grey.nrrd").contains("labels"));
}

TEST_F(CliInfoVolumes, PointsAndTheirNormals) {
    WriteText("points.xyz", "0 0 0 0 0 1\n1 2 3 0 0 1\n");
    const auto json = Json("info points.xyz");
    EXPECT_EQ(json["points"], 2);
    EXPECT_EQ(json["normals"], true);
    EXPECT_EQ(json["bounding_box"]["high"], nlohmann::json::array({1.0, 2.0, 3.0}));
    EXPECT_THAT(MustRun("info points.xyz").out, HasSubstr("normals           yes"));
}

TEST_F(CliInfoVolumes, APlyFileIsAMeshWhereItHasFacesElsePoints) {
    const std::string vertices =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n";
    const std::string rows = "0 0 0\n1 0 0\n0 1 0\n";
    WriteText("points.ply", vertices + "end_header\n" + rows);
    WriteText("mesh.ply",
              vertices + "element face 1\nproperty list uchar int vertex_indices\nend_header\n" + rows + "3 0 1 2\n");
    const auto points = Json("info points.ply");
    EXPECT_EQ(points["points"], 3);
    EXPECT_EQ(points["normals"], false);
    EXPECT_FALSE(points.contains("counts"));
    EXPECT_EQ(Json("info mesh.ply")["counts"]["vertices"], 3);
}

TEST_F(CliInfoVolumes, QualityIsOfCells) {
    WriteText("points.xyz", "0 0 0\n1 2 3\n");
    EXPECT_THAT(ErrorOf("info points.xyz --quality", 2), HasSubstr("--quality"));
}

}  // namespace
}  // namespace SolidSubdiv::CliTesting

// SPDX-License-Identifier: Apache-2.0
// solidsubdiv fit on volumes and points: what is read, what comes out, and what is refused.
#include <cmath>
#include <cstdio>
#include <functional>

#include "apps/cli_testing.h"
#include "sanitized.h"

namespace SolidSubdiv::CliTesting {
namespace {

using testing::HasSubstr;

constexpr int kSize = 20;
constexpr const char* kQuick = " --control 60 --levels 1 --iterations 12 --no-pictures";

class CliFitTargets : public CliTest {
  protected:
    /// kSize^3 numbers in a file whose voxels are 2 x 1 x 0.5 and turned about z, voxel (0, 0, 0) at (100, -50, 7).
    void WriteVolume(const std::string& name, const std::function<double(double, double, double)>& value) const {
        std::ostringstream text;
        text << "NRRD0004\ntype: double\ndimension: 3\nsizes: 20 20 20\nencoding: text\n"
             << "space: right-anterior-superior\nspace directions: (1.2,1.6,0) (-0.8,0.6,0) (0,0,0.5)\n"
             << "space origin: (100,-50,7)\n\n";
        for (int k = 0; k < kSize; ++k) {
            for (int j = 0; j < kSize; ++j) {
                for (int i = 0; i < kSize; ++i) text << value(i - 9.5, j - 9.5, k - 9.5) << "\n";
            }
        }
        WriteText(name, text.str());
    }

    /// n points of a ball of radius 10 times the unit.
    void WriteSphere(const std::string& name, int n, double unit) const {
        std::ostringstream text;
        text.precision(17);
        for (int i = 0; i < n; ++i) {
            const double z = 1 - (2 * i + 1.0) / n, r = std::sqrt(1 - z * z), a = 2.399963229728653 * i;
            text << 10 * unit * r * std::cos(a) << " " << 10 * unit * r * std::sin(a) << " " << 10 * unit * z << "\n";
        }
        WriteText(name, text.str());
    }
};

double BallMask(double x, double y, double z) { return std::hypot(x, y, z) <= 7 ? 1 : 0; }

TEST_F(CliFitTargets, AMaskIsFittedWhereItsVoxelsAre) {
    WriteVolume("ball.nrrd", BallMask);
    const auto json = Json("fit ball.nrrd -o out" + std::string(kQuick));
    EXPECT_EQ(json["target"]["kind"], "volume");
    EXPECT_EQ(json["target"]["label"], 1);
    EXPECT_EQ(json["target"]["smooth"], 1);
    EXPECT_EQ(json["target"]["pieces"], 1);
    EXPECT_EQ(json["target"]["border_edges"], 0);
    EXPECT_EQ(json["target"]["euler_characteristic"], 2);
    EXPECT_EQ(json["settings"]["model"], "solid");
    // What is left of the stairs, with 60 control points: a third of a voxel's 2 units in 34.
    EXPECT_LT(json["fit"]["target_to_surface"]["rms_percent"], 1);
    EXPECT_EQ(json["solid"]["folded"], 0);
    // In voxels about the middle, each vertex of the fit is 7 away.
    const Io::Mesh fitted = ReadMesh("out/fitted.vtu");
    for (std::size_t i = 0; i < fitted.positions.size(); i += 3) {
        const double x = fitted.positions[i] - 100, y = fitted.positions[i + 1] + 50, z = fitted.positions[i + 2] - 7;
        const double u = (0.6 * x + 0.8 * y) / 2 - 9.5, v = -0.8 * x + 0.6 * y - 9.5, w = z / 0.5 - 9.5;
        EXPECT_NEAR(std::hypot(u, v, w), 7, 0.7);
    }
}

TEST_F(CliFitTargets, GreyValuesAreCutAtOtsusThresholdOrWhereAsked) {
    SOLIDSUBDIV_LONG_TEST();
    // 100 inside falling to 0 over four voxels, at 50 on the ball of radius 6.
    WriteVolume("grey.nrrd",
                [](double x, double y, double z) { return 100.5 / (1 + std::exp(2 * (std::hypot(x, y, z) - 6))); });
    const auto otsu = Json("fit grey.nrrd -o out --model surface" + std::string(kQuick));
    EXPECT_NEAR(otsu["target"]["iso"].get<double>(), 50, 15);
    EXPECT_EQ(otsu["target"]["smooth"], 0);
    EXPECT_THAT(MustRun("fit grey.nrrd -o out --model surface" + std::string(kQuick)).err, HasSubstr("Otsu"));
    const auto low = Json("fit grey.nrrd -o out --model surface --iso 2" + std::string(kQuick));
    EXPECT_EQ(low["target"]["iso"], 2);
    EXPECT_GT(low["target"]["diagonal"].get<double>(), 1.1 * otsu["target"]["diagonal"].get<double>());
}

TEST_F(CliFitTargets, EachSideOfTheCaudateNucleusIsFoundByItsLabel) {
    SOLIDSUBDIV_LONG_TEST();
    const std::string file = std::string(SOLIDSUBDIV_SHAPES) + "/volumes/caudate_labels.nii.gz";
    for (const char* label : {"1", "2"}) {
        const auto json =
            Json("fit '" + file + "' -o out --control 80 --levels 1 --iterations 8 --no-pictures --label " +
                 std::string(label));
        EXPECT_EQ(json["target"]["pieces"], 1);
        EXPECT_EQ(json["target"]["euler_characteristic"], 2);
        // Of a diagonal of 68 voxels: half a voxel.
        EXPECT_LT(json["fit"]["surface_to_target"]["rms_percent"], 0.75);
        EXPECT_LT(json["fit"]["target_to_surface"]["rms_percent"], 0.75);
        std::printf("caudate, label %s: RMS %.2f %% and %.2f %%, largest %.2f %% and %.2f %%\n", label,
                    json["fit"]["surface_to_target"]["rms_percent"].get<double>(),
                    json["fit"]["target_to_surface"]["rms_percent"].get<double>(),
                    json["fit"]["surface_to_target"]["max_percent"].get<double>(),
                    json["fit"]["target_to_surface"]["max_percent"].get<double>());
    }
}

TEST_F(CliFitTargets, PointsAreFittedWhateverTheirUnit) {
    SOLIDSUBDIV_LONG_TEST();
    for (const double unit : {1.0, 1e-9, 1e9}) {
        SCOPED_TRACE(unit);
        WriteSphere("points.xyz", 800, unit);
        const auto json = Json("fit points.xyz -o out" + std::string(kQuick));
        EXPECT_EQ(json["target"]["kind"], "points");
        EXPECT_EQ(json["target"]["normals"], "estimated");
        EXPECT_EQ(json["target"]["triangles"], 0);
        EXPECT_NEAR(json["target"]["spacing"].get<double>() / unit, std::sqrt(4 * 3.14159 / 800) * 10, 0.1);
        EXPECT_EQ(json["settings"]["model"], "solid");
        EXPECT_LT(json["fit"]["target_to_surface"]["rms_percent"], 0.5);
        // Between points the nearest one is up to two thirds of a spacing away, 2.5 % of the diagonal.
        EXPECT_LT(json["fit"]["surface_to_target"]["max_percent"], 3);
    }
}

TEST_F(CliFitTargets, PlyFilesOfVerticesAreClouds) {
    SOLIDSUBDIV_LONG_TEST();
    std::ostringstream text;
    text << "ply\nformat ascii 1.0\nelement vertex 400\nproperty double x\nproperty double y\nproperty double z\n"
         << "end_header\n";
    WriteSphere("points.xyz", 400, 1);
    WriteText("points.ply", text.str() + ReadText(folder / "points.xyz"));
    EXPECT_EQ(Json("fit points.ply -o out --model surface --control 60")["target"]["kind"], "points");
    EXPECT_THAT(ReadText(folder / "out/report.html"), HasSubstr("{\"name\":\"target\""));
}

TEST_F(CliFitTargets, WhatCantBeFittedIsSaidAndLeavesNothing) {
    WriteVolume("labels.nrrd", [](double x, double, double) { return x < -4 ? 0 : x < 4 ? 1 : 7; });
    WriteVolume("empty.nrrd", [](double, double, double) { return 0; });
    WriteVolume("mask.nrrd", BallMask);
    WriteText("one.xyz", "1 2 3\n");
    WriteText("same.xyz", "1 2 3\n1 2 3\n1 2 3\n1 2 3\n1 2 3\n");
    WriteText("nan.xyz", "1 2 3\n4 5 nan\n7 8 9\n1 1 1\n");
    EXPECT_THAT(ErrorOf("fit labels.nrrd -o out"),
                HasSubstr("labels.nrrd: has 3 labels (0, 1, 7): name one with --label"));
    EXPECT_THAT(ErrorOf("fit labels.nrrd -o out --label 3"), HasSubstr("no voxel of label 3; its labels are 0, 1, 7"));
    EXPECT_THAT(ErrorOf("fit empty.nrrd -o out"), HasSubstr("each voxel is 0"));
    EXPECT_THAT(ErrorOf("fit mask.nrrd -o out --iso 2"), HasSubstr("level 2 bounds nothing: values are from 0 to 1"));
    EXPECT_THAT(ErrorOf("fit mask.nrrd -o out --iso 0.5 --label 1", 2), HasSubstr("name one of them"));
    EXPECT_THAT(ErrorOf("fit one.xyz -o out"), HasSubstr("has 1 point; a shape needs four at least"));
    EXPECT_THAT(ErrorOf("fit same.xyz -o out"), HasSubstr("all points are one"));
    EXPECT_THAT(ErrorOf("fit nan.xyz -o out"), HasSubstr("nan.xyz"));
    EXPECT_THAT(ErrorOf("fit same.xyz -o out --label 1", 2), HasSubstr("are of volumes"));
}

}  // namespace
}  // namespace SolidSubdiv::CliTesting

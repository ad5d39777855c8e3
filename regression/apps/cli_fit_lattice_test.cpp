// SPDX-License-Identifier: Apache-2.0
// solidsubdiv fit --template: a lattice carries one model to another one.
#include <cmath>

#include "apps/cli_testing.h"

namespace SolidSubdiv::CliTesting {
namespace {

using testing::HasSubstr;

/// A box of n x n quads a side on [0, 1] x [0, 2] x [0, 1], each vertex of it taken to `at`.
template <class Map>
std::string Box(int n, Map&& at) {
    std::ostringstream text;
    text.precision(17);
    int count = 0;
    std::ostringstream faces;
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
            for (int i = 0; i <= n; ++i) {
                for (int j = 0; j <= n; ++j) {
                    std::array<double, 3> p{};
                    p[static_cast<std::size_t>(axis)] = side;
                    p[static_cast<std::size_t>((axis + 1) % 3)] = 1. * i / n;
                    p[static_cast<std::size_t>((axis + 2) % 3)] = 1. * j / n;
                    p = at(std::array<double, 3>{p[0], 2 * p[1], p[2]});
                    text << "v " << p[0] << " " << p[1] << " " << p[2] << "\n";
                }
            }
            for (int i = 0; i < n; ++i) {
                for (int j = 0; j < n; ++j) {
                    const int a = count + i * (n + 1) + j + 1, b = a + n + 1;
                    const std::array<int, 4> f = side ? std::array{a, b, b + 1, a + 1} : std::array{a, a + 1, b + 1, b};
                    faces << "f " << f[0] << " " << f[1] << " " << f[2] << " " << f[3] << "\n";
                }
            }
            count += (n + 1) * (n + 1);
        }
    }
    return text.str() + faces.str();
}

std::array<double, 3> Same(const std::array<double, 3>& p) { return p; }
std::array<double, 3> Sheared(const std::array<double, 3>& p) {
    return {1.1 * p[0] + 0.2 * p[1] + 3, 0.9 * p[1] - 1, p[2] + 0.1 * p[0]};
}
std::array<double, 3> Bent(const std::array<double, 3>& p) { return {p[0] + 0.2 * p[1] * p[1], p[1], p[2]}; }

class CliFitLattice : public CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        WriteText("box.obj", Box(4, Same));
        WriteText("sheared.obj", Box(4, Sheared));
        WriteText("bent.obj", Box(4, Bent));
    }
};

TEST_F(CliFitLattice, AffineImagesAreMetVertexByVertex) {
    const auto json = Json("fit sheared.obj -o out --template box.obj --matched --control 125 --no-pictures");
    EXPECT_EQ(json["settings"]["model"], "lattice");
    EXPECT_EQ(json["fit"]["folded_corners"], 0);
    EXPECT_LT(json["fit"]["surface_to_target"]["max_percent"], 1e-6);
    const Io::Mesh wanted = Io::ReadMesh(folder / "sheared.obj"), got = Io::ReadMesh(folder / "out/fitted.obj");
    ASSERT_EQ(got.positions.size(), wanted.positions.size());
    EXPECT_EQ(got.topology.quads, wanted.topology.quads);
    for (std::size_t i = 0; i < got.positions.size(); ++i) EXPECT_NEAR(got.positions[i], wanted.positions[i], 1e-7);
}

TEST_F(CliFitLattice, OtherModelsAreCarriedAlongByDeform) {
    MustRun("fit bent.obj -o out --template box.obj --matched --control 125 --no-pictures");
    MustRun("deform box.obj --lattice out/start.vtu --to out/lattice.vtu -o carried.obj");
    const Io::Mesh fitted = Io::ReadMesh(folder / "out/fitted.obj"), carried = Io::ReadMesh(folder / "carried.obj");
    ASSERT_EQ(carried.positions.size(), fitted.positions.size());
    for (std::size_t i = 0; i < carried.positions.size(); ++i)
        EXPECT_NEAR(carried.positions[i], fitted.positions[i], 1e-12);
}

TEST_F(CliFitLattice, WithoutMatchesTheNearestPointsAreMet) {
    const auto json = Json("fit bent.obj -o out --template box.obj --control 125 --no-pictures");
    EXPECT_LT(json["fit"]["surface_to_target"]["rms_percent"], 0.5);
    EXPECT_LT(json["fit"]["target_to_surface"]["rms_percent"], 0.5);
    EXPECT_EQ(json["fit"]["folded_corners"], 0);
    EXPECT_FALSE(json["settings"]["matched"]);
}

TEST_F(CliFitLattice, WhatDoesNotGoTogetherIsSaid) {
    WriteText("points.obj", "v 0 0 0\nv 1 0 0\n");
    WriteText("small.obj", Box(2, Same));
    EXPECT_THAT(ErrorOf("fit bent.obj -o out --template small.obj --matched"), HasSubstr("they must be as many"));
    EXPECT_THAT(ErrorOf("fit bent.obj -o out --template points.obj"), HasSubstr("points.obj: has no faces"));
    EXPECT_THAT(ErrorOf("fit bent.obj -o out --template missing.obj"), HasSubstr("missing.obj"));
    for (const char* wrong : {"--model lattice", "--matched", "--template box.obj --model solid",
                              "--template box.obj --scheme box-spline"}) {
        EXPECT_EQ(Run("fit bent.obj -o out " + std::string(wrong)).status, 2) << wrong;
    }
    EXPECT_FALSE(fs::exists(folder / "out"));
}

}  // namespace
}  // namespace SolidSubdiv::CliTesting

// SPDX-License-Identifier: Apache-2.0
// Sliced solids: closed, of the right volume, with linear values kept exactly.
#include "kit/picture/solid_testing.h"

#include <gtest/gtest.h>
#include <solidsubdiv/kit/picture/slice.h>
#include <solidsubdiv/sdc/errors.h>

#include <random>

namespace SolidSubdiv::Picture {
namespace {

std::vector<Index> SkinAndCap(const SolidSlice& slice) {
    std::vector<Index> all = slice.skin;
    all.insert(all.end(), slice.cap.begin(), slice.cap.end());
    return all;
}

double CapArea(const SolidSlice& slice) {
    double area = 0;
    for (std::size_t t = 0; t < slice.cap.size(); t += 3) {
        double p[3][3];
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k)
                p[i][k] = slice.positions[3 * static_cast<std::size_t>(slice.cap[t + i]) + k];
        }
        double n2 = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
            const double n = (p[1][a] - p[0][a]) * (p[2][b] - p[0][b]) - (p[1][b] - p[0][b]) * (p[2][a] - p[0][a]);
            n2 += n * n;
        }
        area += 0.5 * std::sqrt(n2);
    }
    return area;
}

TEST(SliceSolidTest, ABlockIsCutToItsExactVolumeAndArea) {
    const Io::Mesh mesh = TetBlock(4);
    for (double x : {0.3, 1.7, 2.0, 3.999}) {  // 2: vertices on the plane
        const SolidSlice slice = SliceSolid(mesh, {{x, 0, 0}, {5, 0, 0}});
        EXPECT_NEAR(SixVolumes(slice.positions, SkinAndCap(slice)) / 6, 16 * x, 1e-10) << x;
        EXPECT_NEAR(CapArea(slice), 16, 1e-12) << x;
        EXPECT_TRUE(slice.values.empty());
    }
}

TEST(SliceSolidTest, BothSidesTogetherAreTheWholeForEveryKindOfCell) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> x(-1, 1);
    for (const Io::Mesh& mesh : {TetBlock(3), OneOfEach(), AsPolyhedra(OneOfEach())}) {
        const double whole = SixVolumes(mesh.positions, SolidBoundary(mesh).triangles);
        int cut = 0;
        for (int trial = 0; trial < 20; ++trial) {
            const std::size_t v = 3 * (random() % static_cast<std::size_t>(mesh.topology.n_vertices));
            const Plane one{{mesh.positions[v] + 0.4, mesh.positions[v + 1] + 0.3, mesh.positions[v + 2] + 0.2},
                            {x(random), x(random), x(random)}};
            const Plane other{one.point, {-one.normal[0], -one.normal[1], -one.normal[2]}};
            const SolidSlice a = SliceSolid(mesh, one), b = SliceSolid(mesh, other);
            const double volume_a = SixVolumes(a.positions, SkinAndCap(a)),
                         volume_b = SixVolumes(b.positions, SkinAndCap(b));
            EXPECT_NEAR(volume_a + volume_b, whole, 1e-9);
            EXPECT_NEAR(CapArea(a), CapArea(b), 1e-9);
            EXPECT_EQ(a.cap_kinds.size() * 3, a.cap.size());
            cut += volume_a > 0.01 && volume_b > 0.01 ? 1 : 0;
        }
        EXPECT_GT(cut, 10);
    }
}

TEST(SliceSolidTest, LinearValuesStayLinear) {
    const auto linear = [](const double* p) { return 2 * p[0] - 3 * p[1] + 0.5 * p[2] + 7; };
    const Io::Mesh mesh = OneOfEach();
    std::vector<double> values;
    for (std::size_t v = 0; v < mesh.positions.size(); v += 3) values.push_back(linear(&mesh.positions[v]));
    const SolidSlice slice = SliceSolid(mesh, {{0.5, 0.4, 0.3}, {0.2, 0.9, 0.3}}, values);
    ASSERT_EQ(slice.values.size() * 3, slice.positions.size());
    ASSERT_GT(slice.cap.size(), 20u);
    for (std::size_t v = 0; v < slice.values.size(); ++v)
        EXPECT_NEAR(slice.values[v], linear(&slice.positions[3 * v]), 1e-13);
}

TEST(SliceSolidTest, OutlinesAreThoseOfTheCells) {
    Io::Mesh mesh = OneOfEach();
    mesh.topology = {};
    mesh.topology.n_vertices = 18;
    mesh.topology.octs = OneOfEach().topology.octs;
    // Through the octahedron, a little beside its centre and parallel to its equator: one square, no inner lines.
    const SolidSlice slice = SliceSolid(mesh, {{6, 0, 0.25}, {0, 0, 1}});
    ASSERT_EQ(slice.cap_edges.size(), 8u);
    for (Index v : slice.cap_edges) {
        const double* p = &slice.positions[3 * static_cast<std::size_t>(v)];
        EXPECT_NEAR(std::abs(p[0] - 6) + std::abs(p[1]), 0.75, 1e-14);
        EXPECT_EQ(p[2], 0.25);
    }
    EXPECT_NEAR(CapArea(slice), 2 * 0.75 * 0.75, 1e-14);
    for (CellKind kind : slice.cap_kinds) EXPECT_EQ(kind, CellKind::Oct);
}

TEST(SliceSolidTest, BadInputIsRefused) {
    const Io::Mesh mesh = TetBlock(1);
    EXPECT_THROW(SliceSolid(mesh, {{0, 0, 0}, {0, 0, 0}}), InvalidInput);
    EXPECT_THROW(SliceSolid(mesh, {}, std::vector<double>(3)), InvalidInput);
}

}  // namespace
}  // namespace SolidSubdiv::Picture

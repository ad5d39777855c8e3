// SPDX-License-Identifier: Apache-2.0
// The code of docs/voxels.md, compiled and run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include <solidsubdiv/apps/voxel/voxelize.h>
#include <solidsubdiv/far/primvar_refiner.h>

#include "page_code.h"

namespace SolidSubdiv {
namespace {

TEST(VoxelsPage, HasTheCodeOfThisTest) {
    const std::string page = CodeWithoutBlanks("/docs/voxels.md");
    ASSERT_GT(page.size(), 400u);
    EXPECT_THAT(CodeWithoutBlanks("/regression/apps/voxel/voxels_page_test.cpp"), testing::HasSubstr(page));
}

TEST(VoxelsPage, CodeRuns) {
    const std::vector<Index> hex{0, 1, 2, 3, 4, 5, 6, 7};
    auto refiner = Far::TopologyRefiner::Create({.n_vertices = 8, .hexes = hex}, Sdc::Split::Polyhedral);
    refiner.RefineUniform({.max_level = 3});
    std::vector<double> positions{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
    for (int level = 1; level <= 3; ++level) {
        std::vector<double> finer(3 * static_cast<std::size_t>(refiner.n_vertices(level)));
        Far::PrimvarRefiner(refiner, Sdc::LinearSolid{}).Interpolate<double>(level, positions, finer, 3);
        positions = std::move(finer);
    }
    std::vector<double> heat;
    for (std::size_t v = 0; v < positions.size(); v += 3) heat.push_back(1 + positions[v]);
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(testing::TempDir());
    int n_told = 0;
    const auto Tell = [&](const std::string&, Offset, double, double) { ++n_told; };

    Voxel::Grids grids = Voxel::Voxelize(
        refiner, 3, positions,
        {.voxel_size = .05, .kind = Voxel::Kind::Both, .attributes = {{"heat", 1, heat}}, .cell_id = true});
    grids.SetMetadata("source", "part.vtu");
    grids.Write("part.vdb");

    const Voxel::Grids again = Voxel::Grids::Read("part.vdb");
    for (const Voxel::GridInfo& info : again.Describe()) Tell(info.name, info.active_voxels, info.least, info.greatest);
    const std::vector<double> heat_at = again.Values("heat", {0, 0, 0}, {7, 7, 7});
    const Voxel::GridSurface skin = again.Surface("surface", 0);

    std::filesystem::remove("part.vdb");
    std::filesystem::current_path(before);
    EXPECT_EQ(n_told, 4);
    ASSERT_EQ(heat_at.size(), 512u);
    EXPECT_NEAR(heat_at[64 * 4 + 8 * 2 + 1], 1 + .05 * 4, 1e-6);             // a float, at voxel (4, 2, 1)
    ASSERT_GT(skin.quads.size(), 4u * 6 * 18 * 18);                          // a quad for each voxel of six faces
    for (double x : skin.positions) EXPECT_TRUE(x > -.01 && x < 1.01) << x;  // within rounded edges
}

}  // namespace
}  // namespace SolidSubdiv

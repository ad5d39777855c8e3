// SPDX-License-Identifier: Apache-2.0
// What a tile's cells hold, where faces are upright but for rounding.
#include <gtest/gtest.h>

#include <solidsubdiv/apps/voxel/internal/tiles.h>

namespace SolidSubdiv::Voxel::Internal {
namespace {

TEST(Tiles, UprightFacesOfTetsLetNothingThrough_WhateverRoundingDoesToThem) {
    for (const double lean : {0.0, -8.9e-16, 8.9e-16}) {  // a unit in the last place of 6
        // Below (2, 2), (6, 2), (6, 6) and along the edge up to (6, 6, 7): x >= y for all in it.
        VoxelSolid solid;
        solid.points = {2, 2, 1, 6, 2, 1, 6, 6, 1, 6 + lean, 6, 7};
        solid.tets = {0, 1, 2, 3};
        const Tiles tiles(solid, 1, true);
        ASSERT_EQ(tiles.Origin(0), (Place{0, 0, 0}));
        const VoxelSet inside = tiles.Inside(0);
        const auto owners = tiles.FindOwners(0);
        ASSERT_EQ(owners.size(), 1u);
        std::array<std::uint16_t, kTileVoxels> counts;
        tiles.CountInside(0, 4, counts);
        for (int v = 0; v < kTileVoxels; ++v) {
            const int x = v / 64, y = v / 8 % 8, z = v % 8;
            // Over (x, y) the tet ends at the plane through (2, 2, 1), (6, 2, 1) and (6, 6, 7).
            const bool is_in = x >= y && x <= 6 && y >= 2 && z >= 1 && z <= 1 + 1.5 * (y - 2);
            EXPECT_EQ(Holds(inside, v), is_in) << lean << ": " << x << " " << y << " " << z;
            EXPECT_EQ(Holds(owners[0].voxels, v), is_in) << lean << ": " << x << " " << y << " " << z;
            if (y > x + 1 || y < 1 || x > 7 || z < 1) {
                EXPECT_EQ(counts[static_cast<std::size_t>(v)], 0) << lean << ": " << x << " " << y << " " << z;
            }
        }
    }
}

}  // namespace
}  // namespace SolidSubdiv::Voxel::Internal

// SPDX-License-Identifier: Apache-2.0
// Laws of attributes: what cells give to the voxels they hold, and nothing elsewhere.
#include <gtest/gtest.h>

#include <set>

#include "apps/voxel/voxel_testing.h"

namespace SolidSubdiv::Voxel {
namespace {

using namespace TestShapes;

constexpr double kVoxel = 0.23;

/// Corners of a cell, however it is kept.
std::set<Index> CornersOf(const Solid& solid, Index cell) {
    if (!solid.refiner.is_polyhedral()) {
        const auto& l = solid.refiner.level(solid.level);
        if (cell < l.n_tets) {
            const auto v = l.TetVertices(cell);
            return {v.begin(), v.end()};
        }
        const auto v = l.OctVertices(cell - l.n_tets);
        return {v.begin(), v.end()};
    }
    const auto& l = solid.refiner.polyhedral_level(solid.level);
    if (l.IsHex(cell)) return {l.hex_vertices.begin() + 8 * cell, l.hex_vertices.begin() + 8 * cell + 8};
    const auto& p = l.polyhedra;
    const Index k = cell - l.n_hexes;
    const auto first = p.face_vertices.begin();
    return {first + p.face_vertex_offsets[p.offsets[k]], first + p.face_vertex_offsets[p.offsets[k + 1]]};
}

std::vector<double> Linear(const std::vector<double>& positions) {
    std::vector<double> values;
    for (std::size_t i = 0; i < positions.size(); i += 3) {
        values.push_back(2 * positions[i] - positions[i + 1] + 3 * positions[i + 2] + 5);
    }
    return values;
}

TEST(Attributes, ConstantsAndLinearFunctionsAreReproducedInEveryKindOfCell) {
    for (const Solid& solid : Solids()) {
        const auto linear = Linear(solid.positions);
        const std::vector<double> constant(linear.size(), 0.7);
        const Grids grids = solid.Voxelize(
            {.voxel_size = kVoxel,
             .attributes = {{"constant", 1, constant}, {"linear", 1, linear}, {"position", 3, solid.positions}},
             .level_id = true});
        const VoxelBox box = BoxAround(solid, kVoxel, 2);
        const auto constants = grids.Values("constant", box.low, box.high);
        const auto linears = grids.Values("linear", box.low, box.high);
        const auto vectors = grids.Vectors("position", box.low, box.high);
        const auto levels = grids.Values("level", box.low, box.high);
        const BruteForce brute(solid);
        // What lies in a tet of a folded hexahedron need not lie in its trilinear image.
        const bool has_places = solid.name != "folded hexahedra";
        int n_inside = 0;
        box.ForCompared([&](const Voxel3& v, std::size_t i) {
            const Vec p = Center(v, kVoxel);
            const double outside = brute.Outside(p) / kVoxel;
            if (outside <= 0 && has_places) {
                ++n_inside;
                // Floats of values up to 20.
                EXPECT_NEAR(constants[i], 0.7, 1e-6) << solid.name << ", " << NameOf(v);
                EXPECT_NEAR(linears[i], 2 * p[0] - p[1] + 3 * p[2] + 5, 1e-5) << solid.name << ", " << NameOf(v);
                for (std::size_t c = 0; c < 3; ++c) {
                    EXPECT_NEAR(vectors[3 * i + c], p[c], 1e-6) << solid.name << ", " << NameOf(v);
                }
                EXPECT_EQ(levels[i], solid.level);
            } else if (outside > 1e-8) {
                EXPECT_EQ(constants[i], 0) << solid.name << ", " << NameOf(v);
                EXPECT_EQ(linears[i], 0);
                EXPECT_EQ(levels[i], -1);
            }
        });
        const auto n_active = std::count_if(levels.begin(), levels.end(), [](double level) { return level >= 0; });
        EXPECT_GT(n_active, 100) << solid.name;
        EXPECT_EQ(n_inside > 100 / kOneIn, has_places) << solid.name;
        for (const GridInfo& info : grids.Describe()) {
            if (info.name == "surface") continue;
            EXPECT_EQ(info.active_voxels, n_active) << solid.name << ", " << info.name;
        }
    }
}

TEST(Attributes, CellIdNamesACellThatHoldsTheVoxel) {
    for (const Solid& solid : Solids()) {
        const VoxelBox box = BoxAround(solid, kVoxel, 2);
        const auto ids = solid.Voxelize({.voxel_size = kVoxel, .cell_id = true}).Values("cell_id", box.low, box.high);
        const BruteForce brute(solid);
        const auto& tets = brute.tets();
        std::set<double> seen;
        box.ForCompared([&](const Voxel3& v, std::size_t i) {
            const double id = ids[i];
            if (id < 0) {
                EXPECT_EQ(id, -1);
                EXPECT_GT(brute.Outside(Center(v, kVoxel)), 0) << solid.name << ", " << NameOf(v);
                return;
            }
            ASSERT_LT(id, static_cast<double>(solid.refiner.n_cells(solid.level)));
            seen.insert(id);
            const auto corners = CornersOf(solid, static_cast<Index>(id));
            double least = HUGE_VAL;
            for (std::size_t t = 0; t < tets.size() / 4; ++t) {
                bool is_of_cell = true;
                for (std::size_t k = 0; k < 4; ++k) is_of_cell = is_of_cell && corners.contains(tets[4 * t + k]);
                if (is_of_cell) least = std::min(least, brute.Outside(t, Center(v, kVoxel)));
            }
            EXPECT_LE(least, 1e-8 * kVoxel) << solid.name << ", " << NameOf(v);
        });
        EXPECT_GT(seen.size(), static_cast<std::size_t>(solid.refiner.n_cells(solid.level)) / 3 / kOneIn) << solid.name;
    }
}

TEST(Attributes, TheJacobianIsTheVolumeOfABlocksCells) {
    PolyhedralShape block = HexBlock(3);
    for (std::size_t i = 0; i < block.positions.size(); ++i)
        block.positions[i] *= 0.5 + 0.25 * static_cast<double>(i % 3);
    const Solid solid = SolidOf("block", block);
    const auto values =
        solid.Voxelize({.voxel_size = 0.1, .jacobian = true}).Values("jacobian", {0, 0, 0}, {15, 22, 30});
    for (double x : values) EXPECT_NEAR(x, 0.5 * 0.75 * 1, 1e-6);

    // Refined three times a cell has 1/8^3 of it.
    const Solid fine = SolidOf("fine block", block, "linear-solid", 3);
    const auto fine_values =
        fine.Voxelize({.voxel_size = 0.1, .jacobian = true}).Values("jacobian", {1, 1, 1}, {14, 21, 29});
    for (double x : fine_values) EXPECT_NEAR(x, 0.5 * 0.75 / 512, 1e-8);
}

TEST(Attributes, TheJacobianOfOtherCellsIsSixTimesTheVolumeOfTheirTets) {
    const Solid tets = SolidOf("tets", KuhnBlock(3));
    const auto values =
        tets.Voxelize({.voxel_size = 0.17, .jacobian = true}).Values("jacobian", {1, 1, 1}, {16, 16, 16});
    for (double x : values) EXPECT_NEAR(x, 1, 1e-6);
    Solid inverted = tets;
    for (std::size_t i = 0; i < inverted.positions.size(); i += 3) inverted.positions[i] = 3 - inverted.positions[i];
    const auto negative =
        inverted.Voxelize({.voxel_size = 0.17, .jacobian = true}).Values("jacobian", {1, 1, 1}, {16, 16, 16});
    for (double x : negative) EXPECT_NEAR(x, -1, 1e-6);
}

TEST(Attributes, AHexahedronIsTrilinear) {
    // u v w on the unit cube, which no cut into tets gives.
    const Solid solid = SolidOf("cube", HexBlock(1));
    const std::vector<double> product{0, 0, 0, 0, 0, 0, 0, 1};  // HexBlock's last vertex
    const auto values = solid.Voxelize({.voxel_size = 0.1, .attributes = {{"product", 1, product}}})
                            .Values("product", {1, 1, 1}, {9, 9, 9});
    std::size_t i = 0;
    VoxelBox{{1, 1, 1}, {9, 9, 9}}.ForEach(
        [&](const Voxel3& v) { EXPECT_NEAR(values[i++], v[0] * v[1] * v[2] * 1e-3, 1e-6) << NameOf(v); });
}

}  // namespace
}  // namespace SolidSubdiv::Voxel

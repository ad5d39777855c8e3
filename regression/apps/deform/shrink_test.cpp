// SPDX-License-Identifier: Apache-2.0
// Laws of shrunken lattices: they hold the model, keep their cells positive, and lie closer.
#include <gtest/gtest.h>
#include <solidsubdiv/kit/geometry/cell_volume.h>

#include <numeric>

#include "apps/deform/octree_testing.h"
#include "sanitized.h"

namespace SolidSubdiv::Deform {
namespace {

using Geometry::BoxKind;

double VolumeOf(const ControlLattice& lattice) {
    const auto volumes = Geometry::CellVolumes(lattice.View(), lattice.positions);
    return std::accumulate(volumes.begin(), volumes.end(), 0.);
}

/// Some points in a few clumps: cells with vertices in one corner only, next to cells without.
Model Clumps(std::uint64_t seed) {
    TestShapes::Random random(seed);
    Model m{"clumps " + std::to_string(seed), {}, {}};
    for (int clump = 0; clump < 12; ++clump) {
        const double x = random.Uniform(), y = random.Uniform(), z = random.Uniform();
        for (int i = 0; i < 3; ++i) {
            m.points.insert(m.points.end(),
                            {x + .05 * random.Uniform(), y + .05 * random.Uniform(), z + .05 * random.Uniform()});
        }
    }
    return m;
}

std::vector<Model> ModelsToShrink() {
    std::vector<Model> models = Models();
    for (int seed = 1; seed <= FewerIfSanitized(11); ++seed) models.push_back(Clumps(static_cast<std::uint64_t>(seed)));
    return models;
}

TEST(Shrink, CellsStayPositiveAndHoldTheModel) {
    for (const Model& model : ModelsToShrink()) {
        for (BoxKind box : {BoxKind::AxisAligned, BoxKind::Oriented}) {
            for (Cut cut : {Cut::None, Cut::Vertices, Cut::Triangles, Cut::Outside}) {
                for (double offset : {0., .02, 10.}) {
                    const OctreeOptions options{.box = box, .levels = 3, .cut = cut, .shrink = true, .offset = offset};
                    const auto h = MakeOctreeLattices(model.points, model.triangles, options);
                    for (const LatticeLevel& level : h.levels) {
                        EXPECT_EQ(CountBadCells(level.lattice), 0u) << model.name;
                        EXPECT_EQ(CountOutside(level.lattice, model.points), 0u) << model.name;
                    }
                }
            }
        }
    }
}

TEST(Shrink, ABoxThatIsTooLargeShrinksToTheModelAndItsOffset) {
    Model block{"block", {}, {}};  // reaches equally far in all cells on a side
    for (int i = 0; i < 1000; ++i)
        block.points.insert(block.points.end(), {.3 * (i % 10), .2 * (i / 10 % 10), .25 * (i / 100)});
    for (const auto& [model, levels] : {std::pair{Torus(20), 0}, std::pair{block, 2}}) {
        const Geometry::Box bounds = Geometry::BoundingBox(model.points);
        const auto h =
            MakeOctreeLattices(model.points, {}, {.levels = levels, .padding = .1, .shrink = true, .offset = .05});
        for (const LatticeLevel& level : h.levels) {
            const Geometry::Box shrunk = Geometry::BoundingBox(level.lattice.positions);
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_NEAR(shrunk.low[k], bounds.low[k] - .05, 1e-14);  // rounding of coordinates near 4
                EXPECT_NEAR(shrunk.high[k], bounds.high[k] + .05, 1e-14);
            }
        }
    }
}

TEST(Shrink, AnOffsetLargerThanTheGapLeavesThingsAsTheyAre) {
    const Model model = Torus(20);
    OctreeOptions options{.levels = 2};
    const auto plain = MakeOctreeLattices(model.points, {}, options);
    options.shrink = true;
    options.offset = 100;
    EXPECT_TRUE(SameHierarchy(plain, MakeOctreeLattices(model.points, {}, options)));
    options.offset = 0;
    const auto shrunk = MakeOctreeLattices(model.points, {}, options);
    EXPECT_LT(VolumeOf(shrunk.levels[2].lattice), .9 * VolumeOf(plain.levels[2].lattice));
    EXPECT_EQ(shrunk.levels[2].lattice.hexes, plain.levels[2].lattice.hexes);
}

TEST(Shrink, PointsMoveAlongAxesOnWhichCellsEndAndNeverOutwards) {
    const Model model = Clumps(3);
    OctreeOptions options{.levels = 3};
    const auto plain = MakeOctreeLattices(model.points, {}, options);
    options.shrink = true;
    const auto shrunk = MakeOctreeLattices(model.points, {}, options);
    Index n_moved = 0;
    for (std::size_t i = 0; i < plain.levels.size(); ++i) {
        const LatticeLevel& level = plain.levels[i];
        // Whether a point has cells on its low and on its high side.
        std::vector<std::array<std::array<bool, 2>, 3>> has(static_cast<std::size_t>(level.lattice.n_control_points()));
        for (std::size_t c = 0; c < level.cells.size(); ++c) {
            for (std::size_t j = 0; j < 8; ++j) {
                const std::size_t bits = j ^ (j >> 1 & 1);  // one an axis
                const std::size_t v = static_cast<std::size_t>(level.lattice.hexes[8 * c + j]);
                for (std::size_t k = 0; k < 3; ++k) has[v][k][bits >> k & 1 ? 0 : 1] = true;
            }
        }
        for (std::size_t v = 0; v < has.size(); ++v) {
            for (std::size_t k = 0; k < 3; ++k) {
                const double by = shrunk.levels[i].lattice.positions[3 * v + k] - level.lattice.positions[3 * v + k];
                if (has[v][k][0] && has[v][k][1]) {
                    EXPECT_EQ(by, 0);
                } else {
                    EXPECT_GE(has[v][k][1] ? by : -by, 0);
                }
                n_moved += by != 0;
            }
        }
    }
    EXPECT_GT(n_moved, 100);
}

TEST(Shrink, CellsKeepATenthOfTheirThickness) {
    for (const Model& model : ModelsToShrink()) {
        const auto h = MakeOctreeLattices(model.points, {}, {.levels = 3, .shrink = true});
        for (std::size_t i = 0; i < h.levels.size(); ++i) {
            const LatticeLevel& level = h.levels[i];
            for (std::size_t c = 0; c < level.cells.size(); ++c) {
                const auto corner = [&](std::size_t j, std::size_t k) {
                    return level.lattice.positions[3 * static_cast<std::size_t>(level.lattice.hexes[8 * c + j]) + k];
                };
                constexpr std::size_t kAcross[] = {1, 3, 4};
                for (std::size_t k = 0; k < 3; ++k) {
                    // To rounding of coordinates of up to 3e7 in boxes a millionth as large.
                    const double side = h.box.lengths[k] * std::ldexp(1., -static_cast<int>(i));
                    EXPECT_GE(corner(kAcross[k], k) - corner(0, k), .1 * side - 1e-8 * h.box.lengths[0]) << model.name;
                }
            }
        }
    }
}

}  // namespace
}  // namespace SolidSubdiv::Deform

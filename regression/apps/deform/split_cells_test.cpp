// SPDX-License-Identifier: Apache-2.0
// Laws of lattices with some of their cells split: still lattices, of the same shape, that every scheme refines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/apps/deform/octree_lattices.h>
#include <solidsubdiv/apps/deform/split_cells.h>
#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/geometry/cell_volume.h>

#include <cmath>
#include <numeric>

#include "apps/deform/deform_testing.h"

namespace SolidSubdiv::Deform {
namespace {

Far::TopologyRefiner RefinerOf(const ControlLattice& lattice) {
    return Far::TopologyRefiner::Create(lattice.View(), Sdc::Split::Polyhedral);
}

/// Lattices with planar faces.
std::vector<std::pair<std::string, ControlLattice>> Lattices() {
    const std::vector<double> line{0, 0, 0, 1, 1, 1, 2, 1.5, 3};
    return {{"block", LatticeOf(TestShapes::HexBlock(3))},
            {"mixed", LatticeOf(TestShapes::MixedCells())},
            {"touching", LatticeOf(TestShapes::TouchingCubes())},
            {"tets", LatticeOf(TestShapes::KuhnBlock(2))},
            {"octs and tets", LatticeOf(TestShapes::OctsAndTets())},
            {"octree", MakeOctreeLattices(line, {}, {.levels = 3}).levels[3].lattice}};
}

std::vector<Index> SomeCells(const ControlLattice& lattice, int percent, std::uint64_t seed) {
    TestShapes::Random random(seed);
    std::vector<Index> some{random.Below(lattice.n_cells())};
    for (Index c = 0; c < lattice.n_cells(); ++c) {
        if (random.Below(100) < percent) some.push_back(c);
    }
    return some;
}

std::vector<double> VolumesOf(const ControlLattice& lattice) {
    // In the order of control lattices, not of descriptors: hexahedra first.
    const auto by_kind = Geometry::CellVolumes(lattice.View(), lattice.positions);
    const std::size_t n_first = lattice.tets.size() / 4 + lattice.octs.size() / 6, n_hexes = lattice.hexes.size() / 8;
    std::vector<double> volumes(by_kind.begin() + static_cast<std::ptrdiff_t>(n_first),
                                by_kind.begin() + static_cast<std::ptrdiff_t>(n_first + n_hexes));
    volumes.insert(volumes.end(), by_kind.begin(), by_kind.begin() + static_cast<std::ptrdiff_t>(n_first));
    volumes.insert(volumes.end(), by_kind.begin() + static_cast<std::ptrdiff_t>(n_first + n_hexes), by_kind.end());
    return volumes;
}

/// Area of all faces that bound one cell. @pre they are planar
double BoundaryArea(const ControlLattice& lattice) {
    const auto refiner = RefinerOf(lattice);
    const auto& level = refiner.polyhedral_level(0);
    double area = 0;
    for (Index b = 0; b < level.n_boundary_faces; ++b) {
        std::array<double, 3> sum{};
        const auto v = level.BoundaryVertices(b);
        const auto at = [&](std::size_t k, std::size_t c) {
            return lattice.positions[3 * static_cast<std::size_t>(v[k % v.size()]) + c % 3];
        };
        for (std::size_t k = 0; k < v.size(); ++k) {
            for (std::size_t c = 0; c < 3; ++c) {
                sum[c] += .5 * (at(k, c + 1) * at(k + 1, c + 2) - at(k, c + 2) * at(k + 1, c + 1));
            }
        }
        area += std::hypot(sum[0], sum[1], sum[2]);
    }
    return area;
}

constexpr double kRounding = 1e-12;  // of sums of some hundred volumes, areas and coordinates below 10

void ExpectLaws(const ControlLattice& before, const SplitLattice& split, const std::string& name, bool is_planar) {
    const auto defects = Far::Validate(split.lattice.View());
    for (const auto& defect : defects) EXPECT_FALSE(defect.IsFatal()) << name << ": " << defect.text;
    const auto refiner = RefinerOf(split.lattice);
    const auto old = RefinerOf(before);
    if (old.defects().empty()) {
        EXPECT_TRUE(refiner.defects().empty()) << name;
    }

    ASSERT_EQ(split.parents.size(), static_cast<std::size_t>(split.lattice.n_cells()));
    // Parts fill what they are parts of. (Faces inside of split cells other than bricks are not planar.)
    std::vector<double> sums(static_cast<std::size_t>(before.n_cells()), 0.);
    const auto volumes = VolumesOf(split.lattice), expected = VolumesOf(before);
    for (std::size_t c = 0; c < volumes.size(); ++c) {
        EXPECT_GT(volumes[c] * expected[static_cast<std::size_t>(split.parents[c])], 0) << name;
        sums[static_cast<std::size_t>(split.parents[c])] += volumes[c];
    }
    for (std::size_t c = 0; c < sums.size() && is_planar; ++c) EXPECT_NEAR(sums[c], expected[c], kRounding) << name;
    // A face that does not match its neighbour's would bound one cell.
    EXPECT_NEAR(BoundaryArea(split.lattice), BoundaryArea(before), 10 * kRounding) << name;

    ASSERT_EQ(split.rows.n_rows(), split.lattice.n_control_points());
    for (Index v = 0; v < split.rows.n_rows(); ++v) {
        const auto weights = split.rows.Weights(v);
        EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.), 1, kRounding);
        if (v < before.n_control_points()) {
            EXPECT_THAT(split.rows.Indices(v), testing::ElementsAre(v));
        }
    }
}

TEST(SplitCells, LatticesStayLatticesOfTheSameShape) {
    for (const auto& [name, lattice] : Lattices()) {
        for (std::uint64_t seed = 0; seed < 6; ++seed) {
            const auto split = SplitCells(lattice, SomeCells(lattice, 15 * static_cast<int>(seed), seed));
            EXPECT_GT(split.lattice.n_cells(), lattice.n_cells());
            ExpectLaws(lattice, split, name, true);
        }
    }
}

TEST(SplitCells, SplitLatticesCanBeSplitAgain) {
    for (const auto& [name, lattice] : Lattices()) {
        ControlLattice before = lattice;
        for (std::uint64_t round = 0; round < 3; ++round) {
            const auto split = SplitCells(before, SomeCells(before, 10, 7 + round));
            const bool is_planar =
                round == 0 || lattice.hexes.size() == 8 * static_cast<std::size_t>(lattice.n_cells());
            ExpectLaws(before, split, name + ", again", is_planar);
            before = split.lattice;
        }
    }
}

TEST(SplitCells, OneOfTwoCubesMakesTheOtherACellOfNineFaces) {
    const auto split = SplitCells(LatticeOf(TestShapes::HexBlock(2, 1, 1, [](int, int, int) { return true; })), {0});
    EXPECT_EQ(split.lattice.hexes.size(), 8 * 8u);
    ASSERT_EQ(split.lattice.n_polyhedra(), 1);
    EXPECT_THAT(split.lattice.polyhedron_offsets, testing::ElementsAre(0, 9));  // 5 and, for the shared one, 4
    EXPECT_EQ(split.parents.back(), 1);
    EXPECT_EQ(split.rows.n_rows(), 12 + 12 + 6 + 1);
}

TEST(SplitCells, AllCellsAreTheUniformSplit) {
    for (const auto& [name, lattice] : Lattices()) {
        std::vector<Index> all(static_cast<std::size_t>(lattice.n_cells()));
        std::iota(all.begin(), all.end(), 0);
        const auto split = SplitCells(lattice, all);
        auto refiner = RefinerOf(lattice);
        refiner.RefineUniform({.max_level = 1, .full_topology_in_last_level = true});
        const auto& level = refiner.polyhedral_level(1);
        EXPECT_EQ(split.lattice.n_control_points(), level.n_vertices) << name;
        EXPECT_EQ(split.lattice.n_polyhedra(), level.n_polyhedra()) << name;
        EXPECT_THAT(split.lattice.hexes, testing::ElementsAreArray(level.hex_vertices)) << name;
        EXPECT_THAT(split.lattice.polyhedron_vertices, testing::ElementsAreArray(level.polyhedra.face_vertices));
        const auto again = RefinerOf(split.lattice);
        EXPECT_EQ(again.polyhedral_level(0).n_faces, level.n_faces) << name;
        EXPECT_EQ(again.polyhedral_level(0).n_edges, level.n_edges) << name;
    }
}

TEST(SplitCells, NothingSplitIsTheSame) {
    for (const auto& [name, lattice] : Lattices()) {
        const auto split = SplitCells(lattice, std::span<const Index>{});
        EXPECT_EQ(split.lattice.positions, lattice.positions) << name;
        EXPECT_EQ(split.lattice.hexes, lattice.hexes) << name;
        EXPECT_EQ(split.lattice.tets, lattice.tets) << name;
        EXPECT_EQ(split.lattice.octs, lattice.octs) << name;
        EXPECT_EQ(split.lattice.polyhedron_offsets, lattice.polyhedron_offsets) << name;
        EXPECT_EQ(split.lattice.polyhedron_face_offsets, lattice.polyhedron_face_offsets) << name;
        EXPECT_EQ(split.lattice.polyhedron_vertices, lattice.polyhedron_vertices) << name;
        for (std::size_t c = 0; c < split.parents.size(); ++c) EXPECT_EQ(split.parents[c], static_cast<Index>(c));
    }
}

TEST(SplitCells, SchemesForPolyhedraRefineTheResult) {
    for (const auto& [name, lattice] : Lattices()) {
        const auto once = SplitCells(lattice, SomeCells(lattice, 10, 1));
        const auto split = SplitCells(once.lattice, SomeCells(once.lattice, 5, 2)).lattice;
        auto refiner = RefinerOf(split);
        refiner.RefineUniform({.max_level = 2});
        for (const char* scheme : {"catmull-clark-solid", "mlca", "linear-solid"}) {
            const auto table = Far::StencilTable::Create(refiner, Sdc::SchemeOf(scheme));
            for (int l = 1; l <= 2; ++l) {
                const auto& rows = table.level(l);
                for (Index v = 0; v < rows.n_rows(); ++v) {
                    const auto weights = rows.Weights(v);
                    EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.), 1, kRounding) << name;
                }
            }
        }
    }
}

TEST(SplitCells, PlantedFaultsAreFoundByTheLawsAbove) {
    // The neighbour left as a hexahedron: its face and the four beside it bound one cell each.
    const auto two = LatticeOf(TestShapes::HexBlock(2, 1, 1, [](int, int, int) { return true; }));
    auto split = SplitCells(two, {0});
    ControlLattice naive;
    naive.positions = split.lattice.positions;
    naive.hexes = split.lattice.hexes;
    naive.hexes.insert(naive.hexes.end(), two.hexes.begin() + 8, two.hexes.end());
    EXPECT_NEAR(BoundaryArea(naive), BoundaryArea(two) + 2, kRounding);
    // A face turned round.
    std::swap(split.lattice.polyhedron_vertices[0], split.lattice.polyhedron_vertices[2]);
    const auto defects = Far::Validate(split.lattice.View());
    EXPECT_TRUE(std::any_of(defects.begin(), defects.end(), [](const auto& d) { return d.IsFatal(); }));
}

TEST(SplitCells, CellsThatAreNotThereAreNamed) {
    const auto lattice = LatticeOf(TestShapes::HexBlock(1));
    for (Index c : {-1, 1}) {
        try {
            SplitCells(lattice, {0, c});
            FAIL();
        } catch (const InvalidInput& e) {
            EXPECT_THAT(e.what(), testing::HasSubstr("cell " + std::to_string(c)));
        }
    }
}

}  // namespace
}  // namespace SolidSubdiv::Deform

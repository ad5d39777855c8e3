// SPDX-License-Identifier: Apache-2.0
// Volumes: of reference cells by formula, signs by orientation, sums by additivity.
#include <gtest/gtest.h>
#include <solidsubdiv/kit/geometry/cell_volume.h>

#include <array>
#include <cmath>
#include <numeric>

namespace SolidSubdiv::Geometry {
namespace {

// Volumes are sums of a few products of numbers near 1.
constexpr double kTolerance = 1e-14;

const std::vector<double> kUnitCube = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};

/// v0 v1 | v2 v3 | v4 v5 on the axes of a regular octahedron of half diagonal 1, positive.
const std::vector<double> kOctahedron = {0, 0, 1, 0, 0, -1, 0, 1, 0, 0, -1, 0, 1, 0, 0, -1, 0, 0};

TEST(CellVolume, ReferenceTetIsASixthAndPositive) {
    const std::vector<double> p = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    EXPECT_NEAR(TetVolume(p, std::array<Index, 4>{0, 1, 2, 3}), 1.0 / 6.0, kTolerance);
    EXPECT_NEAR(TetVolume(p, std::array<Index, 4>{0, 1, 3, 2}), -1.0 / 6.0, kTolerance);
}

TEST(CellVolume, RegularOctahedronIsFourThirdsOfItsHalfDiagonalCubed) {
    EXPECT_NEAR(OctVolume(kOctahedron, std::array<Index, 6>{0, 1, 2, 3, 4, 5}), 4.0 / 3.0, kTolerance);
    EXPECT_NEAR(OctVolume(kOctahedron, std::array<Index, 6>{0, 1, 2, 3, 5, 4}), -4.0 / 3.0, kTolerance);
}

TEST(CellVolume, OctIsTheSameWhicheverPairIsItsMajorDiagonal) {
    std::vector<double> p = kOctahedron;
    for (std::size_t i = 0; i < p.size(); ++i) p[i] += 0.2 * std::sin(3.0 * static_cast<double>(i));
    const double first = OctVolume(p, std::array<Index, 6>{0, 1, 2, 3, 4, 5});
    EXPECT_NEAR(OctVolume(p, std::array<Index, 6>{2, 3, 4, 5, 0, 1}), first, kTolerance);
    EXPECT_NEAR(OctVolume(p, std::array<Index, 6>{4, 5, 0, 1, 2, 3}), first, kTolerance);
}

TEST(CellVolume, KindsComeInTheOrderOfTheDescriptor) {
    std::vector<double> p = kUnitCube;
    p.insert(p.end(), {0.5, 0.5, 1.0});  // apex of the pyramid over the cube's bottom
    const std::vector<Index> tets = {0, 1, 3, 4}, hexes = {0, 1, 2, 3, 4, 5, 6, 7};
    const std::vector<Index> wedges = {0, 3, 1, 4, 7, 5};  // VTK: the normal of the first triangle points outward
    const std::vector<Index> pyramids = {0, 1, 2, 3, 8};
    const std::vector<Offset> cells = {0, 6}, faces = {0, 4, 8, 12, 16, 20, 24};
    const std::vector<Index> polyhedron = {0, 4, 7, 3, 1, 2, 6, 5, 0, 1, 5, 4, 3, 7, 6, 2, 0, 3, 2, 1, 4, 5, 6, 7};
    Far::TopologyDescriptor d;
    d.n_vertices = 9;
    d.tets = tets;
    d.hexes = hexes;
    d.wedges = wedges;
    d.pyramids = pyramids;
    d.polyhedron_offsets = cells;
    d.polyhedron_face_offsets = faces;
    d.polyhedron_vertices = polyhedron;
    const std::vector<double> volumes = CellVolumes(d, p);
    const std::vector<double> expected = {1.0 / 6.0, 1.0, 0.5, 1.0 / 3.0, 1.0};
    ASSERT_EQ(volumes.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(volumes[i], expected[i], kTolerance) << i;
}

TEST(CellVolume, TwistedHexesThatShareAFaceAddUpToTheirUnion) {
    // A block of two hexes with bent faces; the vertices of the outer faces stay on a box, so its volume is known.
    std::vector<double> p;
    for (int i = 0; i < 3; ++i) {
        for (const auto& yz : {std::array{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
            p.insert(p.end(), {static_cast<double>(i), yz[0], yz[1]});
        }
    }
    p[3 * 4] += 0.3;  // the inner face is no plane any more
    p[3 * 6] -= 0.2;
    const std::vector<Index> hexes = {0, 1, 2, 3, 4, 5, 6, 7, 4, 5, 6, 7, 8, 9, 10, 11};
    Far::TopologyDescriptor d;
    d.n_vertices = 12;
    d.hexes = hexes;
    const std::vector<double> volumes = CellVolumes(d, p);
    ASSERT_EQ(volumes.size(), 2u);
    EXPECT_NEAR(std::abs(volumes[0] + volumes[1]), 2.0, kTolerance);
    EXPECT_GT(std::abs(volumes[0] - volumes[1]), 0.01);
}

TEST(CellVolume, RoundoffIsAboveTheVolumeOfAFlatCellFarFromTheOriginAndBelowThatOfAThinOne) {
    // Four points of a slanted plane, whose coordinates round.
    const auto tet_at = [](double shift, double height) {
        std::vector<double> p;
        for (const auto& uv : {std::array{0.0, 0.0}, {1.0, 0.1}, {0.3, 1.0}, {0.8, 0.7}}) {
            const double lift = p.size() == 9 ? height : 0.0;
            p.insert(p.end(), {shift + uv[0] / 3, shift + uv[1] / 7, shift + (uv[0] + uv[1]) / 11 + lift});
        }
        return p;
    };
    const std::array<Index, 4> tet = {0, 1, 2, 3};
    for (double shift : {0.0, 1.0, 1e3, 1e6}) {
        const std::vector<double> flat = tet_at(shift, 0), thin = tet_at(shift, 1e-6);
        EXPECT_LE(std::abs(TetVolume(flat, tet)), VolumeRoundoff(flat, tet)) << shift;
        EXPECT_GT(std::abs(TetVolume(thin, tet)), VolumeRoundoff(thin, tet)) << shift;
    }
}

}  // namespace
}  // namespace SolidSubdiv::Geometry

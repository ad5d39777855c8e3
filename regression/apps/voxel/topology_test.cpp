// SPDX-License-Identifier: Apache-2.0
// Laws of what is hollow, nested, close and ring-shaped: surfaces of level sets have the right pieces and handles.
#include <gtest/gtest.h>
#include <solidsubdiv/kit/geometry/surface_components.h>

#include "apps/voxel/voxel_testing.h"

namespace SolidSubdiv::Voxel {
namespace {

using namespace TestShapes;

double SignedVolume(const std::vector<double>& positions, const std::vector<Index>& triangles) {
    double volume = 0;
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
        volume += Dot(PointOf(positions, triangles[t]),
                      Cross(PointOf(positions, triangles[t + 1]), PointOf(positions, triangles[t + 2]))) /
                  6;
    }
    return volume;
}

/// The surface of a level set.
struct Extracted {
    std::vector<Geometry::SurfaceComponent> pieces;
    double volume;

    explicit Extracted(const Grids& grids) {
        const GridSurface surface = grids.Surface("surface", 0);
        std::vector<Index> triangles = surface.triangles;
        for (std::size_t q = 0; q < surface.quads.size(); q += 4) {
            const Index* const v = &surface.quads[q];
            triangles.insert(triangles.end(), {v[0], v[1], v[2], v[0], v[2], v[3]});
        }
        pieces = Geometry::SurfaceComponents(triangles, static_cast<Index>(surface.positions.size() / 3));
        volume = SignedVolume(surface.positions, triangles);
    }
    std::vector<Offset> EulerCharacteristics() const {
        std::vector<Offset> all;
        for (const auto& piece : pieces) all.push_back(piece.EulerCharacteristic());
        std::sort(all.begin(), all.end());
        return all;
    }
};

/// Blocks of unit cubes in a box of n^3 with voxels of a fraction of a cube that puts none on a face.
template <class Keep>
Solid Cubes(int n, Keep&& keep) {
    return SolidOf("cubes", HexBlock(n, n, n, keep));
}
constexpr double kVoxel = 0.137;

/// Out of the middle of a cube of the block.
double ValueAtCube(const Grids& grids, int x, int y, int z) {
    Voxel3 v;
    for (std::size_t c = 0; c < 3; ++c) v[c] = static_cast<int>(std::lround((std::array{x, y, z}[c] + 0.5) / kVoxel));
    return grids.Values("surface", v, v)[0];
}

TEST(Topology, ABlockHasASphereForASurfaceThatLooksOutwards) {
    const Extracted surface(Cubes(2, [](int, int, int) { return true; }).Voxelize({.voxel_size = kVoxel}));
    ASSERT_EQ(surface.EulerCharacteristics(), (std::vector<Offset>{2}));
    EXPECT_TRUE(surface.pieces[0].IsClosed());
    EXPECT_EQ(surface.pieces[0].n_flipped_edges, 0);
    // Dual contouring rounds edges: within half a voxel all round.
    EXPECT_NEAR(surface.volume, 8, 24 * kVoxel / 2);
    EXPECT_GT(surface.volume, 0);
}

TEST(Topology, ACavityStaysEmpty) {
    const auto is_rim = [](int i) { return i == 0 || i == 4; };
    const Grids grids = Cubes(5, [&](int x, int y, int z) {
                            return is_rim(x) || is_rim(y) || is_rim(z);
                        }).Voxelize({.voxel_size = kVoxel, .kind = Kind::Both});
    EXPECT_EQ(Extracted(grids).EulerCharacteristics(), (std::vector<Offset>{2, 2}));
    EXPECT_GT(ValueAtCube(grids, 2, 2, 2), 0);
    EXPECT_LT(ValueAtCube(grids, 0, 2, 2), 0);
    EXPECT_NEAR(Extracted(grids).volume, 125 - 27, (150 + 54) * kVoxel / 2);
    EXPECT_EQ(grids.Values("density", {18, 18, 18}, {18, 18, 18})[0], 0);
}

TEST(Topology, ASolidInTheCavityOfAnotherIsThere) {
    // A shell of 7^3, in its cavity of 5^3 a shell of 3^3, and in that a cavity of one cube.
    const auto depth = [](int x, int y, int z) { return std::min({x, y, z, 6 - x, 6 - y, 6 - z}); };
    const Grids grids =
        Cubes(7, [&](int x, int y, int z) { return depth(x, y, z) % 2 == 0; }).Voxelize({.voxel_size = kVoxel});
    EXPECT_EQ(Extracted(grids).EulerCharacteristics(), (std::vector<Offset>{2, 2, 2, 2}));
    EXPECT_LT(ValueAtCube(grids, 0, 3, 3), 0);
    EXPECT_GT(ValueAtCube(grids, 1, 3, 3), 0);
    EXPECT_LT(ValueAtCube(grids, 2, 3, 3), 0);
    EXPECT_GT(ValueAtCube(grids, 3, 3, 3), 0);
    EXPECT_NEAR(Extracted(grids).volume, 343 - 125 + 26, 6 * (49 + 25 + 9 + 1) * kVoxel / 2);
}

TEST(Topology, RingsHaveTheirHandles) {
    // A frame of a square of 3 x 3 has one hole, one of 5 x 5 with two holes two, of a cube's edges five.
    const Extracted ring(
        Cubes(3, [](int x, int y, int z) { return z == 0 && (x != 1 || y != 1); }).Voxelize({.voxel_size = kVoxel}));
    EXPECT_EQ(ring.EulerCharacteristics(), (std::vector<Offset>{0}));
    const Extracted eight(Cubes(5, [](int x, int y, int z) {
                              return z == 0 && (y != 2 || x == 0 || x == 2 || x == 4) && y > 0 && y < 4;
                          }).Voxelize({.voxel_size = kVoxel}));
    EXPECT_EQ(eight.EulerCharacteristics(), (std::vector<Offset>{-2}));
    const Extracted frame(Cubes(3, [](int x, int y, int z) {
                              return (x != 1) + (y != 1) + (z != 1) >= 2;
                          }).Voxelize({.voxel_size = kVoxel}));
    EXPECT_EQ(frame.EulerCharacteristics(), (std::vector<Offset>{-8}));
}

/// Hexahedra bent to a ring around the z axis, as a torus.
Solid Torus(int n_around, int n_across, double ring, double radius, int level) {
    PolyhedralShape s;
    const auto id = [&](int i, int x, int y) { return (i % n_around * (n_across + 1) + x) * (n_across + 1) + y; };
    for (int i = 0; i < n_around; ++i) {
        for (int x = 0; x <= n_across; ++x) {
            for (int y = 0; y <= n_across; ++y) {
                const double turn = 2 * 3.14159265358979323846 * i / n_around;
                const double u = 2.0 * x / n_across - 1, v = 2.0 * y / n_across - 1;
                // From the square to the disc.
                const double r = ring + radius * u * std::sqrt(1 - v * v / 2);
                s.AddVertex(r * std::cos(turn), r * std::sin(turn), radius * v * std::sqrt(1 - u * u / 2));
            }
        }
    }
    for (int i = 0; i < n_around; ++i) {
        for (int x = 0; x < n_across; ++x) {
            for (int y = 0; y < n_across; ++y) {
                s.hexes.insert(s.hexes.end(),
                               {id(i, x, y), id(i, x + 1, y), id(i, x + 1, y + 1), id(i, x, y + 1), id(i + 1, x, y),
                                id(i + 1, x + 1, y), id(i + 1, x + 1, y + 1), id(i + 1, x, y + 1)});
            }
        }
    }
    return SolidOf("torus", s, "catmull-clark-solid", level);
}

TEST(Topology, ATorusOfHexahedraHasOneHandleAtAllLevels) {
    for (int level = 0; level <= 2; ++level) {
        const Extracted surface(Torus(12, 2, 2, 0.7, level).Voxelize({.voxel_size = 0.1}));
        ASSERT_EQ(surface.EulerCharacteristics(), (std::vector<Offset>{0})) << level;
        EXPECT_EQ(surface.pieces[0].Genus(), 1);
        EXPECT_GT(surface.volume, 0);
    }
}

/// Two bricks with a gap between them in z.
Solid TwoBricks(double gap) {
    PolyhedralShape s = HexBlock(1), other = HexBlock(1);
    for (std::size_t v = 0; v < 8; ++v) {
        s.AddVertex(other.positions[3 * v], other.positions[3 * v + 1], other.positions[3 * v + 2] + 1 + gap);
    }
    for (Index v : other.hexes) s.hexes.push_back(8 + v);
    return SolidOf("bricks", s);
}

TEST(Topology, AGapThinnerThanAVoxelKeepsItsSignOnBothSides) {
    // The middle of the gap is on a layer of voxels: 10 steps of 0.101; the gap is a tenth of a voxel.
    constexpr double kSize = 0.101, kGap = 0.0101;
    Solid solid = TwoBricks(kGap);
    for (std::size_t i = 2; i < solid.positions.size(); i += 3) solid.positions[i] += 10 * kSize - 1 - kGap / 2;
    const auto values = solid.Voxelize({.voxel_size = kSize}).Values("surface", {5, 5, 7}, {5, 5, 13});
    EXPECT_NEAR(values[3], kGap / 2, 1e-5 * kSize);
    for (int k = 1; k <= 2; ++k) {
        EXPECT_NEAR(values[3 - k], -(k * kSize - kGap / 2), 1e-5 * kSize);
        EXPECT_NEAR(values[3 + k], -(k * kSize - kGap / 2), 1e-5 * kSize);
    }
    // Between two layers the voxels on both sides are inside and know how near the gap is.
    for (std::size_t i = 2; i < solid.positions.size(); i += 3) solid.positions[i] += kSize / 2;
    const auto beside = solid.Voxelize({.voxel_size = kSize}).Values("surface", {5, 5, 10}, {5, 5, 11});
    for (double value : beside) EXPECT_NEAR(value, -(kSize / 2 - kGap / 2), 1e-5 * kSize);
}

TEST(Topology, BodiesThatTouchAreBothInside) {
    const Solid apart = TwoBricks(0);  // two faces in one place
    const Grids grids = apart.Voxelize({.voxel_size = 0.125});
    for (int z = 1; z <= 15; ++z) {
        const double value = grids.Values("surface", {4, 4, z}, {4, 4, z})[0];
        const double distance = std::min({z * 0.125, std::abs(z * 0.125 - 1), 2 - z * 0.125, 0.375});
        EXPECT_NEAR(value, -distance, 1e-6) << z;
        EXPECT_TRUE(std::signbit(value)) << z;  // on the faces, too
    }
    // Of cells that share the face there is nothing in between.
    const Grids joined = Cubes(2, [](int x, int y, int) { return x == 0 && y == 0; }).Voxelize({.voxel_size = 0.125});
    EXPECT_NEAR(joined.Values("surface", {4, 4, 8}, {4, 4, 8})[0], -0.375, 1e-6);
}

TEST(Topology, CubesThatTouchInAnEdgeOrAVertexAreAllThere) {
    const Solid solid = SolidOf("touching", TouchingCubes());
    const Grids grids = solid.Voxelize({.voxel_size = kVoxel});
    EXPECT_LT(ValueAtCube(grids, 0, 0, 0), 0);
    EXPECT_GT(ValueAtCube(grids, 1, 1, 1), 0);
    EXPECT_LT(ValueAtCube(grids, 3, 3, 1), 0);
    EXPECT_LT(ValueAtCube(grids, 4, 4, 2), 0);
    EXPECT_GT(ValueAtCube(grids, 4, 4, 1), 0);
}

}  // namespace
}  // namespace SolidSubdiv::Voxel

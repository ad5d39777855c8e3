// SPDX-License-Identifier: Apache-2.0
// Laws of lattices that lose only what is outside: closed models are filled, open ones are not.
#include <gtest/gtest.h>
#include <solidsubdiv/apps/deform/internal/vector3.h>
#include <solidsubdiv/kit/geometry/cell_volume.h>

#include <numeric>
#include <set>

#include "apps/deform/octree_testing.h"
#include "apps/deform/sphere_testing.h"

namespace SolidSubdiv::Deform {
namespace {

using Place = std::array<Index, 3>;
using TestShapes::Sphere;

LatticeHierarchy Make(const Sphere& model, int levels, Cut cut = Cut::Outside) {
    return MakeOctreeLattices(model.points, model.triangles, {.levels = levels, .cut = cut});
}

std::set<Place> CellsOf(const LatticeLevel& level) { return {level.cells.begin(), level.cells.end()}; }

std::vector<Place> AllPlaces(Index n) {
    std::vector<Place> all;
    for (Index i = 0; i < n * n * n; ++i) all.push_back({i % n, i / n % n, i / (n * n)});
    return all;
}

/// The largest ball around the middle of a sphere of triangles that they do not cut.
double InnerRadius(const Sphere& sphere) {
    using namespace Internal;
    double least = 1e9;
    for (std::size_t t = 0; t < sphere.triangles.size(); t += 3) {
        std::array<Vector3, 3> v;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t p = 3 * static_cast<std::size_t>(sphere.triangles[t + k]);
            v[k] = {sphere.points[p], sphere.points[p + 1], sphere.points[p + 2]};
        }
        const Vector3 normal = Cross(Minus(v[1], v[0]), Minus(v[2], v[0]));
        least = std::min(least, Dot(normal, v[0]) / std::sqrt(Dot(normal, normal)));
    }
    return least;
}

/// Cells that are wrongly there or not, around a ball in the middle of the box that all of the model is near to: cells
/// with their middle in the ball must stay, and of those that are cut every corner is outside.
std::size_t CountWrong(const LatticeHierarchy& h, int level, double radius) {
    const std::set<Place> cells = CellsOf(h.levels[static_cast<std::size_t>(level)]);
    const Index n = Index{1} << level;
    std::size_t n_wrong = 0;
    for (const Place& cell : AllPlaces(n)) {
        if (cells.contains(cell)) continue;
        const auto distance = [&](double x, double y, double z) {
            const auto p = h.box.At({h.box.lengths[0] * (cell[0] + x) / n, h.box.lengths[1] * (cell[1] + y) / n,
                                     h.box.lengths[2] * (cell[2] + z) / n});
            return std::hypot(p[0], p[1], p[2]);
        };
        bool is_outside = distance(.5, .5, .5) > radius;
        for (int j = 0; j < 8; ++j) is_outside = is_outside && distance(j & 1, j >> 1 & 1, j >> 2) > radius;
        n_wrong += !is_outside;
    }
    return n_wrong;
}

double VolumeOf(const ControlLattice& lattice) {
    const auto volumes = Geometry::CellVolumes(lattice.View(), lattice.positions);
    return std::accumulate(volumes.begin(), volumes.end(), 0.);
}

/// A sphere without the triangles that lie above a height, and without the vertices that then have none.
Sphere Open(Sphere sphere, double height) {
    std::vector<Index> numbers(static_cast<std::size_t>(sphere.n_points()), -1), left;
    std::vector<double> points;
    for (std::size_t t = 0; t < sphere.triangles.size(); t += 3) {
        const auto corner = [&](std::size_t k) { return static_cast<std::size_t>(sphere.triangles[t + k]); };
        const auto z = [&](std::size_t k) { return sphere.points[3 * corner(k) + 2]; };
        if (std::max({z(0), z(1), z(2)}) > height) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            Index& number = numbers[corner(k)];
            if (number < 0) {
                number = static_cast<Index>(points.size() / 3);
                for (std::size_t c = 0; c < 3; ++c) points.push_back(sphere.points[3 * corner(k) + c]);
            }
            left.push_back(number);
        }
    }
    sphere.points = points;
    sphere.triangles = left;
    return sphere;
}

TEST(OutsideCut, AClosedSphereIsFilled) {
    const Sphere sphere(24, 1);
    const double radius = InnerRadius(sphere);
    ASSERT_GT(radius, .99);
    const auto h = Make(sphere, 5), skin = Make(sphere, 5, Cut::Triangles);
    for (int i = 0; i <= 5; ++i) {
        const LatticeLevel& level = h.levels[static_cast<std::size_t>(i)];
        EXPECT_EQ(CountWrong(h, i, radius), 0u) << "level " << i;
        EXPECT_GE(VolumeOf(level.lattice), 4. / 3 * std::acos(-1.)) << "level " << i;
        EXPECT_EQ(CountBadCells(level.lattice), 0u);
    }
    // Not the whole box: around a ball there is something to cut. And a skin of cells is no ball.
    EXPECT_LT(VolumeOf(h.levels[5].lattice), .7 * h.box.Volume());
    EXPECT_GT(CountWrong(skin, 5, radius), 4000u);
    // Shrunken it is less, but only outside: it still holds the sphere.
    const auto shrunk =
        MakeOctreeLattices(sphere.points, sphere.triangles, {.levels = 5, .cut = Cut::Outside, .shrink = true});
    EXPECT_LT(VolumeOf(shrunk.levels[5].lattice), VolumeOf(h.levels[5].lattice));
    EXPECT_GT(VolumeOf(shrunk.levels[5].lattice), 4. / 3 * std::acos(-1.) * std::pow(radius, 3));
}

TEST(OutsideCut, ACellThatIsMissingInsideIsFound) {
    auto h = Make(Sphere(24, 1), 4);
    ASSERT_EQ(CountWrong(h, 4, .99), 0u);
    auto& cells = h.levels[4].cells;
    cells.erase(std::find(cells.begin(), cells.end(), Place{7, 8, 3}));
    EXPECT_EQ(CountWrong(h, 4, .99), 1u);
}

TEST(OutsideCut, StaysWhateverASearchFromOutsideDoesNotReach) {
    std::size_t n_filled = 0;
    for (const Model& model : Models()) {
        for (Geometry::BoxKind box : {Geometry::BoxKind::AxisAligned, Geometry::BoxKind::Oriented}) {
            for (int level = 0; level <= 4; ++level) {
                OctreeOptions options{.box = box, .levels = level, .cut = Cut::Triangles};
                const std::set<Place> touched =
                    CellsOf(MakeOctreeLattices(model.points, model.triangles, options).levels.back());
                options.cut = Cut::Outside;
                const std::set<Place> cells =
                    CellsOf(MakeOctreeLattices(model.points, model.triangles, options).levels.back());
                // From outside: over and over, until nothing new is reached.
                const Index n = Index{1} << level;
                std::set<Place> outside;
                std::size_t before;
                do {
                    before = outside.size();
                    for (const Place& cell : AllPlaces(n)) {
                        bool reached = false;
                        for (std::size_t k = 0; k < 3; ++k) {
                            for (Index step : {-1, 1}) {
                                Place next = cell;
                                next[k] += step;
                                reached = reached || next[k] < 0 || next[k] == n || outside.contains(next);
                            }
                        }
                        if (reached && !touched.contains(cell)) outside.insert(cell);
                    }
                } while (outside.size() > before);
                for (const Place& cell : AllPlaces(n)) {
                    EXPECT_NE(cells.contains(cell), outside.contains(cell)) << model.name << ", level " << level;
                }
                n_filled += cells.size() - touched.size();
            }
        }
    }
    EXPECT_GT(n_filled, 30u);  // the torus is thick enough
}

TEST(OutsideCut, WhatLiesInAClosedModelChangesNothing) {
    const Sphere outer(24, 1), inner(8, .3, {.1, .2, 0});
    Sphere both = outer;
    for (Index v : inner.triangles) both.triangles.push_back(outer.n_points() + v);
    both.points.insert(both.points.end(), inner.points.begin(), inner.points.end());
    EXPECT_TRUE(SameHierarchy(Make(both, 4), Make(outer, 4)));
    EXPECT_FALSE(SameHierarchy(Make(both, 4, Cut::Triangles), Make(outer, 4, Cut::Triangles)));
}

TEST(OutsideCut, AHoleThatCellsFitThroughLeavesTheSkinAtAllLevels) {
    // Radius .6: four cells of the finest level, and less than one of level 1.
    const Sphere open = Open(Sphere(24, 1), .8);
    EXPECT_TRUE(SameHierarchy(Make(open, 4), Make(open, 4, Cut::Triangles)));
    const auto coarse = Make(open, 2);
    EXPECT_EQ(CountWrong(coarse, 2, .5), 0u);  // as no cell of that grid fits through
}

TEST(OutsideCut, AHoleThatIsSmallerThanACellDoesNotMatter) {
    // Without the vertex on top, at the corner of four cells: a hole of radius .06 above cells of .125 a side.
    const Sphere open = Open(Sphere(24, 1), .9999);
    ASSERT_EQ(open.triangles.size() + 3 * 4, Sphere(24, 1).triangles.size());
    const auto h = Make(open, 4);
    for (int i = 0; i <= 4; ++i) EXPECT_EQ(CountWrong(h, i, .98), 0u) << "level " << i;
}

TEST(OutsideCut, ARegionCutsModelsOpen) {
    const Sphere sphere(24, 1);
    OctreeOptions options{.levels = 4, .cut = Cut::Outside, .region = Geometry::Box{{-1, -1, -1}, {1, 1, .2}}};
    const auto h = MakeOctreeLattices(sphere.points, sphere.triangles, options);
    options.cut = Cut::Triangles;
    EXPECT_TRUE(SameHierarchy(h, MakeOctreeLattices(sphere.points, sphere.triangles, options)));
}

TEST(OutsideCut, FilledLatticesAreRefusedBeforeTheyAreMade) {
    const Sphere sphere(8, 1);
    try {
        MakeOctreeLattices(sphere.points, sphere.triangles, {.levels = 7, .cut = Cut::Outside, .max_bytes = 100 << 20});
        ADD_FAILURE() << "not refused";
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("lattices to level 7"), std::string::npos) << error.what();
    }
    // A skin of the same cells is no problem.
    MakeOctreeLattices(sphere.points, sphere.triangles, {.levels = 7, .cut = Cut::Triangles, .max_bytes = 100 << 20});
}

}  // namespace
}  // namespace SolidSubdiv::Deform

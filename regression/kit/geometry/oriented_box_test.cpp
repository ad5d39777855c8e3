// SPDX-License-Identifier: Apache-2.0
// Laws of boxes around points: what they hold, how they turn with the points, how small they are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/kit/geometry/oriented_box.h>
#include <solidsubdiv/sdc/errors.h>
#include <solidsubdiv/sdc/parallel.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "test_shapes.h"

namespace SolidSubdiv::Geometry {
namespace {

using Points = std::vector<double>;
using Axes = std::array<std::array<double, 3>, 3>;
constexpr BoxKind kKinds[] = {BoxKind::AxisAligned, BoxKind::Oriented, BoxKind::Minimum};

/// A rotation by turns about x, y, z (radians), as rows.
Axes Rotation(double a, double b, double c) {
    Axes r{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const double angles[] = {a, b, c};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        const double cosine = std::cos(angles[axis]), sine = std::sin(angles[axis]);
        for (auto& row : r) {
            const double x = row[u], y = row[v];
            row[u] = cosine * x - sine * y;
            row[v] = sine * x + cosine * y;
        }
    }
    return r;
}

Points Moved(const Points& points, const Axes& rows, const std::array<double, 3>& by = {0, 0, 0}) {
    Points moved(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& row = rows[i % 3];
        const double* p = &points[i - i % 3];
        moved[i] = by[i % 3] + row[0] * p[0] + row[1] * p[1] + row[2] * p[2];
    }
    return moved;
}

/// Points of an egg with a nose: no symmetry, no equal components.
Points Egg(int n) {
    TestShapes::Random random(7);
    Points points;
    for (int i = 0; i < n; ++i) {
        double p[3], length = 0;
        for (double& x : p) {
            x = random.Uniform();
            length += x * x;
        }
        const double s = 1 / std::sqrt(length), bump = p[0] > .8 / s ? 1.3 : 1;
        points.insert(points.end(), {3 * s * p[0] * bump, 2 * s * p[1] + .2 * p[0], s * p[2] + .3 * p[1] * p[1]});
    }
    return points;
}

Points BoxCorners(const std::array<double, 3>& lengths) {
    Points points;
    for (int i = 0; i < 8; ++i) {
        for (int k = 0; k < 3; ++k) points.push_back(i >> k & 1 ? lengths[static_cast<std::size_t>(k)] : 0);
    }
    return points;
}

double Largest(const Points& points) {
    double largest = 0;
    for (double x : points) largest = std::max(largest, std::abs(x));
    return largest;
}

/// How far the farthest point is outside of a box.
double LargestExcess(const OrientedBox& box, const Points& points) {
    double excess = 0;
    for (std::size_t i = 0; i < points.size(); i += 3) {
        const auto t = box.CoordinatesOf(std::span(points).subspan(i).first<3>());
        for (std::size_t k = 0; k < 3; ++k) excess = std::max({excess, -t[k], t[k] - box.lengths[k]});
    }
    return excess;
}

/// Coordinates in a box are sums of three products, once when it is made and once here.
double RoundOff(const Points& points) { return 32 * std::numeric_limits<double>::epsilon() * Largest(points); }

bool IsRightHanded(const OrientedBox& box) {
    const auto& a = box.axes;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const double dot = a[i][0] * a[j][0] + a[i][1] * a[j][1] + a[i][2] * a[j][2];
            if (std::abs(dot - (i == j)) > 1e-14) return false;  // some tens of roundings
        }
    }
    const double det = a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
                       a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
                       a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
    return det > 0;
}

struct Named {
    std::string name;
    Points points;
};

std::vector<Named> Shapes() {
    const Axes turn = Rotation(.4, 1.1, -.7);
    return {{"egg", Egg(2000)},
            {"turned egg, far away", Moved(Egg(700), turn, {1e4, -2e4, 5})},
            {"needle", Moved(BoxCorners({1, 1e-3, 1e-5}), turn)},
            {"turned square", Moved(BoxCorners({1, 1, 0}), turn, {3, 0, 0})},
            {"turned segment", Moved({0, 0, 0, 1, 0, 0, .3, 0, 0}, turn)},
            {"cube", BoxCorners({1, 1, 1})},
            {"point", {3, 4, 5}},
            {"one point, often", {3, 4, 5, 3, 4, 5, 3, 4, 5}},
            {"two points", {0, 0, 0, 1, 2, 3}}};
}

TEST(OrientedBox, HoldsItsPointsInARightHandedFrame) {
    for (const auto& [name, points] : Shapes()) {
        for (BoxKind kind : kKinds) {
            const OrientedBox box = MakeBox(points, kind);
            EXPECT_LE(LargestExcess(box, points), RoundOff(points)) << name << ", " << static_cast<int>(kind);
            EXPECT_TRUE(IsRightHanded(box)) << name;
            for (double length : box.lengths) EXPECT_GE(length, 0) << name;
        }
    }
}

TEST(OrientedBox, PlantedFaultsAreFoundByTheLawsAbove) {
    const Points points = Egg(500);
    for (BoxKind kind : kKinds) {
        const OrientedBox box = MakeBox(points, kind);
        for (std::size_t k = 0; k < 3; ++k) {
            OrientedBox shorter = box, shifted = box;
            shorter.lengths[k] *= 1 - 1e-9;
            EXPECT_GT(LargestExcess(shorter, points), RoundOff(points));
            shifted.corner[k] += 1e-9;
            EXPECT_GT(LargestExcess(shifted, points), RoundOff(points));
        }
        OrientedBox mirrored = box;
        for (double& x : mirrored.axes[1]) x = -x;
        EXPECT_FALSE(IsRightHanded(mirrored));
    }
}

TEST(OrientedBox, NoSideIsLongerThanItsPointsReach) {
    for (const auto& [name, points] : Shapes()) {
        for (BoxKind kind : kKinds) {
            const OrientedBox box = MakeBox(points, kind);
            for (std::size_t k = 0; k < 3; ++k) {
                double least = 1e300, greatest = -1e300;
                for (std::size_t i = 0; i < points.size(); i += 3) {
                    const double t = box.CoordinatesOf(std::span(points).subspan(i).first<3>())[k];
                    least = std::min(least, t);
                    greatest = std::max(greatest, t);
                }
                EXPECT_NEAR(greatest - least, box.lengths[k], RoundOff(points)) << name;
            }
        }
    }
}

TEST(OrientedBox, AxisAlignedIsTheBoundingBoxToTheBit) {
    const Points points = Egg(300);
    const OrientedBox box = MakeBox(points, BoxKind::AxisAligned);
    const Box bounds = BoundingBox(points);
    EXPECT_EQ(box.corner, bounds.low);
    EXPECT_EQ(box.axes, OrientedBox{}.axes);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(box.lengths[static_cast<std::size_t>(k)], bounds.Extent(k));
}

TEST(OrientedBox, MinimumIsNeverLargerThanTheOthers) {
    for (const auto& [name, points] : Shapes()) {
        const double diagonal = BoundingBox(points).Diagonal();
        const double minimum = MakeBox(points, BoxKind::Minimum).Volume();
        for (BoxKind kind : {BoxKind::AxisAligned, BoxKind::Oriented}) {
            // Sides below 1e-10 of the diagonal are taken for that: flat boxes do not compete in rounding.
            EXPECT_LE(minimum, MakeBox(points, kind).Volume() * (1 + 1e-11) + 1e-10 * std::pow(diagonal, 3)) << name;
        }
    }
    EXPECT_LT(MakeBox(Egg(2000), BoxKind::Minimum).Volume(), .999 * MakeBox(Egg(2000), BoxKind::AxisAligned).Volume());
}

TEST(OrientedBox, VolumesOfOrientedAndMinimumStayUnderRotation) {
    const Points egg = Egg(1000);
    for (BoxKind kind : {BoxKind::Oriented, BoxKind::Minimum}) {
        const double volume = MakeBox(egg, kind).Volume();
        for (int i = 1; i < 6; ++i) {
            const Points turned = Moved(egg, Rotation(.7 * i, 1.9 * i, .31 * i));
            EXPECT_NEAR(MakeBox(turned, kind).Volume() / volume, 1, 1e-9) << i;  // 30 bits of 1000 points, averaged
        }
    }
}

TEST(OrientedBox, ATurnedBoxIsFoundExactly) {
    // Points crowd in one corner: principal components are off, the least box is not.
    TestShapes::Random random(3);
    for (const std::array<double, 3>& lengths : {std::array<double, 3>{3, 2, 1}, {1, 1, 1}, {2, 2, 1}, {10, 1, 1}}) {
        for (int i = 0; i < 8; ++i) {
            Points points = BoxCorners(lengths);
            for (int k = 0; k < 300; ++k) points.push_back(.2 * (1 + random.Uniform()));
            const Axes turn = Rotation(3 * random.Uniform(), 3 * random.Uniform(), 3 * random.Uniform());
            const Points turned = Moved(points, turn, {1, 2, 3});
            const double volume = lengths[0] * lengths[1] * lengths[2];
            // The search ends where a turn gains less than a part in 1e12.
            EXPECT_NEAR(MakeBox(turned, BoxKind::Minimum).Volume() / volume, 1, 4e-12) << i;
            // Without the crowd, Oriented finds it as well: by its components, or, equal ones, by the least rectangle.
            const Points corners = Moved(BoxCorners(lengths), turn);
            EXPECT_NEAR(MakeBox(corners, BoxKind::Oriented).Volume() / volume, 1, 1e-8) << i;  // 30 bits
        }
    }
}

TEST(OrientedBox, TheLeastBoxOfARegularTetrahedronIsTheCubeAroundIt) {
    const Points tet = Moved({0, 0, 0, 1, 1, 0, 1, 0, 1, 0, 1, 1}, Rotation(.3, .9, 2));
    EXPECT_NEAR(MakeBox(tet, BoxKind::Minimum).Volume(), 1, 4e-12);
}

TEST(OrientedBox, NoTurnAboutAnAxisMakesTheLeastBoxSmaller) {
    const Points points = Egg(3000);
    const OrientedBox box = MakeBox(points, BoxKind::Minimum);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto u = box.axes[(k + 1) % 3], v = box.axes[(k + 2) % 3];
        for (double angle = -.8; angle < .8; angle += .01) {
            Axes axes{box.axes[k], u, v};
            for (std::size_t c = 0; c < 3; ++c) {
                axes[1][c] = std::cos(angle) * u[c] + std::sin(angle) * v[c];
                axes[2][c] = std::cos(angle) * v[c] - std::sin(angle) * u[c];
            }
            const double volume = MakeBox(Moved(points, axes), BoxKind::AxisAligned).Volume();
            EXPECT_GE(volume, box.Volume() * (1 - 1e-11)) << k << ' ' << angle;
        }
    }
}

TEST(OrientedBox, FlatAndCollinearPointsHaveSidesWithoutLength) {
    for (BoxKind kind : {BoxKind::Oriented, BoxKind::Minimum}) {
        for (const auto& [name, points] : Shapes()) {
            std::array<double, 3> lengths = MakeBox(points, kind).lengths;
            std::sort(lengths.begin(), lengths.end());
            // Flat to 30 bits of the size.
            if (name == "turned square") {
                EXPECT_LT(lengths[0], 1e-8);
                EXPECT_NEAR(lengths[1] * lengths[2], 1, 1e-8);  // a square's components are equal, its least box is not
            } else if (name == "turned segment") {
                EXPECT_LT(lengths[1], 1e-8);
                EXPECT_NEAR(lengths[2], 1, 1e-8);
            } else if (name.find("point") != std::string::npos && name != "two points") {
                EXPECT_EQ(lengths[2], 0) << name;
            }
        }
    }
}

TEST(OrientedBox, NeitherOrderNorThreadsMatterByABit) {
    const Points egg = Egg(40000);
    std::vector<std::array<double, 3>> shuffled(egg.size() / 3);
    for (std::size_t i = 0; i < shuffled.size(); ++i) shuffled[i] = {egg[3 * i], egg[3 * i + 1], egg[3 * i + 2]};
    TestShapes::Random(5).Shuffle(shuffled);
    Points other;
    for (const auto& p : shuffled) other.insert(other.end(), p.begin(), p.end());
    for (BoxKind kind : kKinds) {
        const OrientedBox box = MakeBox(egg, kind);
        const Sdc::ThreadLimit one(1);
        for (const Points* points : {&std::as_const(other), &egg}) {
            const OrientedBox again = MakeBox(*points, kind);
            EXPECT_EQ(box.corner, again.corner);
            EXPECT_EQ(box.axes, again.axes);
            EXPECT_EQ(box.lengths, again.lengths);
        }
    }
}

TEST(OrientedBox, BadPointsAreNamed) {
    const auto message = [](const Points& points) -> std::string {
        try {
            MakeBox(points, BoxKind::Minimum);
        } catch (const InvalidInput& e) {
            return e.what();
        }
        return {};
    };
    EXPECT_THAT(message({}), testing::HasSubstr("there is none"));
    EXPECT_THAT(message({1, 2}), testing::HasSubstr("2 numbers"));
    EXPECT_THAT(message({1, 2, 3, 1, std::nan(""), 2}), testing::HasSubstr("point 1: coordinate 1"));
    EXPECT_THROW(BoxKindOf("ball"), InvalidInput);
    EXPECT_EQ(BoxKindOf("minimum"), BoxKind::Minimum);
}

}  // namespace
}  // namespace SolidSubdiv::Geometry

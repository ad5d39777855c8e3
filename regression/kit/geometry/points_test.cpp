// SPDX-License-Identifier: Apache-2.0
// Boxes around points, and points at the same place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/kit/geometry/coincident_vertices.h>

#include <cmath>

namespace SolidSubdiv::Geometry {
namespace {

TEST(BoundingBox, IsTheLeastAndGreatestCoordinate) {
    const Box box = BoundingBox(std::vector<double>{1, 5, -2, -3, 7, 0, 0, 6, 10});
    EXPECT_THAT(box.low, testing::ElementsAre(-3, 5, -2));
    EXPECT_THAT(box.high, testing::ElementsAre(1, 7, 10));
    EXPECT_EQ(box.Extent(2), 12);
    EXPECT_DOUBLE_EQ(box.Diagonal(), std::sqrt(16.0 + 4.0 + 144.0));
}

TEST(BoundingBox, OfNothingIsEmptyAndOfOnePointIsNot) {
    const Box nothing = BoundingBox({});
    EXPECT_TRUE(nothing.IsEmpty());
    EXPECT_EQ(nothing.Diagonal(), 0);
    const Box point = BoundingBox(std::vector<double>{1, 2, 3});
    EXPECT_FALSE(point.IsEmpty());
    EXPECT_EQ(point.Diagonal(), 0);
}

TEST(CoincidentVertices, AreThoseWithALowerTwin) {
    const std::vector<double> p = {0, 0, 0, 1, 2, 3, 0, 0, 1, 1, 2, 3, -0.0, 0, 0, 1, 2, 3};
    EXPECT_THAT(FindCoincidentVertices(p), testing::ElementsAre(3, 4, 5));
    EXPECT_THAT(FindCoincidentVertices(std::vector<double>{0, 0, 0, 0, 0, 1e-300}), testing::IsEmpty());
}

}  // namespace
}  // namespace SolidSubdiv::Geometry

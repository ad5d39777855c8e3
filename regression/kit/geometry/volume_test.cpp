// SPDX-License-Identifier: Apache-2.0
// Laws of volumes: trilinear values, the map to the world and back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include <solidsubdiv/kit/geometry/volume.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Geometry {
namespace {

/// A turned, sheared, mirrored map.
constexpr AffineMap kMap = {0, -3, 0.5, 10, 2, 0, 0.25, 20, 0, 1, -4, 30};

Volume VolumeOf(const std::array<Offset, 3>& dims, const std::function<double(double, double, double)>& f) {
    Volume volume{dims, {}, kMap};
    for (Offset k = 0; k < dims[2]; ++k) {
        for (Offset j = 0; j < dims[1]; ++j) {
            for (Offset i = 0; i < dims[0]; ++i) {
                volume.values.push_back(f(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)));
            }
        }
    }
    return volume;
}

TEST(Volume, ValueReproducesTrilinearFunctionsBetweenCentres) {
    const auto f = [](double x, double y, double z) { return 1 + 2 * x - 3 * y + z + x * y - 0.5 * x * y * z; };
    const Volume volume = VolumeOf({5, 4, 3}, f);
    for (double z = 0; z <= 2; z += 0.25) {
        for (double y = 0; y <= 3; y += 0.375) {
            // Values up to 31, some ten roundings.
            for (double x = 0; x <= 4; x += 0.3125) EXPECT_NEAR(volume.Value({x, y, z}), f(x, y, z), 1e-13);
        }
    }
}

TEST(Volume, ValueIsExactAtCentresAndKeepsOneLabel) {
    const auto random = [](double x, double y, double z) { return std::sin(100 * x + 10 * y + z); };
    const Volume volume = VolumeOf({4, 3, 2}, random);
    EXPECT_EQ(volume.Value({3, 2, 1}), random(3, 2, 1));
    EXPECT_EQ(volume.Value({1, 0, 1}), random(1, 0, 1));
    EXPECT_EQ(volume.At(2, 1, 0), random(2, 1, 0));
    const Volume label = VolumeOf({4, 3, 2}, [](double, double, double) { return 0.1; });
    EXPECT_EQ(label.Value({1.7, 0.3, 0.9}), 0.1);
}

TEST(Volume, BeyondTheOutermostCentresTheNearestValueHolds) {
    const Volume volume = VolumeOf({4, 3, 2}, [](double x, double y, double z) { return x + 10 * y + 100 * z; });
    EXPECT_EQ(volume.Value({-5, 1, 0}), 10);
    EXPECT_EQ(volume.Value({1e300, -1e300, 7}), 103);
    const Volume one = VolumeOf({1, 1, 1}, [](double, double, double) { return 7; });
    EXPECT_EQ(one.Value({0.5, -0.5, 0}), 7);
}

TEST(AffineMap, InverseUndoesTheMap) {
    const AffineMap inverse = Inverse(kMap);
    const std::array<double, 3> there = Apply(kMap, {1, 2, 3});
    // By hand: 0 - 6 + 1.5 + 10; 2 + 0.75 + 20; 2 - 12 + 30.
    EXPECT_EQ(there, (std::array<double, 3>{5.5, 22.75, 20}));
    const std::array<double, 3> back = Apply(inverse, there);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(back[k], static_cast<double>(k + 1), 1e-14);  // some roundings
}

TEST(AffineMap, FlatMapsAreSingularAtAnyScale) {
    const auto with_steps = [](double x, double y, double z) { return AffineMap{x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0}; };
    EXPECT_FALSE(IsSingular(kMap));
    EXPECT_FALSE(IsSingular(with_steps(1e-9, 1e-9, 1e-9)));
    EXPECT_FALSE(IsSingular(with_steps(1e9, 1e-9, 1)));
    EXPECT_TRUE(IsSingular(with_steps(1, 0, 1)));
    EXPECT_TRUE(IsSingular({1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0}));
    EXPECT_TRUE(IsSingular(with_steps(1, std::numeric_limits<double>::quiet_NaN(), 1)));
    EXPECT_TRUE(IsSingular(with_steps(1, std::numeric_limits<double>::infinity(), 1)));
    EXPECT_THROW(Inverse(with_steps(1, 0, 1)), InvalidInput);
}

TEST(Volume, BoxIsThatOfTheCentresOfItsCorners) {
    const Volume volume = VolumeOf({3, 2, 2}, [](double, double, double) { return 0; });
    const Box box = BoundingBox(volume);
    // By hand from the rows of the map: 10 + {0, -3} + {0, 0.5}; 20 + {0, 4} + {0, 0.25}; 30 + {0, 1} + {0, -4}.
    EXPECT_EQ(box.low, (std::array<double, 3>{7, 20, 26}));
    EXPECT_EQ(box.high, (std::array<double, 3>{10.5, 24.25, 31}));
    EXPECT_EQ(volume.Spacing()[0], 2);
    EXPECT_TRUE(BoundingBox(Volume{}).IsEmpty());
}

TEST(Volume, LabelsAreDistinctIntegersInOrder) {
    Volume volume{{6, 1, 1}, {3, 3, -1, 3, 16777217, 0}, kMap};
    EXPECT_THAT(LabelsOf(volume), testing::ElementsAre(-1, 0, 3, 16777217));
    volume.values[2] = 0.5;
    EXPECT_THAT(LabelsOf(volume), testing::IsEmpty());
}

}  // namespace
}  // namespace SolidSubdiv::Geometry

// SPDX-License-Identifier: Apache-2.0
// Orders are told as they are, and one that is too low is caught.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "validation/fit_orders.h"

namespace SolidSubdiv::Validation {
namespace {

using testing::Contains;
using testing::HasSubstr;

TEST(FitOrdersValidator, CatchesAnOrderThatIsTooLow) {
    Findings good, bad, flat;
    CompareOrders({1, 1. / 16, 1. / 256}, 4, good);
    EXPECT_TRUE(good.Passes(0.01));
    EXPECT_THAT(good.notes, Contains(HasSubstr("order 4.00")));
    CompareOrders({1, 1. / 16, 1. / 128}, 4, bad);
    EXPECT_DOUBLE_EQ(bad.largest_error, 1);
    EXPECT_EQ(bad.where, "from size 1 to the next");
    CompareOrders({1, NAN}, 4, flat);
    EXPECT_FALSE(flat.Passes(10));
}

TEST(FitOrdersValidator, CatchesATorusRefinedAlongOneDirectionAlone) {
    // Rings held at six points around the tube: that error stays.
    Findings stuck, free;
    CompareOrders({TorusError(TorusMesh::Quads, 12, 6), TorusError(TorusMesh::Quads, 24, 6)}, 4, stuck);
    EXPECT_FALSE(stuck.Passes(0.3));
    CompareOrders({TorusError(TorusMesh::Quads, 12, 6), TorusError(TorusMesh::Quads, 24, 12)}, 4, free);
    EXPECT_TRUE(free.Passes(0.3)) << free.largest_error;
}

}  // namespace
}  // namespace SolidSubdiv::Validation

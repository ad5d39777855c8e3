// SPDX-License-Identifier: Apache-2.0
// The conformance suite must catch backends that are wrong, each in one way.
#include <gtest/gtest.h>

#include "osd/conformance.h"

namespace SolidSubdiv::TestOsd {
namespace {

enum class Fault {
    None,
    DropsLastWeight,         ///< of rows longer than one
    DropsWeightsOfLongRows,  ///< beyond 65536: a counter of 16 bits
    IgnoresSourceOffset,
    IgnoresSourceStride,
    IgnoresDestinationStride,
    WritesRangeFromElementZero,
    WritesOneRowMore,
    WritesPadding,
    SkipsEmptyRows,
    ReadsPadding,       ///< with a weight of 0
    SkipsZeroWeights,   ///< and so loses NaN and infinity
    SumsInHalfTheBits,  ///< of the numbers given
    SumsByThreads,      ///< in as many parts as there are threads
    StartsWithRange,    ///< adds what the call's first row has first to all others, when calls start inside
    ReadsBehindTheView,
    ReadsBeforeTheView,
};

/// The plain loop with one fault.
template <class Real, Fault kFault>
void EvalWrongly(const Far::StencilRows<Real>& rows, const BufferView<const Real>& source,
                 const BufferView<Real>& destination, Index begin, Index end) {
    BufferDescriptor from = source.descriptor, to = destination.descriptor;
    if (kFault == Fault::IgnoresSourceOffset) from.offset = 0;
    if (kFault == Fault::IgnoresSourceStride) from.stride = from.length;
    if (kFault == Fault::IgnoresDestinationStride) to.stride = to.length;
    if (kFault == Fault::WritesOneRowMore) end = std::min(end + 1, rows.n_rows());

    for (Index row = begin; row < end; ++row) {
        const Offset first = rows.offsets[row];
        Offset last = rows.offsets[row + 1];
        if (kFault == Fault::DropsLastWeight && last - first > 1) --last;
        if (kFault == Fault::DropsWeightsOfLongRows) last = std::min<Offset>(last, first + 65536);
        if (kFault == Fault::SkipsEmptyRows && first == last) continue;
        const Index place = kFault == Fault::WritesRangeFromElementZero ? row - begin : row;
        Real* const out = destination.data + to.offset + place * static_cast<Offset>(to.stride);
        for (int c = 0; c < to.length; ++c) {
            const auto value = [&](Offset k) {
                return source.data[from.offset + rows.indices[k] * static_cast<Offset>(from.stride) + c];
            };
            Real sum = 0;
            const Offset n_parts = kFault == Fault::SumsByThreads ? Sdc::ThreadCount() : 1;
            for (Offset part = 0; part < n_parts; ++part) {
                Real partial = 0;
                for (Offset k = first + part; k < last; k += n_parts) {
                    if (kFault == Fault::SkipsZeroWeights && rows.weights[k] == 0) continue;
                    partial += rows.weights[k] * value(k);
                    if (kFault == Fault::SumsInHalfTheBits) {  // clears the lower half of the fraction
                        const int bits = std::numeric_limits<Real>::digits / 2;
                        const Real large = std::ldexp(std::abs(partial), bits);
                        volatile Real shifted = partial + large;
                        partial = shifted - large;
                    }
                }
                sum += partial;
            }
            if (kFault == Fault::ReadsPadding && from.stride > from.length && c + 1 == from.length && last > first) {
                sum +=
                    0 * *(&source.data[from.offset + rows.indices[first] * static_cast<Offset>(from.stride) + c] + 1);
            }
            if (kFault == Fault::StartsWithRange && begin % 7 != 0 && row > begin) sum *= Real{1.5};
            out[c] = sum;
        }
        if (kFault == Fault::WritesPadding && to.stride > to.length && row + 1 < end) out[to.length] = 0;
        const Offset view_end = from.offset + (rows.n_sources - 1) * static_cast<Offset>(from.stride) + from.length;
        volatile Real ignored = 0;
        if (kFault == Fault::ReadsBehindTheView) ignored = source.data[view_end];
        if (kFault == Fault::ReadsBeforeTheView) ignored = *(source.data - 1);
        static_cast<void>(ignored);
    }
}

template <Fault kFault>
Osd::Backend Wrong() {
    return {"wrong", &EvalWrongly<float, kFault>, &EvalWrongly<double, kFault>};
}

/// Whether the suite's check of this name finds fault with a backend.
bool Finds(std::string_view check_name, const Osd::Backend& backend) {
    for (const Check& check : kConformance) {
        if (check.name == check_name) return !check.Run(backend).empty();
    }
    ADD_FAILURE() << "there is no check " << check_name;
    return false;
}

TEST(PlantedFaults, NoneMeansNothingIsFound) {
    for (const Check& check : kConformance) EXPECT_EQ(check.Run(Wrong<Fault::None>()), "") << check.name;
}

TEST(PlantedFaults, DroppedWeightsAreCaught) {
    EXPECT_TRUE(Finds("ExactOnWholeNumbers", Wrong<Fault::DropsLastWeight>()));
    EXPECT_TRUE(Finds("RoundsNoMoreThanItsSums", Wrong<Fault::DropsLastWeight>()));
    EXPECT_TRUE(Finds("EmptyAndLongRows", Wrong<Fault::DropsWeightsOfLongRows>()));
    // Nothing else has rows so long: the check earns its place.
    EXPECT_FALSE(Finds("ExactOnWholeNumbers", Wrong<Fault::DropsWeightsOfLongRows>()));
}

TEST(PlantedFaults, WrongPlacesAreCaught) {
    EXPECT_TRUE(Finds("ExactOnWholeNumbers", Wrong<Fault::IgnoresSourceOffset>()));
    EXPECT_TRUE(Finds("ExactOnWholeNumbers", Wrong<Fault::IgnoresSourceStride>()));
    EXPECT_TRUE(Finds("WritesNothingElse", Wrong<Fault::IgnoresDestinationStride>()));
    EXPECT_TRUE(Finds("WritesNothingElse", Wrong<Fault::WritesRangeFromElementZero>()));
    EXPECT_TRUE(Finds("WritesNothingElse", Wrong<Fault::WritesOneRowMore>()));
    EXPECT_FALSE(Finds("ExactOnWholeNumbers", Wrong<Fault::WritesOneRowMore>()));
    EXPECT_TRUE(Finds("WritesNothingElse", Wrong<Fault::WritesPadding>()));
    EXPECT_TRUE(Finds("SharesRecords", Wrong<Fault::WritesPadding>()));
    EXPECT_TRUE(Finds("EmptyAndLongRows", Wrong<Fault::SkipsEmptyRows>()));
    EXPECT_TRUE(Finds("ReadsNothingElse", Wrong<Fault::ReadsPadding>()));
}

TEST(PlantedFaults, WrongSumsAreCaught) {
    EXPECT_TRUE(Finds("NotANumberSpreadsAsInSums", Wrong<Fault::SkipsZeroWeights>()));
    EXPECT_FALSE(Finds("ExactOnWholeNumbers", Wrong<Fault::SkipsZeroWeights>()));
    EXPECT_TRUE(Finds("RoundsNoMoreThanItsSums", Wrong<Fault::SumsInHalfTheBits>()));
    EXPECT_TRUE(Finds("SameBitsForAnyRangeAndAlignment", Wrong<Fault::StartsWithRange>()));
}

TEST(PlantedFaults, SumsThatDependOnThreadsAreCaught) {
    {
        const Sdc::ThreadLimit two(2);
        if (Sdc::ThreadCount() < 2) GTEST_SKIP() << "built without threads";
    }
    EXPECT_TRUE(Finds("SameBitsForAnyNumberOfThreads", Wrong<Fault::SumsByThreads>()));
    EXPECT_FALSE(Finds("RoundsNoMoreThanItsSums", Wrong<Fault::SumsByThreads>()));
}

TEST(PlantedFaultsDeathTest, StepsOutsideTheViewsAreCaught) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_DEATH(StaysInsideItsViews<float>(&EvalWrongly<float, Fault::ReadsBehindTheView>), "");
    EXPECT_DEATH(StaysInsideItsViews<double>(&EvalWrongly<double, Fault::ReadsBeforeTheView>), "");
}

}  // namespace
}  // namespace SolidSubdiv::TestOsd

// SPDX-License-Identifier: Apache-2.0
// The conformance suite must catch backends that are wrong, each in one way.
#include <gmock/gmock.h>
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

/// Names of the checks that find something.
std::vector<std::string> FoundBy(const Osd::Backend& backend) {
    std::vector<std::string> names;
    for (const Check& check : kConformance) {
        if (!check.Run(backend).empty()) names.push_back(check.name);
    }
    return names;
}

using testing::Contains;

TEST(PlantedFaults, NoneMeansNothingIsFound) { EXPECT_THAT(FoundBy(Wrong<Fault::None>()), testing::IsEmpty()); }

TEST(PlantedFaults, DroppedWeightsAreCaught) {
    const auto found = FoundBy(Wrong<Fault::DropsLastWeight>());
    EXPECT_THAT(found, Contains("ExactOnWholeNumbers"));
    EXPECT_THAT(found, Contains("RoundsNoMoreThanItsSums"));
    EXPECT_THAT(FoundBy(Wrong<Fault::DropsWeightsOfLongRows>()), testing::ElementsAre("EmptyAndLongRows"));
}

TEST(PlantedFaults, WrongPlacesAreCaught) {
    EXPECT_THAT(FoundBy(Wrong<Fault::IgnoresSourceOffset>()), Contains("ExactOnWholeNumbers"));
    EXPECT_THAT(FoundBy(Wrong<Fault::IgnoresSourceStride>()), Contains("ExactOnWholeNumbers"));
    EXPECT_THAT(FoundBy(Wrong<Fault::IgnoresDestinationStride>()), Contains("WritesNothingElse"));
    EXPECT_THAT(FoundBy(Wrong<Fault::WritesRangeFromElementZero>()), Contains("WritesNothingElse"));
    EXPECT_THAT(FoundBy(Wrong<Fault::WritesOneRowMore>()), testing::ElementsAre("WritesNothingElse"));
    EXPECT_THAT(FoundBy(Wrong<Fault::WritesPadding>()), Contains("WritesNothingElse"));
    EXPECT_THAT(FoundBy(Wrong<Fault::WritesPadding>()), Contains("SharesRecords"));
    EXPECT_THAT(FoundBy(Wrong<Fault::SkipsEmptyRows>()), Contains("EmptyAndLongRows"));
    EXPECT_THAT(FoundBy(Wrong<Fault::ReadsPadding>()), Contains("ReadsNothingElse"));
}

TEST(PlantedFaults, WrongSumsAreCaught) {
    EXPECT_THAT(FoundBy(Wrong<Fault::SkipsZeroWeights>()), testing::ElementsAre("NotANumberSpreadsAsInSums"));
    EXPECT_THAT(FoundBy(Wrong<Fault::SumsInHalfTheBits>()), Contains("RoundsNoMoreThanItsSums"));
    EXPECT_THAT(FoundBy(Wrong<Fault::StartsWithRange>()), Contains("SameBitsForAnyRangeAndAlignment"));
}

TEST(PlantedFaults, SumsThatDependOnThreadsAreCaught) {
    {
        const Sdc::ThreadLimit two(2);
        if (Sdc::ThreadCount() < 2) GTEST_SKIP() << "built without threads";
    }
    EXPECT_THAT(FoundBy(Wrong<Fault::SumsByThreads>()), testing::ElementsAre("SameBitsForAnyNumberOfThreads"));
}

TEST(PlantedFaultsDeathTest, StepsOutsideTheViewsAreCaught) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_DEATH(StaysInsideItsViews<float>(&EvalWrongly<float, Fault::ReadsBehindTheView>), "");
    EXPECT_DEATH(StaysInsideItsViews<double>(&EvalWrongly<double, Fault::ReadsBeforeTheView>), "");
}

}  // namespace
}  // namespace SolidSubdiv::TestOsd

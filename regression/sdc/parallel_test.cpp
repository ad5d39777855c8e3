// SPDX-License-Identifier: Apache-2.0
// Parallel loops cover every index once and pass exceptions on; running sums are right for any length.
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <solidsubdiv/sdc/parallel.h>

namespace {

using namespace SolidSubdiv;

TEST(ParallelForTest, VisitsEveryIndexOnceWithAnyNumberOfThreads) {
    for (int threads : {1, 2, 5}) {
        const Sdc::ThreadLimit limit(threads);
        for (Offset n : {0, 1, 99, 100, 101, 100000}) {
            std::vector<int> visits(static_cast<std::size_t>(n), 0);
            Sdc::ParallelFor(n, 100, [&](Offset begin, Offset end) {
                for (Offset i = begin; i < end; ++i) ++visits[static_cast<std::size_t>(i)];
            });
            for (int v : visits) ASSERT_EQ(v, 1);
        }
    }
}

TEST(ParallelForTest, RethrowsTheExceptionOfABody) {
    const auto thrower = [](Offset begin, Offset end) {
        for (Offset i = begin; i < end; ++i) {
            if (i == 777) throw std::runtime_error("777");
        }
    };
    EXPECT_THROW(Sdc::ParallelFor(10000, 10, thrower), std::runtime_error);
}

TEST(SerialScopeTest, KeepsLoopsInTheThreadThatStartsThem) {
    const auto own = std::this_thread::get_id();
    const Sdc::SerialScope serial;
    Offset n_visited = 0;
    Sdc::ParallelFor(100000, 1, [&](Offset begin, Offset end) {
        EXPECT_EQ(std::this_thread::get_id(), own);
        n_visited += end - begin;
    });
    EXPECT_EQ(n_visited, 100000);
}

TEST(ThreadLimitTest, HoldsWhileItLives) {
    const Sdc::ThreadLimit outer(1);
    EXPECT_EQ(Sdc::ThreadCount(), 1);
}

TEST(ScanLengthsTest, GivesRunningSums) {
    for (std::size_t n : {0u, 1u, 2u, 65535u, 65536u, 65537u, 200001u}) {
        Array<Offset> offsets(n + 1);
        std::vector<Offset> lengths(n);
        for (std::size_t i = 0; i < n; ++i) lengths[i] = offsets[i] = static_cast<Offset>((i * 7) % 11);
        Offset sum = 0;
        const Offset total = Sdc::ScanLengths(offsets);
        for (std::size_t i = 0; i < n; ++i) {
            ASSERT_EQ(offsets[i], sum);
            sum += lengths[i];
        }
        EXPECT_EQ(offsets[n], sum);
        EXPECT_EQ(total, sum);
    }
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// Counting, grouping and numbering against what standard containers say.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <vector>

#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/vtr/relation.h>
#include <solidsubdiv/vtr/short_map.h>
#include <solidsubdiv/vtr/unique_tuples.h>

#include "test_shapes.h"

namespace SolidSubdiv {
namespace {

TEST(Grouping, InvertListsEveryPartOnceInTheItemsOrder) {
    TestShapes::Random random(1);
    constexpr Index kParts = 40, kItems = 300;
    constexpr int kArity = 3;
    std::vector<Index> parts;
    std::vector<std::vector<Index>> items(kParts);
    std::vector<std::vector<Sdc::Local>> locals(kParts);
    for (Index i = 0; i < kItems; ++i) {
        for (int k = 0; k < kArity; ++k) {
            parts.push_back(random.Below(kParts / 2) * 2);  // every other part has no item
            items[parts.back()].push_back(i);
            locals[parts.back()].push_back(static_cast<Sdc::Local>(k));
        }
    }
    for (int n_threads : {1, 2, 7}) {
        const Sdc::ThreadLimit limit(n_threads);
        const Vtr::Relation r = Vtr::Invert(parts, kArity, kParts, true);
        for (Index p = 0; p < kParts; ++p) {
            const auto mine = r[p];
            const auto my_locals = r.Locals(p);
            EXPECT_EQ(std::vector<Index>(mine.begin(), mine.end()), items[p]);
            EXPECT_EQ(std::vector<Sdc::Local>(my_locals.begin(), my_locals.end()), locals[p]);
        }
    }
    EXPECT_TRUE(Vtr::Invert({}, kArity, kParts, false).empty());
    EXPECT_EQ(Vtr::Invert({}, kArity, kParts, false)[3].size(), 0u);
}

TEST(Grouping, UniqueTuplesAreSortedAndKnowTheirItems) {
    TestShapes::Random random(2);
    constexpr Index kVertices = 12;
    std::vector<std::array<Index, 3>> given(500);
    std::set<std::array<Index, 3>> distinct;
    for (auto& t : given) {
        for (Index& v : t) v = random.Below(kVertices);
        auto sorted = t;
        std::sort(sorted.begin(), sorted.end());
        distinct.insert(sorted);
    }
    for (int n_threads : {1, 3}) {
        const Sdc::ThreadLimit limit(n_threads);
        const Vtr::UniqueTuples<3> unique(kVertices, static_cast<Offset>(given.size()),
                                          [&](Offset i) { return given[i]; });
        ASSERT_EQ(unique.size(), static_cast<Index>(distinct.size()));
        Index id = 0;
        for (const auto& t : distinct) {
            EXPECT_TRUE(std::equal(t.begin(), t.end(), unique.tuples.begin() + 3 * id));
            ++id;
        }
        for (std::size_t i = 0; i < given.size(); ++i) {
            auto sorted = given[i];
            std::sort(sorted.begin(), sorted.end());
            EXPECT_TRUE(std::equal(sorted.begin(), sorted.end(), unique.tuples.begin() + 3 * unique.ids[i]));
        }
    }
}

TEST(Grouping, ShortMapIsAMapUntilItStartsAnew) {
    TestShapes::Random random(3);
    Vtr::ShortMap map;
    for (int round = 0; round < 200; ++round) {
        const std::size_t n = 1 + static_cast<std::size_t>(random.Below(round < 100 ? 30 : 300));
        map.Start(n);
        std::map<Index, Index> expected;
        for (std::size_t i = 0; i < n; ++i) {
            // Keys a power of two apart meet in the same place of a table.
            const Index key = random.Below(64) << (round % 24), value = random.Below(1000);
            EXPECT_EQ(map.Note(key, value), expected.emplace(key, value).first->second);
        }
    }
}

}  // namespace
}  // namespace SolidSubdiv

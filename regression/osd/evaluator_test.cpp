// SPDX-License-Identifier: Apache-2.0
// The driver that all backends share, on tables of real complexes: levels, composites, ranges, and what it refuses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/osd/backends.h>
#include <solidsubdiv/osd/evaluator.h>

#include "far/far_testing.h"
#include "osd/osd_testing.h"

namespace SolidSubdiv::TestOsd {
namespace {

using Far::StencilTableReal;
using Osd::EvaluatorReal;
using testing::HasSubstr;
using testing::ThrowsMessage;

template <class Real>
struct Tables {
    TestShapes::Shape shape;
    StencilTableReal<Real> cascaded, composite;
    std::vector<Real> control;  ///< positions, (n, 3)

    static Tables Of(const TestShapes::Shape& shape, const Sdc::Scheme& scheme, int levels) {
        const auto refiner = TestFar::Refined(shape, levels);
        return {shape,
                StencilTableReal<Real>::Create(refiner, scheme),
                StencilTableReal<Real>::CreateComposite(refiner, scheme, {{.level = levels, .vertices = {}}}),
                {shape.positions.begin(), shape.positions.end()}};
    }
};

/// Every backend, float and double.
template <class Real>
class Evaluation : public testing::Test {
  protected:
    /// Runs for every backend, on every shape that is solid or a surface.
    template <class Function>
    static void ForEach(Function&& function) {
        for (const Osd::Backend& backend : Osd::Backends()) {
            for (const auto& [name, shape] : TestShapes::AllShapes()) {
                SCOPED_TRACE(std::string(backend.name()) + ", " + name);
                const bool is_solid = !shape.tets.empty() || !shape.octs.empty();
                const Sdc::Scheme scheme = is_solid ? Sdc::Scheme(Sdc::BoxSpline{}) : Sdc::Scheme(Sdc::Loop{});
                const auto tables = Tables<Real>::Of(shape, scheme, 2);
                function(backend, tables);
            }
        }
    }

    /// Positions are of size 10 at most, and a row has at most a few hundred weights, most of them positive.
    static constexpr double kTolerance = 10 * 200 * std::numeric_limits<Real>::epsilon();

    static void ExpectNear(const std::vector<Real>& a, const std::vector<double>& b) {
        TestFar::ExpectNear(std::vector<double>(a.begin(), a.end()), b, kTolerance);
    }
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Evaluation, Reals);

TYPED_TEST(Evaluation, LastLevelAgreesWithPlainSumsAndWithTheComposite) {
    TestFixture::ForEach([](const auto& backend, const auto& tables) {
        const auto exact =
            Tables<double>::Of(tables.shape,
                               tables.shape.tets.empty() && tables.shape.octs.empty() ? Sdc::Scheme(Sdc::Loop{})
                                                                                      : Sdc::Scheme(Sdc::BoxSpline{}),
                               2);
        const std::vector<double> truth = TestFar::Apply(exact.cascaded, exact.control);
        for (const auto* table : {&tables.cascaded, &tables.composite}) {
            EvaluatorReal eval(*table, backend);
            ASSERT_EQ(eval.n_refined_vertices(), static_cast<Index>(truth.size() / 3));
            std::vector<TypeParam> refined(truth.size());
            eval.Evaluate(tables.control, refined);
            TestFixture::ExpectNear(refined, truth);
        }
    });
}

TYPED_TEST(Evaluation, AllLevelsEndWithTheLastAndFollowFromEachOther) {
    TestFixture::ForEach([](const auto& backend, const auto& tables) {
        using Real = TypeParam;
        EvaluatorReal eval(tables.cascaded, backend);
        const auto n_first = static_cast<std::size_t>(tables.cascaded.level(1).n_rows()) * 3;
        std::vector<Real> all(static_cast<std::size_t>(eval.n_vertices_of_all_levels()) * 3);
        eval.EvaluateAllLevels(BufferView<const Real>(tables.control, 3), BufferView<Real>(all, 3));

        std::vector<Real> last(static_cast<std::size_t>(eval.n_refined_vertices()) * 3);
        eval.Evaluate(tables.control, last);
        EXPECT_TRUE(SameBits(last, {all.begin() + n_first, all.end()}));

        std::vector<Real> by_ranges(last.size(), kUntouched<Real>);
        const Index n = eval.n_refined_vertices();
        const std::span<const Real> first(all.data(), n_first);
        for (const Index begin : {Index{0}, n / 3}) {
            const Index end = begin == 0 ? n / 3 : n;
            eval.EvaluateRange(2, BufferView<const Real>(first, 3), BufferView<Real>(by_ranges, 3), begin, end);
        }
        EXPECT_TRUE(SameBits(last, by_ranges));
    });
}

/// Six values an element, in records: two copies of the positions give two copies of the result.
TYPED_TEST(Evaluation, WiderDataInRecordsIsEvaluatedValueByValue) {
    TestFixture::ForEach([](const auto& backend, const auto& tables) {
        using Real = TypeParam;
        EvaluatorReal eval(tables.cascaded, backend);
        const BufferDescriptor record{2, 6, 9};
        const auto n_control = static_cast<std::size_t>(tables.shape.n_vertices);
        const auto n = static_cast<std::size_t>(eval.n_refined_vertices());
        std::vector<Real> packed(3 * n), control(2 + 9 * n_control, kNaN<Real>), refined(2 + 9 * n, kUntouched<Real>);
        for (std::size_t i = 0; i < n_control; ++i) {
            for (std::size_t c = 0; c < 6; ++c) control[2 + 9 * i + c] = tables.control[3 * i + c % 3];
        }
        eval.Evaluate(tables.control, packed);
        eval.Evaluate(BufferView<const Real>(control, record), BufferView<Real>(refined, record));
        for (std::size_t i = 0; i < refined.size(); ++i) {
            const std::size_t c = (i + 9 - 2) % 9, row = (i + 9 - 2) / 9 - 1;
            EXPECT_EQ(refined[i], i >= 2 && c < 6 ? packed[3 * row + c % 3] : kUntouched<Real>) << "number " << i;
        }
    });
}

TYPED_TEST(Evaluation, TablesWithoutLevelsOrRowsAreFollowed) {
    using Real = TypeParam;
    for (const Osd::Backend& backend : Osd::Backends()) {
        const auto none = StencilTableReal<Real>::FromRows(2, {});  // no level: the control vertices themselves
        EvaluatorReal copy(none, backend);
        EXPECT_EQ(copy.n_refined_vertices(), 2);
        EXPECT_EQ(copy.n_vertices_of_all_levels(), 0);
        const std::vector<Real> source{1, 2, 3, 4};
        std::vector<Real> destination(4), nothing;
        copy.Evaluate(source, destination, 2);
        EXPECT_EQ(destination, source);
        copy.EvaluateAllLevels(BufferView<const Real>(source, 2), BufferView<Real>(nothing, 2));

        const auto no_rows = StencilTableReal<Real>::FromRows(0, {Far::StencilRows<Real>{}});
        EvaluatorReal empty(no_rows, backend);
        EXPECT_EQ(empty.n_refined_vertices(), 0);
        empty.Evaluate(nothing, nothing);

        const StencilTableReal<Real> made_by_default;
        EvaluatorReal idle(made_by_default, backend);
        EXPECT_EQ(idle.n_refined_vertices(), 0);
        idle.Evaluate(nothing, nothing);
    }
}

/// A tetrahedron split once: 4 control vertices, 10 refined ones.
class Refusals : public testing::Test {
  protected:
    Refusals() : eval_(table_, Osd::Backend::Best()), source_(100), destination_(100) {}

    void Evaluate(BufferView<const double> from, BufferView<double> to) { eval_.Evaluate(from, to); }
    /// Expects that the views are refused, with a text that has `words`.
    void ExpectRefused(BufferView<const double> from, BufferView<double> to, const char* words) {
        EXPECT_THAT([&] { eval_.Evaluate(from, to); }, ThrowsMessage<InvalidInput>(HasSubstr(words)));
    }
    BufferView<const double> From(BufferDescriptor d) const { return {std::span(source_), d}; }
    BufferView<double> To(BufferDescriptor d) { return {std::span(destination_), d}; }

    Far::StencilTable table_ =
        Far::StencilTable::Create(TestFar::Refined(TestShapes::SingleTet(), 1), Sdc::BoxSpline{});
    Osd::Evaluator eval_;
    std::vector<double> source_, destination_;
};

TEST_F(Refusals, ViewsThatFitExactlyAreTaken) {
    source_.resize(7 + 3 * 4 + 3);
    destination_.resize(1 + 9 * 5 + 3);
    EXPECT_NO_THROW(Evaluate(From({7, 3, 4}), To({1, 3, 5})));
}

TEST_F(Refusals, ViewsTooSmallAreRefused) {
    source_.resize(7 + 3 * 4 + 2);
    ExpectRefused(From({7, 3, 4}), To({0, 3, 3}),
                  "the source holds 21 numbers; 4 elements of length 3 from offset 7 with stride 4 need 22");
    source_.resize(100);
    destination_.resize(1 + 9 * 5 + 2);
    ExpectRefused(From({0, 3, 3}), To({1, 3, 5}), "the destination holds 48 numbers");
    ExpectRefused(From({std::numeric_limits<Offset>::max() - 1, 3, 3}), To({0, 3, 3}), "the source holds 100 numbers");
    source_.clear();
    ExpectRefused(From({0, 3, 3}), To({0, 3, 3}), "the source holds 0 numbers");
}

TEST_F(Refusals, ViewsThatMakeNoSenseAreRefused) {
    ExpectRefused(From({0, 0, 3}), To({0, 0, 3}), "length 0");
    ExpectRefused(From({0, 3, 2}), To({0, 3, 3}), "stride 2");
    ExpectRefused(From({-1, 3, 3}), To({0, 3, 3}), "offset -1");
    ExpectRefused(From({0, 3, 3}), To({0, 3, -3}), "stride -3");
    ExpectRefused(From({0, 3, 3}), To({0, 2, 3}), "the source has 3 values an element, the destination 2");
}

TEST_F(Refusals, ViewsThatShareMemoryAreRefused) {
    std::vector<double> array(200);
    const auto refused = [&](BufferDescriptor from, BufferDescriptor to) {
        ExpectRefused({std::span<const double>(array), from}, {std::span(array), to}, "overlap");
    };
    refused({0, 3, 3}, {0, 3, 3});
    refused({0, 3, 3}, {11, 3, 3});  // the source's last number
    refused({30, 3, 3}, {3, 3, 3});  // the destination's last element
    refused({0, 3, 6}, {2, 3, 6});   // records alike, parts that overlap
    refused({0, 3, 6}, {4, 3, 6});   // ... across the record's end
    refused({0, 3, 6}, {3, 3, 7});   // parts that meet further on
    const auto taken = [&](BufferDescriptor from, BufferDescriptor to) {
        EXPECT_NO_THROW(Evaluate({std::span<const double>(array), from}, {std::span(array), to}));
    };
    taken({0, 3, 3}, {12, 3, 3});
    taken({30, 3, 3}, {0, 3, 3});
    taken({0, 3, 6}, {3, 3, 6});
    taken({9, 3, 6}, {0, 3, 6});
}

TEST_F(Refusals, RangesThatAreNotThereAreRefused) {
    const auto refused = [&](int level, Index begin, Index end) {
        EXPECT_THAT(
            [&] {
                eval_.EvaluateRange(level, From({0, 3, 3}), To({0, 3, 3}), begin, end);
            },
            ThrowsMessage<InvalidInput>(HasSubstr("level " + std::to_string(level))));
    };
    refused(0, 0, 1);
    refused(2, 0, 1);
    refused(1, -1, 1);
    refused(1, 3, 2);
    refused(1, 0, 11);
    EXPECT_NO_THROW(eval_.EvaluateRange(1, From({0, 3, 3}), To({0, 3, 3}), 9, 10));
    destination_.resize(3 * 9);
    EXPECT_NO_THROW(eval_.EvaluateRange(1, From({0, 3, 3}), To({0, 3, 3}), 0, 9));
    EXPECT_THAT(
        [&] {
            eval_.EvaluateRange(1, From({0, 3, 3}), To({0, 3, 3}), 9, 10);
        },
        ThrowsMessage<InvalidInput>(HasSubstr("the destination holds 27 numbers")));
}

}  // namespace
}  // namespace SolidSubdiv::TestOsd

// SPDX-License-Identifier: Apache-2.0
// Rows that are grouped by their weights are the rows that they were.
#include <solidsubdiv/apps/deform/deformer.h>
#include <solidsubdiv/apps/deform/internal/grouped_rows.h>
#include <solidsubdiv/osd/backends.h>
#include <solidsubdiv/sdc/parallel.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "apps/deform/deform_testing.h"

namespace SolidSubdiv::Deform {
namespace {

using Internal::GroupedRows;

/// Rows of lists that repeat often, of some that do not, and of twins that differ in a weight's last bit.
Far::StencilRows<double> RowsOfLists(Index n_rows, Index n_sources, int n_lists, std::uint64_t seed) {
    TestShapes::Random random(seed);
    std::vector<std::vector<double>> lists(static_cast<std::size_t>(n_lists));
    for (std::size_t i = 0; i < lists.size(); ++i) {
        lists[i].resize(static_cast<std::size_t>(1 + random.Below(27)));
        for (double& weight : lists[i]) weight = random.Uniform();
        if (i % 3 == 2) {
            lists[i] = lists[i - 1];
            lists[i].back() = std::nextafter(lists[i].back(), 2);
        }
    }
    Far::StencilRows<double> rows;
    rows.n_sources = n_sources;
    for (Index row = 0; row < n_rows; ++row) {
        const auto& list = lists[static_cast<std::size_t>(random.Below(n_lists))];
        for (double weight : list) {
            rows.indices.push_back(random.Below(n_sources));
            rows.weights.push_back(row % 10 == 7 ? random.Uniform() : weight);
        }
        rows.offsets.push_back(static_cast<Offset>(rows.indices.size()));
    }
    return rows;
}

template <class Real>
Far::StencilRows<Real> Converted(const Far::StencilRows<double>& rows) {
    Far::StencilRows<Real> result;
    result.n_sources = rows.n_sources;
    result.offsets = rows.offsets;
    result.indices = rows.indices;
    result.weights.assign(rows.weights.begin(), rows.weights.end());
    return result;
}

template <class Real>
Array<Real> Values(Index n, std::uint64_t seed) {
    TestShapes::Random random(seed);
    Array<Real> values(4 * static_cast<std::size_t>(n));
    for (Real& x : values) x = static_cast<Real>(random.Uniform());
    return values;
}

/// values[numbers[i]] = by_old[i], of four.
template <class Real>
Array<Real> Renumbered(const Array<Real>& by_old, const std::vector<Index>& numbers) {
    Array<Real> values(by_old.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        std::copy_n(&by_old[4 * i], 4, &values[4 * static_cast<std::size_t>(numbers[i])]);
    }
    return values;
}

template <class Real>
void ExpectTheBitsOfOsd(Index n_sources) {
    const auto rows = RowsOfLists(9001, n_sources, 30, 1);
    const auto plain = Converted<Real>(rows);
    const Array<Real> source = Values<Real>(n_sources, 2);
    Array<Real> expected(4 * static_cast<std::size_t>(rows.n_rows()));
    Osd::Backend::Best().eval<Real>()(plain, Osd::BufferView<const Real>(std::span<const Real>(source), 4),
                                      Osd::BufferView<Real>(std::span<Real>(expected), 4), 0, rows.n_rows());

    std::vector<Index> numbers_of_sources(static_cast<std::size_t>(n_sources));  // backwards
    std::iota(numbers_of_sources.rbegin(), numbers_of_sources.rend(), 0);
    for (std::vector<Index> numbers : {std::vector<Index>{}, numbers_of_sources}) {
        const Array<Real> given = numbers.empty() ? source : Renumbered(source, numbers);
        const GroupedRows<Real> grouped(rows, numbers);
        ASSERT_EQ(grouped.n_rows(), rows.n_rows());
        std::vector<Index> sorted = numbers;
        std::sort(sorted.begin(), sorted.end());
        for (Index i = 0; i < rows.n_rows(); ++i) ASSERT_EQ(sorted[static_cast<std::size_t>(i)], i);
        const Array<Real> renumbered = Renumbered(expected, numbers);
        for (int n_threads : {1, 2}) {
            const Sdc::ThreadLimit limit(n_threads);
            Array<Real> sums(expected.size());
            grouped.Eval(given, sums);
            EXPECT_EQ(sums, renumbered) << n_threads;
        }
        for (Index row = 0; row < rows.n_rows(); ++row) {
            Real sum = 0;
            grouped.ForEachTerm(row, [&](Index i, Real weight) {
                const Real product = given[4 * static_cast<std::size_t>(i)] * weight;
                sum += product;
            });
            EXPECT_EQ(sum, renumbered[4 * static_cast<std::size_t>(row)]) << row;
        }
    }
}

TEST(GroupedRows, AreThoseOfOsd_RenumberedToTheBit) {
    for (Index n_sources : {50, 65536, 65537}) {  // the last has numbers of 17 bits
        ExpectTheBitsOfOsd<double>(n_sources);
        ExpectTheBitsOfOsd<float>(n_sources);
    }
}

TEST(GroupedRows, TakeTheIndicesOnly_WhereListsRepeat) {
    Far::StencilRows<double> rows;
    rows.n_sources = 100;
    for (Index row = 0; row < 1000; ++row) {
        for (Index k = 0; k < 8; ++k) {
            rows.indices.push_back((row + k) % 100);
            rows.weights.push_back(0.125);
        }
        rows.offsets.push_back(static_cast<Offset>(rows.indices.size()));
    }
    std::vector<Index> numbers;
    EXPECT_LT(GroupedRows<double>(rows, numbers).Bytes(), 8000 * 2 + 200);  // and one list, one group
    EXPECT_GT(rows.Bytes(), 8000 * 12);
}

TEST(GroupedRows, StayAsTheyWere_WhereNoListRepeats) {
    auto rows = RowsOfLists(500, 100, 500, 3);
    for (std::size_t k = 0; k < rows.weights.size(); ++k) rows.weights[k] = static_cast<double>(k);
    std::vector<Index> numbers;
    EXPECT_EQ(GroupedRows<double>(rows, numbers).Bytes(), rows.Bytes());
    for (Index row = 0; row < rows.n_rows(); ++row) EXPECT_EQ(numbers[static_cast<std::size_t>(row)], row);
}

TEST(Deformers, OfHexahedra_TakeAThirdOfTheCascadesTables) {
    const ControlLattice lattice = LatticeOf(TestShapes::HexBlock(6));
    const auto e = Embedding::Create(lattice.View(), lattice.positions, PointsAround(lattice, 5000, 1), {.levels = 2});
    Offset of_tables = 0;
    for (const auto& level : e.tables().cascade) of_tables += Converted<float>(level).Bytes();
    const DeformerReal<float> deformer(e);
    const Offset of_lattice = deformer.Bytes() - deformer.PointBytes();
    EXPECT_LT(3 * (of_lattice - 16 * Offset{e.tables().n_patch_points()}), of_tables);
    EXPECT_GE(deformer.PointBytes(), 16 * Offset{e.n_points()} - Offset{16} * static_cast<Offset>(e.outside().size()));
}

}  // namespace
}  // namespace SolidSubdiv::Deform

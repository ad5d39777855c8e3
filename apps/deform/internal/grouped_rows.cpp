// SPDX-License-Identifier: Apache-2.0
// Rows are grouped by the bits of their weights; groups are summed four rows at a time.
#include <solidsubdiv/apps/deform/internal/grouped_rows.h>

#include <solidsubdiv/apps/deform/internal/kernels.h>
#include <solidsubdiv/osd/backends.h>
#include <solidsubdiv/sdc/parallel.h>

#include <limits>
#include <string_view>
#include <unordered_map>

#if defined(__x86_64__)
#define SOLIDSUBDIV_HAS_AVX2 1
#endif
// A function for the instructions of its caller.
#define SOLIDSUBDIV_INLINE inline __attribute__((always_inline))

namespace SolidSubdiv::Deform::Internal {

namespace {

constexpr Index kFewestRows = 16;  // of a group: it costs a branch that is not foreseen
constexpr Offset kGrain = 2048;    // rows: some ten microseconds
constexpr int kAtOnce = 4;         // rows

/// For each row its list of weights: lists have the same number where they have the same bits.
std::vector<Index> ListsOf(const Far::StencilRows<double>& rows) {
    std::vector<Index> lists(static_cast<std::size_t>(rows.n_rows()));
    std::unordered_map<std::string_view, Index> known;
    std::string_view last;
    for (Index row = 0; row < rows.n_rows(); ++row) {
        const auto weights = rows.Weights(row);
        const std::string_view bits(reinterpret_cast<const char*>(weights.data()), weights.size_bytes());
        Index& list = lists[static_cast<std::size_t>(row)];
        list = row > 0 && bits == last ? (&list)[-1]
                                       : known.try_emplace(bits, static_cast<Index>(known.size())).first->second;
        last = bits;
    }
    return lists;
}

/// Rows of one group, from the first to sum on.
template <class Real, class Short>
struct Span {
    const Short* indices;
    const Real* weights;
    Index length, n_rows;
};

template <class Vector, int kRows, class Real, class Short>
SOLIDSUBDIV_INLINE void SumBlock(const Span<Real, Short>& rows, Index row, const Real* source, Real* destination) {
    const Short* const indices = rows.indices + Offset{row} * rows.length;
    Vector sums[kRows];
    for (Vector& sum : sums) sum = Vector{};
    for (Index k = 0; k < rows.length; ++k) {
        const Real weight = rows.weights[k];
        for (int i = 0; i < kRows; ++i) {
            Vector x;
            std::memcpy(&x, source + 4 * static_cast<Offset>(indices[i * rows.length + k]), sizeof x);
            sums[i] += x * weight;
        }
    }
    std::memcpy(destination + 4 * Offset{row}, &sums, sizeof sums);
}

template <class Vector, class Real, class Short>
SOLIDSUBDIV_INLINE void SumSpan(const Span<Real, Short>& rows, const Real* source, Real* destination) {
    Index row = 0;
    for (; row + kAtOnce <= rows.n_rows; row += kAtOnce) SumBlock<Vector, kAtOnce>(rows, row, source, destination);
    for (; row < rows.n_rows; ++row) SumBlock<Vector, 1>(rows, row, source, destination);
}

template <class Real, class Short>
void SumBaseline(const Span<Real, Short>& rows, const Real* source, Real* destination) {
    SumSpan<typename Four<Real>::Type>(rows, source, destination);
}

#if SOLIDSUBDIV_HAS_AVX2
template <class Real, class Short>
__attribute__((target("avx2"))) void SumAvx2(const Span<Real, Short>& rows, const Real* source, Real* destination) {
    typedef Real Vector __attribute__((vector_size(4 * sizeof(Real))));
    SumSpan<Vector>(rows, source, destination);
}
#endif

template <class Real, class Short>
auto BestSum() {
#if SOLIDSUBDIV_HAS_AVX2
    if (__builtin_cpu_supports("avx2")) return &SumAvx2<Real, Short>;
#endif
    return &SumBaseline<Real, Short>;
}

}  // namespace

template <class Real>
GroupedRows<Real>::GroupedRows(const Far::StencilRows<double>& rows, std::vector<Index>& numbers) {
    const std::vector<Index> lists = ListsOf(rows);
    std::vector<Index> n_rows_of, group_of;  // of lists
    for (Index list : lists) {
        if (list == static_cast<Index>(n_rows_of.size())) n_rows_of.push_back(0);
        ++n_rows_of[static_cast<std::size_t>(list)];
    }
    group_of.assign(n_rows_of.size(), kNoIndex);
    Offset n_indices = 0;
    for (Index row = 0; row < rows.n_rows(); ++row) {
        const std::size_t list = static_cast<std::size_t>(lists[static_cast<std::size_t>(row)]);
        if (n_rows_of[list] < kFewestRows || group_of[list] != kNoIndex) continue;
        group_of[list] = static_cast<Index>(groups_.size());
        const auto weights = rows.Weights(row);
        groups_.push_back({n_grouped_, n_grouped_, n_indices, static_cast<Index>(weights_.size()),
                           static_cast<Index>(weights.size())});
        n_grouped_ += n_rows_of[list];
        n_indices += Offset{n_rows_of[list]} * groups_.back().length;
        weights_.insert(weights_.end(), weights.begin(), weights.end());
    }

    const auto number = [&](Index source) {
        return numbers.empty() ? source : numbers[static_cast<std::size_t>(source)];
    };
    rest_.n_sources = rows.n_sources;
    std::vector<Index> numbers_of_rows(static_cast<std::size_t>(rows.n_rows()));
    for (Index row = 0; row < rows.n_rows(); ++row) {
        const Index group = group_of[static_cast<std::size_t>(lists[static_cast<std::size_t>(row)])];
        if (group != kNoIndex) {
            numbers_of_rows[static_cast<std::size_t>(row)] = groups_[static_cast<std::size_t>(group)].end++;
            continue;
        }
        numbers_of_rows[static_cast<std::size_t>(row)] = n_rows();
        for (Index source : rows.Indices(row)) rest_.indices.push_back(number(source));
        const auto weights = rows.Weights(row);
        rest_.weights.insert(rest_.weights.end(), weights.begin(), weights.end());
        rest_.offsets.push_back(static_cast<Offset>(rest_.indices.size()));
    }

    const auto fill = [&]<class Short>(Array<Short>& indices) {
        indices.resize(static_cast<std::size_t>(n_indices));
        Sdc::ParallelFor(rows.n_rows(), kGrain, [&](Offset begin, Offset end) {
            for (Index row = static_cast<Index>(begin); row < end; ++row) {
                const Index g = group_of[static_cast<std::size_t>(lists[static_cast<std::size_t>(row)])];
                if (g == kNoIndex) continue;
                const Group& group = groups_[static_cast<std::size_t>(g)];
                Short* to =
                    &indices[group.first_index +
                             Offset{numbers_of_rows[static_cast<std::size_t>(row)] - group.begin} * group.length];
                for (Index source : rows.Indices(row)) *to++ = static_cast<Short>(number(source));
            }
        });
    };
    if (rows.n_sources - 1 <= std::numeric_limits<std::uint16_t>::max()) {
        fill(short_indices_);
    } else {
        fill(indices_);
    }
    numbers = std::move(numbers_of_rows);
}

template <class Real>
void GroupedRows<Real>::Eval(const Array<Real>& source, Array<Real>& destination) const {
    const auto eval = [&]<class Short>(const Array<Short>& indices) {
        const auto sum = BestSum<Real, Short>();
        Sdc::ParallelFor(n_grouped_, kGrain, [&](Offset first, Offset last) {
            for (auto group = GroupOf(static_cast<Index>(first)); first < last; ++group) {
                const Index begin = static_cast<Index>(first);
                first = std::min<Offset>(last, group->end);
                sum({indices.data() + group->first_index + Offset{begin - group->begin} * group->length,
                     weights_.data() + group->first_weight, group->length, static_cast<Index>(first) - begin},
                    source.data(), destination.data() + 4 * Offset{begin});
            }
        });
    };
    if (short_indices_.empty()) {
        eval(indices_);
    } else {
        eval(short_indices_);
    }
    if (rest_.n_rows() == 0) return;
    const std::span<Real> others = std::span(destination).subspan(4 * static_cast<std::size_t>(n_grouped_));
    Osd::Backend::Best().eval<Real>()(rest_, Osd::BufferView<const Real>(std::span<const Real>(source), 4),
                                      Osd::BufferView<Real>(others, 4), 0, rest_.n_rows());
}

template <class Real>
Offset GroupedRows<Real>::Bytes() const {
    return static_cast<Offset>(groups_.size() * sizeof(Group) + indices_.size() * sizeof(Index) +
                               short_indices_.size() * sizeof(std::uint16_t) + weights_.size() * sizeof(Real)) +
           rest_.Bytes();
}

template class GroupedRows<double>;
template class GroupedRows<float>;

}  // namespace SolidSubdiv::Deform::Internal

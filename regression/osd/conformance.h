// SPDX-License-Identifier: Apache-2.0
// The conformance suite: what every backend must do. A check returns what is wrong, or an empty text.
//
// The checks know no backend: they compare with sums computed here, so that they hold the reference to the same laws.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <solidsubdiv/sdc/parallel.h>

#include "osd/osd_testing.h"

namespace SolidSubdiv::TestOsd {

template <class Real>
using Eval = Osd::EvalStencilsFunction<Real>;

/// Lengths of elements, with what lies around them: packed; padded by one; as part of a record.
inline std::vector<std::pair<BufferDescriptor, BufferDescriptor>> Layouts() {
    std::vector<std::pair<BufferDescriptor, BufferDescriptor>> layouts;
    for (int n : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 31, 40}) {
        layouts.push_back({{0, n, n}, {0, n, n}});
        layouts.push_back({{0, n, n + 1}, {1, n, n}});
        layouts.push_back({{5, n, n}, {0, n, n + 1}});
        layouts.push_back({{3, n, n + 6}, {2, n, n + 3}});
    }
    return layouts;
}

/// Sources of 300 rows: some, and so few that a backend may copy them first.
inline constexpr Index kSourceCounts[] = {50, 9};

/// Ranges of 300 rows.
inline std::vector<std::pair<Index, Index>> Ranges() { return {{0, 300}, {0, 1}, {299, 300}, {7, 7}, {41, 213}}; }

/// Whole numbers make exact sums, whatever the order: every value must be right to the last bit.
template <class Real>
std::string ExactOnWholeNumbers(Eval<Real> eval) {
    for (const Index n_sources : kSourceCounts) {
        const auto rows = RandomRows<Real>(n_sources, 300, 1);
        for (const auto& [from, to] : Layouts()) {
            for (const auto& [begin, end] : Ranges()) {
                Trial<Real> trial(rows, from, to, 2);
                trial.Run(eval, begin, end);
                for (Index i = begin; i < end; ++i) {
                    for (int c = 0; c < from.length; ++c) {
                        if (static_cast<long double>(trial.At(i, c)) != trial.Truth(i, c).value)
                            return trial.Text(i, c);
                    }
                }
            }
        }
    }
    return {};
}

/// n products and n - 1 sums, each rounded by at most u of what it is: n u (1 + n u) times the sum of magnitudes; one u
/// more for the truth and for a result rounded from a longer type.
template <class Real>
std::string RoundsNoMoreThanItsSums(Eval<Real> eval) {
    constexpr long double u = std::numeric_limits<Real>::epsilon() / 2;
    for (const Index n_sources : kSourceCounts) {
        const auto rows = RandomRows<Real>(n_sources, 300, 3, false);
        for (const auto& [from, to] : Layouts()) {
            Trial<Real> trial(rows, from, to, 4, false);
            trial.Run(eval);
            for (Index i = 0; i < 300; ++i) {
                const auto n = static_cast<long double>(rows.Indices(i).size());
                for (int c = 0; c < from.length; ++c) {
                    const auto truth = trial.Truth(i, c);
                    const long double error = std::abs(static_cast<long double>(trial.At(i, c)) - truth.value);
                    if (!(error <= (n + 1) * u * truth.magnitude)) return trial.Text(i, c);
                }
            }
        }
    }
    return {};
}

template <class Real>
std::string WritesNothingElse(Eval<Real> eval) {
    for (const Index n_sources : kSourceCounts) {
        const auto rows = RandomRows<Real>(n_sources, 300, 5);
        for (const auto& [from, to] : Layouts()) {
            for (const auto& [begin, end] : Ranges()) {
                Trial<Real> trial(rows, from, to, 6);
                trial.Run(eval, begin, end);
                const Offset at = trial.StrayWrite(begin, end);
                if (at >= 0) return "number " + std::to_string(at) + " of the destination is written: not of the range";
            }
        }
    }
    return {};
}

/// What lies between elements is NaN in every trial; here, elements that no row of the range names are NaN too.
template <class Real>
std::string ReadsNothingElse(Eval<Real> eval) {
    for (const Index n_sources : kSourceCounts) {
        const auto rows = RandomRows<Real>(n_sources, 300, 7);
        for (const auto& [from, to] : Layouts()) {
            Trial<Real> trial(rows, from, to, 8);
            const Index begin = 100, end = 103;
            std::vector<bool> is_named(n_sources);
            for (Offset k = rows.offsets[begin]; k < rows.offsets[end]; ++k) is_named[rows.indices[k]] = true;
            for (Index s = 0; s < n_sources; ++s) {
                for (int c = 0; c < from.length && !is_named[s]; ++c) trial.Source()[s * from.stride + c] = kNaN<Real>;
            }
            trial.Run(eval, begin, end);
            for (Index i = begin; i < end; ++i) {
                for (int c = 0; c < from.length; ++c) {
                    if (std::isnan(trial.At(i, c))) return trial.Text(i, c);
                }
            }
        }
    }
    return {};
}

/// NaN and infinity of one value reach the same value of the rows that name it, a weight of 0 included, and no other.
template <class Real>
std::string NotANumberSpreadsAsInSums(Eval<Real> eval) {
    for (const Index n_sources : kSourceCounts) {
        const auto rows = RandomRows<Real>(n_sources, 300, 9);
        for (const auto& [from, to] : Layouts()) {
            for (const Real poison : {kNaN<Real>, std::numeric_limits<Real>::infinity()}) {
                Trial<Real> trial(rows, from, to, 10);
                trial.Source()[(n_sources - 1) * from.stride + from.length - 1] = poison;
                trial.Source()[n_sources / 3 * from.stride] = poison;
                trial.Run(eval);
                for (Index i = 0; i < 300; ++i) {
                    for (int c = 0; c < from.length; ++c) {
                        const auto truth = static_cast<Real>(trial.Truth(i, c).value);
                        if (trial.At(i, c) != truth && !(std::isnan(truth) && std::isnan(trial.At(i, c)))) {
                            return trial.Text(i, c);
                        }
                    }
                }
            }
        }
    }
    return {};
}

/// Views that end, or begin, where memory does: a step outside ends the program.
template <class Real>
std::string StaysInsideItsViews(Eval<Real> eval) {
    for (const Index n_sources : kSourceCounts) {
        const auto rows = RandomRows<Real>(n_sources, 300, 11);
        for (int length = 1; length <= 40; ++length) {
            Trial<Real> trial(rows, length, 12);
            GuardedArray<Real> source(static_cast<std::size_t>(n_sources * length)),
                destination(static_cast<std::size_t>(300 * length));
            for (const bool at_end : {false, true}) {
                const auto from = at_end ? source.AtEnd() : source.AtStart();
                const auto to = at_end ? destination.AtEnd() : destination.AtStart();
                std::copy(trial.source.begin(), trial.source.begin() + n_sources * length, from.begin());
                eval(rows, BufferView<const Real>(from, length), BufferView<Real>(to, length), 0, 300);
                std::copy(to.begin(), to.end(), trial.destination.begin());
                for (Index i = 0; i < 300; ++i) {
                    if (static_cast<long double>(trial.At(i, 0)) != trial.Truth(i, 0).value) return trial.Text(i, 0);
                }
            }
        }
    }
    return {};
}

/// Rows of no weight give 0; rows of 100,000 give their sum (weights and values of at most 8 keep it exact).
template <class Real>
std::string EmptyAndLongRows(Eval<Real> eval) {
    Far::StencilRows<Real> rows;
    rows.n_sources = 1000;
    Random random(13);
    for (const int length : {0, 100000, 0, 0, 3, 65537, 0}) {
        for (int k = 0; k < length; ++k) {
            rows.indices.push_back(random.Below(1000));
            rows.weights.push_back(static_cast<Real>(random.Below(3) - 1));
        }
        rows.offsets.push_back(static_cast<Offset>(rows.indices.size()));
    }
    for (int length : {1, 2, 3, 4, 7, 16, 20}) {
        Trial<Real> trial(rows, length, 14);
        trial.Run(eval);
        for (Index i = 0; i < rows.n_rows(); ++i) {
            for (int c = 0; c < length; ++c) {
                if (static_cast<long double>(trial.At(i, c)) != trial.Truth(i, c).value) return trial.Text(i, c);
            }
        }
    }
    return {};
}

template <class Real>
std::string SameBitsForAnyNumberOfThreads(Eval<Real> eval) {
    for (int length : {1, 3, 4, 7}) {
        const auto rows = RandomRows<Real>(length == 3 ? 500 : 2500, 10000, 15, false);
        std::vector<Real> first;
        for (int n_threads : {1, 2, 5}) {
            const Sdc::ThreadLimit limit(n_threads);
            Trial<Real> trial(rows, {0, length, length}, {0, length, length}, 16, false);
            trial.Run(eval);
            if (n_threads == 1) first = trial.destination;
            if (!SameBits(first, trial.destination)) {
                return "length " + std::to_string(length) + ": " + std::to_string(n_threads) +
                       " threads give other bits than one";
            }
        }
    }
    return {};
}

/// One call, three calls and a call a row agree, and so does data that begins anywhere in a vector register's width.
template <class Real>
std::string SameBitsForAnyRangeAndAlignment(Eval<Real> eval) {
    for (const Index n_sources : kSourceCounts) {
        const auto rows = RandomRows<Real>(n_sources, 300, 17, false);
        for (int length = 1; length <= 20; ++length) {
            const BufferDescriptor packed{0, length, length};
            Trial<Real> whole(rows, packed, packed, 18, false);
            whole.Run(eval);
            for (const Index step : {1, 113}) {
                Trial<Real> pieces(rows, packed, packed, 18, false);
                for (Index i = 0; i < 300; i += step) pieces.Run(eval, i, std::min(i + step, 300));
                if (!SameBits(whole.destination, pieces.destination))
                    return "ranges of " + std::to_string(step) + " rows";
            }
            for (int shift = 1; shift < 8; ++shift) {
                Trial<Real> shifted(rows, {shift, length, length}, {8 - shift, length, length}, 18, false);
                shifted.Run(eval);
                for (Index i = 0; i < 300; ++i) {
                    for (int c = 0; c < length; ++c) {
                        if (shifted.At(i, c) != whole.At(i, c))
                            return "shifted by " + std::to_string(shift) + ": " + shifted.Text(i, c);
                    }
                }
            }
        }
    }
    return {};
}

/// Source and destination in one array of records, each in its own part of them.
template <class Real>
std::string SharesRecords(Eval<Real> eval) {
    const auto rows = RandomRows<Real>(300, 300, 19);
    for (int length = 1; length <= 16; ++length) {
        const int stride = 2 * length;
        for (const int first : {0, length}) {
            Trial<Real> apart(rows, {first, length, stride}, {length - first, length, stride}, 20);
            std::vector<Real> records(static_cast<std::size_t>(300 * stride) + 1);
            for (Index i = 0; i < 300; ++i)
                std::copy_n(apart.Source() + i * stride, length, records.begin() + i * stride + first);
            apart.Run(eval);
            eval(rows, BufferView<const Real>(records, apart.from), BufferView<Real>(records, apart.to), 0, 300);
            for (Index i = 0; i < 300; ++i) {
                for (int c = 0; c < length; ++c) {
                    if (records[static_cast<std::size_t>(apart.to.offset + i * stride + c)] != apart.At(i, c)) {
                        return "in one array: " + apart.Text(i, c);
                    }
                }
            }
        }
    }
    return {};
}

struct Check {
    const char* name;
    std::string (*run_float)(Eval<float>);
    std::string (*run_double)(Eval<double>);

    std::string Run(const Osd::Backend& backend) const {
        const std::string single = run_float(backend.eval<float>());
        if (!single.empty()) return "float: " + single;
        const std::string twofold = run_double(backend.eval<double>());
        return twofold.empty() ? twofold : "double: " + twofold;
    }
};

/// The suite.
inline constexpr Check kConformance[] = {
#define SOLIDSUBDIV_CHECK(name) \
    { #name, &name < float>, &name < double> }
    SOLIDSUBDIV_CHECK(ExactOnWholeNumbers),
    SOLIDSUBDIV_CHECK(RoundsNoMoreThanItsSums),
    SOLIDSUBDIV_CHECK(WritesNothingElse),
    SOLIDSUBDIV_CHECK(ReadsNothingElse),
    SOLIDSUBDIV_CHECK(NotANumberSpreadsAsInSums),
    SOLIDSUBDIV_CHECK(StaysInsideItsViews),
    SOLIDSUBDIV_CHECK(EmptyAndLongRows),
    SOLIDSUBDIV_CHECK(SameBitsForAnyNumberOfThreads),
    SOLIDSUBDIV_CHECK(SameBitsForAnyRangeAndAlignment),
    SOLIDSUBDIV_CHECK(SharesRecords),
#undef SOLIDSUBDIV_CHECK
};

}  // namespace SolidSubdiv::TestOsd

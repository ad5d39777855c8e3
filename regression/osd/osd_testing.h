// SPDX-License-Identifier: Apache-2.0
// What tests of osd share: random tables, trials that show what a backend reads and writes, memory with guarded ends.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstring>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <solidsubdiv/osd/backend.h>

#include "test_shapes.h"

namespace SolidSubdiv::TestOsd {

using Osd::BufferDescriptor;
using Osd::BufferView;
using TestShapes::Random;

template <class Real>
inline constexpr Real kNaN = std::numeric_limits<Real>::quiet_NaN();

/// What destinations hold before: no result of whole numbers can be equal to it.
template <class Real>
inline constexpr Real kUntouched = static_cast<Real>(-77777.5);

/// Rows of 0 to 12 weights, some of 40. Whole weights of at most 8: with whole values of at most 64, sums are exact
/// in float too, in any order. Otherwise weights are in [-1, 1).
template <class Real>
Far::StencilRows<Real> RandomRows(Index n_sources, Index n_rows, std::uint64_t seed, bool whole = true) {
    Random random(seed);
    Far::StencilRows<Real> rows;
    rows.n_sources = n_sources;
    for (Index i = 0; i < n_rows; ++i) {
        const int length = random.Below(16) == 0 ? 40 : random.Below(13);
        for (int k = 0; k < length; ++k) {
            rows.indices.push_back(random.Below(n_sources));
            rows.weights.push_back(static_cast<Real>(whole ? random.Below(17) - 8 : random.Uniform()));
        }
        rows.offsets.push_back(static_cast<Offset>(rows.indices.size()));
    }
    return rows;
}

/// Numbers that n elements need.
inline std::size_t SizeFor(const BufferDescriptor& d, Offset n) {
    return static_cast<std::size_t>(n == 0 ? d.offset : d.offset + (n - 1) * d.stride + d.length);
}

/// One application of rows: a source whose padding is NaN, a destination full of kUntouched.
template <class Real>
struct Trial {
    const Far::StencilRows<Real>& rows;
    BufferDescriptor from, to;
    std::vector<Real> source, destination;

    Trial(const Far::StencilRows<Real>& r, BufferDescriptor f, BufferDescriptor t, std::uint64_t seed,
          bool whole = true)
        : rows(r), from(f), to(t), source(SizeFor(f, r.n_sources) + 5, kNaN<Real>) {
        Random random(seed);
        for (Index i = 0; i < r.n_sources; ++i) {
            for (int c = 0; c < f.length; ++c) {
                Source()[i * f.stride + c] = static_cast<Real>(whole ? random.Below(129) - 64 : random.Uniform());
            }
        }
        destination.assign(SizeFor(t, r.n_rows()) + 5, kUntouched<Real>);
    }
    Trial(const Far::StencilRows<Real>& r, int length, std::uint64_t seed)
        : Trial(r, {0, length, length}, {0, length, length}, seed) {}

    Real* Source() { return source.data() + from.offset; }
    const Real* Source() const { return source.data() + from.offset; }
    Real At(Index row, int c) const { return destination[static_cast<std::size_t>(to.offset + row * to.stride + c)]; }

    void Run(Osd::EvalStencilsFunction<Real> eval, Index begin, Index end) {
        eval(rows, BufferView<const Real>(source, from), BufferView<Real>(destination, to), begin, end);
    }
    void Run(Osd::EvalStencilsFunction<Real> eval) { Run(eval, 0, rows.n_rows()); }

    /// The sum that belongs at (row, c), and the sum of the terms' magnitudes.
    struct Sum {
        long double value = 0, magnitude = 0;
    };
    Sum Truth(Index row, int c) const {
        Sum sum;
        for (Offset k = rows.offsets[row]; k < rows.offsets[row + 1]; ++k) {
            const long double term =
                static_cast<long double>(rows.weights[k]) * Source()[rows.indices[k] * from.stride + c];
            sum.value += term;
            sum.magnitude += term < 0 ? -term : term;
        }
        return sum;
    }

    /// Where the destination was written though it does not belong to rows [begin, end); -1: nowhere.
    Offset StrayWrite(Index begin, Index end) const {
        for (std::size_t i = 0; i < destination.size(); ++i) {
            const Offset at = static_cast<Offset>(i) - to.offset;
            const bool is_ours =
                at >= 0 && at / to.stride >= begin && at / to.stride < end && at % to.stride < to.length;
            if (!is_ours && destination[i] != kUntouched<Real>) return static_cast<Offset>(i);
        }
        return -1;
    }

    std::string Text(Index row, int c) const {
        return "row " + std::to_string(row) + ", value " + std::to_string(c) + " of " + std::to_string(from.length) +
               ", strides " + std::to_string(from.stride) + " to " + std::to_string(to.stride) + ": " +
               std::to_string(At(row, c)) + " instead of " + std::to_string(static_cast<double>(Truth(row, c).value));
    }
};

template <class Real>
bool SameBits(const std::vector<Real>& a, const std::vector<Real>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Real)) == 0);
}

/// Memory between two pages that nobody may touch: a step outside ends the program.
template <class Real>
class GuardedArray {
  public:
    explicit GuardedArray(std::size_t n) : n_(n), page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))) {
        pages_ = (n * sizeof(Real) + page_ - 1) / page_;
        void* const p = mmap(nullptr, (pages_ + 2) * page_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (p == MAP_FAILED) throw std::runtime_error("mmap failed");
        memory_ = static_cast<char*>(p);
        if (mprotect(memory_ + page_, pages_ * page_, PROT_READ | PROT_WRITE) != 0)
            throw std::runtime_error("mprotect failed");
    }
    ~GuardedArray() { munmap(memory_, (pages_ + 2) * page_); }
    GuardedArray(const GuardedArray&) = delete;
    GuardedArray& operator=(const GuardedArray&) = delete;

    /// n numbers right behind the first guard, or right before the last one.
    std::span<Real> AtStart() { return {reinterpret_cast<Real*>(memory_ + page_), n_}; }
    std::span<Real> AtEnd() { return {reinterpret_cast<Real*>(memory_ + (pages_ + 1) * page_) - n_, n_}; }

  private:
    std::size_t n_, page_, pages_;
    char* memory_;
};

}  // namespace SolidSubdiv::TestOsd

// SPDX-License-Identifier: Apache-2.0
// The only door to threads: a parallel loop over ranges and a running sum, on oneTBB, std::jthread or one thread.
//
// Which one is chosen when the framework is built (SOLIDSUBDIV_THREADS). Every use in the framework writes to places
// that the loop's index alone decides, so results are the same bits for any number of threads.
#pragma once

#include <memory>
#include <span>
#include <type_traits>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Sdc {

/// How many threads a parallel loop uses at the moment.
int ThreadCount();

/// While it lives, parallel loops of this process use at most n_threads threads (at least 1).
class ThreadLimit {
  public:
    explicit ThreadLimit(int n_threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// While it lives, parallel loops that this thread starts run in it alone. For work that others wait for: a thread in
/// the middle of it must not take up a task that waits as well.
class SerialScope {
  public:
    SerialScope();
    ~SerialScope();
    SerialScope(const SerialScope&) = delete;
    SerialScope& operator=(const SerialScope&) = delete;
};

namespace Internal {
using RangeFunction = void (*)(void* context, Offset begin, Offset end);
void ParallelForRanges(Offset n, Offset grain, RangeFunction function, void* context);
}  // namespace Internal

/// Calls body(begin, end) on ranges that cover [0, n) once, in parallel, in no particular order. Ranges are cut at
/// multiples of `grain`, the least amount of work worth a task. The first exception thrown by a body is rethrown.
template <class Body>
void ParallelFor(Offset n, Offset grain, Body&& body) {
    using Plain = std::remove_reference_t<Body>;
    Internal::ParallelForRanges(
        n, grain, [](void* context, Offset begin, Offset end) { (*static_cast<Plain*>(context))(begin, end); },
        const_cast<void*>(static_cast<const void*>(std::addressof(body))));
}

/// Replaces row lengths in offsets[0, n) by their running sums: offsets[i] becomes the start of row i and offsets[n]
/// (any value before) the total, which is returned. The span has n + 1 places.
Offset ScanLengths(std::span<Offset> offsets);

}  // namespace SolidSubdiv::Sdc

// SPDX-License-Identifier: Apache-2.0
// The three ways to run a parallel loop; see parallel.h.
#include <solidsubdiv/sdc/parallel.h>

#include <algorithm>
#include <cassert>

#if defined(SOLIDSUBDIV_THREADS_TBB)
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#elif defined(SOLIDSUBDIV_THREADS_STD)
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#endif

namespace SolidSubdiv::Sdc {

namespace {
thread_local int serial_scopes = 0;  // of this thread
}

SerialScope::SerialScope() { ++serial_scopes; }
SerialScope::~SerialScope() { --serial_scopes; }

#if defined(SOLIDSUBDIV_THREADS_TBB)

int ThreadCount() {
    return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

struct ThreadLimit::State {
    explicit State(std::size_t n) : control(tbb::global_control::max_allowed_parallelism, n) {}
    tbb::global_control control;
};

ThreadLimit::ThreadLimit(int n_threads)
    : state_(std::make_unique<State>(static_cast<std::size_t>(std::max(1, n_threads)))) {}

void Internal::ParallelForRanges(Offset n, Offset grain, RangeFunction function, void* context) {
    if (n <= 0) return;
    const Offset n_chunks = (n + grain - 1) / grain;
    if (n_chunks == 1 || serial_scopes > 0) return function(context, 0, n);
    tbb::parallel_for(tbb::blocked_range<Offset>(0, n_chunks), [&](const tbb::blocked_range<Offset>& chunks) {
        function(context, chunks.begin() * grain, std::min(chunks.end() * grain, n));
    });
}

#elif defined(SOLIDSUBDIV_THREADS_STD)

namespace {
std::atomic<int> thread_limit{0};  // 0: as many as the machine has
}

int ThreadCount() {
    // Asked once: the library looks it up in the system each time.
    static const int n_processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const int limit = thread_limit.load();
    return limit > 0 ? limit : n_processors;
}

struct ThreadLimit::State {
    int before;
};

ThreadLimit::ThreadLimit(int n_threads)
    : state_(std::make_unique<State>(State{thread_limit.exchange(std::max(1, n_threads))})) {}

void Internal::ParallelForRanges(Offset n, Offset grain, RangeFunction function, void* context) {
    if (n <= 0) return;
    const Offset n_chunks = (n + grain - 1) / grain;
    const Offset n_threads = std::min<Offset>(ThreadCount(), n_chunks);
    if (n_threads == 1 || serial_scopes > 0) return function(context, 0, n);

    std::atomic<Offset> next{0};
    std::exception_ptr error;
    std::mutex error_mutex;
    const auto work = [&] {
        try {
            for (Offset chunk = next++; chunk < n_chunks; chunk = next++) {
                function(context, chunk * grain, std::min((chunk + 1) * grain, n));
            }
        } catch (...) {
            const std::lock_guard lock(error_mutex);
            if (!error) error = std::current_exception();
            next = n_chunks;
        }
    };
    {
        std::vector<std::jthread> threads;
        for (Offset t = 1; t < n_threads; ++t) threads.emplace_back(work);
        work();
    }
    if (error) std::rethrow_exception(error);
}

#else

int ThreadCount() { return 1; }

struct ThreadLimit::State {};

ThreadLimit::ThreadLimit(int) {}

void Internal::ParallelForRanges(Offset n, Offset, RangeFunction function, void* context) {
    if (n > 0) function(context, 0, n);
}

#endif

ThreadLimit::~ThreadLimit() {
#if defined(SOLIDSUBDIV_THREADS_STD)
    thread_limit = state_->before;
#endif
}

Offset ScanLengths(std::span<Offset> offsets) {
    assert(!offsets.empty());
    const Offset n = static_cast<Offset>(offsets.size()) - 1;
    constexpr Offset kBlock = 1 << 16;
    const Offset n_blocks = (n + kBlock - 1) / kBlock;
    std::vector<Offset> block_start(static_cast<std::size_t>(n_blocks) + 1, 0);
    ParallelFor(n_blocks, 1, [&](Offset begin, Offset end) {
        for (Offset b = begin; b < end; ++b) {
            Offset sum = 0;
            for (Offset i = b * kBlock; i < std::min((b + 1) * kBlock, n); ++i) sum += offsets[i];
            block_start[b + 1] = sum;
        }
    });
    for (Offset b = 0; b < n_blocks; ++b) block_start[b + 1] += block_start[b];
    ParallelFor(n_blocks, 1, [&](Offset begin, Offset end) {
        for (Offset b = begin; b < end; ++b) {
            Offset sum = block_start[b];
            for (Offset i = b * kBlock; i < std::min((b + 1) * kBlock, n); ++i) sum += std::exchange(offsets[i], sum);
        }
    });
    return offsets[n] = block_start[n_blocks];
}

}  // namespace SolidSubdiv::Sdc

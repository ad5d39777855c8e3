// SPDX-License-Identifier: Apache-2.0
// Asks Linux and glibc.
#include "perf/machine.h"

#include <malloc.h>
#include <sched.h>
#include <sys/utsname.h>
#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <limits>
#include <vector>

#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Perf {

namespace {

/// The processors that the process may use, asked before any thread is pinned.
const std::vector<int>& Processors() {
    static const std::vector<int> processors = [] {
        cpu_set_t set;
        std::vector<int> found;
        sched_getaffinity(0, sizeof set, &set);
        for (int i = 0; i < CPU_SETSIZE; ++i) {
            if (CPU_ISSET(i, &set)) found.push_back(i);
        }
        return found;
    }();
    return processors;
}

}  // namespace

void PinThisThread(int i) {
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(Processors()[static_cast<std::size_t>(i) % Processors().size()], &set);
    sched_setaffinity(0, sizeof set, &set);
}

int ProcessorCount() { return static_cast<int>(Processors().size()); }

struct PinnedThreads::Observer : tbb::task_scheduler_observer {
    Observer() { observe(true); }
    ~Observer() override { observe(false); }
    void on_scheduler_entry(bool) override { PinThisThread(tbb::this_task_arena::current_thread_index()); }
};

PinnedThreads::PinnedThreads() {
    Processors();
    // oneTBB reads how many threads it may have from the first thread's set of processors: before it shrinks.
    tbb::this_task_arena::max_concurrency();
    observer_ = std::make_unique<Observer>();
    PinThisThread(0);
}
PinnedThreads::~PinnedThreads() = default;

MemoryCopy::MemoryCopy() : from_(std::size_t{256} << 20, 'x'), to_(from_.size(), 'y') {}

void MemoryCopy::Run() {
    Sdc::ParallelFor(static_cast<Offset>(from_.size()), 4 << 20, [&](Offset begin, Offset end) {
        std::memcpy(to_.data() + begin, from_.data() + begin, static_cast<std::size_t>(end - begin));
    });
}

double MemoryCopy::Bytes() const { return 2.0 * static_cast<double>(from_.size()); }

namespace {

struct Threshold {
    int option;
    const char* variable;
    int goes_back, is_kept;
};
constexpr Threshold kThresholds[] = {
    {M_MMAP_THRESHOLD, "MALLOC_MMAP_THRESHOLD_", 128 << 10, 128 << 10},  // glibc's start; set, it no longer moves
    {M_MMAP_MAX, "MALLOC_MMAP_MAX_", 65536, 0},
    {M_TRIM_THRESHOLD, "MALLOC_TRIM_THRESHOLD_", 128 << 10, std::numeric_limits<int>::max()},
    {M_TOP_PAD, "MALLOC_TOP_PAD_", 0, 256 << 20},
};

}  // namespace

void SetFreed(Freed freed) {
    for (const Threshold& t : kThresholds) mallopt(t.option, freed == Freed::IsKept ? t.is_kept : t.goes_back);
    if (freed == Freed::GoesBack) malloc_trim(0);
}

std::vector<std::string> EnvironmentOf(Freed freed) {
    std::vector<std::string> variables;
    for (const Threshold& t : kThresholds) {
        variables.push_back(std::string(t.variable) + "=" +
                            std::to_string(freed == Freed::IsKept ? t.is_kept : t.goes_back));
    }
    return variables;
}

double ResidentBytes() {
    malloc_trim(0);
    double total = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> total >> resident;  // pages
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

MachineInfo DescribeMachine() {
    MachineInfo info;
    std::ifstream cpu("/proc/cpuinfo");
    for (std::string line; std::getline(cpu, line) && !line.empty();) {  // of the first processor
        const auto colon = line.find(": ");
        if (colon == std::string::npos) continue;
        const std::string value = line.substr(colon + 2);
        if (line.starts_with("model name")) info.processor = value + info.processor;
        if (line.starts_with("cpu family")) info.processor += ", family " + value;
        if (line.starts_with("model\t")) info.processor += " model " + value;
        if (line.starts_with("cache size")) info.processor += ", L2 " + value;
    }
    utsname name{};
    uname(&name);
    info.system = std::string(name.sysname) + " " + name.release;
    info.compiler = SOLIDSUBDIV_COMPILER;
    info.n_processors = ProcessorCount();
    info.memory_bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    std::ifstream("/proc/loadavg") >> info.load;
    return info;
}

}  // namespace SolidSubdiv::Perf

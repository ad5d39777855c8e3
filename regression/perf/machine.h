// SPDX-License-Identifier: Apache-2.0
// The machine that runs the benchmarks: its processors, its memory's speed, the bytes that the process holds.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Perf {

/// While it lives, thread i of oneTBB stays on the i-th processor that the process may use, and so does the caller.
class PinnedThreads {
  public:
    PinnedThreads();
    ~PinnedThreads();

  private:
    struct Observer;
    std::unique_ptr<Observer> observer_;
};

/// Keeps the calling thread on the i-th processor (modulo their number) that the process could use when it started.
void PinThisThread(int i);

/// Processors that the process may use.
int ProcessorCount();

/// Copies an array much larger than the caches into another.
class MemoryCopy {
  public:
    MemoryCopy();
    void Run();
    /// Read and written in a run.
    double Bytes() const;

  private:
    Array<char> from_, to_;
};

/// What freed memory becomes. Where pages are dear, this decides a race more than what the candidates compute.
enum class Freed {
    GoesBack,  ///< to the system: every run starts with fresh pages, as a program does that refines once
    IsKept     ///< by the process: runs find pages that are there already, and no candidate pays for them
};
void SetFreed(Freed freed);
/// The same for a process to be started: its environment, NAME=VALUE.
std::vector<std::string> EnvironmentOf(Freed freed);

/// Bytes of memory that the process holds at the moment, what it has freed given back first.
double ResidentBytes();

struct MachineInfo {
    std::string processor, system, compiler;
    int n_processors = 0;
    double memory_bytes = 0;
    double load = 0;  ///< how many tasks ran on the machine lately, this one included
};
MachineInfo DescribeMachine();

}  // namespace SolidSubdiv::Perf

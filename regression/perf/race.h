// SPDX-License-Identifier: Apache-2.0
// A race: candidates that take turns in one process, so that what slows the machine down slows all of them.
//
// Google Benchmark runs them, each as often as the others, in an order that is drawn anew each time. A candidate's k-th
// turn is compared with its peer's k-th; what is reported is the median of these ratios. Each race also copies memory,
// on as many threads as its candidates have, so that bytes a second can be told as a share of what the machine does in
// the same minute.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace SolidSubdiv::Perf {

struct Seconds {
    double passed = 0;  ///< on the wall
    double ran = 0;     ///< on a processor
};

struct Candidate {
    std::string name;
    int n_threads = 1;
    std::function<void()> run{};
    std::function<Seconds()> run_apart{};  ///< instead of run: runs in another process and tells how long it took
    int times = 1;                         ///< a turn is so many runs, of short ones; times are those of one run
    double work = 0;                       ///< units done in a run
    std::string unit{};                    ///< of work: "cells"
    std::vector<std::string> peers{};      ///< names of candidates to compare with
    double moved_bytes = 0;                ///< that a run must at least read and write; 0: not counted
    double kept_bytes = 0;                 ///< of memory that the result takes; 0: not counted
    std::function<void()> clear{};         ///< frees the result, after the clock has stopped
};

struct Result {
    Candidate candidate;
    std::vector<double> passed{}, ran{};  ///< seconds, one a turn: on the wall, in the calling thread
    double median_seconds = 0;            ///< ran, of one thread; passed, of more
    std::vector<double> speed_ratios{};   ///< of each peer: median of our work a second over its; above 1 we are faster
    double bandwidth_share = 0;           ///< median of (bytes moved a second) over (bytes copied a second)

    /// The seconds to compare with a candidate of n threads.
    const std::vector<double>& SecondsBeside(int n_threads_of_peer) const {
        return candidate.n_threads == 1 && n_threads_of_peer == 1 ? ran : passed;
    }
};

class Race {
  public:
    explicit Race(std::string name) : name_(std::move(name)) {}

    void Add(Candidate candidate);
    /// Runs every candidate once without a clock (caches, lazy set-up), then `turns` times with one.
    void Run(int turns);

    const std::string& name() const { return name_; }
    const std::vector<Result>& results() const { return results_; }
    /// What the race is about, for the report: sizes, settings.
    std::vector<std::string> notes;

  private:
    const Result* Find(const std::string& name) const;

    std::string name_;
    std::vector<Result> results_;
};

}  // namespace SolidSubdiv::Perf

// SPDX-License-Identifier: Apache-2.0
// Turns by Google Benchmark, and medians of ratios.
#include "perf/race.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include <solidsubdiv/sdc/parallel.h>

#include "perf/machine.h"

namespace SolidSubdiv::Perf {

namespace {

double Median(std::vector<double> v) {
    std::sort(v.begin(), v.end());
    const std::size_t middle = v.size() / 2;
    return v.size() % 2 ? v[middle] : (v[middle - 1] + v[middle]) / 2;
}

/// Counters of what ran in another process.
constexpr const char *kPassed = "passed", *kRan = "ran";

/// One turn.
void TakeTurn(benchmark::State& state, const Candidate& candidate) {
    const Sdc::ThreadLimit limit(candidate.n_threads);
    for (auto unused : state) {
        static_cast<void>(unused);
        if (candidate.run_apart) {
            const Seconds seconds = candidate.run_apart();
            state.counters[kPassed] = seconds.passed;
            state.counters[kRan] = seconds.ran;
        } else {
            for (int i = 0; i < candidate.times; ++i) candidate.run();
        }
        state.PauseTiming();
        if (candidate.clear) candidate.clear();
        state.ResumeTiming();
    }
}

/// Keeps the times of all turns, says nothing.
class Collector : public benchmark::BenchmarkReporter {
  public:
    explicit Collector(std::vector<Result>& results) : results_(results) {}
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.run_type != Run::RT_Iteration) continue;
            Result& result = results_[static_cast<std::size_t>(run.family_index)];
            const bool ran_apart = run.counters.contains(kRan);
            const double times = result.candidate.times;
            result.passed.push_back(ran_apart ? run.counters.at(kPassed).value : run.real_accumulated_time / times);
            result.ran.push_back(ran_apart ? run.counters.at(kRan).value : run.cpu_accumulated_time / times);
        }
    }

  private:
    std::vector<Result>& results_;  // in the order of registration
};

std::string CopyName(int n_threads) { return "copy of memory, " + std::to_string(n_threads) + "T"; }

}  // namespace

void Race::Add(Candidate candidate) { results_.push_back({std::move(candidate)}); }

const Result* Race::Find(const std::string& name) const {
    const auto at =
        std::find_if(results_.begin(), results_.end(), [&](const auto& r) { return r.candidate.name == name; });
    return at == results_.end() ? nullptr : &*at;
}

void Race::Run(int turns) {
    std::set<int> thread_counts;
    for (const Result& r : results_) {
        thread_counts.insert(r.candidate.n_threads);
        for (const std::string& name : r.candidate.peers) {
            const Result* const peer = Find(name);
            if (!peer || peer->candidate.unit != r.candidate.unit) {
                throw std::logic_error(r.candidate.name + " can't be compared with " + name);
            }
        }
    }
    MemoryCopy copy;
    for (int n : thread_counts) {
        Add({.name = CopyName(n), .n_threads = n, .run = [&copy] { copy.Run(); }, .moved_bytes = copy.Bytes()});
    }
    std::string program = "solidsubdiv-bench", interleave = "--benchmark_enable_random_interleaving=true";
    char* arguments[] = {program.data(), interleave.data(), nullptr};
    int n_arguments = 2;
    benchmark::Initialize(&n_arguments, arguments);
    benchmark::ClearRegisteredBenchmarks();
    for (const Result& r : results_) {
        const Sdc::ThreadLimit limit(r.candidate.n_threads);
        r.candidate.run_apart ? static_cast<void>(r.candidate.run_apart()) : r.candidate.run();
        if (r.candidate.clear) r.candidate.clear();
        benchmark::RegisterBenchmark(r.candidate.name.c_str(), TakeTurn, r.candidate)
            ->Iterations(1)
            ->Repetitions(turns);
    }
    Collector collector(results_);
    benchmark::RunSpecifiedBenchmarks(&collector, "all");
    benchmark::ClearRegisteredBenchmarks();
    for (Result& r : results_) {
        const int n_threads = r.candidate.n_threads;
        r.median_seconds = Median(r.SecondsBeside(n_threads));
        for (const std::string& name : r.candidate.peers) {
            const Result& peer = *Find(name);
            const auto& ours = r.SecondsBeside(peer.candidate.n_threads);
            const auto& theirs = peer.SecondsBeside(n_threads);
            std::vector<double> ratios;
            for (std::size_t i = 0; i < ours.size(); ++i) {
                ratios.push_back(theirs[i] / ours[i] * (r.candidate.work / peer.candidate.work));
            }
            r.speed_ratios.push_back(Median(ratios));
        }
        const auto& seconds = r.SecondsBeside(n_threads);
        const auto& copied = Find(CopyName(n_threads))->SecondsBeside(n_threads);
        std::vector<double> shares;
        for (std::size_t i = 0; i < seconds.size(); ++i) {
            shares.push_back(r.candidate.moved_bytes / seconds[i] / (copy.Bytes() / copied[i]));
        }
        r.bandwidth_share = Median(shares);
        r.candidate.run = nullptr;  // and what the closures hold
        r.candidate.run_apart = nullptr;
        r.candidate.clear = nullptr;
    }
}

}  // namespace SolidSubdiv::Perf

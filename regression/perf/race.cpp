// SPDX-License-Identifier: Apache-2.0
// Interleaved rounds and medians of ratios.
#include "perf/race.h"

#include <time.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <stdexcept>

#include <solidsubdiv/sdc/parallel.h>

#include "perf/machine.h"
#include "test_shapes.h"

namespace SolidSubdiv::Perf {

namespace {

double Median(std::vector<double> v) {
    std::sort(v.begin(), v.end());
    const std::size_t middle = v.size() / 2;
    return v.size() % 2 ? v[middle] : (v[middle - 1] + v[middle]) / 2;
}

double Now(clockid_t clock) {
    timespec t{};
    clock_gettime(clock, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void RunOnce(Result& result, bool is_timed) {
    const Candidate& candidate = result.candidate;
    const Sdc::ThreadLimit limit(candidate.n_threads);
    const double passed = Now(CLOCK_MONOTONIC), ran = Now(CLOCK_THREAD_CPUTIME_ID);
    candidate.run();
    if (is_timed) {
        result.ran.push_back(Now(CLOCK_THREAD_CPUTIME_ID) - ran);
        result.passed.push_back(Now(CLOCK_MONOTONIC) - passed);
    }
    if (candidate.clear) candidate.clear();
}

std::string CopyName(int n_threads) { return "copy of memory, " + std::to_string(n_threads) + "T"; }

}  // namespace

void Race::Add(Candidate candidate) { results_.push_back({std::move(candidate)}); }

const Result* Race::Find(const std::string& name) const {
    const auto at =
        std::find_if(results_.begin(), results_.end(), [&](const auto& r) { return r.candidate.name == name; });
    return at == results_.end() ? nullptr : &*at;
}

void Race::Run(int rounds) {
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
    std::vector<std::size_t> order(results_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    TestShapes::Random random(1);
    for (int round = -1; round < rounds; ++round) {  // round -1 warms up
        random.Shuffle(order);
        for (const std::size_t i : order) RunOnce(results_[i], round >= 0);
    }
    for (Result& r : results_) {
        const int n_threads = r.candidate.n_threads;
        r.median_seconds = Median(r.Seconds(n_threads));
        for (const std::string& name : r.candidate.peers) {
            const Result& peer = *Find(name);
            const auto& ours = r.Seconds(peer.candidate.n_threads);
            const auto& theirs = peer.Seconds(n_threads);
            std::vector<double> ratios;
            for (std::size_t i = 0; i < ours.size(); ++i) {
                ratios.push_back(theirs[i] / ours[i] * (r.candidate.work / peer.candidate.work));
            }
            r.speed_ratios.push_back(Median(ratios));
        }
        const auto& seconds = r.Seconds(n_threads);
        const auto& copied = Find(CopyName(n_threads))->Seconds(n_threads);
        std::vector<double> shares;
        for (std::size_t i = 0; i < seconds.size(); ++i) {
            shares.push_back(r.candidate.moved_bytes / seconds[i] / (copy.Bytes() / copied[i]));
        }
        r.bandwidth_share = Median(shares);
        r.candidate.run = nullptr;  // and what the closures hold
        r.candidate.clear = nullptr;
    }
}

}  // namespace SolidSubdiv::Perf

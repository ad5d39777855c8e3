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

double Now(Clock clock) {
    timespec t{};
    clock_gettime(clock == Clock::Wall ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double Seconds(const Candidate& candidate, Clock clock) {
    const Sdc::ThreadLimit limit(candidate.n_threads);
    const double start = Now(clock);
    candidate.run();
    const double seconds = Now(clock) - start;
    if (candidate.clear) candidate.clear();
    return seconds;
}

std::string CopyName(int n_threads) { return "copy of memory, " + std::to_string(n_threads) + "T"; }

}  // namespace

void Race::Add(Candidate candidate) { results_.push_back({std::move(candidate)}); }

const Result* Race::Find(const std::string& name) const {
    const auto at =
        std::find_if(results_.begin(), results_.end(), [&](const auto& r) { return r.candidate.name == name; });
    return at == results_.end() ? nullptr : &*at;
}

void Race::Run(int rounds, Clock clock) {
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
        for (const std::size_t i : order) {
            Result& r = results_[i];
            const double seconds = Seconds(r.candidate, clock);
            if (round >= 0) r.seconds.push_back(seconds);
        }
    }
    for (Result& r : results_) {
        r.median_seconds = Median(r.seconds);
        for (const std::string& name : r.candidate.peers) {
            const Result& peer = *Find(name);
            std::vector<double> ratios;
            for (std::size_t i = 0; i < r.seconds.size(); ++i) {
                ratios.push_back(peer.seconds[i] / r.seconds[i] * (r.candidate.work / peer.candidate.work));
            }
            r.speed_ratios.push_back(Median(ratios));
        }
        const Result& copied = *Find(CopyName(r.candidate.n_threads));
        std::vector<double> shares;
        for (std::size_t i = 0; i < r.seconds.size(); ++i) {
            shares.push_back(r.candidate.moved_bytes / r.seconds[i] / (copy.Bytes() / copied.seconds[i]));
        }
        r.bandwidth_share = Median(shares);
        r.candidate.run = nullptr;  // and what the closures hold
        r.candidate.clear = nullptr;
    }
}

}  // namespace SolidSubdiv::Perf

// SPDX-License-Identifier: Apache-2.0
// What every sub-command shares.
#include <solidsubdiv/apps/cli/common.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

namespace SolidSubdiv::Cli {

namespace {

std::atomic<bool> is_interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "signal handlers may only touch lock-free atomics");

constexpr int kMaxThreads = 4096;

}  // namespace

void AddCommonOptions(CLI::App& command, CommonOptions& options) {
    command.add_option("--json", options.json, "write counts, times and settings as JSON; - is standard output")
        ->option_text("FILE|-");
    command.add_option("--threads", options.threads, "use at most N threads; default: all processors")
        ->option_text("N")
        ->check(CLI::Range(1, kMaxThreads));
    command.add_flag("--quiet", options.quiet, "say nothing but errors");
}

Session::Session(const CommonOptions& options) : options_(options), bar_(!options.quiet) {
    if (options_.threads > 0) limit_ = std::make_unique<Sdc::ThreadLimit>(options_.threads);
    if (wants_json() && options_.json != "-") staged_json_ = outputs_.Stage(options_.json).string();
}

void Session::Print(const std::string& text) {
    if (options_.quiet || options_.json == "-") return;
    bar_.Hide();
    std::fputs((text + "\n").c_str(), stdout);
}

void Session::Note(const std::string& text) {
    if (options_.quiet) return;
    bar_.Hide();
    std::fputs(("solidsubdiv: " + text + "\n").c_str(), stderr);
}

void Session::Stage(std::string_view name) {
    EndStage();
    stage_ = name;
    stage_began_ = Clock::now();
    bar_.Show(name, -1);
}

void Session::EndStage() {
    if (!stage_.empty()) {
        seconds_.emplace_back(stage_, std::chrono::duration<double>(Clock::now() - stage_began_).count());
        stage_.clear();
    }
    bar_.Hide();
    if (IsInterrupted()) throw Cancelled();
}

Progress Session::progress() {
    return [this](std::string_view stage, double fraction) {
        bar_.Show(stage, fraction);
        return !IsInterrupted();
    };
}

Json Session::Seconds() const {
    Json json = Json::object();
    double sum = 0;
    for (const auto& [name, seconds] : seconds_) {
        json[name] = json.value(name, 0.0) + seconds;
        sum += seconds;
    }
    json["sum"] = sum;
    return json;
}

void Session::Finish(const Json& result) {
    EndStage();
    const std::string text =
        wants_json() ? result.dump(2, ' ', false, Json::error_handler_t::replace) + "\n" : std::string();
    if (!staged_json_.empty()) {
        std::ofstream file(staged_json_, std::ios::binary);
        file << text;
        file.close();
        if (!file) throw IoError(options_.json + ": can't be written; is the disk full?");
    }
    outputs_.Commit();
    if (options_.json == "-") std::fputs(text.c_str(), stdout);
    if (std::fflush(stdout) != 0) throw IoError("standard output: can't be written");
}

void CatchInterrupts() {
    struct sigaction action {};
    action.sa_handler = [](int) { is_interrupted = true; };
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool IsInterrupted() { return is_interrupted; }

void ForgetInterrupt() { is_interrupted = false; }

std::string Counted(long long n, std::string_view one, std::string_view many) {
    return std::to_string(n) + " " + std::string(n == 1 ? one : many);
}

std::string Text(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

}  // namespace SolidSubdiv::Cli

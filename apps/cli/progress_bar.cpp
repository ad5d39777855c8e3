// SPDX-License-Identifier: Apache-2.0
// A progress bar on a terminal.
#include <solidsubdiv/apps/cli/progress_bar.h>

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace SolidSubdiv::Cli {

namespace {

constexpr auto kPatience = std::chrono::seconds(1);
constexpr auto kRefresh = std::chrono::milliseconds(200);
constexpr std::size_t kWidth = 30;

}  // namespace

ProgressBar::ProgressBar(bool is_wanted) {
    if (is_wanted && isatty(STDERR_FILENO)) thread_ = std::jthread([this](std::stop_token stop) { Run(stop); });
}

ProgressBar::~ProgressBar() { Hide(); }

void ProgressBar::Show(std::string_view what, double fraction) {
    const std::lock_guard lock(mutex_);
    if (what_.empty()) began_ = std::chrono::steady_clock::now();
    what_ = what;
    fraction_ = std::min(fraction, 1.0);
}

void ProgressBar::Hide() {
    const std::lock_guard lock(mutex_);
    Clear();
    what_.clear();
}

void ProgressBar::Clear() {
    if (is_drawn_) std::fputs("\r\033[K", stderr);
    is_drawn_ = false;
}

void ProgressBar::Run(std::stop_token stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
        changed_.wait_for(lock, stop, kRefresh, [] { return false; });
        const auto elapsed = std::chrono::steady_clock::now() - began_;
        if (stop.stop_requested() || what_.empty() || elapsed < kPatience) continue;
        std::string bar;
        if (fraction_ >= 0) {
            const auto n_full = static_cast<std::size_t>(fraction_ * kWidth);
            bar = "[" + std::string(n_full, '#') + std::string(kWidth - n_full, '.') + "] " +
                  std::to_string(static_cast<int>(100 * fraction_)) + " %  ";
        }
        std::fprintf(stderr, "\r\033[K%s%s  %.0f s", bar.c_str(), what_.c_str(),
                     std::chrono::duration<double>(elapsed).count());
        std::fflush(stderr);
        is_drawn_ = true;
    }
}

}  // namespace SolidSubdiv::Cli

// SPDX-License-Identifier: Apache-2.0
// A progress bar on a terminal, for stages that take over a second. Nothing is drawn where standard error is no
// terminal.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace SolidSubdiv::Cli {

/// Draws from a thread of its own, so that a stage that reports nothing is shown too.
class ProgressBar {
  public:
    explicit ProgressBar(bool is_wanted);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// What is being done, and how much of it, in [0, 1], or less than 0 if that is not known. Drawn after a second.
    void Show(std::string_view what, double fraction);
    /// Clears the line; the next Show begins a new second.
    void Hide();

  private:
    void Run(std::stop_token stop);
    void Clear();

    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::string what_;
    double fraction_ = 0;
    bool is_drawn_ = false;
    std::chrono::steady_clock::time_point began_;
    std::jthread thread_;  // last: ends before what it uses
};

}  // namespace SolidSubdiv::Cli

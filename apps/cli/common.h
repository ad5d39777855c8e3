// SPDX-License-Identifier: Apache-2.0
// What every sub-command shares: its common options, what it says and where, its stages, times, progress and outputs.
//
// Results go to standard output, words about them (notes, progress, errors) to standard error.
#pragma once

#include <chrono>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <solidsubdiv/apps/cli/outputs.h>
#include <solidsubdiv/apps/cli/progress_bar.h>
#include <solidsubdiv/sdc/errors.h>
#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/sdc/progress.h>

namespace CLI {
class App;
}

namespace SolidSubdiv::Cli {

using Json = nlohmann::ordered_json;

/// The command line can't be used (exit status 2, where other errors are 1).
class UsageError : public Error {
  public:
    using Error::Error;
};

struct CommonOptions {
    std::string json;  ///< a file name, "-" for standard output, or empty
    int threads = 0;   ///< 0: as many as the machine has
    bool quiet = false;
};

/// Adds --json, --threads and --quiet to a sub-command. The options must outlive it.
void AddCommonOptions(CLI::App& command, CommonOptions& options);

/// One run of a sub-command.
class Session {
  public:
    explicit Session(const CommonOptions& options);

    /// A result for people; said only if not quiet and standard output is not taken by JSON.
    void Print(const std::string& text);
    /// A word on standard error, said unless quiet.
    void Note(const std::string& text);

    /// Ends the stage before and begins one; its time goes to Seconds(). @throws Cancelled
    void Stage(std::string_view name);
    /// Ends the last stage. @throws Cancelled
    void EndStage();
    /// Progress within a stage; for the library's callbacks.
    Progress progress();
    /// Times of all stages so far.
    Json Seconds() const;

    Outputs& outputs() { return outputs_; }
    bool wants_json() const { return !options_.json.empty(); }

    /// The end of a successful run: puts the JSON where it was asked for and gives every output its name.
    void Finish(const Json& result);

  private:
    using Clock = std::chrono::steady_clock;

    CommonOptions options_;
    Outputs outputs_;
    ProgressBar bar_;
    std::unique_ptr<Sdc::ThreadLimit> limit_;
    std::string staged_json_;
    std::vector<std::pair<std::string, double>> seconds_;
    std::string stage_;
    Clock::time_point stage_began_;
};

/// From now on Ctrl-C (and a polite kill) makes the next report of progress throw Cancelled.
void CatchInterrupts();
bool IsInterrupted();
/// Work goes on, up to the next Ctrl-C: for those who keep what they have found so far.
void ForgetInterrupt();

/// "1 vertex", "3 vertices".
std::string Counted(long long n, std::string_view one, std::string_view many);
/// A number with at most six digits, for people.
std::string Text(double value);

/// Runs a step whose InvalidInput is about a file: its name is put before the text.
template <class Step>
auto About(const std::string& file, Step&& step) {
    try {
        return step();
    } catch (const InvalidInput& error) {
        throw InvalidInput(file + ": " + error.what());
    }
}

}  // namespace SolidSubdiv::Cli

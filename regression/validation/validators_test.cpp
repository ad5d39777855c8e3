// SPDX-License-Identifier: Apache-2.0
// Running validators and the program: what passes, fails and is skipped, and how that is told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>

#include "sanitized.h"
#include "temporary_folder.h"
#include "validation/validators.h"

namespace SolidSubdiv::Validation {
namespace {

namespace fs = std::filesystem;

Validator Fake(Findings (*run)(const Context&)) { return {"fake", "a <fake> \"check\"", 1e-3, "made up", run}; }

Findings OneError(double error) {
    Findings findings;
    findings.Error(error, [] { return "here"; });
    return findings;
}

Status StatusOf(Findings (*run)(const Context&)) {
    const Validator validator = Fake(run);
    return Run(validator, {}).status;
}

TEST(Validators, PassOnlyWhereSomethingWasComparedAndIsWithinTolerance) {
    EXPECT_EQ(StatusOf([](const Context&) { return OneError(1e-3); }), Status::Pass);
    EXPECT_EQ(StatusOf([](const Context&) { return OneError(1.001e-3); }), Status::Fail);
    EXPECT_EQ(StatusOf([](const Context&) { return Findings(); }), Status::Fail);
    EXPECT_EQ(StatusOf([](const Context&) { return OneError(std::numeric_limits<double>::quiet_NaN()); }),
              Status::Fail);
    EXPECT_EQ(StatusOf([](const Context&) {
                  Findings findings = OneError(0);
                  findings.Fault("wrong");
                  return findings;
              }),
              Status::Fail);
}

TEST(Validators, AreSkippedOnlyIfTheirOracleIsMissing) {
    EXPECT_EQ(StatusOf([](const Context&) -> Findings { throw Unavailable{"no oracle"}; }), Status::Skipped);
    EXPECT_EQ(StatusOf([](const Context&) -> Findings { throw std::runtime_error("broken"); }), Status::Fail);
}

TEST(Validators, MergedFindingsKeepTheLargestErrorAndEveryFault) {
    Findings all = OneError(1e-5), worse = OneError(1e-2);
    worse.Fault("wrong");
    worse.skipped.push_back("part");
    all.Merge(worse, "shape");
    all.Merge(OneError(1e-6), "other");
    EXPECT_EQ(all.largest_error, 1e-2);
    EXPECT_EQ(all.where, "shape: here");
    EXPECT_EQ(all.n_compared, 3);
    EXPECT_THAT(all.faults, testing::ElementsAre("shape: wrong"));
    EXPECT_THAT(all.skipped, testing::ElementsAre("shape: part"));
    EXPECT_FALSE(all.Passes(1));
}

TEST(Validators, ReportsEscapeWhatTheyQuote) {
    const Validator validator = Fake([](const Context&) { return OneError(1); });
    const std::vector<Outcome> outcomes = {Validation::Run(validator, {})};
    EXPECT_THAT(JsonOf(outcomes), testing::HasSubstr(R"("checks": "a <fake> \"check\"")"));
    EXPECT_THAT(HtmlOf(outcomes), testing::HasSubstr("a &lt;fake> \"check\""));
    EXPECT_THAT(LineOf(outcomes[0]), testing::AllOf(testing::StartsWith("FAIL"), testing::HasSubstr("at here")));
}

TEST(Validators, NamesAreUniqueAndEveryoneSaysWhatItChecksAndWhyItsTolerance) {
    std::set<std::string_view> names;
    for (const Validator& v : Validators()) {
        EXPECT_TRUE(names.insert(v.name).second) << v.name;
        EXPECT_FALSE(v.checks.empty() || v.tolerance_reason.empty()) << v.name;
        // Fits come near round by round, and orders are measured: what they may miss stands with their reasons.
        const bool is_fit = v.name.starts_with("fit-");
        EXPECT_LE(v.tolerance, v.name == "fit-orders" ? 0.3 : is_fit ? 1e-6 : 1e-9) << v.name;
    }
    EXPECT_GE(names.size(), 7U);
}

class ValidateProgram : public testing::Test {
  protected:
    /// Exit code; what it prints is in `output_`.
    int Call(const std::string& arguments) {
        const fs::path output = folder_ / "output.txt";
        const std::string program = std::string(SOLIDSUBDIV_PROGRAMS) + "/solidsubdiv-validate";
        const int status = std::system(("'" + program + "' " + arguments + " >'" + output.string() + "' 2>&1").c_str());
        std::ostringstream text;
        text << std::ifstream(output).rdbuf();
        output_ = text.str();
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    const TemporaryFolder folder_;
    std::string output_;
};

TEST_F(ValidateProgram, PassesWithAReportAndJson) {
    const fs::path page = folder_ / "page.html";
    ASSERT_EQ(Call("--only counts --json - --report '" + page.string() + "'"), 0) << output_;
    EXPECT_THAT(output_, testing::HasSubstr("\"name\": \"counts\", \"status\": \"PASS\""));
    EXPECT_GT(fs::file_size(page), 500U);
}

TEST_F(ValidateProgram, QuickRunsCompareLessAndSaySo) {
    const auto n_compared = [&](const std::string& how) {
        EXPECT_EQ(Call("--only box-spline-regular --json - " + how), 0) << output_;
        const std::string name = "\"comparisons\": ";
        const std::size_t at = output_.find(name);
        return at == std::string::npos ? 0 : std::stoi(output_.substr(at + name.size()));
    };
    const int n = n_compared("--quick");
    EXPECT_GT(n, 0);
    EXPECT_THAT(output_, testing::HasSubstr("quick: fewer levels"));
    if (!kIsSanitized) {
        EXPECT_LT(n, n_compared("") / 2);
        EXPECT_THAT(output_, testing::Not(testing::HasSubstr("quick: fewer levels")));
    }
}

TEST_F(ValidateProgram, FailsIfAShapeHasAnotherNumberOfCells) {
    fs::copy(SOLIDSUBDIV_SHAPES, folder_ / "shapes", fs::copy_options::recursive);
    const fs::path shapes = folder_ / "shapes" / "validation";
    fs::copy_file(shapes / "lattice_20.vtu", shapes / "lattice_28.vtu", fs::copy_options::overwrite_existing);
    EXPECT_EQ(Call("--only counts --shapes '" + (folder_ / "shapes").string() + "'"), 1);
    EXPECT_THAT(output_, testing::AllOf(testing::StartsWith("FAIL"), testing::HasSubstr("published 7280")));
}

TEST_F(ValidateProgram, FailsInOneLineIfItsShapesAreMissing) {
    EXPECT_EQ(Call("--only counts --shapes '" + folder_.Path().string() + "'"), 1);
    EXPECT_THAT(output_, testing::AllOf(testing::StartsWith("FAIL"), testing::HasSubstr("lattice_28.vtu")));
    EXPECT_EQ(Call("--shapes /no/such/folder"), 1);
    EXPECT_THAT(output_, testing::HasSubstr("there is no such folder"));
}

TEST_F(ValidateProgram, RefusesBadUsage) {
    EXPECT_EQ(Call("--only nothing"), 2);
    EXPECT_THAT(output_, testing::HasSubstr("there is no validator nothing"));
    EXPECT_EQ(Call("--frobnicate"), 2);
    EXPECT_EQ(Call("--report"), 2);
    EXPECT_EQ(Call("--list"), 0);
    for (const Validator& v : Validators()) EXPECT_THAT(output_, testing::HasSubstr(std::string(v.name)));
}

}  // namespace
}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
// Report pages in a browser without a screen: the 3-D view draws, its buttons work, its faults are told.
#include "kit/picture/report_testing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace SolidSubdiv::Picture {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class ReportInBrowser : public testing::Test {
  protected:
    void SetUp() override {
        if (std::system("command -v chromium >/dev/null") != 0) {
            GTEST_SKIP() << "there is no browser (Debian: chromium)";
        }
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    /// The page after its scripts ran: the attributes of its first element, or the whole of it.
    std::string Document(const std::string& page, const std::string& options = {}) const {
        std::ofstream(folder_ / "page.html") << page;
        // --no-sandbox: root has none. SwiftShader draws without a graphics card.
        const std::string command =
            "timeout 120 chromium --headless --no-sandbox --use-angle=swiftshader "
            "--enable-unsafe-swiftshader --window-size=800,900 "
            "--user-data-dir='" +
            (folder_ / "profile").string() + "' " + options + " --dump-dom 'file://" +
            (folder_ / "page.html").string() + "' 2>'" + (folder_ / "messages").string() + "'";
        std::string document;
        std::FILE* pipe = popen(command.c_str(), "r");
        char buffer[4096];
        for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) document.append(buffer, n);
        EXPECT_EQ(pclose(pipe), 0) << std::ifstream(folder_ / "messages").rdbuf();
        return document;
    }
    std::string Attributes(const std::string& page, const std::string& options = {}) const {
        return Between(Document(page, options), "<html", ">");
    }

    /// The page with a script at its end, which runs after the first frame, and then draws another.
    static std::string WithScript(std::string page, const std::string& script) {
        return page.insert(page.rfind("</body>"), "<script>" + script + "report_view.Draw();</script>");
    }

    static std::string Replaced(std::string page, const std::string& from, const std::string& to) {
        const std::size_t at = page.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return page.replace(at, from.size(), to);
    }

    const fs::path folder_ = fs::path(testing::TempDir()) / ("solidsubdiv_report_" + std::to_string(getpid()));
    const ExampleShapes shapes_;
    const std::string page_ = ReportPage(ExampleReport(shapes_));
};

/// 8 * 4^3 triangles of the target, 8 * 4^2 of the fitted sphere, and two for each of the box's 12 lines.
constexpr const char *kAll = "data-triangles=\"664\"", *kWithoutTarget = "data-triangles=\"152\"",
                     *kWithoutFitted = "data-triangles=\"536\"";

TEST_F(ReportInBrowser, ViewDrawsEveryMesh) {
    const std::string document = Document(page_), attributes = Between(document, "<html", ">");
    EXPECT_THAT(attributes, AllOf(HasSubstr("data-view=\"drawn\""), HasSubstr(kAll), HasSubstr("has-view"),
                                  Not(HasSubstr("data-error"))));
    // The box, seen aslant, is as high as the view and nearly as wide as high, and the spheres fill half of it.
    const double covered = std::stod(Between(attributes, "data-covered=\"", "\""));
    EXPECT_GT(covered, 0.1);
    EXPECT_LT(covered, 0.6);
    for (const char* text : {">target</button>", ">fitted</button>", ">lattice</button>", "<span>fitted: height</span>",
                             "<b>-0.9 mm</b><b>0.9 mm</b>", "aria-pressed=\"true\""}) {
        EXPECT_THAT(document, HasSubstr(text));
    }
}

TEST_F(ReportInBrowser, ButtonsShowAndHideAndSlidersFade) {
    const std::string press = "const press = (i) => document.querySelectorAll('.buttons button')[i].click();";
    const std::string fade =
        "const fade = (x) => {const s = document.querySelector('.sliders input');"
        " s.value = x; s.dispatchEvent(new Event('input'));};";
    const auto after = [&](const std::string& script) { return Attributes(WithScript(page_, press + fade + script)); };
    EXPECT_THAT(after("press(0);"), HasSubstr(kWithoutTarget));
    EXPECT_THAT(after("fade(0);"), HasSubstr(kWithoutFitted));
    EXPECT_THAT(after("fade(1);"), HasSubstr(kWithoutTarget));
    EXPECT_THAT(after("press(0); press(1); press(2); press(4);"), HasSubstr(kAll)) << "the fifth resets the view";
}

TEST_F(ReportInBrowser, WithoutWebGlASentenceStandsInPlaceOfTheView) {
    const std::string attributes = Attributes(page_, "--disable-3d-apis");
    EXPECT_THAT(attributes,
                AllOf(HasSubstr("data-view=\"none\""), Not(HasSubstr("has-view")), Not(HasSubstr("data-error"))));
}

TEST_F(ReportInBrowser, TextsDoNotRun) {
    const std::string evil =
        "\"></script><script>document.documentElement.dataset.ran = 1</script>"
        "<img src=x onerror='document.documentElement.dataset.ran = 1'>";
    Report report = ExampleReport(shapes_);
    report.title = report.summary = report.sections[0].title = report.sections[0].rows[0].value = evil;
    report.sections[0].pictures[0].caption = evil;
    for (ReportMesh& mesh : report.meshes) mesh.name = mesh.value_name = mesh.unit = evil;
    EXPECT_THAT(Attributes(ReportPage(report)), AllOf(HasSubstr("data-view=\"drawn\""), Not(HasSubstr("data-ran"))));
    // The same as markup does run.
    EXPECT_THAT(Attributes(Replaced(page_, "A ball in a box.", evil)), HasSubstr("data-ran"));
}

TEST_F(ReportInBrowser, PlantedFaultsAreTold) {
    const auto expect_told = [&](const std::string& from, const std::string& to, const std::string& error) {
        EXPECT_THAT(Attributes(Replaced(page_, from, to)),
                    AllOf(HasSubstr("data-error=\""), HasSubstr(error), Not(HasSubstr("data-view=\"drawn\"")),
                          Not(HasSubstr("has-view"))));
    };
    expect_told("\"positions\":\"", "\"positions\":\"!", "atob");
    expect_told("gl_Position = projectionMatrix * seen", "gl_Position = projectionMatrix * unseen", "shader");
    expect_told("var THREE", "var TWO", "THREE is not defined");
    // A script that can't be read tells nothing, and draws nothing.
    EXPECT_THAT(Attributes(Replaced(page_, "class View {", "class View {{")), Not(HasSubstr("data-view")));
}

}  // namespace
}  // namespace SolidSubdiv::Picture

// SPDX-License-Identifier: Apache-2.0
// Report pages in a browser without a screen: the 3-D view draws, its buttons work, its faults are told.
#include "kit/picture/report_testing.h"
#include "sanitized.h"
#include "temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace SolidSubdiv::Picture {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class ReportInBrowser : public testing::Test {
  protected:
    void SetUp() override {
        if (kIsSanitized) GTEST_SKIP() << "what runs here is the browser, not our code";
        if (std::system("command -v chromium-headless-shell >/dev/null") != 0) {
            GTEST_SKIP() << "there is no browser (Debian: chromium-headless-shell)";
        }
    }

    /// The page after its scripts ran: the attributes of its first element, or the whole of it.
    std::string Document(const std::string& page, const std::string& options = {}) const {
        std::ofstream(folder_ / "page.html") << page;
        // --no-sandbox: root has none. SwiftShader draws without a graphics card.
        const std::string command =
            "timeout 120 chromium-headless-shell --no-sandbox --use-angle=swiftshader "
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

    /// What each of `bodies` of functions returns, run one by one on the view as it is at the start.
    std::vector<std::string> Values(const std::vector<std::string>& bodies) const {
        std::string script =
            "const press = (i) => document.querySelectorAll('.buttons button')[i].click();"
            "const slide = (i, x) => {const s = document.querySelectorAll('.sliders input')[i];"
            " s.value = x; s.dispatchEvent(new Event('input'));};"
            "const type = (key) => report_view.canvas.dispatchEvent(new KeyboardEvent('keydown', {key: key}));"
            "const triangles = () => {report_view.Draw(); return document.documentElement.dataset.triangles;};"
            "const covered = () => report_view.Covered();"
            "const camera = () => report_view.camera.position.toArray().map((x) => x.toFixed(6));"
            "const bodies = [";
        for (const std::string& body : bodies) script += "() => {" + body + "},";
        script += "]; document.documentElement.dataset.values = bodies.map((f) => {press(4); return f();}).join('|');";
        std::string page = page_;
        page.insert(page.rfind("</body>"), "<script>" + script + "</script>");
        std::istringstream text(Between(Attributes(page), "data-values=\"", "\""));
        std::vector<std::string> values;
        for (std::string value; std::getline(text, value, '|');) values.push_back(value);
        EXPECT_EQ(values.size(), bodies.size());
        values.resize(bodies.size(), "0");
        return values;
    }

    static std::string Replaced(std::string page, const std::string& from, const std::string& to) {
        const std::size_t at = page.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return page.replace(at, from.size(), to);
    }

    const TemporaryFolder folder_;
    const ExampleShapes shapes_;
    const std::string page_ = ReportPage(ExampleReport(shapes_));
};

TEST_F(ReportInBrowser, ViewDrawsEveryMesh) {
    const std::string document = Document(page_);
    // 8 * 4^3 triangles of the target, 8 * 4^2 of the fitted sphere, and two for each of the box's 12 lines.
    EXPECT_THAT(Between(document, "<html", ">"),
                AllOf(HasSubstr("data-view=\"drawn\""), HasSubstr("data-triangles=\"664\""), HasSubstr("has-view"),
                      Not(HasSubstr("data-error"))));
    for (const char* text : {">target</button>", ">fitted</button>", ">lattice</button>", "<span>fitted: height</span>",
                             "<b>-0.9 mm</b><b>0.9 mm</b>", "aria-pressed=\"true\""}) {
        EXPECT_THAT(document, HasSubstr(text));
    }
}

TEST_F(ReportInBrowser, ButtonsShowHideAndReset) {
    EXPECT_THAT(Values({"press(0); return triangles();", "press(1); press(2); return triangles();",
                        "press(0); press(1); press(2); press(4); return triangles();"}),
                ElementsAre("152", "512", "664"))
        << "of 512, 128 and 24; the fifth button resets the view";
}

TEST_F(ReportInBrowser, SlidersFadeAndCut) {
    const auto values =
        Values({"slide(0, 0); return triangles();", "slide(0, 1); return triangles();",
                "press(2); slide(0, 0); return covered();", "press(2); slide(0, 0); slide(1, 0.5); return covered();",
                "press(2); slide(0, 0.5); return covered();"});
    EXPECT_EQ(values[0], "536") << "without the fitted sphere";
    EXPECT_EQ(values[1], "152") << "without the target";
    // The target alone, whole and cut in the middle: some of what is cut off shows the inside instead. The spheres are
    // concentric, so half faded they cover the target's pixels less half of its rim.
    const double whole = std::stod(values[2]), cut = std::stod(values[3]), faded = std::stod(values[4]);
    EXPECT_GT(whole, 0.05);
    EXPECT_LT(whole, 0.5);
    EXPECT_LT(cut, 0.95 * whole);
    EXPECT_GT(cut, 0.5 * whole);
    EXPECT_LT(faded, 0.99 * whole);
    EXPECT_GT(faded, 0.85 * whole) << "the smaller one has 0.81 of the larger one's area";
}

TEST_F(ReportInBrowser, KeysTurnAndZoomAndTheButtonResets) {
    const auto cameras =
        Values({"return camera();", "type('ArrowLeft'); return camera();", "type('ArrowUp'); return camera();",
                "type('+'); return camera();", "type('a'); return camera();",
                "type('ArrowLeft'); type('ArrowUp'); type('+'); press(4); return camera();"});
    for (std::size_t i : {1u, 2u, 3u}) EXPECT_NE(cameras[i], cameras[0]) << i;
    for (std::size_t i : {4u, 5u}) EXPECT_EQ(cameras[i], cameras[0]) << i;
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

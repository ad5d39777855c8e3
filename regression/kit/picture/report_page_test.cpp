// SPDX-License-Identifier: Apache-2.0
// Report pages as text: nothing is loaded, texts stay texts, numbers can be read back. See also
// report_browser_test.cpp.
#include "kit/picture/report_testing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/kit/picture/internal/markup.h>
#include <solidsubdiv/kit/picture/internal/report_assets.h>
#include <solidsubdiv/sdc/errors.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>

namespace SolidSubdiv::Picture {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::size_t Count(std::string_view text, std::string_view word) {
    std::size_t n = 0;
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) ++n;
    return n;
}

/// Places of a page that make a browser load something, each as a few characters.
std::vector<std::string> Loads(std::string_view page) {
    std::vector<std::string> found;
    const auto add = [&](std::string_view word, auto&& is_harmless) {
        for (std::size_t at = page.find(word); at != std::string_view::npos; at = page.find(word, at + 1)) {
            if (!is_harmless(page.substr(at + word.size()))) found.emplace_back(page.substr(at, word.size() + 12));
        }
    };
    const auto never = [](std::string_view) { return false; };
    // Names of languages look like addresses, and nobody goes there.
    const auto is_namespace = [](std::string_view rest) { return rest.starts_with("www.w3.org/"); };
    const auto is_data = [](std::string_view rest) { return rest.starts_with("data:"); };
    add("http://", is_namespace), add("https://", never);
    add(" src=\"", is_data), add(" src='", never), add(" href=", never), add("<link", never);
    add("@import", never), add("import(", never), add("url(", never);
    add("fetch(", never), add("XMLHttpRequest", never), add("WebSocket", never), add("sendBeacon", never);
    return found;
}

std::string ErrorOf(const Report& report) {
    try {
        ReportPage(report);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "no InvalidInput";
}

/// Numbers of an array of the page's `mesh`-th mesh.
template <class T>
std::vector<T> Array(const std::string& page, std::size_t mesh, const std::string& name) {
    std::size_t start = 0;
    for (std::size_t i = 0; i <= mesh; ++i) start = page.find("{\"name\":", start + 1);
    const std::vector<std::uint8_t> bytes = FromBase64(Between(page, "\"" + name + "\":\"", "\"", start));
    std::vector<T> numbers(bytes.size() / sizeof(T));
    // The tests' machines are little endian.
    if (!bytes.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size());
    return numbers;
}

TEST(ReportPage, LoadsNothing) {
    const ExampleShapes shapes;
    const std::string page = ReportPage(ExampleReport(shapes));
    EXPECT_THAT(Loads(page), IsEmpty());
    EXPECT_THAT(page, HasSubstr("default-src 'none'"));
}

TEST(ReportPage, PlantedLoadsAreCaught) {
    for (const char* load : {"<img src=\"a.png\">", "<img src='a.png'>", "<script src=\"http://a.org/b.js\">",
                             "<a href=\"b\">", "<link rel=", "@import 'a.css'", "background: url(a.png)", "fetch('a')",
                             "import('a')", "new WebSocket(", "https://a.org"}) {
        EXPECT_THAT(Loads(load), Not(IsEmpty())) << load;
    }
    EXPECT_THAT(Loads("<img src=\"data:image/png;base64,\"> http://www.w3.org/1999/xhtml"), IsEmpty());
}

TEST(ReportPage, TextsAreNeverMarkup) {
    const std::string evil = "</script><script>\"'&\\\n";
    const ExampleShapes shapes;
    const std::string harmless = ReportPage(ExampleReport(shapes));
    Report report = ExampleReport(shapes);
    for (std::string* text : {&report.title, &report.summary}) *text = evil;
    for (ReportMesh& mesh : report.meshes) mesh.name = mesh.value_name = mesh.unit = evil;
    ReportSection& section = report.sections[0];
    for (std::string* text : {&section.title, &section.text, &section.rows[0].name, &section.rows[0].value,
                              &section.pictures[0].caption, &section.plots[0].caption}) {
        *text = evil;
    }
    section.plots[0].svg = "<svg>" + evil + "</svg>";
    const std::string page = ReportPage(report);
    for (const char* tag : {"<script", "</script", "<img", "<section", "<td>"}) {
        EXPECT_EQ(Count(page, tag), Count(harmless, tag)) << tag;
    }
    EXPECT_THAT(page, HasSubstr("<h1>&lt;/script&gt;&lt;script&gt;&quot;&#39;&amp;"));
    EXPECT_EQ(Count(page, R"("\u003c/script>\u003cscript>\u0022'&\u005c\u000a")"), 9u) << "three texts of three meshes";
}

TEST(ReportPage, NumbersAreReadBack) {
    const ExampleShapes shapes;
    const std::string page = ReportPage(ExampleReport(shapes));
    const auto check = [&](std::size_t mesh, const std::vector<double>& positions, const std::vector<Index>& triangles,
                           const std::vector<Index>& lines) {
        const auto read = Array<float>(page, mesh, "positions");
        ASSERT_EQ(read.size(), positions.size());
        // The largest mesh is the box, from -1.2 to 1.2: the middle is 0 and half the diagonal 1.2 sqrt(3). A float has
        // 24 bits.
        for (std::size_t i = 0; i < read.size(); ++i) {
            EXPECT_NEAR(1.2 * std::sqrt(3.0) * static_cast<double>(read[i]), positions[i], std::ldexp(2.1, -24));
        }
        EXPECT_EQ(Array<Index>(page, mesh, "triangles"), triangles);
        EXPECT_EQ(Array<Index>(page, mesh, "lines"), lines);
    };
    check(0, shapes.target.positions, shapes.target.triangles, {});
    check(1, shapes.fitted.positions, shapes.fitted.triangles, {});
    check(2, shapes.corners, {}, shapes.edges);
    EXPECT_THAT(Array<float>(page, 0, "values"), IsEmpty());
    EXPECT_EQ(Array<float>(page, 1, "values"), std::vector<float>(shapes.heights.begin(), shapes.heights.end()));
    EXPECT_THAT(page, HasSubstr("\"low\":-0.9,\"high\":0.9")) << "a sphere of radius 0.9";
}

TEST(ReportPage, FarPlacesAndTinyUnitsLoseNoDigits) {
    const ExampleShapes shapes;
    const auto near = Array<float>(ReportPage(ExampleReport(shapes)), 0, "positions");
    for (const auto& [unit, place] : {std::pair{1e-9, 0.0}, {1e9, 0.0}, {1.0, 1e6}, {1e-300, 0.0}, {1e300, 0.0}}) {
        ExampleShapes moved = shapes;
        for (std::vector<double>* positions : {&moved.target.positions, &moved.fitted.positions, &moved.corners}) {
            for (double& x : *positions) x = x * unit + place;
        }
        const auto far = Array<float>(ReportPage(ExampleReport(moved)), 0, "positions");
        ASSERT_EQ(far.size(), near.size());
        for (std::size_t i = 0; i < far.size(); ++i) {
            // At 1e6 doubles are 1e-10 apart, which is less than a float's last bit.
            EXPECT_NEAR(far[i], near[i], std::ldexp(1, -23)) << unit << " " << place;
        }
    }
}

TEST(ReportPage, PicturesAndPlotsAreReadBack) {
    const ExampleShapes shapes;
    const Report report = ExampleReport(shapes);
    const std::string page = ReportPage(report);
    EXPECT_EQ(FromBase64(Between(page, "data:image/png;base64,", "\"")), report.sections[0].pictures[0].png);
    const std::string& svg = report.sections[0].plots[0].svg;
    EXPECT_EQ(FromBase64(Between(page, "data:image/svg+xml;base64,", "\"")),
              std::vector<std::uint8_t>(svg.begin(), svg.end()));
}

TEST(ReportPage, HasEveryWordOnceAndOnlyWhatItNeeds) {
    const ExampleShapes shapes;
    Report report = ExampleReport(shapes);
    const std::string page = ReportPage(report);
    for (const char* text : {"<title>ball</title>", "<h1>ball</h1>", "<p>A ball in a box.</p>", "<h2>Errors</h2>",
                             "<p>All of them.</p>", "<th scope=\"row\">largest</th><td>0.1 mm</td>",
                             "<figcaption>a red square</figcaption>", "<figcaption>a plot</figcaption>"}) {
        EXPECT_EQ(Count(page, text), 1u) << text;
    }
    EXPECT_THAT(page, HasSubstr("Permission is hereby granted")) << "three.js's license comes with it";
    report.meshes.clear();
    const std::string bare = ReportPage(report);
    EXPECT_THAT(bare, Not(HasSubstr("<script")));
    EXPECT_THAT(bare, Not(HasSubstr("<canvas")));
    EXPECT_LT(bare.size(), 10000u) << "a style of about 4 kB and these few texts";
}

TEST(ReportPage, HasTheSizeThatItsHeaderSays) {
    const ExampleShapes shapes;
    Report report = ExampleReport(shapes);
    report.meshes.resize(1);
    const std::size_t with_one = ReportPage(report).size();
    report.meshes.push_back(report.meshes[0]);
    const std::size_t vertices = shapes.target.positions.size() / 3, triangles = shapes.target.triangles.size() / 3;
    // Names and other fields of a mesh take less than 300 characters; at the ends of Base64 there may be 2 more.
    EXPECT_NEAR(static_cast<double>(ReportPage(report).size() - with_one),
                static_cast<double>(16 * vertices + 16 * triangles), 300);
    EXPECT_LT(with_one, 450000u);
}

TEST(ReportPage, CompiledFilesAreTheFilesOfTheTree) {
    using namespace Internal;
    const std::string folder = std::string(SOLIDSUBDIV_SOURCE) + "/kit/picture/";
    for (const auto& [pieces, path] : {std::pair{kThreeScript, "three/three.min.js"},
                                       {kViewScript, "report_view.js"},
                                       {kPageStyle, "report_page.css"}}) {
        std::string compiled;
        for (const std::string_view piece : pieces) compiled += piece;
        std::ifstream file(folder + path, std::ios::binary);
        EXPECT_TRUE(compiled == std::string(std::istreambuf_iterator<char>(file), {})) << path;
        EXPECT_THAT(compiled, Not(HasSubstr("</script"))) << path;
    }
}

TEST(ReportPage, RefusesWhatItCannotShow) {
    const ExampleShapes shapes;
    const Report good = ExampleReport(shapes);
    const auto refused = [&](auto&& change) {
        Report report = good;
        change(report);
        return ErrorOf(report);
    };
    const std::vector<double> bad_positions = {0, 0, 0, 1, std::numeric_limits<double>::infinity(), 0};
    const std::vector<double> huge = {1.7e308, 1.7e308, 1.7e308, -1.7e308, -1.7e308, -1.7e308};
    const std::vector<Index> bad_triangles = {0, 1, 2, 0, 1, 8}, line = {0, 1}, negative = {0, 1, 0, -1};
    EXPECT_THAT(refused([&](Report& r) { r.meshes[2].positions = bad_positions; }),
                HasSubstr("mesh 'lattice': vertex 1 is at inf"));
    EXPECT_THAT(refused([&](Report& r) { r.meshes[2].positions = std::span(shapes.corners).first(23); }),
                HasSubstr("mesh 'lattice' has 23 coordinates"));
    EXPECT_THAT(refused([&](Report& r) { r.meshes[2].triangles = bad_triangles; }),
                HasSubstr("mesh 'lattice': triangle 1 has vertex 8; there are 8"));
    EXPECT_THAT(refused([&](Report& r) { r.meshes[2].lines = negative; }), HasSubstr("line 1 has vertex -1"));
    EXPECT_THAT(refused([&](Report& r) { r.meshes[2].triangles = line; }), HasSubstr("2 indices of triangles"));
    EXPECT_THAT(refused([&](Report& r) { r.meshes[2].lines = {}; }), HasSubstr("neither triangles nor lines"));
    EXPECT_THAT(refused([&](Report& r) { r.meshes[0].values = shapes.heights; }),
                HasSubstr("mesh 'target' has 66 values"));
    EXPECT_THAT(refused([&](Report& r) { r.meshes[1].low = 1; }), HasSubstr("range of values 1 to 0"));
    EXPECT_THAT(refused([&](Report& r) { r.meshes[2].positions = huge, r.meshes[2].lines = line; }),
                HasSubstr("1.7e+308 wide"));
    EXPECT_THAT(refused([&](Report& r) { r.view.elevation = 91; }), HasSubstr("elevation"));
    EXPECT_THAT(refused([&](Report& r) { r.sections[0].pictures[0].png.erase(r.sections[0].pictures[0].png.begin()); }),
                HasSubstr("section 'Errors': picture 0 is not a PNG file"));
    EXPECT_THAT(refused([&](Report& r) { r.sections[0].plots[0].svg = "plot.svg"; }),
                HasSubstr("section 'Errors': plot 0 does not begin with <svg"));
    EXPECT_EQ(ErrorOf(good), "no InvalidInput");
}

TEST(Markup, Base64HasTheStandardsExamples) {
    std::vector<std::string> encoded;
    for (const std::string text : {"", "f", "fo", "foo", "foob", "fooba", "foobar"}) {
        encoded.push_back(Internal::Base64(std::vector<std::uint8_t>(text.begin(), text.end())));
    }
    EXPECT_THAT(encoded, ElementsAre("", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy")) << "RFC 4648, 10";
}

}  // namespace
}  // namespace SolidSubdiv::Picture

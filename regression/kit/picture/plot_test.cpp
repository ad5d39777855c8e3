// SPDX-License-Identifier: Apache-2.0
// Plots: well-formed SVG with everything in it, in the frame and in order.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/kit/picture/plot.h>

#include <algorithm>
#include <limits>
#include <regex>

namespace SolidSubdiv::Picture {
namespace {

using testing::HasSubstr;

Plot Example() {
    Plot plot{.title = "a < b & c", .x_label = "cells", .y_label = "modulus"};
    plot.x_ticks = {{3, "3"}, {4, "4"}, {5, "5"}};
    plot.lines = {{0.5, "1/2"}};
    plot.series.push_back({.name = "across", .points = {{3, 0.41}, {4, 0.5}, {5, 0.55}}, .is_line = true});
    plot.series.push_back({.name = "along", .points = {{3, 0.25}}, .marker = Marker::Triangle});
    return plot;
}

/// Numbers of an attribute of the circles, in their order.
std::vector<double> Circles(const std::string& svg, const std::string& attribute) {
    std::vector<double> numbers;
    const std::regex circle("<circle[^>]* " + attribute + "=\"([0-9.]+)\"");
    for (std::sregex_iterator it(svg.begin(), svg.end(), circle), end; it != end; ++it) {
        numbers.push_back(std::stod((*it)[1]));
    }
    return numbers;
}

TEST(Plot, IsWellFormedAndHasEveryWord) {
    const std::string svg = ToSvg(Example());
    for (const char* word :
         {"a &lt; b &amp; c", ">cells<", ">modulus<", ">across<", ">along<", ">1/2<", ">3<", ">5<"}) {
        EXPECT_THAT(svg, HasSubstr(word));
    }
    // Every tag closes itself or has its end.
    const auto count = [&](const char* pattern) {
        const std::regex regex(pattern);
        return std::distance(std::sregex_iterator(svg.begin(), svg.end(), regex), std::sregex_iterator());
    };
    EXPECT_EQ(count("<[a-z]"), count("/>") + count("</"));
    EXPECT_EQ(count("\"") % 2, 0);
}

TEST(Plot, PutsLargerValuesFurtherRightAndUpInsideTheFrame) {
    const std::string svg = ToSvg(Example());
    std::vector<double> x = Circles(svg, "cx"), y = Circles(svg, "cy");
    ASSERT_EQ(x.size(), 4u) << "three points and the legend's";
    x.pop_back(), y.pop_back();
    EXPECT_TRUE(std::is_sorted(x.begin(), x.end()));
    EXPECT_TRUE(std::is_sorted(y.rbegin(), y.rend()));
    EXPECT_NEAR(x[1] - x[0], x[2] - x[1], 0.02) << "two digits are written";
    for (double at : x) EXPECT_TRUE(at > 0 && at < 900);
    for (double at : y) EXPECT_TRUE(at > 0 && at < 540);
}

TEST(Plot, SpacesPowersEvenlyOnALogarithmicAxis) {
    Plot plot{.is_logarithmic = true};
    plot.series.push_back({.points = {{1, 0.5}, {2, 0.25}, {3, 0.125}}});
    const std::vector<double> y = Circles(ToSvg(plot), "cy");
    EXPECT_NEAR(y.at(1) - y.at(0), y.at(2) - y.at(1), 0.02) << "two digits are written";
}

TEST(Plot, WritesLongLabelsAslant) {
    Plot plot = Example();
    EXPECT_THAT(ToSvg(plot), testing::Not(HasSubstr("rotate(-38")));
    for (PlotTick& tick : plot.x_ticks) tick.label = std::string(60, 'x');
    EXPECT_THAT(ToSvg(plot), HasSubstr("rotate(-38"));
}

TEST(Plot, RefusesWhatItCannotPlace) {
    Plot plot = Example();
    plot.series[0].points[1].y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(ToSvg(plot), InvalidInput);
    plot = Example();
    plot.is_logarithmic = true;
    plot.series[1].points[0].y = 0;
    EXPECT_THROW(ToSvg(plot), InvalidInput);
    EXPECT_THROW(ToSvg(Plot{.title = "empty"}), InvalidInput);
}

}  // namespace
}  // namespace SolidSubdiv::Picture

// SPDX-License-Identifier: Apache-2.0
// Plots of numbers as SVG: points and lines over two axes, with a legend, for pages and browsers.
//
//     Picture::Plot plot{.title = "eigenvalues", .x_label = "cells around the edge", .y_label = "modulus"};
//     plot.x_ticks = {{3, "3"}, {4, "4"}};
//     plot.series.push_back({.name = "across", .points = {{3, 0.41}, {4, 0.5}}, .is_line = true});
//     std::ofstream("plot.svg") << Picture::ToSvg(plot);
#pragma once

#include <string>
#include <vector>

#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Picture {

struct PlotPoint {
    double x = 0, y = 0;
};

enum class Marker { Circle, Ring, Square, Diamond, Triangle, Cross };

struct PlotSeries {
    std::string name{};  ///< in the legend; empty: not there
    std::vector<PlotPoint> points{};
    bool is_line = false;  ///< joined in their order
    Marker marker = Marker::Circle;
    int color = -1;  ///< of the palette; -1: the next one
};

struct PlotTick {
    double at = 0;
    std::string label{};
};

struct Plot {
    std::string title{}, x_label{}, y_label{};
    std::vector<PlotTick> x_ticks{}, y_ticks{};
    std::vector<PlotTick> headings{};  ///< above the frame, in the middle of what they stand over
    std::vector<PlotTick> lines{};     ///< across, at values of y, named at the right
    std::vector<PlotSeries> series{};
    bool is_logarithmic = false;    ///< y
    int width = 900, height = 540;  ///< in pixels; the legend and long labels below the axis have theirs in it
};

/// Ranges are those of points, ticks and lines. Labels of x ticks that would overlap are written aslant.
/// @throws InvalidInput naming the series where a point is not finite, or not positive though y is logarithmic; and
/// where there is nothing to draw
std::string ToSvg(const Plot& plot);

}  // namespace SolidSubdiv::Picture

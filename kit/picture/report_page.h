// SPDX-License-Identifier: Apache-2.0
// A report as one page of HTML: tables, pictures, plots and a 3-D view that a reader can turn, cut and fade. Everything
// stands in the page: it opens anywhere, loads nothing, and forbids the browser to.
//
//     Picture::Report report{.title = "bunny", .summary = "A lattice of 480 control points fitted to 35,947
//     vertices."}; report.meshes.push_back({.name = "target", .positions = p, .triangles = t, .is_shown = false});
//     report.meshes.push_back({.name = "fitted", .positions = q, .triangles = u, .values = errors,
//                              .value_name = "distance to the target", .unit = "mm"});
//     report.meshes.push_back({.name = "control lattice", .positions = c, .lines = edges, .color = Palette::kLattice});
//     report.sections.push_back({.title = "Errors", .rows = {{"largest", "0.8 mm"}}, .plots = {{"convergence", svg}}});
//     std::ofstream("report.html") << Picture::ReportPage(report);
//
// The view is drawn by a part of three.js (MIT license, three/LICENSE), which is in the page with its license. Where a
// browser has no WebGL the page says so in a sentence and shows the rest.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <solidsubdiv/kit/picture/camera.h>
#include <solidsubdiv/kit/picture/color.h>
#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Picture {

/// What a button of the 3-D view shows and hides: a surface, lines, or both. The first two surfaces of a report can be
/// faded into each other.
struct ReportMesh {
    std::string name{};
    std::span<const double> positions;   ///< (n, 3), finite
    std::span<const Index> triangles{};  ///< (m, 3), the outside counterclockwise
    std::span<const double> values{};    ///< (n) or empty: coloured by `map`, with a legend; not finite = grey
    std::string value_name{}, unit{};    ///< of the legend
    std::span<const Index> lines{};      ///< (k, 2), as the edges of a control lattice
    ColorMap map = ColorMap::Sequential;
    double low = 0, high = 0;  ///< values at the map's ends; equal: the least and greatest finite value
    Color color = Palette::kSkin;
    bool is_shown = true;  ///< when the page opens
};

struct ReportRow {
    std::string name{}, value{};
};

struct ReportPicture {
    std::string caption{};
    std::vector<std::uint8_t> png{};  ///< the bytes of the file: EncodePng makes them
};

struct ReportPlot {
    std::string caption{};
    std::string svg{};  ///< ToSvg makes it
};

/// What has a heading: words, a table, pictures, plots, each of them there or not.
struct ReportSection {
    std::string title{}, text{};
    std::vector<ReportRow> rows{};
    std::vector<ReportPicture> pictures{};
    std::vector<ReportPlot> plots{};
};

struct Report {
    std::string title{}, summary{};
    std::vector<ReportMesh> meshes{};  ///< none: no 3-D view, and no script in the page
    View view{};                       ///< at the start; its field is that across the height, its margin is not used
    std::vector<ReportSection> sections{};
};

/// The text of the page, in UTF-8 as the report's texts are; these may have any characters, they are never markup.
/// Same report, same bytes. Size: 0.4 MB where there are meshes, and 4/3 of pictures, plots and numbers (16 bytes a
/// vertex, 20 with values, 16 a triangle). Positions are written as float, relative to the middle and the size of all
/// of them, so neither far places nor tiny units lose digits.
/// @throws InvalidInput naming the mesh or section, the element and the value that can't be used
std::string ReportPage(const Report& report);

}  // namespace SolidSubdiv::Picture

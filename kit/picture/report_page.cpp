// SPDX-License-Identifier: Apache-2.0
// Writes the page: head, the data of the view as JSON, sections, scripts. See report_page.h.
#include <solidsubdiv/kit/picture/internal/markup.h>
#include <solidsubdiv/kit/picture/internal/report_assets.h>
#include <solidsubdiv/kit/picture/report_page.h>
#include <solidsubdiv/sdc/errors.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

namespace SolidSubdiv::Picture {
namespace {

using Internal::Base64;
using Internal::Escaped;
using Internal::JsonString;

constexpr int kMapSteps = 256;

/// As short as it can be read back; the same in every language of the user's.
std::string Number(double x) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, x).ptr};
}

std::string Numbers(std::span<const double> numbers) {
    std::string text = "[";
    for (double x : numbers) text += (text.size() > 1 ? "," : "") + Number(x);
    return text + "]";
}

/// Base64 of float or std::uint32_t, little endian, quoted.
template <class To, class Range, class Change>
std::string Packed(const Range& numbers, Change&& change) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(4 * numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto bits = std::bit_cast<std::uint32_t>(static_cast<To>(change(numbers[i], i)));
        for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(bits >> shift));
    }
    return '"' + Base64(bytes) + '"';
}

void CheckIndices(const ReportMesh& mesh, std::span<const Index> indices, std::size_t arity, const char* what) {
    const std::string where = "report: mesh '" + mesh.name + "'";
    if (indices.size() % arity != 0) {
        throw InvalidInput(where + " has " + std::to_string(indices.size()) + " indices of " + what + "s, which take " +
                           std::to_string(arity) + " each");
    }
    const auto n = static_cast<Index>(mesh.positions.size() / 3);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] < 0 || indices[i] >= n) {
            throw InvalidInput(where + ": " + what + " " + std::to_string(i / arity) + " has vertex " +
                               std::to_string(indices[i]) + "; there are " + std::to_string(n));
        }
    }
}

void Check(const ReportMesh& mesh) {
    const std::string where = "report: mesh '" + mesh.name + "'";
    if (mesh.positions.size() % 3 != 0) {
        throw InvalidInput(where + " has " + std::to_string(mesh.positions.size()) +
                           " coordinates, not three a vertex");
    }
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (!std::isfinite(mesh.positions[i])) {
            throw InvalidInput(where + ": vertex " + std::to_string(i / 3) + " is at " + Number(mesh.positions[i]));
        }
    }
    CheckIndices(mesh, mesh.triangles, 3, "triangle");
    CheckIndices(mesh, mesh.lines, 2, "line");
    if (mesh.triangles.empty() && mesh.lines.empty()) {
        throw InvalidInput(where + " has neither triangles nor lines");
    }
    if (!mesh.values.empty() && mesh.values.size() != mesh.positions.size() / 3) {
        throw InvalidInput(where + " has " + std::to_string(mesh.values.size()) + " values on " +
                           std::to_string(mesh.positions.size() / 3) + " vertices");
    }
    if (!std::isfinite(mesh.low) || !std::isfinite(mesh.high) || mesh.low > mesh.high) {
        throw InvalidInput(where + " has the range of values " + Number(mesh.low) + " to " + Number(mesh.high));
    }
}

/// The box around all meshes: the view's coordinates are relative to its middle and half its diagonal.
struct Frame {
    std::array<double, 3> middle{}, half_sizes{};
    double scale = 1;

    explicit Frame(std::span<const ReportMesh> meshes) {
        std::array<double, 3> low, high;
        low.fill(std::numeric_limits<double>::max()), high.fill(-std::numeric_limits<double>::max());
        for (const ReportMesh& mesh : meshes) {
            for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
                low[i % 3] = std::min(low[i % 3], mesh.positions[i]);
                high[i % 3] = std::max(high[i % 3], mesh.positions[i]);
            }
        }
        // Halves are taken first: the sum of the largest numbers is not one.
        for (std::size_t k = 0; k < 3; ++k) {
            middle[k] = low[k] / 2 + high[k] / 2;
            half_sizes[k] = high[k] / 2 - low[k] / 2;
        }
        const double half_diagonal = std::hypot(half_sizes[0], half_sizes[1], half_sizes[2]);
        if (!std::isfinite(half_diagonal)) {
            throw InvalidInput("report: the meshes are " + Number(half_sizes[0]) +
                               " wide on each side of their middle");
        }
        if (half_diagonal > 0) scale = half_diagonal;
        for (double& size : half_sizes) size /= scale;
    }
};

/// The ends of the colour map, as ReportMesh says.
std::array<double, 2> RangeOf(const ReportMesh& mesh) {
    if (mesh.low < mesh.high) return {mesh.low, mesh.high};
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (double x : mesh.values) {
        if (std::isfinite(x)) low = std::min(low, x), high = std::max(high, x);
    }
    return low <= high ? std::array{low, high} : std::array{0.0, 0.0};
}

const char* NameOf(ColorMap map) { return map == ColorMap::Diverging ? "diverging" : "sequential"; }

std::string MapJson(ColorMap map) {
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < kMapSteps; ++i) {
        const Color color = Lookup(map, static_cast<double>(i) / (kMapSteps - 1));
        for (float x : {color.r, color.g, color.b}) bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * x)));
    }
    return JsonString(NameOf(map)) + ":" + JsonString(Base64(bytes));
}

std::string MeshJson(const ReportMesh& mesh, const Frame& frame) {
    const std::array<double, 3> color = {mesh.color.r, mesh.color.g, mesh.color.b};
    const std::array<double, 2> range = RangeOf(mesh);
    const auto same = [](auto x, std::size_t) { return x; };
    const auto place = [&](double x, std::size_t i) { return (x - frame.middle[i % 3]) / frame.scale; };
    return "{\"name\":" + JsonString(mesh.name) + ",\"color\":" + Numbers(color) +
           ",\"is_shown\":" + (mesh.is_shown ? "true" : "false") + ",\"value_name\":" + JsonString(mesh.value_name) +
           ",\"unit\":" + JsonString(mesh.unit) + ",\"map\":" + JsonString(NameOf(mesh.map)) +
           ",\"low\":" + Number(range[0]) + ",\"high\":" + Number(range[1]) +
           ",\n\"positions\":" + Packed<float>(mesh.positions, place) +
           ",\n\"triangles\":" + Packed<std::uint32_t>(mesh.triangles, same) +
           ",\n\"values\":" + Packed<float>(mesh.values, same) +
           ",\n\"lines\":" + Packed<std::uint32_t>(mesh.lines, same) + "}";
}

std::string ViewJson(const Report& report) {
    const double a = report.view.azimuth * std::numbers::pi / 180, e = report.view.elevation * std::numbers::pi / 180;
    const double right = std::sin(a) * std::cos(e), up = std::sin(e), near = std::cos(a) * std::cos(e);
    const bool is_y_up = report.view.up == UpAxis::Y;
    const std::array<double, 3> direction =
        is_y_up ? std::array{right, up, near} : std::array{right, -near, up};  // as View says
    const std::array<double, 3> up_axis = is_y_up ? std::array{0.0, 1.0, 0.0} : std::array{0.0, 0.0, 1.0};
    const Frame frame(report.meshes);

    std::string json = "{\"direction\":" + Numbers(direction) + ",\"up\":" + Numbers(up_axis) +
                       ",\"field_of_view\":" + Number(report.view.field_of_view) +
                       ",\"half_sizes\":" + Numbers(frame.half_sizes) + ",\"middle\":" + Numbers(frame.middle) +
                       ",\"scale\":" + Number(frame.scale) + ",\n\"maps\":{" + MapJson(ColorMap::Sequential) + "," +
                       MapJson(ColorMap::Diverging) + "},\n\"meshes\":[";
    for (std::size_t i = 0; i < report.meshes.size(); ++i) {
        json += (i == 0 ? "\n" : ",\n") + MeshJson(report.meshes[i], frame);
    }
    return json + "]}";
}

void AppendAsset(std::string& page, std::span<const std::string_view> pieces) {
    for (std::string_view piece : pieces) page += piece;
}

void AppendFigure(std::string& page, const std::string& caption, const char* type,
                  std::span<const std::uint8_t> bytes) {
    page += "<figure><img alt=\"" + Escaped(caption) + "\" src=\"data:" + type + ";base64," + Base64(bytes) + "\">";
    if (!caption.empty()) page += "<figcaption>" + Escaped(caption) + "</figcaption>";
    page += "</figure>\n";
}

void AppendSection(std::string& page, const ReportSection& section) {
    const std::string where = "report: section '" + section.title + "'";
    page += "<section>\n<h2>" + Escaped(section.title) + "</h2>\n";
    if (!section.text.empty()) page += "<p>" + Escaped(section.text) + "</p>\n";
    if (!section.rows.empty()) page += "<table>\n";
    for (const ReportRow& row : section.rows) {
        page += "<tr><th scope=\"row\">" + Escaped(row.name) + "</th><td>" + Escaped(row.value) + "</td></tr>\n";
    }
    if (!section.rows.empty()) page += "</table>\n";
    for (std::size_t i = 0; i < section.pictures.size(); ++i) {
        constexpr std::array<std::uint8_t, 8> kMagic = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
        const ReportPicture& picture = section.pictures[i];
        if (picture.png.size() < kMagic.size() || !std::equal(kMagic.begin(), kMagic.end(), picture.png.begin())) {
            throw InvalidInput(where + ": picture " + std::to_string(i) + " is not a PNG file");
        }
        AppendFigure(page, picture.caption, "image/png", picture.png);
    }
    for (std::size_t i = 0; i < section.plots.size(); ++i) {
        const ReportPlot& plot = section.plots[i];
        if (!plot.svg.starts_with("<svg")) {
            throw InvalidInput(where + ": plot " + std::to_string(i) + " does not begin with <svg");
        }
        // An image, not a part of the page: scripts in it would not run, and its names don't meet the page's.
        AppendFigure(page, plot.caption, "image/svg+xml",
                     {reinterpret_cast<const std::uint8_t*>(plot.svg.data()), plot.svg.size()});
    }
    page += "</section>\n";
}

constexpr const char* kView = R"(<div id="view">
<p class="no-view">The 3-D view needs JavaScript and WebGL, which this browser does not offer; the rest of the page
shows the result.</p>
<div class="buttons"></div>
<div class="sliders"></div>
<canvas tabindex="0" role="application"
aria-label="3-D view: arrow keys turn it, with shift move it, plus and minus zoom"></canvas>
<div class="legends"></div>
<p class="hint">Drag to turn; with the right button, or two fingers, to move; click, then use the wheel to zoom.</p>
</div>
)";

}  // namespace

std::string ReportPage(const Report& report) {
    report.view.Validate();
    for (const ReportMesh& mesh : report.meshes) Check(mesh);

    // The browser itself sees to it that nothing is loaded.
    std::string page = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy"
content="default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="SolidSubdiv">
)";
    page += "<title>" + Escaped(report.title) + "</title>\n<style>\n";
    AppendAsset(page, Internal::kPageStyle);
    page += "</style>\n</head>\n<body>\n<h1>" + Escaped(report.title) + "</h1>\n";
    if (!report.summary.empty()) page += "<p>" + Escaped(report.summary) + "</p>\n";
    if (!report.meshes.empty()) page += kView;
    for (const ReportSection& section : report.sections) AppendSection(page, section);
    if (!report.meshes.empty()) {
        page +=
            "<script type=\"application/json\" id=\"report-data\">\n" + ViewJson(report) + "\n</script>\n<script>\n";
        AppendAsset(page, Internal::kThreeScript);
        page += "</script>\n<script>\n";
        AppendAsset(page, Internal::kViewScript);
        page += "</script>\n";
    }
    return page + "</body>\n</html>\n";
}

}  // namespace SolidSubdiv::Picture

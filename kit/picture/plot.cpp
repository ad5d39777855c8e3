// SPDX-License-Identifier: Apache-2.0
// SVG by hand: a frame, ticks, named lines, series, legend.
#include <solidsubdiv/kit/picture/internal/markup.h>
#include <solidsubdiv/kit/picture/plot.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace SolidSubdiv::Picture {

namespace {

using Internal::Escaped;

/// Okabe and Ito's colours, which colour-blind people tell apart.
constexpr std::array<const char*, 7> kPalette = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                 "#E69F00", "#56B4E9", "#000000"};
constexpr double kFont = 13, kCharacter = 0.56 * kFont;  // how wide one is about

std::string Number(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", x);
    return text;
}

double WidthOf(const std::string& text) { return kCharacter * static_cast<double>(text.size()); }

struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;

    void Add(double x) { low = std::min(low, x), high = std::max(high, x); }
    void Widen(double share) {
        const double more = high > low ? share * (high - low) : 0.5;
        low -= more, high += more;
    }
};

class Drawing {
  public:
    explicit Drawing(const Plot& plot) : plot_(plot) {
        Measure();
        Layout();
        Open();
        Axes();
        Lines();
        for (std::size_t i = 0; i < plot.series.size(); ++i) Series(plot.series[i], ColorOf(i));
        Legend();
        svg_ += "</svg>\n";
    }

    std::string Take() { return std::move(svg_); }

  private:
    double Scaled(double y) const { return plot_.is_logarithmic ? std::log10(y) : y; }
    double X(double x) const { return left_ + (x - x_.low) / (x_.high - x_.low) * (right_ - left_); }
    double Y(double y) const { return bottom_ - (Scaled(y) - y_.low) / (y_.high - y_.low) * (bottom_ - top_); }
    const char* ColorOf(std::size_t series) const {
        const int given = plot_.series[series].color;
        return kPalette[(given >= 0 ? static_cast<std::size_t>(given) : series) % kPalette.size()];
    }

    void Measure() {
        for (const PlotSeries& series : plot_.series) {
            for (const PlotPoint& p : series.points) {
                if (!std::isfinite(p.x) || !std::isfinite(p.y) || (plot_.is_logarithmic && p.y <= 0)) {
                    throw InvalidInput("plot: series '" + series.name + "' has the point (" + std::to_string(p.x) +
                                       ", " + std::to_string(p.y) + ")");
                }
                x_.Add(p.x), y_.Add(Scaled(p.y));
            }
        }
        if (x_.low > x_.high) throw InvalidInput("plot: no points");
        for (const PlotTick& t : plot_.x_ticks) x_.Add(t.at);
        for (const PlotTick& t : plot_.y_ticks) y_.Add(Scaled(t.at));
        for (const PlotTick& t : plot_.lines) y_.Add(Scaled(t.at));
        x_.Widen(0.04), y_.Widen(0.04);
    }

    /// Room for labels: at the left those of y, at the right those of lines, below those of x and the legend.
    void Layout() {
        double y_labels = 0, line_labels = 0, x_labels = 0;
        for (const PlotTick& t : plot_.y_ticks) y_labels = std::max(y_labels, WidthOf(t.label));
        for (const PlotTick& t : plot_.lines) line_labels = std::max(line_labels, WidthOf(t.label));
        for (const PlotTick& t : plot_.x_ticks) x_labels = std::max(x_labels, WidthOf(t.label));
        const double y_room = 24 + y_labels + (plot_.y_label.empty() ? 0 : 24);
        left_ = y_room;
        right_ = plot_.width - 24 - line_labels;
        double gap = right_ - left_;
        for (std::size_t i = 1; i < plot_.x_ticks.size(); ++i) {
            gap = std::min(gap, std::abs(X(plot_.x_ticks[i].at) - X(plot_.x_ticks[i - 1].at)));
        }
        is_aslant_ = x_labels > gap - 6;
        if (is_aslant_) {  // labels go down to the left; the first must not leave the picture
            for (const PlotTick& t : plot_.x_ticks) {
                left_ = std::max(left_, 0.8 * WidthOf(t.label) + 10 - (X(t.at) - left_));
            }
        }
        y_label_at_ = 18 + left_ - y_room;
        PlaceLegend();
        top_ = (plot_.title.empty() ? 16 : 44) + (plot_.headings.empty() ? 0 : 18);
        const double below = (is_aslant_ ? 18 + 0.62 * x_labels : 26) + (plot_.x_label.empty() ? 0 : 22);
        bottom_ = plot_.height - below - 20 * n_legend_rows_ - 8;
    }

    void PlaceLegend() {
        double x = left_;
        n_legend_rows_ = 0;
        for (const PlotSeries& series : plot_.series) {
            legend_.push_back({x, 0});
            if (series.name.empty()) continue;
            const double width = 34 + WidthOf(series.name);
            if (n_legend_rows_ == 0) n_legend_rows_ = 1;
            if (x > left_ && x + width > plot_.width - 10) x = left_, ++n_legend_rows_;
            legend_.back() = {x, n_legend_rows_ - 1.0};
            x += width;
        }
    }

    void Open() {
        svg_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + std::to_string(plot_.width) + "\" height=\"" +
               std::to_string(plot_.height) + "\" viewBox=\"0 0 " + std::to_string(plot_.width) + " " +
               std::to_string(plot_.height) + "\" font-family=\"DejaVu Sans, Verdana, sans-serif\" font-size=\"" +
               Number(kFont) + "\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
        if (!plot_.title.empty()) Write(left_, 26, "start", plot_.title, "font-size=\"16\" font-weight=\"bold\"");
    }

    void Axes() {
        for (const PlotTick& t : plot_.y_ticks) {
            Stroke(left_, Y(t.at), right_, Y(t.at), "#e4e4e4");
            Write(left_ - 8, Y(t.at) + 4.5, "end", t.label);
        }
        for (const PlotTick& t : plot_.x_ticks) {
            Stroke(X(t.at), top_, X(t.at), bottom_, "#f0f0f0");
            Stroke(X(t.at), bottom_, X(t.at), bottom_ + 4, "#444444");
            if (is_aslant_) {
                Write(X(t.at) + 4, bottom_ + 16, "end", t.label,
                      "transform=\"rotate(-38 " + Number(X(t.at) + 4) + " " + Number(bottom_ + 16) + ")\"");
            } else {
                Write(X(t.at), bottom_ + 20, "middle", t.label);
            }
        }
        for (const PlotTick& t : plot_.headings) Write(X(t.at), top_ - 8, "middle", t.label, "fill=\"#555555\"");
        svg_ += "<rect x=\"" + Number(left_) + "\" y=\"" + Number(top_) + "\" width=\"" + Number(right_ - left_) +
                "\" height=\"" + Number(bottom_ - top_) + "\" fill=\"none\" stroke=\"#444444\"/>\n";
        if (!plot_.x_label.empty()) {
            Write((left_ + right_) / 2, plot_.height - 20 * n_legend_rows_ - 14, "middle", plot_.x_label);
        }
        if (!plot_.y_label.empty()) {
            const double middle = (top_ + bottom_) / 2;
            Write(y_label_at_, middle, "middle", plot_.y_label,
                  "transform=\"rotate(-90 " + Number(y_label_at_) + " " + Number(middle) + ")\"");
        }
    }

    void Lines() {
        for (const PlotTick& t : plot_.lines) {
            Stroke(left_, Y(t.at), right_, Y(t.at), "#888888", "stroke-dasharray=\"6 4\"");
            Write(right_ + 6, Y(t.at) + 4.5, "start", t.label, "fill=\"#555555\"");
        }
    }

    void Series(const PlotSeries& series, const char* color) {
        if (series.is_line && series.points.size() > 1) {
            svg_ += "<polyline fill=\"none\" stroke=\"" + std::string(color) + "\" stroke-width=\"1.6\" points=\"";
            for (const PlotPoint& p : series.points) svg_ += Number(X(p.x)) + "," + Number(Y(p.y)) + " ";
            svg_.back() = '"';
            svg_ += "/>\n";
        }
        for (const PlotPoint& p : series.points) Mark(X(p.x), Y(p.y), series.marker, color);
    }

    void Legend() {
        for (std::size_t i = 0; i < plot_.series.size(); ++i) {
            const PlotSeries& series = plot_.series[i];
            if (series.name.empty()) continue;
            const double x = legend_[i].x, y = plot_.height - 20 * (n_legend_rows_ - legend_[i].y) + 8;
            if (series.is_line) Stroke(x, y, x + 20, y, ColorOf(i), "stroke-width=\"1.6\"");
            Mark(x + 10, y, series.marker, ColorOf(i));
            Write(x + 26, y + 4.5, "start", series.name);
        }
    }

    void Stroke(double x1, double y1, double x2, double y2, const char* color, const std::string& more = {}) {
        svg_ += "<line x1=\"" + Number(x1) + "\" y1=\"" + Number(y1) + "\" x2=\"" + Number(x2) + "\" y2=\"" +
                Number(y2) + "\" stroke=\"" + color + "\" " + more + "/>\n";
    }

    void Write(double x, double y, const char* anchor, const std::string& text, const std::string& more = {}) {
        svg_ += "<text x=\"" + Number(x) + "\" y=\"" + Number(y) + "\" text-anchor=\"" + anchor + "\" " + more + ">" +
                Escaped(text) + "</text>\n";
    }

    void Mark(double x, double y, Marker marker, const char* color) {
        const auto path = [&](const std::string& d, bool is_filled) {
            svg_ += "<path d=\"" + d + "\" " +
                    (is_filled ? "fill=\"" : "fill=\"none\" stroke-width=\"1.8\" stroke=\"") + color + "\"/>\n";
        };
        const auto at = [&](double dx, double dy) { return Number(x + dx) + " " + Number(y + dy); };
        switch (marker) {
            case Marker::Circle:
            case Marker::Ring:
                svg_ += "<circle cx=\"" + Number(x) + "\" cy=\"" + Number(y) + "\" r=\"4\" " +
                        (marker == Marker::Circle ? "fill=\"" : "fill=\"none\" stroke-width=\"1.8\" stroke=\"") +
                        color + "\"/>\n";
                break;
            case Marker::Square:
                path("M" + at(-3.6, -3.6) + "L" + at(3.6, -3.6) + "L" + at(3.6, 3.6) + "L" + at(-3.6, 3.6) + "Z", true);
                break;
            case Marker::Diamond:
                path("M" + at(0, -5) + "L" + at(5, 0) + "L" + at(0, 5) + "L" + at(-5, 0) + "Z", true);
                break;
            case Marker::Triangle:
                path("M" + at(0, -5) + "L" + at(4.6, 3.4) + "L" + at(-4.6, 3.4) + "Z", true);
                break;
            case Marker::Cross:
                path("M" + at(-4, -4) + "L" + at(4, 4) + "M" + at(-4, 4) + "L" + at(4, -4), false);
                break;
        }
    }

    const Plot& plot_;
    Range x_, y_;
    double left_ = 0, right_ = 0, top_ = 0, bottom_ = 0, y_label_at_ = 0;
    bool is_aslant_ = false;
    int n_legend_rows_ = 0;
    std::vector<PlotPoint> legend_;  // x, and the row as y
    std::string svg_;
};

}  // namespace

std::string ToSvg(const Plot& plot) { return Drawing(plot).Take(); }

}  // namespace SolidSubdiv::Picture

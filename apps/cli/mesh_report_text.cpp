// SPDX-License-Identifier: Apache-2.0
// The description of a mesh in lines for people.
#include <nlohmann/json.hpp>

#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/apps/cli/mesh_report.h>

namespace SolidSubdiv::Cli {

namespace {

constexpr std::size_t kPiecesSaid = 10;
constexpr std::size_t kDefectsSaid = 3;

std::string Padded(std::string text, std::size_t width) {
    text.resize(std::max(width, text.size() + 1), ' ');
    return text;
}

std::string Percent(const Json& share) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f %%", 100 * share.get<double>());
    return text;
}

class ReportWriter {
  public:
    explicit ReportWriter(const Json& json) : json_(json) {}

    std::string Write() {
        for (const auto& [kind, count] : json_["counts"].items()) {
            std::string name = kind;
            std::replace(name.begin(), name.end(), '_', ' ');
            Line(name, count.dump());
        }
        WriteShape();
        WritePieces("boundary");
        WritePieces("surface");
        WriteRegularity();
        WriteAttributes("point_data", "point data");
        WriteAttributes("cell_data", "cell data");
        WriteCreases();
        const auto n_holes = json_["holes"].get<Offset>();
        if (n_holes > 0) Line("holes", Counted(n_holes, "face", "faces"));
        WriteDefects();
        if (json_["analysis"] != "complete") Line("note", json_["analysis"].get<std::string>());
        return std::move(text_);
    }

  private:
    void Line(const std::string& name, const std::string& value) {
        text_ += (text_.empty() ? "" : "\n") + Padded("  " + name, 20) + value;
    }

    static std::string Range(const Json& low, const Json& high) {
        std::string text;
        for (std::size_t i = 0; i < low.size(); ++i) {
            text += (i > 0 ? ",  " : "") + Text(low[i].get<double>()) + " to " + Text(high[i].get<double>());
        }
        return text;
    }

    void WriteCreases() {
        const auto edges = json_["creases"]["edges"].get<Offset>(), corners = json_["creases"]["corners"].get<Offset>();
        if (edges + corners == 0) return;
        Line("creases",
             Counted(edges, "sharp edge", "sharp edges") + ", " + Counted(corners, "sharp vertex", "sharp vertices"));
    }

    void WriteShape() {
        const Json& box = json_["bounding_box"];
        if (!box.is_null()) Line("bounding box", Range(box["low"], box["high"]));
        if (!json_.contains("volume")) return;
        const Json& volume = json_["volume"];
        Line("volume", Text(volume["sum_of_sizes"].get<double>()) + "; cells from " +
                           Text(volume["least_cell"].get<double>()) + " to " +
                           Text(volume["greatest_cell"].get<double>()));
    }

    void WritePieces(const std::string& what) {
        if (!json_.contains(what)) return;
        const Json& all = json_[what];
        Line(what, Counted(all["count"].get<long long>(), "component", "components"));
        std::size_t n = 0;
        for (const Json& piece : all["components"]) {
            if (n++ == kPiecesSaid) {
                Line("", "...");
                return;
            }
            Line("", PieceText(piece));
        }
    }

    static std::string PieceText(const Json& piece) {
        std::string text = Counted(piece["faces"].get<long long>(), "face", "faces") + ", " +
                           Counted(piece["vertices"].get<long long>(), "vertex", "vertices") + ", " +
                           "Euler characteristic " + piece["euler_characteristic"].dump();
        if (!piece["manifold"].get<bool>()) return text + ", not manifold";
        text += piece["closed"].get<bool>()
                    ? ", closed"
                    : ", " + Counted(piece["border_loops"].get<long long>(), "border", "borders");
        if (!piece["genus"].is_null()) return text + ", genus " + piece["genus"].dump();
        return text + ", " + Counted(piece["flipped_edges"].get<long long>(), "edge", "edges") +
               " between faces that look against each other";
    }

    void WriteHistogram(const std::string& name, const Json& histogram, const std::string& what) {
        if (histogram.empty()) return;
        std::string text;
        for (const auto& [value, count] : histogram.items()) text += value + ": " + count.dump() + "  ";
        Line(name, text + "(" + what + ")");
    }

    /// What a histogram counts, and the values that are regular: "; regular: 4 and 6".
    std::string WithRegular(std::string what, const char* key) const {
        std::string separator = "; regular: ";
        for (const Json& value : json_["regular"][key]) {
            what += separator + value.dump();
            separator = " and ";
        }
        return what;
    }

    void WriteRegularity() {
        if (!json_.contains("valence")) return;
        const Json& valence = json_["valence"];
        const char *const inside = "adjacent_inside_solids", *const on_surfaces = "edges_on_surfaces";
        WriteHistogram("valence", valence["edges_at_vertices"], "edges at a vertex");
        WriteHistogram("  inside", valence[inside], WithRegular("adjacent vertices", inside));
        WriteHistogram("  on surfaces", valence[on_surfaces], WithRegular("edges of the surface", on_surfaces));
        // Octahedra count as the tets that they are cut into.
        const char* const cells = json_.contains("matched_faces") ? "tets" : "cells";
        WriteHistogram("links", json_["links"], WithRegular(std::string(cells) + " around an inner edge", "links"));
        if (!json_.contains("matched_faces")) return;
        const Json& faces = json_["matched_faces"];
        std::string text = Percent(faces["as_ordered"]) + " of " +
                           Counted(faces["inner_faces"].get<long long>(), "inner face", "inner faces") +
                           " as the cells are ordered, " + Percent(faces["matched"]) + " with --diagonals matched";
        if (faces.contains("given")) text += ", " + Percent(faces["given"]) + " with --diagonals given";
        Line("matched faces", text);
    }

    void WriteAttributes(const std::string& key, const std::string& name) {
        for (const Json& a : json_[key]) {
            std::string text =
                a["name"].get<std::string>() + ": " + Counted(a["width"].get<long long>(), "number", "numbers");
            if (a.contains("low")) text += ", " + Range(a["low"], a["high"]);
            Line(name, text);
        }
    }

    void WriteElements(const std::string& name, const Json& elements, const std::string& one, const std::string& many) {
        const auto n = elements["count"].get<long long>();
        if (n == 0) return;
        std::string text = Counted(n, one, many) + ":";
        for (std::size_t i = 0; i < elements["first"].size() && i < 5; ++i)
            text += " " + ElementText(elements["first"][i]);
        Defect(name, text + (n > 5 ? " ..." : ""));
    }

    void Defect(const std::string& name, const std::string& text) {
        Line(has_defects_ ? "" : "defects", name + ": " + text);
        has_defects_ = true;
    }

    /// Edges as 4-7.
    static std::string ElementText(const Json& element) {
        return element.is_array() ? element[0].dump() + "-" + element[1].dump() : element.dump();
    }

    void WriteDefects() {
        for (const auto& [one, many] : {std::pair("tetrahedron", "tetrahedra"), std::pair("octahedron", "octahedra")}) {
            if (json_.contains("inverted")) WriteElements("inverted", json_["inverted"][many], one, many);
            if (json_.contains("zero_volume")) WriteElements("no volume", json_["zero_volume"][many], one, many);
        }
        WriteElements("at the place of another", json_["coincident_vertices"], "vertex", "vertices");
        if (json_.contains("other_cells")) {
            WriteOthers("inverted");
            WriteOthers("zero_volume");
        }
        if (json_.contains("cells_meeting_only_in")) {
            const Json& places = json_["cells_meeting_only_in"];
            WriteElements("cells meet only in", places["edges"], "edge", "edges");
            WriteElements("cells meet only in", places["vertices"], "vertex", "vertices");
        }
        if (json_.contains("defects")) {
            for (const Json& code : json_["defects"]) WriteCode(code);
            if (!has_defects_) Line("defects", "none");
        }
    }

    void WriteCode(const Json& code) {
        const bool is_complete = code["count_is_complete"].get<bool>();
        Defect(code["code"].get<std::string>() + (code["fatal"].get<bool>() ? " (fatal)" : ""),
               (is_complete ? "" : "at least ") + code["count"].dump());
        for (std::size_t i = 0; i < code["first"].size() && i < kDefectsSaid; ++i) {
            Line("", "  " + code["first"][i]["text"].get<std::string>());
        }
        if (code["first"].size() > kDefectsSaid) Line("", "  ...");
    }

    const Json& json_;
    std::string text_;
    /// Hexahedra, wedges, pyramids and polyhedra, which are only counted.
    void WriteOthers(const std::string& what) {
        const auto n = json_["other_cells"][what].get<Offset>();
        if (n == 0) return;
        Defect(what == "inverted" ? what : "no volume",
               std::to_string(n) + " hexahedra, wedges, pyramids or polyhedra");
    }

    bool has_defects_ = false;
};

}  // namespace

std::string MeshReportText(const Json& description) { return ReportWriter(description).Write(); }

}  // namespace SolidSubdiv::Cli

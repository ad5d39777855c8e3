// SPDX-License-Identifier: Apache-2.0
// Reads Wavefront OBJ (.obj): vertices, faces, lines, points, OpenSubdiv's tags. Per-corner texture coordinates and
// normals are not kept.
#include <array>
#include <charconv>
#include <vector>

#include <solidsubdiv/kit/io/internal/mesh_builder.h>
#include <solidsubdiv/kit/io/internal/obj_tags.h>
#include <solidsubdiv/kit/io/internal/readers.h>
#include <solidsubdiv/kit/io/internal/text.h>

namespace SolidSubdiv::Io::Internal {

namespace {

class ObjReader {
  public:
    ObjReader(std::string_view bytes, const std::string& file)
        : text_(bytes, file), builder_(file, 1), tags_(builder_) {}

    Mesh Read() {
        TextCursor line = text_;
        while (text_.NextLine(line, true)) ReadLine(line);
        builder_.AddPositions(positions_);
        if (n_colored_ > 0 && 3 * n_colored_ == positions_.size()) builder_.AddPointData({"color", 3, colors_});
        if (has_corner_data_) builder_.AddNote("texture coordinates and normals of the faces' corners are not kept");
        if (n_free_form_ > 0) {
            builder_.AddNote(Counted(n_free_form_, "line", "lines") + " of free-form curves or surfaces skipped");
        }
        tags_.Finish();
        Mesh mesh = builder_.Finish();
        mesh.scheme_options = tags_.scheme_options();
        return mesh;
    }

  private:
    void ReadLine(TextCursor& line) {
        const std::string_view keyword = line.Word();
        if (keyword == "v") {
            ReadVertex(line);
        } else if (keyword == "f" || keyword == "fo") {
            ReadVertices(line);
            if (vertices_.size() < 3) line.FailHere("a face needs at least three vertices; remove it");
            tags_.NoteFace();
            builder_.NextRow();
            builder_.AddElement(ElementKind::Polygon, vertices_);
        } else if (keyword == "l") {
            ReadVertices(line);
            if (vertices_.size() < 2) line.FailHere("a line needs at least two vertices; remove it");
            for (std::size_t i = 1; i < vertices_.size(); ++i) {
                tags_.AddElement(std::span<const std::int64_t>(vertices_).subspan(i - 1, 2));
            }
        } else if (keyword == "p") {
            ReadVertices(line);
            for (const std::int64_t& v : vertices_) tags_.AddElement({&v, 1});
        } else if (keyword == "vt" || keyword == "vn") {
            has_corner_data_ = true;
        } else if (keyword == "t") {
            tags_.ReadTag(line);
        } else if (keyword == "curv" || keyword == "curv2" || keyword == "surf") {
            ++n_free_form_;
        }
    }

    /// x y z, and after them nothing, a weight, or a colour.
    void ReadVertex(TextCursor& line) {
        for (int i = 0; i < 3; ++i) positions_.push_back(line.Real("a coordinate"));
        std::array<double, 4> more = {};
        std::size_t n = 0;
        for (; n < 4 && !line.AtComment(); ++n) more[n] = line.Real("a number");
        if (n < 3) return;
        ++n_colored_;
        colors_.insert(colors_.end(), more.begin() + (n - 3), more.begin() + n);
    }

    /// v, v/vt, v//vn or v/vt/vn, counted from 1, or back from the latest vertex with -1.
    void ReadVertices(TextCursor& line) {
        vertices_.clear();
        while (!line.AtComment()) {
            const std::string_view word = line.PeekWord();
            const std::string_view digits = word.substr(0, word.find('/'));
            const auto n_now = static_cast<std::int64_t>(positions_.size() / 3);
            std::int64_t v = 0;
            const auto [last, error] = std::from_chars(digits.data(), digits.data() + digits.size(), v);
            if (error != std::errc() || last != digits.data() + digits.size()) line.FailExpected("a vertex");
            if (v == 0) line.FailHere("vertex 0: vertices are counted from 1");
            if (v < -n_now) line.FailHere("vertex " + std::to_string(v) + " counts back behind the first vertex");
            vertices_.push_back(v < 0 ? n_now + v : v - 1);
            line.Word();
        }
    }

    TextCursor text_;
    MeshBuilder builder_;
    ObjTags tags_;
    std::vector<double> positions_;
    std::vector<double> colors_;
    std::vector<std::int64_t> vertices_;
    std::size_t n_colored_ = 0;
    bool has_corner_data_ = false;
    std::int64_t n_free_form_ = 0;
};

}  // namespace

Mesh ParseObj(std::string_view bytes, const std::string& file) { return ObjReader(bytes, file).Read(); }

}  // namespace SolidSubdiv::Io::Internal

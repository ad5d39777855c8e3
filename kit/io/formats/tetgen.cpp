// SPDX-License-Identifier: Apache-2.0
// TetGen meshes: points in PART.node, tetrahedra in PART.ele. Either name opens and writes both.
//
// The format has no names for its attributes. We write them in a comment on the first line ("# columns NAME WIDTH ...",
// blanks as %20), which TetGen skips, and take them from there; otherwise they are attribute1, attribute2, ...
#include <array>
#include <charconv>
#include <filesystem>
#include <string>
#include <vector>

#include <solidsubdiv/kit/io/internal/files.h>
#include <solidsubdiv/kit/io/internal/mesh_builder.h>
#include <solidsubdiv/kit/io/internal/octahedra.h>
#include <solidsubdiv/kit/io/internal/percents.h>
#include <solidsubdiv/kit/io/internal/readers.h>
#include <solidsubdiv/kit/io/internal/text.h>
#include <solidsubdiv/kit/io/internal/writers.h>
#include <solidsubdiv/kit/io/internal/writing.h>

namespace SolidSubdiv::Io::Internal {

namespace {

constexpr std::string_view kColumns = "# columns ";

/// How many numbers a row of all attributes but one has.
std::int64_t NumbersPerRow(std::span<const Attribute> attributes, const Attribute* without) {
    std::int64_t n = 0;
    for (const Attribute& a : attributes) n += &a == without ? 0 : a.width;
    return n;
}

/// Names and widths of the first line's comment; none if that is no such comment.
std::vector<Attribute> NamedColumns(std::string_view bytes) {
    std::vector<Attribute> columns;
    if (bytes.substr(0, kColumns.size()) != kColumns) return columns;
    TextCursor words(bytes.substr(0, bytes.find_first_of("\r\n")), {});
    words.Bytes(static_cast<std::int64_t>(kColumns.size()), "a comment");
    while (words.SkipSpace()) {
        const std::string name = DecodePercents(words.Word());
        const std::string_view digits = words.Word();
        int width = 0;
        std::from_chars(digits.data(), digits.data() + digits.size(), width);
        if (width < 1) return {};
        columns.push_back({name, width, {}});
    }
    return columns;
}

/// One of the two files: a header, then numbered rows; comments start with '#'.
class TetgenTable {
  public:
    TetgenTable(std::string_view bytes, const std::string& file) : text_(bytes, file), columns_(NamedColumns(bytes)) {}

    std::int64_t Integer(std::string_view what) {
        text_.SkipComments('#');
        return text_.Integer(what);
    }
    double Real(std::string_view what) {
        text_.SkipComments('#');
        return text_.Real(what);
    }
    std::int64_t Count(std::string_view what, std::int64_t min_bytes) {
        text_.SkipComments('#');
        return text_.Count(what, min_bytes);
    }
    bool AtEnd() { return !text_.SkipComments('#'); }

    /// Reads a row's attributes.
    void AddRow(std::int64_t n_attributes) {
        for (std::int64_t i = 0; i < n_attributes; ++i) values_.push_back(Real("an attribute"));
    }

    /// The attributes of all rows, split into the columns that the first line names, if it fits.
    std::vector<Attribute> Attributes(std::int64_t n_attributes) {
        if (values_.empty()) return {};
        if (NumbersPerRow(columns_, nullptr) != n_attributes) {
            columns_.clear();
            for (std::int64_t i = 1; i <= n_attributes; ++i)
                columns_.push_back({"attribute" + std::to_string(i), 1, {}});
        }
        const auto stride = static_cast<std::size_t>(n_attributes);
        for (std::size_t row = 0; row < values_.size(); row += stride) {
            std::size_t at = row;
            for (Attribute& column : columns_) {
                for (int k = 0; k < column.width; ++k) column.values.push_back(values_[at++]);
            }
        }
        return std::move(columns_);
    }

    TextCursor& text() { return text_; }

  private:
    TextCursor text_;
    std::vector<Attribute> columns_;
    std::vector<double> values_;
};

/// Reads the points and returns the number of the first one, 0 or 1.
std::int64_t ReadNodes(TetgenTable& table, MeshBuilder& builder) {
    const std::int64_t n = table.Count("points", 8);
    const std::int64_t dimension = table.Integer("the dimension");
    const std::int64_t n_attributes = table.Count("attributes of a point", 1);
    const std::int64_t has_markers = table.Integer("0 or 1 boundary markers");
    if (dimension != 3)
        table.text().FailHere("points of dimension " + std::to_string(dimension) + "; only 3 can be used");
    if (has_markers != 0 && has_markers != 1) table.text().FailHere("the number of boundary markers must be 0 or 1");
    std::int64_t first = 0;
    std::vector<double> positions, markers;
    for (std::int64_t i = 0; i < n; ++i) {
        const std::int64_t number = table.Integer("the number of a point");
        if (i == 0) first = number;
        if (first != 0 && first != 1) table.text().FailHere("points must be counted from 0 or 1");
        if (number != first + i) {
            table.text().FailHere("expected point " + std::to_string(first + i) + ", found " + std::to_string(number));
        }
        for (int k = 0; k < 3; ++k) positions.push_back(table.Real("a coordinate"));
        table.AddRow(n_attributes);
        if (has_markers == 1) markers.push_back(static_cast<double>(table.Integer("a boundary marker")));
    }
    if (!table.AtEnd()) table.text().FailHere("more follows after the last announced point");
    builder.AddPositions(positions);
    for (Attribute& attribute : table.Attributes(n_attributes)) builder.AddPointData(std::move(attribute));
    if (has_markers == 1) builder.AddPointData({"marker", 1, std::move(markers)});
    return first;
}

void ReadTets(TetgenTable& table, std::int64_t first, MeshBuilder& builder) {
    const std::int64_t n = table.Count("tetrahedra", 10);
    const std::int64_t n_corners = table.Integer("the number of points of a tetrahedron");
    const std::int64_t n_attributes = table.Count("attributes of a tetrahedron", 1);
    if (n_corners != 4) {
        table.text().FailHere("elements of " + std::to_string(n_corners) +
                              " points; only tetrahedra of 4 points (first order) can be used");
    }
    std::array<std::int64_t, 4> vertices;
    for (std::int64_t i = 0; i < n; ++i) {
        table.Integer("the number of a tetrahedron");
        for (std::int64_t& v : vertices) {
            v = table.Integer("a point of a tetrahedron") - first;
            if (v < 0 || v >= builder.n_vertices()) {
                table.text().FailHere("a tetrahedron names point " + std::to_string(v + first) + "; there are " +
                                      std::to_string(builder.n_vertices()) + ", counted from " + std::to_string(first));
            }
        }
        builder.NextRow();
        builder.AddElement(ElementKind::Tet, vertices);
        table.AddRow(n_attributes);
    }
    if (!table.AtEnd()) table.text().FailHere("more follows after the last announced tetrahedron");
    for (Attribute& attribute : table.Attributes(n_attributes)) builder.AddCellData(std::move(attribute));
}

void WriteColumns(OutputFile& file, std::span<const Attribute> attributes, const Attribute* without) {
    std::string names;
    for (const Attribute& a : attributes) {
        if (&a != without) names += EncodePercents(a.name) + " " + std::to_string(a.width) + " ";
    }
    if (!names.empty()) file << kColumns << names << '\n';
}

void WriteRow(OutputFile& file, std::span<const Attribute> attributes, const Attribute* without, std::size_t row) {
    for (const Attribute& a : attributes) {
        const auto width = static_cast<std::size_t>(a.width);
        for (std::size_t k = 0; &a != without && k < width; ++k) file << ' ' << a.values[row * width + k];
    }
}

void Write(const std::filesystem::path& path, const Mesh& mesh) {
    constexpr std::array kinds = {ElementKind::Tet};
    RequireKinds(path, mesh, "TetGen", kinds);
    const Attribute* markers = FindLabels(mesh.point_data, "marker");

    OutputFile nodes(std::filesystem::path(path).replace_extension(".node"));
    WriteColumns(nodes, mesh.point_data, markers);
    nodes << mesh.topology.n_vertices << " 3 " << NumbersPerRow(mesh.point_data, markers)
          << (markers ? " 1\n" : " 0\n");
    for (std::size_t i = 0; 3 * i < mesh.positions.size(); ++i) {
        nodes << i << ' ' << mesh.positions[3 * i] << ' ' << mesh.positions[3 * i + 1] << ' '
              << mesh.positions[3 * i + 2];
        WriteRow(nodes, mesh.point_data, markers, i);
        if (markers) nodes << ' ' << LabelOf(markers, i);
        nodes << '\n';
    }

    OutputFile elements(std::filesystem::path(path).replace_extension(".ele"));
    WriteColumns(elements, mesh.cell_data, nullptr);
    elements << mesh.topology.n_tets() << " 4 " << NumbersPerRow(mesh.cell_data, nullptr) << '\n';
    for (std::size_t i = 0; 4 * i < mesh.topology.tets.size(); ++i) {
        elements << i;
        for (std::size_t k = 0; k < 4; ++k) elements << ' ' << mesh.topology.tets[4 * i + k];
        WriteRow(elements, mesh.cell_data, nullptr, i);
        elements << '\n';
    }
    nodes.Close();
    elements.Close();
    nodes.Commit();
    elements.Commit();
}

}  // namespace

Mesh ParseTetgen(std::string_view nodes, const std::string& nodes_file, std::string_view elements,
                 const std::string& elements_file) {
    MeshBuilder builder(elements_file);
    TetgenTable node_table(nodes, nodes_file);
    const std::int64_t first = ReadNodes(node_table, builder);
    TetgenTable element_table(elements, elements_file);
    ReadTets(element_table, first, builder);
    return builder.Finish();
}

Mesh ReadTetgen(const std::filesystem::path& path) {
    const auto nodes = std::filesystem::path(path).replace_extension(".node");
    const auto elements = std::filesystem::path(path).replace_extension(".ele");
    return ParseTetgen(ReadWholeFile(nodes), NameOf(nodes), ReadWholeFile(elements), NameOf(elements));
}

void WriteTetgen(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions&) {
    mesh.topology.octs.empty() ? Write(path, mesh) : Write(path, CutOctahedra(mesh));
}

}  // namespace SolidSubdiv::Io::Internal

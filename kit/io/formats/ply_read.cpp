// SPDX-License-Identifier: Apache-2.0
// Reads PLY (.ply), text and binary in both byte orders: vertices, faces, edges, and their further properties as
// attributes.
#include <algorithm>
#include <bit>
#include <optional>
#include <string>
#include <vector>

#include <solidsubdiv/kit/io/internal/mesh_builder.h>
#include <solidsubdiv/kit/io/internal/numbers.h>
#include <solidsubdiv/kit/io/internal/readers.h>
#include <solidsubdiv/kit/io/internal/text.h>

namespace SolidSubdiv::Io::Internal {

namespace {

/// Faces and edges share their columns, zeros where one lacks them: the file's size alone would not bound the memory.
constexpr std::size_t kMostCellColumns = 128;

struct Property {
    std::string name;
    NumberType type = NumberType::Float64;
    bool is_list = false;
    NumberType count_type = NumberType::UInt8;
};

struct Element {
    std::string name;
    std::int64_t n = 0;
    std::vector<Property> properties;
};

std::optional<NumberType> TypeNamed(std::string_view name) {
    constexpr std::pair<std::string_view, NumberType> names[] = {
        {"char", NumberType::Int8},      {"int8", NumberType::Int8},       {"uchar", NumberType::UInt8},
        {"uint8", NumberType::UInt8},    {"short", NumberType::Int16},     {"int16", NumberType::Int16},
        {"ushort", NumberType::UInt16},  {"uint16", NumberType::UInt16},   {"int", NumberType::Int32},
        {"int32", NumberType::Int32},    {"uint", NumberType::UInt32},     {"uint32", NumberType::UInt32},
        {"float", NumberType::Float32},  {"float32", NumberType::Float32}, {"double", NumberType::Float64},
        {"float64", NumberType::Float64}};
    for (const auto& [key, type] : names) {
        if (key == name) return type;
    }
    return std::nullopt;
}

/// Properties NAME_0, NAME_1, ... that follow one another become one attribute NAME.
std::vector<Attribute> Joined(std::vector<Attribute> columns) {
    std::vector<Attribute> joined;
    for (std::size_t first = 0; first < columns.size();) {
        const std::string& name = columns[first].name;
        const std::string base = name.size() > 2 && name.ends_with("_0") ? name.substr(0, name.size() - 2) : "";
        std::size_t n = 1;
        while (!base.empty() && first + n < columns.size() && columns[first + n].name == base + "_" + std::to_string(n))
            ++n;
        if (n == 1) {
            joined.push_back(std::move(columns[first++]));
            continue;
        }
        Attribute attribute{base, static_cast<int>(n), {}};
        for (std::size_t row = 0; row < columns[first].values.size(); ++row) {
            for (std::size_t k = 0; k < n; ++k) attribute.values.push_back(columns[first + k].values[row]);
        }
        joined.push_back(std::move(attribute));
        first += n;
    }
    return joined;
}

class PlyReader {
  public:
    PlyReader(std::string_view bytes, const std::string& file) : text_(bytes, file), builder_(file) {}

    Mesh Read() {
        ReadHeader();
        for (const Element& element : elements_) {
            if (element.name == "vertex") {
                ReadVertices(element);
            } else if (element.name == "face") {
                ReadFaces(element);
            } else if (element.name == "edge") {
                ReadEdges(element);
            } else {
                builder_.AddNote("element " + Quoted(element.name) + " is left out");
                ReadRows(
                    element, [](std::size_t, double) {}, [](std::size_t) {}, [] {});
            }
        }
        for (Attribute& attribute : Joined(std::move(cell_columns_))) builder_.AddCellData(std::move(attribute));
        return builder_.Finish();
    }

  private:
    // ---- Header ----

    void ReadHeader() {
        if (text_.Word() != "ply") Fail(text_.file(), "is no PLY file: it must start with 'ply'");
        bool have_format = false;
        for (;;) {
            text_.SkipSpace();
            TextCursor line = text_;
            if (!text_.NextLine(line)) Fail(text_.file(), "the header has no end_header; is the file complete?");
            const std::string_view keyword = line.Word();
            if (keyword == "end_header") break;
            if (keyword == "format") {
                ReadFormat(line);
                have_format = true;
            } else if (keyword == "element") {
                Element element;
                element.name = line.Word();
                element.n = line.Integer("the number of elements");
                if (element.n < 0) line.FailHere("a negative number of elements");
                elements_.push_back(element);
            } else if (keyword == "property") {
                ReadProperty(line);
            } else if (keyword != "comment" && keyword != "obj_info") {
                line.FailHere("unknown keyword " + Quoted(keyword) + " in the header");
            }
        }
        if (!have_format) Fail(text_.file(), "the header has no 'format'");
    }

    void ReadFormat(TextCursor& line) {
        const std::string_view format = line.Word();
        if (format == "ascii") return;
        binary_ = true;
        if (format != "binary_little_endian" && format != "binary_big_endian") {
            line.FailHere("the format " + Quoted(format) + " is unknown");
        }
        swap_bytes_ = (format == "binary_big_endian") != (std::endian::native == std::endian::big);
    }

    void ReadProperty(TextCursor& line) {
        if (elements_.empty()) line.FailHere("a property before the first element");
        const auto read_type = [&] {
            const std::string_view word = line.Word();
            const std::optional<NumberType> type = TypeNamed(word);
            if (!type) line.FailHere("the type " + Quoted(word) + " is unknown");
            return *type;
        };
        Property property;
        property.is_list = line.PeekWord() == "list";
        if (property.is_list) {
            line.Word();
            property.count_type = read_type();
        }
        property.type = read_type();
        property.name = line.Word();
        elements_.back().properties.push_back(property);
    }

    // ---- Rows ----

    double ReadNumber(NumberType type) {
        if (!binary_) return text_.Real("a number");
        const char* bytes = text_.Bytes(SizeOf(type), "a number").data();
        return VisitNumberType(
            type, [&](auto zero) { return static_cast<double>(LoadNumber<decltype(zero)>(bytes, swap_bytes_)); });
    }

    std::int64_t ToInteger(double number, std::string_view what) const {
        if (!(number >= -2147483648.0 && number <= 4294967295.0) ||
            number != static_cast<double>(static_cast<std::int64_t>(number))) {
            text_.FailHere(std::string(what) + " is no integer");
        }
        return static_cast<std::int64_t>(number);
    }

    /// Reads all rows of an element. Calls on_number(property, value) for single numbers, on_list(property) when list_
    /// holds a list, and on_row() behind each row.
    template <class OnNumber, class OnList, class OnRow>
    void ReadRows(const Element& element, OnNumber on_number, OnList on_list, OnRow on_row) {
        if (element.properties.empty()) {
            if (element.n > 0) text_.FailHere("the element " + Quoted(element.name) + " has no properties");
            return;
        }
        RequireRoom(element);
        for (std::int64_t row = 0; row < element.n; ++row) {
            for (std::size_t i = 0; i < element.properties.size(); ++i) {
                const Property& property = element.properties[i];
                if (!property.is_list) {
                    on_number(i, ReadNumber(property.type));
                    continue;
                }
                const std::int64_t n = ToInteger(ReadNumber(property.count_type), "the length of a list");
                if (n < 0) text_.FailHere("a list of negative length");
                list_.clear();
                for (std::int64_t k = 0; k < n; ++k) list_.push_back(ReadNumber(property.type));
                on_list(i);
            }
            on_row();
        }
    }

    void RequireRoom(const Element& element) const {
        std::int64_t row_bytes = 0;
        for (const Property& p : element.properties)
            row_bytes += binary_ ? SizeOf(p.is_list ? p.count_type : p.type) : 2;
        if (element.n <= (text_.remaining() + 1) / row_bytes) return;
        text_.FailHere(std::to_string(element.n) + " rows of the element " + Quoted(element.name) +
                       " are announced, but only " + Counted(text_.remaining(), "byte", "bytes") +
                       " follow; is the file complete?");
    }

    /// The property of that name that is a single number, or their number.
    static std::size_t PlaceOf(const Element& element, std::string_view name) {
        const auto found = std::find_if(element.properties.begin(), element.properties.end(),
                                        [&](const Property& p) { return p.name == name && !p.is_list; });
        return static_cast<std::size_t>(found - element.properties.begin());
    }

    void NoteList(const Property& property) {
        builder_.AddNote("property " + Quoted(property.name) + " is a list and is left out");
    }

    void ReadVertices(const Element& element) {
        if (builder_.n_vertices() > 0) text_.FailHere("a second element 'vertex'");
        const std::size_t n_properties = element.properties.size();
        const std::size_t axes[] = {PlaceOf(element, "x"), PlaceOf(element, "y"), PlaceOf(element, "z")};
        std::vector<Attribute> columns(n_properties);
        std::vector<std::size_t> axis_of(n_properties, 3);
        for (std::size_t k = 0; k < 3; ++k) {
            if (axes[k] == n_properties) text_.FailHere(std::string("the vertices have no property ") + "xyz"[k]);
            axis_of[axes[k]] = k;
        }
        std::vector<double> positions;
        double point[3] = {};
        ReadRows(
            element,
            [&](std::size_t i, double value) {
                if (axis_of[i] < 3) {
                    point[axis_of[i]] = value;
                } else {
                    columns[i].values.push_back(value);
                }
            },
            [](std::size_t) {}, [&] { positions.insert(positions.end(), point, point + 3); });
        builder_.AddPositions(positions);

        std::vector<Attribute> kept;
        for (std::size_t i = 0; i < n_properties; ++i) {
            if (element.properties[i].is_list) {
                NoteList(element.properties[i]);
            } else if (axis_of[i] == 3) {
                columns[i].name = element.properties[i].name;
                kept.push_back(std::move(columns[i]));
            }
        }
        for (Attribute& attribute : Joined(std::move(kept))) builder_.AddPointData(std::move(attribute));
    }

    static bool IsVertexList(const Property& p) {
        return p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
    }

    void ReadFaces(const Element& element) {
        const auto n_lists = std::count_if(element.properties.begin(), element.properties.end(), IsVertexList);
        if (n_lists != 1 && element.n > 0) text_.FailHere("the faces need one list property 'vertex_indices'");
        for (const Property& p : element.properties) {
            if (p.is_list && !IsVertexList(p)) NoteList(p);
        }
        std::vector<std::int64_t> vertices;
        ReadCellRows(
            element, [](std::size_t) { return true; },
            [&](std::size_t i) {
                if (!IsVertexList(element.properties[i])) return;
                vertices.clear();
                for (const double v : list_) vertices.push_back(ToInteger(v, "a vertex of a face"));
            },
            [&](std::size_t, double) {}, [&] { builder_.AddElement(ElementKind::Polygon, vertices); });
    }

    void ReadEdges(const Element& element) {
        const std::size_t ends[] = {PlaceOf(element, "vertex1"), PlaceOf(element, "vertex2")};
        const std::size_t none = element.properties.size();
        if (ends[0] == none || ends[1] == none) text_.FailHere("the edges need the properties vertex1 and vertex2");
        std::int64_t vertices[2] = {};
        ReadCellRows(
            element, [&](std::size_t i) { return i != ends[0] && i != ends[1]; }, [](std::size_t) {},
            [&](std::size_t i, double value) {
                for (int k = 0; k < 2; ++k) {
                    if (i == ends[k]) vertices[k] = ToInteger(value, "a vertex of an edge");
                }
            },
            [&] { builder_.AddElement(ElementKind::Edge, vertices); });
    }

    /// Rows that are elements of the mesh. Properties for which is_attribute(i) holds become cell data; rows of other
    /// elements, which lack them, get 0.
    template <class IsAttribute, class OnList, class OnNumber, class OnRow>
    void ReadCellRows(const Element& element, IsAttribute is_attribute, OnList on_list, OnNumber on_number,
                      OnRow on_row) {
        const auto first_row = static_cast<std::size_t>(builder_.n_rows());
        std::vector<std::size_t> column_of(element.properties.size(), element.properties.size());
        std::vector<Attribute> columns;
        for (std::size_t i = 0; i < element.properties.size(); ++i) {
            if (element.properties[i].is_list || !is_attribute(i)) continue;
            column_of[i] = columns.size();
            columns.push_back({element.properties[i].name, 1, {}});
        }
        ReadRows(
            element,
            [&](std::size_t i, double value) {
                if (column_of[i] < columns.size()) columns[column_of[i]].values.push_back(value);
                on_number(i, value);
            },
            on_list,
            [&] {
                builder_.NextRow();
                on_row();
            });
        if (element.n == 0) return;
        if (cell_columns_.size() + columns.size() > kMostCellColumns) {
            text_.FailHere("faces and edges have more than " + std::to_string(kMostCellColumns) +
                           " properties together; remove some");
        }
        for (Attribute& column : columns) {
            auto found = std::find_if(cell_columns_.begin(), cell_columns_.end(),
                                      [&](const Attribute& a) { return a.name == column.name; });
            if (found == cell_columns_.end()) found = cell_columns_.insert(found, Attribute{column.name, 1, {}});
            found->values.resize(first_row, 0.0);
            found->values.insert(found->values.end(), column.values.begin(), column.values.end());
        }
        for (Attribute& column : cell_columns_) column.values.resize(static_cast<std::size_t>(builder_.n_rows()), 0.0);
    }

    TextCursor text_;
    MeshBuilder builder_;
    bool binary_ = false;
    bool swap_bytes_ = false;
    std::vector<Element> elements_;
    std::vector<double> list_;
    std::vector<Attribute> cell_columns_;
};

}  // namespace

Mesh ParsePly(std::string_view bytes, const std::string& file) { return PlyReader(bytes, file).Read(); }

}  // namespace SolidSubdiv::Io::Internal

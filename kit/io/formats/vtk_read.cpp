// SPDX-License-Identifier: Apache-2.0
// Reads legacy VTK files (.vtk): unstructured grids and poly data, text or big-endian binary, both layouts of cells.
#include <algorithm>
#include <bit>
#include <optional>

#include <solidsubdiv/kit/io/internal/mesh_builder.h>
#include <solidsubdiv/kit/io/internal/numbers.h>
#include <solidsubdiv/kit/io/internal/percents.h>
#include <solidsubdiv/kit/io/internal/readers.h>
#include <solidsubdiv/kit/io/internal/text.h>
#include <solidsubdiv/kit/io/internal/vtk_cells.h>

namespace SolidSubdiv::Io::Internal {

namespace {

using Integers = std::vector<std::int64_t>;

constexpr NumberType kInt = NumberType::Int32;

/// Legacy type names; "bit" is a type of its own, eight to a byte.
std::optional<NumberType> TypeNamed(const std::string& name) {
    constexpr std::pair<std::string_view, NumberType> names[] = {{"char", NumberType::Int8},
                                                                 {"signed_char", NumberType::Int8},
                                                                 {"unsigned_char", NumberType::UInt8},
                                                                 {"short", NumberType::Int16},
                                                                 {"unsigned_short", NumberType::UInt16},
                                                                 {"int", NumberType::Int32},
                                                                 {"unsigned_int", NumberType::UInt32},
                                                                 {"long", NumberType::Int64},
                                                                 {"unsigned_long", NumberType::UInt64},
                                                                 {"vtkidtype", NumberType::Int32},
                                                                 {"vtktypeint64", NumberType::Int64},
                                                                 {"vtktypeuint64", NumberType::UInt64},
                                                                 {"float", NumberType::Float32},
                                                                 {"double", NumberType::Float64}};
    for (const auto& [key, type] : names) {
        if (key == name) return type;
    }
    return std::nullopt;
}

/// Lists of vertices, one a cell: ends[i] is where list i ends in `vertices`.
struct CellLists {
    Integers vertices;
    Integers ends;
};

class VtkReader {
  public:
    VtkReader(std::string_view bytes, const std::string& file) : text_(bytes, file), builder_(file) {}

    Mesh Read() {
        ReadHeader();
        std::string keyword;
        while (!(keyword = LowerCase(text_.Word())).empty()) ReadSection(keyword);
        if (!have_points_) text_.FailHere("the file ends before any POINTS; is it complete?");
        AddCells();
        for (const auto& [attribute, of_points] : attributes_) AddAttribute(attribute, of_points);
        return builder_.Finish();
    }

  private:
    void ReadHeader() {
        const std::string first = LowerCase(text_.RestOfLine());
        if (first.find("vtk datafile") == first.npos) {
            Fail(text_.file(), "is no legacy VTK file: its first line must be '# vtk DataFile Version ...'");
        }
        text_.RestOfLine();  // the title
        const std::string form = LowerCase(text_.PeekWord());
        if (form != "ascii" && form != "binary") text_.FailExpected("ASCII or BINARY");
        binary_ = form == "binary";
        text_.Word();
        if (LowerCase(text_.PeekWord()) != "dataset") text_.FailExpected("DATASET");
        text_.Word();
        const std::string dataset = LowerCase(text_.PeekWord());
        if (dataset != "unstructured_grid" && dataset != "polydata") {
            text_.FailHere("DATASET " + Quoted(text_.PeekWord()) +
                           " can't be used, only UNSTRUCTURED_GRID and POLYDATA; convert it");
        }
        poly_data_ = dataset == "polydata";
        text_.Word();
    }

    void ReadSection(const std::string& keyword) {
        if (keyword == "points") return ReadPoints();
        if (keyword == "cells" && !poly_data_) return ReadCellLists(cells_);
        if (keyword == "cell_types" && !poly_data_) return ReadCellTypes();
        if (keyword == "vertices" && poly_data_) return ReadCellLists(poly_vertices_);
        if (keyword == "lines" && poly_data_) return ReadCellLists(poly_lines_);
        if (keyword == "polygons" && poly_data_) return ReadCellLists(poly_polygons_);
        if (keyword == "triangle_strips" && poly_data_) return ReadCellLists(poly_strips_);
        if (keyword == "metadata") return SkipMetadata();
        if (keyword == "point_data" || keyword == "cell_data") {
            in_attributes_ = true;
            of_points_ = keyword == "point_data";
            n_rows_ = text_.Integer("the number of rows");
            return;
        }
        if (keyword == "field") return ReadField();
        if (in_attributes_ && ReadAttribute(keyword)) return;
        text_.FailHere("unknown keyword " + Quoted(keyword));
    }

    /// Looks ahead without moving: binary data may follow instead, from the end of this line.
    bool NextWordIs(std::string_view keyword) const {
        TextCursor ahead = text_;
        return LowerCase(ahead.PeekWord().substr(0, keyword.size() + 1)) == keyword;
    }

    // ---- Numbers ----

    NumberType ReadType() {
        const std::string name = LowerCase(text_.PeekWord());
        const std::optional<NumberType> type = TypeNamed(name);
        if (!type) text_.FailHere("the number type " + Quoted(name) + " can't be used; remove the array");
        text_.Word();
        return *type;
    }

    NumberType ReadIntegerType(std::string_view what) {
        const NumberType type = ReadType();
        if (!IsInteger(type)) text_.FailHere(std::string(what) + " must be of an integer type");
        return type;
    }

    /// n * width numbers; refused before anything is allocated if the file's rest is too short for them.
    template <class T>
    std::vector<T> ReadNumbers(std::int64_t n, std::int64_t width, NumberType type, std::string_view what) {
        const std::int64_t min_bytes = binary_ ? SizeOf(type) : 2;
        if (n < 0 || width < 1 || (n > 0 && width > (text_.remaining() + 1) / min_bytes / n)) {
            text_.FailHere(std::to_string(n) + " rows of " + std::to_string(width) + " for " + std::string(what) +
                           " are announced, but only " + Counted(text_.remaining(), "byte", "bytes") +
                           " follow; is the file complete?");
        }
        if (binary_) {
            text_.SkipPastNewline();
            const std::string_view bytes = text_.Bytes(n * width * SizeOf(type), what);
            return ConvertNumbers<T>(bytes, type, std::endian::native != std::endian::big);
        }
        std::vector<T> numbers(static_cast<std::size_t>(n * width));
        for (T& number : numbers) {
            if constexpr (std::is_same_v<T, double>) {
                number = text_.Real("a number of " + std::string(what));
            } else {
                number = text_.Integer("an integer of " + std::string(what));
            }
        }
        return numbers;
    }

    std::vector<double> ReadBits(std::int64_t n, std::int64_t width, std::string_view what) {
        if (!binary_) return ReadNumbers<double>(n, width, NumberType::UInt8, what);
        if (n < 0 || width < 1 || (n > 0 && width > text_.remaining() * 8 / n)) {
            text_.FailHere(std::to_string(n) + " rows are announced for " + std::string(what) + ", but the file ends");
        }
        text_.SkipPastNewline();
        const std::string_view bytes = text_.Bytes((n * width + 7) / 8, what);
        std::vector<double> bits;
        for (std::size_t i = 0; i < static_cast<std::size_t>(n * width); ++i)
            bits.push_back(bytes[i / 8] >> (7 - i % 8) & 1);
        return bits;
    }

    std::vector<double> ReadTypedReals(std::int64_t n, std::int64_t width, std::string_view what) {
        if (LowerCase(text_.PeekWord()) == "bit") {
            text_.Word();
            return ReadBits(n, width, what);
        }
        const NumberType type = ReadType();
        return ReadNumbers<double>(n, width, type, what);
    }

    // ---- Geometry ----

    void ReadPoints() {
        const std::int64_t n = text_.Integer("the number of points");
        RequireIndexable(n, "points", text_.file());
        builder_.AddPositions(ReadTypedReals(n, 3, "POINTS"));
        have_points_ = true;
    }

    void ReadCellLists(CellLists& lists) {
        const std::int64_t n = text_.Integer("the number of cells");
        const std::int64_t size = text_.Integer("the size of the cells");
        if (!lists.ends.empty()) text_.FailHere("a second list of cells of one kind");
        if (NextWordIs("offsets")) {
            ReadOffsetsAndConnectivity(n, size, lists);
        } else {
            SplitLists(n, ReadNumbers<std::int64_t>(size, 1, kInt, "the cells"), lists);
        }
    }

    /// The old layout: for each cell the number of its vertices, then these.
    void SplitLists(std::int64_t n, const Integers& numbers, CellLists& lists) {
        std::size_t at = 0;
        for (std::int64_t cell = 0; cell < n; ++cell) {
            const std::int64_t length = at < numbers.size() ? numbers[at++] : -1;
            if (length < 0 || length > static_cast<std::int64_t>(numbers.size() - at)) {
                text_.FailHere("the list of cell " + std::to_string(cell) +
                               " does not fit the announced size of the cells");
            }
            const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(at);
            lists.vertices.insert(lists.vertices.end(), first, first + static_cast<std::ptrdiff_t>(length));
            lists.ends.push_back(static_cast<std::int64_t>(lists.vertices.size()));
            at += static_cast<std::size_t>(length);
        }
        if (at != numbers.size()) text_.FailHere("the announced size of the cells does not fit their lists");
    }

    /// The layout of version 5: n - 1 cells, n offsets, then all vertices.
    void ReadOffsetsAndConnectivity(std::int64_t n, std::int64_t size, CellLists& lists) {
        text_.Word();
        const NumberType offset_type = ReadIntegerType("OFFSETS");
        const Integers offsets = ReadNumbers<std::int64_t>(n, 1, offset_type, "OFFSETS");
        if (LowerCase(text_.PeekWord()) != "connectivity") text_.FailExpected("CONNECTIVITY");
        text_.Word();
        const NumberType type = ReadIntegerType("CONNECTIVITY");
        lists.vertices = ReadNumbers<std::int64_t>(size, 1, type, "CONNECTIVITY");
        for (std::size_t cell = 1; cell < offsets.size(); ++cell) {
            if (offsets[0] != 0 || offsets[cell] < offsets[cell - 1] || offsets[cell] > size) {
                text_.FailHere("the offsets of cell " + std::to_string(cell - 1) + " are wrong");
            }
            lists.ends.push_back(offsets[cell]);
        }
    }

    void ReadCellTypes() {
        const std::int64_t n = text_.Integer("the number of cells");
        types_ = ReadNumbers<std::int64_t>(n, 1, kInt, "CELL_TYPES");
    }

    void AddCells() {
        if (!poly_data_) {
            if (types_.size() != cells_.ends.size()) {
                Fail(text_.file(), "has " + std::to_string(cells_.ends.size()) + " CELLS but " +
                                       std::to_string(types_.size()) + " CELL_TYPES");
            }
            return AddCells(cells_, [&](std::size_t cell) { return types_[cell]; });
        }
        // Cell data count the kinds in this order, whatever their order in the file.
        AddCells(poly_vertices_, [](std::size_t) { return 2; });
        AddCells(poly_lines_, [](std::size_t) { return 4; });
        AddCells(poly_polygons_, [](std::size_t) { return 7; });
        AddCells(poly_strips_, [](std::size_t) { return 6; });
    }

    template <class TypeOf>
    void AddCells(const CellLists& lists, TypeOf type_of) {
        std::int64_t begin = 0;
        for (std::size_t cell = 0; cell < lists.ends.size(); ++cell) {
            const std::span<const std::int64_t> list(lists.vertices.data() + begin,
                                                     static_cast<std::size_t>(lists.ends[cell] - begin));
            begin = lists.ends[cell];
            const std::int64_t type = type_of(cell);
            if (type == kVtkPolyhedron) {
                AddVtkCell(builder_, type, {}, list);
            } else {
                AddVtkCell(builder_, type, list, {});
            }
        }
    }

    // ---- Attributes ----

    std::string ReadName() {
        const std::string_view name = text_.Word();
        if (name.empty()) text_.FailExpected("the name of an array");
        return DecodePercents(name);
    }

    void Keep(std::string name, std::int64_t width, std::vector<double> values) {
        attributes_.push_back({{std::move(name), static_cast<int>(width), std::move(values)}, of_points_});
    }

    /// Returns false if the keyword is none of an attribute.
    bool ReadAttribute(const std::string& keyword) {
        if (keyword == "lookup_table") {
            ReadName();
            const std::int64_t n = text_.Integer("the size of the table");
            ReadNumbers<double>(n, 4, NumberType::UInt8, "LOOKUP_TABLE");
            return true;
        }
        if (keyword == "color_scalars") {
            std::string name = ReadName();
            const std::int64_t width = text_.Integer("the number of components");
            std::vector<double> values = ReadNumbers<double>(n_rows_, width, NumberType::UInt8, "COLOR_SCALARS");
            if (binary_) {
                for (double& v : values) v /= 255;  // bytes stand for 0 to 1
            }
            Keep(std::move(name), width, std::move(values));
            return true;
        }
        constexpr std::pair<std::string_view, int> widths[] = {
            {"scalars", 1},  {"vectors", 3},    {"normals", 3},      {"texture_coordinates", 0}, {"tensors", 9},
            {"tensors6", 6}, {"global_ids", 1}, {"pedigree_ids", 1}, {"edge_flags", 1}};
        const auto found =
            std::find_if(std::begin(widths), std::end(widths), [&](const auto& w) { return w.first == keyword; });
        if (found == std::end(widths)) return false;

        std::string name = ReadName();
        std::int64_t width = found->second;
        if (keyword == "texture_coordinates") width = text_.Integer("the number of components");
        if (keyword == "scalars") return ReadScalars(std::move(name));
        Keep(std::move(name), width, ReadTypedReals(n_rows_, width, Quoted(keyword)));
        return true;
    }

    /// SCALARS name type [components], then usually LOOKUP_TABLE name, then the numbers.
    bool ReadScalars(std::string name) {
        TextCursor type = text_;
        text_.Word();
        TextCursor line = text_;
        TextCursor rest(line.RestOfLine(), text_.file());
        const std::int64_t width = rest.SkipSpace() ? text_.Integer("the number of components") : 1;
        if (NextWordIs("lookup_table")) {
            text_.Word();
            ReadName();
        }
        const std::string type_name = LowerCase(type.PeekWord());
        if (type_name == "bit") {
            Keep(std::move(name), width, ReadBits(n_rows_, width, "SCALARS"));
            return true;
        }
        const std::optional<NumberType> number_type = TypeNamed(type_name);
        if (!number_type) type.FailHere("the number type " + Quoted(type_name) + " can't be used; remove the array");
        Keep(std::move(name), width, ReadNumbers<double>(n_rows_, width, *number_type, "SCALARS"));
        return true;
    }

    /// FIELD name n, then n times: name components rows type, numbers.
    void ReadField() {
        ReadName();
        const std::int64_t n_arrays = text_.Integer("the number of arrays");
        for (std::int64_t i = 0; i < n_arrays; ++i) {
            if (LowerCase(text_.PeekWord()) == "metadata") {
                text_.Word();
                SkipMetadata();
            }
            std::string name = ReadName();
            const std::int64_t width = text_.Integer("the number of components");
            const std::int64_t rows = text_.Integer("the number of rows");
            std::vector<double> values = ReadTypedReals(rows, width, "array " + Quoted(name));
            if (!in_attributes_) continue;
            if (rows == n_rows_) {
                Keep(std::move(name), width, std::move(values));
            } else {
                builder_.AddNote("array " + Quoted(name) + " has not one row for each element and is left out");
            }
        }
    }

    /// Information keys up to an empty line.
    void SkipMetadata() {
        text_.RestOfLine();
        while (text_.remaining() > 0) {
            TextCursor line(text_.RestOfLine(), text_.file());
            if (!line.SkipSpace()) return;
        }
    }

    void AddAttribute(const Attribute& attribute, bool of_points) {
        const Offset rows = static_cast<Offset>(attribute.values.size()) / std::max(attribute.width, 1);
        const Offset needed = of_points ? builder_.n_vertices() : builder_.n_rows();
        if (rows != needed) {
            Fail(text_.file(), std::string(of_points ? "POINT_DATA" : "CELL_DATA") + " has " + std::to_string(rows) +
                                   " rows, but there are " + std::to_string(needed) +
                                   (of_points ? " points" : " cells"));
        }
        of_points ? builder_.AddPointData(attribute) : builder_.AddCellData(attribute);
    }

    TextCursor text_;
    MeshBuilder builder_;
    bool binary_ = false;
    bool poly_data_ = false;
    bool have_points_ = false;

    CellLists cells_;
    Integers types_;
    CellLists poly_vertices_, poly_lines_, poly_polygons_, poly_strips_;

    bool in_attributes_ = false;
    bool of_points_ = false;
    std::int64_t n_rows_ = 0;
    std::vector<std::pair<Attribute, bool>> attributes_;  // and whether it is of points
};

}  // namespace

Mesh ParseVtk(std::string_view bytes, const std::string& file) { return VtkReader(bytes, file).Read(); }

}  // namespace SolidSubdiv::Io::Internal

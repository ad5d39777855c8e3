// SPDX-License-Identifier: Apache-2.0
// Reads VTK XML unstructured grids (.vtu): every encoding, byte order and number type that VTK itself writes.
#include <algorithm>
#include <pugixml.hpp>

#include <solidsubdiv/kit/io/internal/mesh_builder.h>
#include <solidsubdiv/kit/io/internal/readers.h>
#include <solidsubdiv/kit/io/internal/text.h>
#include <solidsubdiv/kit/io/internal/vtk_cells.h>
#include <solidsubdiv/kit/io/internal/vtu_arrays.h>

namespace SolidSubdiv::Io::Internal {

namespace {

using Integers = std::vector<std::int64_t>;

/// The XML proper, and what stands in AppendedData: that may be raw bytes, which no XML parser takes.
struct VtuParts {
    std::string xml;
    std::string_view appended;
};

VtuParts CutAppendedData(std::string_view bytes) {
    const std::size_t tag = bytes.find("<AppendedData");
    const std::size_t tag_end = tag == bytes.npos ? tag : bytes.find('>', tag);
    if (tag_end == bytes.npos || bytes[tag_end - 1] == '/') return {std::string(bytes), {}};
    VtuParts parts;
    parts.xml = std::string(bytes.substr(0, tag_end + 1)) + "</AppendedData></VTKFile>";
    parts.appended = bytes.substr(tag_end + 1);
    parts.appended = parts.appended.substr(0, parts.appended.rfind("</AppendedData>"));
    const std::size_t underscore = parts.appended.find('_');
    parts.appended.remove_prefix(underscore == bytes.npos ? parts.appended.size() : underscore + 1);
    return parts;
}

/// One <Piece>.
class PieceReader {
  public:
    PieceReader(const pugi::xml_node& piece, const VtuArrays& arrays, MeshBuilder& builder)
        : piece_(piece),
          arrays_(arrays),
          builder_(builder),
          n_points_(CountNamed("NumberOfPoints")),
          n_cells_(CountNamed("NumberOfCells")) {}

    void ReadMesh() {
        first_vertex_ = builder_.n_vertices();
        ReadPoints();
        ReadCells();
    }

    std::vector<Attribute> ReadAttributes(const char* section, Offset n_rows) {
        std::vector<Attribute> attributes;
        for (const pugi::xml_node array : piece_.child(section).children("DataArray")) {
            Attribute attribute;
            attribute.name = array.attribute("Name").as_string();
            if (!VtuArrays::HoldsNumbers(array)) {
                builder_.AddNote(VtuArrays::PlaceOf(array) + " holds no numbers and is left out");
                continue;
            }
            attribute.width = array.attribute("NumberOfComponents").as_int(1);
            attribute.values = arrays_.Reals(array);
            RequireSize(array, attribute.values.size(), n_rows, attribute.width);
            attributes.push_back(std::move(attribute));
        }
        return attributes;
    }

    Offset n_points() const { return n_points_; }
    Offset n_cells() const { return n_cells_; }

  private:
    std::int64_t CountNamed(const char* name) const {
        TextCursor text(piece_.attribute(name).as_string(), builder_.file(), std::string(name) + " of a Piece");
        const std::int64_t n = text.Integer("a number");
        if (n < 0) text.FailHere("it is " + std::to_string(n));
        RequireIndexable(n, name, builder_.file());
        return n;
    }

    void RequireSize(const pugi::xml_node& array, std::size_t size, Offset n_rows, Offset width) const {
        if (width >= 1 && static_cast<Offset>(size) % width == 0 && static_cast<Offset>(size) / width == n_rows) return;
        Fail(builder_.file(), VtuArrays::PlaceOf(array) + " has " + std::to_string(size) + " numbers; " +
                                  std::to_string(n_rows) + " rows of " + std::to_string(width) + " are needed");
    }

    pugi::xml_node CellsArray(const char* name, bool required) const {
        const pugi::xml_node array = piece_.child("Cells").find_child_by_attribute("DataArray", "Name", name);
        if (!array && required) Fail(builder_.file(), "a Piece has no array '" + std::string(name) + "' in its Cells");
        return array;
    }

    void ReadPoints() {
        if (n_points_ == 0) return;
        const pugi::xml_node array = piece_.child("Points").child("DataArray");
        if (!array) Fail(builder_.file(), "a Piece has no array in its Points");
        const std::vector<double> coordinates = arrays_.Reals(array);
        RequireSize(array, coordinates.size(), n_points_, 3);
        builder_.AddPositions(coordinates);
    }

    void ReadCells() {
        if (n_cells_ == 0) return;
        const Integers types = IntegersOf("types");
        const Integers ends = IntegersOf("offsets");
        RequireSize(CellsArray("types", true), types.size(), n_cells_, 1);
        RequireSize(CellsArray("offsets", true), ends.size(), n_cells_, 1);
        Integers connectivity = IntegersOf("connectivity");
        ReadFaces(types);

        std::int64_t begin = 0;
        for (std::size_t cell = 0; cell < types.size(); ++cell) {
            const std::span<std::int64_t> points = Slice(connectivity, begin, ends[cell], cell, "connectivity");
            begin = ends[cell];
            for (std::int64_t& v : points) v = ToGlobal(v, cell);
            AddVtkCell(builder_, types[cell], points, FacesOf(cell));
        }
    }

    Integers IntegersOf(const char* name) const { return arrays_.Integers(CellsArray(name, true)); }

    /// Vertices count on from piece to piece.
    std::int64_t ToGlobal(std::int64_t vertex, std::size_t cell) const {
        if (vertex < 0 || vertex >= n_points_) {
            Fail(builder_.file(), "cell " + std::to_string(cell) + " names vertex " + std::to_string(vertex) +
                                      ", but there are " + Counted(n_points_, "vertex", "vertices"));
        }
        return vertex + first_vertex_;
    }

    std::span<std::int64_t> Slice(Integers& all, std::int64_t begin, std::int64_t end, std::size_t cell,
                                  const char* name) const {
        if (begin < 0 || end < begin || end > static_cast<std::int64_t>(all.size())) {
            Fail(builder_.file(), "cell " + std::to_string(cell) + " takes the numbers from " + std::to_string(begin) +
                                      " to " + std::to_string(end) + " of '" + name + "', which has " +
                                      std::to_string(all.size()));
        }
        return {all.data() + begin, static_cast<std::size_t>(end - begin)};
    }

    /// Polyhedra, in either of VTK's layouts, become one stream of faces a cell.
    void ReadFaces(const Integers& types) {
        if (std::find(types.begin(), types.end(), kVtkPolyhedron) == types.end()) return;
        if (CellsArray("face_connectivity", false)) return ReadFaceTables();
        Integers faces = IntegersOf("faces");
        const Integers ends = IntegersOf("faceoffsets");
        RequireSize(CellsArray("faceoffsets", true), ends.size(), n_cells_, 1);
        std::int64_t begin = 0;
        for (std::size_t cell = 0; cell < types.size(); ++cell) {
            if (types[cell] == kVtkPolyhedron) {
                const std::span<std::int64_t> stream = Slice(faces, begin, ends[cell], cell, "faces");
                begin = ends[cell];
                ToGlobalStream(stream, cell);
                face_streams_.insert(face_streams_.end(), stream.begin(), stream.end());
            }
            stream_ends_.push_back(face_streams_.size());
        }
    }

    /// A stream mixes counts and vertices; only the latter are shifted.
    void ToGlobalStream(std::span<std::int64_t> stream, std::size_t cell) const {
        for (std::size_t at = 1; at < stream.size();) {
            const std::int64_t n = stream[at++];
            for (std::int64_t i = 0; i < n && at < stream.size(); ++i, ++at) stream[at] = ToGlobal(stream[at], cell);
        }
    }

    /// VTK 9.4 and later: faces of cells and vertices of faces in tables.
    void ReadFaceTables() {
        Integers vertices = IntegersOf("face_connectivity");
        const Integers face_ends = IntegersOf("face_offsets");
        Integers cell_faces = IntegersOf("polyhedron_to_faces");
        const Integers cell_ends = IntegersOf("polyhedron_offsets");
        RequireSize(CellsArray("polyhedron_offsets", true), cell_ends.size(), n_cells_, 1);
        std::vector<std::uint8_t> uses(face_ends.size(), 0);
        std::int64_t begin = 0;
        for (std::size_t cell = 0; cell < cell_ends.size(); ++cell) {
            const auto faces = Slice(cell_faces, begin, cell_ends[cell], cell, "polyhedron_to_faces");
            begin = cell_ends[cell];
            if (!faces.empty()) face_streams_.push_back(static_cast<std::int64_t>(faces.size()));
            for (const std::int64_t face : faces) {
                if (face < 0 || face >= static_cast<std::int64_t>(face_ends.size())) {
                    Fail(builder_.file(), "cell " + std::to_string(cell) + " names face " + std::to_string(face) +
                                              ", which is not there");
                }
                if (++uses[static_cast<std::size_t>(face)] > 2) {
                    Fail(builder_.file(), "face " + std::to_string(face) + " belongs to more than two cells");
                }
                const std::int64_t face_begin = face == 0 ? 0 : face_ends[static_cast<std::size_t>(face) - 1];
                const auto corners =
                    Slice(vertices, face_begin, face_ends[static_cast<std::size_t>(face)], cell, "face_connectivity");
                face_streams_.push_back(static_cast<std::int64_t>(corners.size()));
                for (const std::int64_t v : corners) face_streams_.push_back(ToGlobal(v, cell));
            }
            stream_ends_.push_back(face_streams_.size());
        }
    }

    std::span<const std::int64_t> FacesOf(std::size_t cell) const {
        if (stream_ends_.empty()) return {};
        const std::size_t begin = cell == 0 ? 0 : stream_ends_[cell - 1];
        return std::span(face_streams_).subspan(begin, stream_ends_[cell] - begin);
    }

    const pugi::xml_node& piece_;
    const VtuArrays& arrays_;
    MeshBuilder& builder_;
    std::int64_t n_points_;
    std::int64_t n_cells_;
    std::int64_t first_vertex_ = 0;
    Integers face_streams_;
    std::vector<std::size_t> stream_ends_;
};

/// Appends a further piece's attributes to those of the pieces before.
void AppendAttributes(std::vector<Attribute>& all, std::vector<Attribute> piece, bool first_piece,
                      MeshBuilder& builder) {
    if (first_piece) {
        all = std::move(piece);
        return;
    }
    for (Attribute& attribute : all) {
        const auto found = std::find_if(piece.begin(), piece.end(), [&](const Attribute& a) {
            return a.name == attribute.name && a.width == attribute.width;
        });
        if (found == piece.end()) {
            Fail(builder.file(), "array " + Quoted(attribute.name) + " is not there in every Piece; add or remove it");
        }
        attribute.values.insert(attribute.values.end(), found->values.begin(), found->values.end());
    }
}

}  // namespace

Mesh ParseVtu(std::string_view bytes, const std::string& file) {
    VtuParts parts = CutAppendedData(bytes);
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer_inplace(parts.xml.data(), parts.xml.size());
    if (!parsed) {
        TextCursor place(bytes, file);
        place.Bytes(std::min<std::int64_t>(parsed.offset, place.remaining()), "XML");
        place.FailHere("is no complete XML: " + LowerCase(parsed.description()));
    }
    const pugi::xml_node vtk_file = document.child("VTKFile");
    if (!vtk_file) Fail(file, "is no VTK file: it has no element VTKFile");
    const pugi::xml_node grid = vtk_file.child("UnstructuredGrid");
    if (!grid) {
        Fail(file, "holds " + Quoted(vtk_file.attribute("type").as_string()) + ", not an UnstructuredGrid; convert it");
    }

    const std::string_view encoding = vtk_file.child("AppendedData").attribute("encoding").as_string("raw");
    const VtuArrays arrays(vtk_file, parts.appended, encoding == "raw", file);
    MeshBuilder builder(file);
    std::vector<Attribute> point_data, cell_data;
    bool first_piece = true;
    for (const pugi::xml_node piece : grid.children("Piece")) {
        PieceReader reader(piece, arrays, builder);
        reader.ReadMesh();
        AppendAttributes(point_data, reader.ReadAttributes("PointData", reader.n_points()), first_piece, builder);
        AppendAttributes(cell_data, reader.ReadAttributes("CellData", reader.n_cells()), first_piece, builder);
        first_piece = false;
    }
    if (first_piece) Fail(file, "has no Piece in its UnstructuredGrid");
    for (Attribute& attribute : point_data) builder.AddPointData(std::move(attribute));
    for (Attribute& attribute : cell_data) builder.AddCellData(std::move(attribute));
    return builder.Finish();
}

}  // namespace SolidSubdiv::Io::Internal

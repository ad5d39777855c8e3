// SPDX-License-Identifier: Apache-2.0
// Makes a consistent Mesh of what a reader finds: elements of all kinds in the file's order, attributes row by row.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <solidsubdiv/kit/io/internal/elements.h>

namespace SolidSubdiv::Io::Internal {

/// Readers hand in numbers as the file has them, counted from 0; every check that is the same for all formats is here.
///
/// A *row* is what the file counts as an element and has one row of cell data for. Most rows become one element; some
/// (polylines, strips) become several, with the same data; some none.
class MeshBuilder {
  public:
    /// `first_number` is what the file's own count of vertices and elements starts with, for messages.
    explicit MeshBuilder(std::string file, int first_number = 0)
        : file_(std::move(file)), first_number_(first_number) {}

    /// Appends vertices, three coordinates each. @throws IoError naming the vertex that isn't finite
    void AddPositions(std::span<const double> coordinates);
    Offset n_vertices() const { return static_cast<Offset>(mesh_.positions.size() / 3); }

    /// Starts the next row and returns its number.
    Offset NextRow();
    Offset n_rows() const { return n_rows_; }

    /// Adds an element of the latest row. Polygons of 3 and 4 vertices become triangles and quads.
    void AddElement(ElementKind kind, std::span<const std::int64_t> vertices);
    /// Adds a polyhedron of the latest row: the number of its faces, then for each face its size and vertices.
    /// Octahedra are recognized; their pairs of opposite vertices come in the order in which `listed` names them.
    void AddPolyhedron(std::span<const std::int64_t> listed, std::span<const std::int64_t> face_stream);

    /// A row a vertex.
    void AddPointData(Attribute attribute) { point_data_.push_back(std::move(attribute)); }
    /// A row a file's row.
    void AddCellData(Attribute attribute) { cell_data_.push_back(std::move(attribute)); }
    void AddNote(std::string note) { mesh_.notes.push_back(std::move(note)); }

    /// Checks indices and lengths and puts cell data in the mesh's order. Attributes that aren't finite are left out
    /// with a note. @throws IoError naming the element
    Mesh Finish();

    const std::string& file() const { return file_; }

  private:
    Index ToVertex(std::int64_t vertex) const;
    void AppendVertices(std::vector<Index>& to, std::span<const std::int64_t> vertices) const;
    void CountElement(ElementKind kind);
    void CheckVertices() const;
    std::string ElementName(ElementKind kind, std::size_t element) const;
    void AddChecked(std::vector<Attribute>& to, std::set<std::string>& names, Attribute attribute, Offset n_rows,
                    const char* what);
    std::vector<double> InMeshOrder(const Attribute& by_row) const;

    std::string file_;
    int first_number_;
    Mesh mesh_;
    Offset n_rows_ = 0;
    std::array<std::vector<Index>, kElementKinds> rows_;  // per kind, for each element its row
    std::vector<Attribute> point_data_;
    std::vector<Attribute> cell_data_;
};

/// A number of vertices or elements that this build can't index is refused, with the number.
void RequireIndexable(std::int64_t n, std::string_view what, const std::string& file);

}  // namespace SolidSubdiv::Io::Internal

// SPDX-License-Identifier: Apache-2.0
// Collects elements and attributes and checks them.
#include <solidsubdiv/kit/io/internal/mesh_builder.h>

#include <cmath>
#include <limits>

#include <solidsubdiv/kit/io/internal/octahedra.h>
#include <solidsubdiv/kit/io/internal/text.h>

namespace SolidSubdiv::Io::Internal {

namespace {

std::size_t At(ElementKind kind) { return static_cast<std::size_t>(kind); }

/// Place of the first number that isn't finite, or the size. (x - x is 0 for finite numbers, NaN for all others; the
/// sum over a block needs no branch.)
std::size_t FindNotFinite(std::span<const double> values) {
    constexpr std::size_t block = 4096;
    for (std::size_t first = 0; first < values.size(); first += block) {
        const std::size_t last = std::min(first + block, values.size());
        double sum = 0;
        for (std::size_t i = first; i < last; ++i) sum += values[i] - values[i];
        if (sum == 0) continue;
        for (std::size_t i = first; i < last; ++i) {
            if (!std::isfinite(values[i])) return i;
        }
    }
    return values.size();
}

}  // namespace

void RequireIndexable(std::int64_t n, std::string_view what, const std::string& file) {
    constexpr std::int64_t most = std::numeric_limits<Index>::max();
    if (n <= most) return;
    Fail(file, "has " + std::to_string(n) + " " + std::string(what) + "; at most " + std::to_string(most) +
                   " can be handled, split the mesh");
}

void MeshBuilder::AddPositions(std::span<const double> coordinates) {
    const std::size_t bad = FindNotFinite(coordinates);
    if (bad != coordinates.size()) {
        const Offset vertex = n_vertices() + static_cast<Offset>(bad / 3) + first_number_;
        Fail(file_, "vertex " + std::to_string(vertex) + " has a coordinate " + "xyz"[bad % 3] +
                        " that is not a finite number; correct or remove it");
    }
    mesh_.positions.insert(mesh_.positions.end(), coordinates.begin(), coordinates.end());
    RequireIndexable(n_vertices(), "vertices", file_);
}

Offset MeshBuilder::NextRow() {
    RequireIndexable(n_rows_ + 1, "elements", file_);
    return n_rows_++;
}

Index MeshBuilder::ToVertex(std::int64_t vertex) const {
    if (vertex < 0 || vertex > std::numeric_limits<Index>::max()) {
        Fail(file_, "element " + std::to_string(n_rows_ - 1 + first_number_) + " names vertex " +
                        std::to_string(vertex + first_number_) + ", which is not there");
    }
    return static_cast<Index>(vertex);
}

void MeshBuilder::AppendVertices(std::vector<Index>& to, std::span<const std::int64_t> vertices) const {
    for (const std::int64_t v : vertices) to.push_back(ToVertex(v));
}

void MeshBuilder::CountElement(ElementKind kind) {
    std::vector<Index>& rows = rows_[At(kind)];
    RequireIndexable(static_cast<Offset>(rows.size()) + 1, InfoOf(kind).plural, file_);
    rows.push_back(static_cast<Index>(n_rows_ - 1));
}

void MeshBuilder::AddElement(ElementKind kind, std::span<const std::int64_t> vertices) {
    if (kind == ElementKind::Polygon) {
        if (vertices.size() < 3) {
            Fail(file_, "element " + std::to_string(n_rows_ - 1 + first_number_) + " is a polygon of " +
                            Counted(static_cast<Offset>(vertices.size()), "vertex", "vertices") + "; remove it");
        }
        if (vertices.size() == 3) kind = ElementKind::Triangle;
        if (vertices.size() == 4) kind = ElementKind::Quad;
    }
    AppendVertices(VerticesOf(mesh_.topology, kind), vertices);
    if (kind == ElementKind::Polygon) {
        std::vector<Offset>& offsets = mesh_.topology.polygon_offsets;
        if (offsets.empty()) offsets.push_back(0);
        offsets.push_back(static_cast<Offset>(mesh_.topology.polygon_vertices.size()));
    }
    CountElement(kind);
}

void MeshBuilder::AddPolyhedron(std::span<const std::int64_t> listed, std::span<const std::int64_t> face_stream) {
    const auto fail = [&](const std::string& what) {
        Fail(file_,
             "element " + std::to_string(n_rows_ - 1 + first_number_) + " is a polyhedron whose list of faces " + what);
    };
    Topology& topology = mesh_.topology;
    std::vector<Index> vertices;
    std::vector<Offset> face_ends;
    const std::int64_t n_faces = face_stream.empty() ? 0 : face_stream[0];
    std::size_t at = 1;
    for (std::int64_t face = 0; face < n_faces; ++face) {
        if (at >= face_stream.size()) fail("ends too early");
        const std::int64_t n = face_stream[at++];
        if (n < 3) fail("has one of less than three vertices");
        if (n > static_cast<std::int64_t>(face_stream.size() - at)) fail("ends too early");
        AppendVertices(vertices, face_stream.subspan(at, static_cast<std::size_t>(n)));
        face_ends.push_back(static_cast<Offset>(vertices.size()));
        at += static_cast<std::size_t>(n);
    }
    if (face_ends.size() < 4) fail("has less than four faces");

    std::vector<Index> listed_vertices;
    AppendVertices(listed_vertices, listed);
    std::array<Index, 6> oct;
    if (face_ends.size() == 8 && vertices.size() == 24 && RecognizeOctahedron(listed_vertices, vertices, oct)) {
        topology.octs.insert(topology.octs.end(), oct.begin(), oct.end());
        CountElement(ElementKind::Oct);
        return;
    }
    if (topology.polyhedron_offsets.empty()) {
        topology.polyhedron_offsets.push_back(0);
        topology.polyhedron_face_offsets.push_back(0);
    }
    const auto first = static_cast<Offset>(topology.polyhedron_vertices.size());
    for (const Offset end : face_ends) topology.polyhedron_face_offsets.push_back(first + end);
    topology.polyhedron_vertices.insert(topology.polyhedron_vertices.end(), vertices.begin(), vertices.end());
    topology.polyhedron_offsets.push_back(static_cast<Offset>(topology.polyhedron_face_offsets.size()) - 1);
    CountElement(ElementKind::Polyhedron);
}

std::string MeshBuilder::ElementName(ElementKind kind, std::size_t element) const {
    const Offset row = rows_[At(kind)][element] + static_cast<Offset>(first_number_);
    return std::string(InfoOf(kind).name) + " (element " + std::to_string(row) + " of the file)";
}

void MeshBuilder::CheckVertices() const {
    for (const ElementKind kind : kAllElementKinds) {
        const std::vector<Index>& vertices = VerticesOf(mesh_.topology, kind);
        Index largest = -1;
        for (const Index v : vertices) largest = std::max(largest, v);
        if (largest < n_vertices()) continue;
        std::size_t at = 0;
        while (vertices[at] < n_vertices()) ++at;
        std::size_t element = 0;
        if (kind == ElementKind::Polyhedron || kind == ElementKind::Polygon) {
            const Topology& t = mesh_.topology;
            const auto end = [&](std::size_t e) {
                if (kind == ElementKind::Polygon) return t.polygon_offsets[e + 1];
                return t.polyhedron_face_offsets[static_cast<std::size_t>(t.polyhedron_offsets[e + 1])];
            };
            while (end(element) <= static_cast<Offset>(at)) ++element;
        } else {
            element = at / static_cast<std::size_t>(InfoOf(kind).n_vertices);
        }
        Fail(file_, "a " + ElementName(kind, element) + " names vertex " +
                        std::to_string(vertices[at] + static_cast<Offset>(first_number_)) + ", but there " +
                        (n_vertices() == 1 ? "is " : "are ") + Counted(n_vertices(), "vertex", "vertices"));
    }
}

std::vector<double> MeshBuilder::InMeshOrder(const Attribute& by_row) const {
    const auto width = static_cast<std::size_t>(by_row.width);
    std::size_t n_elements = 0;
    for (const std::vector<Index>& rows : rows_) n_elements += rows.size();
    std::vector<double> values;
    values.reserve(n_elements * width);
    for (const std::vector<Index>& rows : rows_) {
        for (const Index row : rows) {
            const double* first = by_row.values.data() + static_cast<std::size_t>(row) * width;
            values.insert(values.end(), first, first + width);
        }
    }
    return values;
}

void MeshBuilder::AddChecked(std::vector<Attribute>& to, std::set<std::string>& names, Attribute attribute,
                             Offset n_rows, const char* what) {
    const std::string label = std::string(what) + " " + Quoted(attribute.name);
    if (attribute.width < 1 || static_cast<Offset>(attribute.values.size()) != n_rows * attribute.width) {
        Fail(file_, label + " has " + Counted(static_cast<Offset>(attribute.values.size()), "number", "numbers") +
                        " where " + std::to_string(n_rows) + " rows of " + std::to_string(attribute.width) +
                        " are needed");
    }
    if (!names.insert(attribute.name).second) {
        AddNote(label + " is there twice; the first one is used");
        return;
    }
    const std::size_t bad = FindNotFinite(attribute.values);
    if (bad != attribute.values.size()) {
        const auto row = static_cast<Offset>(bad) / attribute.width + first_number_;
        AddNote(label + " is left out: row " + std::to_string(row) + " is not a finite number");
        return;
    }
    to.push_back(std::move(attribute));
}

Mesh MeshBuilder::Finish() {
    mesh_.topology.n_vertices = static_cast<Index>(n_vertices());
    CheckVertices();
    std::set<std::string> names;
    for (Attribute& a : point_data_) AddChecked(mesh_.point_data, names, std::move(a), n_vertices(), "point data");
    names.clear();
    for (Attribute& a : cell_data_) AddChecked(mesh_.cell_data, names, std::move(a), n_rows_, "cell data");
    for (Attribute& attribute : mesh_.cell_data) attribute.values = InMeshOrder(attribute);
    return std::move(mesh_);
}

}  // namespace SolidSubdiv::Io::Internal

// SPDX-License-Identifier: Apache-2.0
// Writes PLY (.ply), little-endian binary or text: vertices, faces, edges, all attributes as further properties.
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>

#include <solidsubdiv/kit/io/internal/files.h>
#include <solidsubdiv/kit/io/internal/text.h>
#include <solidsubdiv/kit/io/internal/writers.h>
#include <solidsubdiv/kit/io/internal/writing.h>

namespace SolidSubdiv::Io::Internal {

namespace {

class PlyWriter {
  public:
    PlyWriter(const std::filesystem::path& path, const Mesh& mesh, bool binary)
        : file_(path), mesh_(mesh), binary_(binary) {}

    void Write() {
        const Topology& t = mesh_.topology;
        const Offset n_faces = t.n_triangles() + t.n_quads() + t.n_polygons();
        for (Offset i = 0; i < t.n_polygons(); ++i) {
            wide_lists_ = wide_lists_ || ElementVertices(t, ElementKind::Polygon, i).size() > 255;
        }
        file_ << "ply\nformat " << (binary_ ? "binary_little_endian" : "ascii")
              << " 1.0\ncomment written by SolidSubdiv\n"
              << "element vertex " << t.n_vertices << "\nproperty double x\nproperty double y\nproperty double z\n";
        WriteProperties(mesh_.point_data);
        if (n_faces > 0) {
            file_ << "element face " << n_faces << "\nproperty list " << (wide_lists_ ? "int" : "uchar")
                  << " int vertex_indices\n";
            WriteProperties(mesh_.cell_data);
        }
        if (t.n_edges() > 0) {
            file_ << "element edge " << t.n_edges() << "\nproperty int vertex1\nproperty int vertex2\n";
            WriteProperties(mesh_.cell_data);
        }
        file_ << "end_header\n";

        for (std::size_t i = 0; i < static_cast<std::size_t>(t.n_vertices); ++i) {
            for (std::size_t k = 0; k < 3; ++k) Put(mesh_.positions[3 * i + k]);
            EndRow(mesh_.point_data, i);
        }
        std::size_t row = 0;
        ForEachElement(t, [&](ElementKind kind, Offset element) {
            const std::span<const Index> vertices = ElementVertices(t, kind, element);
            if (kind != ElementKind::Edge) PutLength(vertices.size());
            for (const Index v : vertices) Put(v);
            EndRow(mesh_.cell_data, row++);
        });
        file_.Commit();
    }

  private:
    /// An attribute of several numbers becomes the properties NAME_0, NAME_1, ...
    void WriteProperties(const std::vector<Attribute>& attributes) {
        for (const Attribute& a : attributes) {
            std::string name = a.name.empty() ? "unnamed" : a.name;
            std::replace_if(name.begin(), name.end(), IsSpace, '_');
            for (int k = 0; k < a.width; ++k) {
                file_ << "property double " << name;
                if (a.width > 1) file_ << '_' << k;
                file_ << '\n';
            }
        }
    }

    void EndRow(const std::vector<Attribute>& attributes, std::size_t row) {
        for (const Attribute& a : attributes) {
            const auto width = static_cast<std::size_t>(a.width);
            for (std::size_t k = 0; k < width; ++k) Put(a.values[row * width + k]);
        }
        if (!binary_) file_ << '\n';
    }

    void PutLength(std::size_t n) {
        if (binary_ && !wide_lists_) {
            file_ << static_cast<char>(n);
        } else {
            Put(static_cast<Index>(n));
        }
    }

    template <class T>
    void Put(T number) {
        if (!binary_) {
            file_ << number << ' ';
            return;
        }
        std::array<char, sizeof(T)> bytes;
        std::memcpy(bytes.data(), &number, sizeof(T));
        if (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
        file_ << std::string_view(bytes.data(), bytes.size());
    }

    OutputFile file_;
    const Mesh& mesh_;
    bool binary_;
    bool wide_lists_ = false;
};

}  // namespace

void WritePly(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions& options) {
    constexpr std::array kinds = {ElementKind::Triangle, ElementKind::Quad, ElementKind::Polygon, ElementKind::Edge};
    RequireKinds(path, mesh, "PLY", kinds);
    PlyWriter(path, mesh, options.binary).Write();
}

}  // namespace SolidSubdiv::Io::Internal

// SPDX-License-Identifier: Apache-2.0
// STL (.stl), text and binary. The format repeats every corner; corners in exactly one place become one vertex.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <solidsubdiv/kit/io/internal/files.h>
#include <solidsubdiv/kit/io/internal/mesh_builder.h>
#include <solidsubdiv/kit/io/internal/numbers.h>
#include <solidsubdiv/kit/io/internal/readers.h>
#include <solidsubdiv/kit/io/internal/text.h>
#include <solidsubdiv/kit/io/internal/writers.h>
#include <solidsubdiv/kit/io/internal/writing.h>

namespace SolidSubdiv::Io::Internal {

namespace {

constexpr std::size_t kHeaderSize = 84;  // 80 free bytes and the number of triangles
constexpr std::size_t kFacetSize = 50;   // normal, three corners as floats, two bytes

using Point = std::array<double, 3>;

/// Gives equal points one number, in the order of their first appearance.
class PointMerger {
  public:
    explicit PointMerger(std::size_t n_corners) : slots_(std::bit_ceil(2 * n_corners + 1), kNoIndex) {}

    Index Add(const Point& corner) {
        // Adding zero makes -0 and 0 one place.
        const Point point = {corner[0] + 0.0, corner[1] + 0.0, corner[2] + 0.0};
        std::uint64_t hash = 0;
        for (const double x : point) {
            hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u;
            hash ^= hash >> 32;
        }
        std::size_t slot = hash & (slots_.size() - 1);
        for (; slots_[slot] != kNoIndex; slot = (slot + 1) & (slots_.size() - 1)) {
            const double* other = positions_.data() + 3 * static_cast<std::size_t>(slots_[slot]);
            if (std::equal(point.begin(), point.end(), other)) return slots_[slot];
        }
        slots_[slot] = static_cast<Index>(positions_.size() / 3);
        positions_.insert(positions_.end(), point.begin(), point.end());
        return slots_[slot];
    }

    const std::vector<double>& positions() const { return positions_; }

  private:
    std::vector<Index> slots_;
    std::vector<double> positions_;
};

/// Corners, three a triangle.
std::vector<Point> ReadBinary(std::string_view bytes, std::size_t n) {
    std::vector<Point> corners;
    corners.reserve(3 * n);
    const bool swap_bytes = std::endian::native == std::endian::big;
    for (std::size_t i = 0; i < n; ++i) {
        const char* at = bytes.data() + kHeaderSize + i * kFacetSize + 3 * sizeof(float);
        for (int corner = 0; corner < 3; ++corner) {
            Point p;
            for (double& x : p) {
                x = LoadNumber<float>(at, swap_bytes);
                at += sizeof(float);
            }
            corners.push_back(p);
        }
    }
    return corners;
}

class TextReader {
  public:
    TextReader(std::string_view bytes, const std::string& file) : text_(bytes, file) {}

    std::vector<Point> Read() {
        while (text_.SkipSpace()) {
            const std::string keyword = LowerCase(text_.PeekWord());
            if (keyword == "solid" || keyword == "endsolid") {
                text_.RestOfLine();  // with any name
            } else if (keyword == "facet") {
                ReadFacet();
            } else {
                text_.FailExpected("'facet' or 'endsolid'");
            }
        }
        return std::move(corners_);
    }

  private:
    void Expect(std::string_view keyword) {
        if (LowerCase(text_.PeekWord()) != keyword) text_.FailExpected(keyword);
        text_.Word();
    }

    void ReadFacet() {
        Expect("facet");
        Expect("normal");
        for (int i = 0; i < 3; ++i) text_.Word();  // often wrong, not used
        Expect("outer");
        Expect("loop");
        for (int corner = 0; corner < 3; ++corner) {
            Expect("vertex");
            Point p;
            for (double& x : p) x = text_.Real("a coordinate");
            corners_.push_back(p);
        }
        Expect("endloop");
        Expect("endfacet");
    }

    TextCursor text_;
    std::vector<Point> corners_;
};

std::vector<Point> ReadCorners(std::string_view bytes, const std::string& file, MeshBuilder& builder) {
    // Binary files may start with "solid" too: their length tells.
    const bool has_header = bytes.size() >= kHeaderSize;
    const std::size_t n =
        has_header ? LoadNumber<std::uint32_t>(bytes.data() + 80, std::endian::native == std::endian::big) : 0;
    const bool fits = has_header && bytes.size() == kHeaderSize + n * kFacetSize;
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    const bool says_solid = first != bytes.npos && LowerCase(bytes.substr(first, 5)) == "solid";
    if (!fits && says_solid) return TextReader(bytes, file).Read();
    if (!has_header) Fail(file, "is no STL file: it is too short for a binary one and does not start with 'solid'");
    if (bytes.size() < kHeaderSize + n * kFacetSize) {
        Fail(file, std::to_string(n) + " triangles are announced, but the file has room for " +
                       std::to_string((bytes.size() - kHeaderSize) / kFacetSize) + "; is it complete?");
    }
    if (!fits) builder.AddNote("the file has more bytes than its triangles need; they are ignored");
    return ReadBinary(bytes, n);
}

std::array<float, 3> NormalOf(const double* a, const double* b, const double* c) {
    const Point u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const Point n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double length = std::hypot(n[0], n[1], n[2]);
    if (!(length > 0) || !std::isfinite(length)) return {0, 0, 0};
    return {static_cast<float>(n[0] / length), static_cast<float>(n[1] / length), static_cast<float>(n[2] / length)};
}

void WriteText(OutputFile& file, const Mesh& mesh) {
    file << "solid SolidSubdiv\n";
    for (std::size_t at = 0; at < mesh.topology.triangles.size(); at += 3) {
        std::array<const double*, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i] = mesh.positions.data() + 3 * static_cast<std::size_t>(mesh.topology.triangles[at + i]);
        }
        const std::array<float, 3> normal = NormalOf(corners[0], corners[1], corners[2]);
        file << "facet normal " << normal[0] << ' ' << normal[1] << ' ' << normal[2] << "\n outer loop\n";
        for (const double* p : corners) file << "  vertex " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
        file << " endloop\nendfacet\n";
    }
    file << "endsolid SolidSubdiv\n";
}

void WriteBinary(OutputFile& file, const Mesh& mesh) {
    const auto put = [&](auto number) {
        std::array<char, sizeof(number)> bytes;
        std::memcpy(bytes.data(), &number, sizeof(number));
        if (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
        file << std::string_view(bytes.data(), bytes.size());
    };
    std::string header = "written by SolidSubdiv";
    header.resize(80, ' ');
    file << header;
    put(static_cast<std::uint32_t>(mesh.topology.n_triangles()));
    for (std::size_t at = 0; at < mesh.topology.triangles.size(); at += 3) {
        std::array<const double*, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i] = mesh.positions.data() + 3 * static_cast<std::size_t>(mesh.topology.triangles[at + i]);
        }
        for (const float x : NormalOf(corners[0], corners[1], corners[2])) put(x);
        for (const double* p : corners) {
            for (int k = 0; k < 3; ++k) put(static_cast<float>(p[k]));
        }
        put(std::uint16_t{0});
    }
}

}  // namespace

Mesh ParseStl(std::string_view bytes, const std::string& file) {
    MeshBuilder builder(file);
    const std::vector<Point> corners = ReadCorners(bytes, file, builder);
    RequireIndexable(static_cast<std::int64_t>(corners.size()), "corners", file);
    PointMerger merger(corners.size());
    std::array<std::int64_t, 3> triangle;
    Offset n_flat = 0;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            for (const double x : corners[i + k]) {
                if (!std::isfinite(x))
                    Fail(file, "triangle " + std::to_string(i / 3) +
                                   " has a coordinate that is not a finite number; correct or remove it");
            }
            triangle[k] = merger.Add(corners[i + k]);
        }
        n_flat += triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
        builder.NextRow();
        builder.AddElement(ElementKind::Triangle, triangle);
    }
    builder.AddPositions(merger.positions());
    builder.AddNote(Counted(static_cast<Offset>(corners.size()), "corner", "corners") + " of triangles merged into " +
                    Counted(builder.n_vertices(), "vertex", "vertices"));
    if (n_flat > 0) builder.AddNote(Counted(n_flat, "triangle has", "triangles have") + " two corners in one place");
    return builder.Finish();
}

bool StlCarries(const Mesh&, const Attribute&) { return false; }

void WriteStl(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions& options) {
    constexpr std::array kinds = {ElementKind::Triangle};
    RequireKinds(path, mesh, "STL", kinds);
    for (const double x : mesh.positions) {
        if (options.binary && std::abs(x) > std::numeric_limits<float>::max()) {
            Fail(NameOf(path),
                 "a coordinate is too large for the 32-bit numbers of a binary STL file; choose another format");
        }
    }
    OutputFile file(path);
    options.binary ? WriteBinary(file, mesh) : WriteText(file, mesh);
    file.Commit();
}

}  // namespace SolidSubdiv::Io::Internal

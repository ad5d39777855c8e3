// SPDX-License-Identifier: Apache-2.0
// Writes legacy VTK unstructured grids (.vtk), big-endian binary or text, in the layout that every reader knows.
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <span>
#include <string>

#include <solidsubdiv/kit/io/internal/files.h>
#include <solidsubdiv/kit/io/internal/octahedra.h>
#include <solidsubdiv/kit/io/internal/percents.h>
#include <solidsubdiv/kit/io/internal/text.h>
#include <solidsubdiv/kit/io/internal/vtk_cells.h>
#include <solidsubdiv/kit/io/internal/writers.h>

namespace SolidSubdiv::Io::Internal {

namespace {

class VtkWriter {
  public:
    VtkWriter(const std::filesystem::path& path, bool binary) : path_(path), file_(path), binary_(binary) {}

    void Write(const Mesh& mesh) {
        file_ << "# vtk DataFile Version 3.0\nwritten by SolidSubdiv\n"
              << (binary_ ? "BINARY" : "ASCII") << "\nDATASET UNSTRUCTURED_GRID\nPOINTS " << mesh.topology.n_vertices
              << " double\n";
        WriteNumbers<double>(mesh.positions, 3);
        WriteCells(MakeVtkCells(mesh.topology));
        WriteAttributes("POINT_DATA", mesh.topology.n_vertices, mesh.point_data);
        WriteAttributes("CELL_DATA", mesh.topology.n_elements(), mesh.cell_data);
        file_.Commit();
    }

  private:
    void WriteCells(const VtkCells& cells) {
        std::vector<Index> lists;
        lists.reserve(cells.connectivity.size() + cells.ends.size());
        std::size_t begin = 0, stream_begin = 0;
        for (std::size_t cell = 0; cell < cells.ends.size(); ++cell) {
            const auto end = static_cast<std::size_t>(cells.ends[cell]);
            std::span<const Index> list = std::span(cells.connectivity).subspan(begin, end - begin);
            begin = end;
            if (!cells.stream_ends.empty() && cells.stream_ends[cell] >= 0) {
                const auto stream_end = static_cast<std::size_t>(cells.stream_ends[cell]);
                list = std::span(cells.face_streams).subspan(stream_begin, stream_end - stream_begin);
                stream_begin = stream_end;
            }
            lists.push_back(static_cast<Index>(list.size()));
            lists.insert(lists.end(), list.begin(), list.end());
        }
        if (lists.size() > static_cast<std::size_t>(std::numeric_limits<Index>::max())) {
            Fail(NameOf(path_), "the mesh is too large for a legacy VTK file; write .vtu");
        }
        file_ << "CELLS " << cells.ends.size() << ' ' << lists.size() << '\n';
        if (binary_) {
            WriteNumbers<Index>(lists, 1);
        } else {
            for (std::size_t at = 0; at < lists.size();) {
                const auto n = static_cast<std::size_t>(lists[at]) + 1;
                WriteNumbers<Index>(std::span(lists).subspan(at, n), n);
                at += n;
            }
        }
        file_ << "CELL_TYPES " << cells.types.size() << '\n';
        WriteNumbers<Index>(std::vector<Index>(cells.types.begin(), cells.types.end()), 1);
    }

    void WriteAttributes(const char* section, Offset n_rows, const std::vector<Attribute>& attributes) {
        if (attributes.empty()) return;
        file_ << section << ' ' << n_rows << "\nFIELD FieldData " << attributes.size() << '\n';
        for (const Attribute& a : attributes) {
            file_ << EncodePercents(a.name) << ' ' << a.width << ' ' << n_rows << " double\n";
            WriteNumbers<double>(a.values, static_cast<std::size_t>(a.width));
        }
    }

    /// Text: `row` numbers a line.
    template <class T>
    void WriteNumbers(std::span<const T> numbers, std::size_t row) {
        if (!binary_) {
            for (std::size_t i = 0; i < numbers.size(); ++i) file_ << numbers[i] << ((i + 1) % row == 0 ? '\n' : ' ');
            return;
        }
        for (const T number : numbers) {
            std::array<char, sizeof(T)> bytes;
            std::memcpy(bytes.data(), &number, sizeof(T));
            if (std::endian::native != std::endian::big) std::reverse(bytes.begin(), bytes.end());
            file_ << std::string_view(bytes.data(), bytes.size());
        }
        file_ << '\n';
    }

    std::filesystem::path path_;
    OutputFile file_;
    bool binary_;
};

}  // namespace

void WriteVtk(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions& options) {
    VtkWriter writer(path, options.binary);
    if (options.keep_octahedra || mesh.topology.octs.empty()) return writer.Write(mesh);
    writer.Write(CutOctahedra(mesh));
}

}  // namespace SolidSubdiv::Io::Internal

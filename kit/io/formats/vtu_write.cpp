// SPDX-License-Identifier: Apache-2.0
// Writes VTK XML unstructured grids (.vtu): zlib-compressed raw arrays appended behind the XML, or all text.
#include <bit>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <solidsubdiv/kit/io/internal/files.h>
#include <solidsubdiv/kit/io/internal/octahedra.h>
#include <solidsubdiv/kit/io/internal/vtk_cells.h>
#include <solidsubdiv/kit/io/internal/writers.h>
#include <solidsubdiv/kit/io/internal/zlib_blocks.h>

namespace SolidSubdiv::Io::Internal {

namespace {

std::string EscapedXml(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '<') {
            escaped += "&lt;";
        } else if (c == '&') {
            escaped += "&amp;";
        } else if (c == '"') {
            escaped += "&quot;";
        } else {
            escaped += c;
        }
    }
    return escaped;
}

template <class T>
constexpr const char* VtkName() {
    if constexpr (std::is_same_v<T, double>) return "Float64";
    if constexpr (std::is_same_v<T, std::uint8_t>) return "UInt8";
    if constexpr (std::is_same_v<T, std::int32_t>) return "Int32";
    return "Int64";
}

class VtuWriter {
  public:
    VtuWriter(const std::filesystem::path& path, bool binary) : file_(path), binary_(binary) {}

    void Write(const Mesh& mesh) {
        const VtkCells cells = MakeVtkCells(mesh.topology);
        const bool big_endian = std::endian::native == std::endian::big;
        file_ << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\""
              << (big_endian ? "BigEndian" : "LittleEndian") << "\" header_type=\"UInt64\""
              << (binary_ ? " compressor=\"vtkZLibDataCompressor\"" : "")
              << ">\n  <UnstructuredGrid>\n    <Piece NumberOfPoints=\"" << mesh.topology.n_vertices
              << "\" NumberOfCells=\"" << cells.types.size() << "\">\n";
        WriteAttributes("PointData", mesh.point_data);
        WriteAttributes("CellData", mesh.cell_data);
        file_ << "      <Points>\n";
        WriteArray<double>("Points", 3, mesh.positions);
        file_ << "      </Points>\n      <Cells>\n";
        WriteCells(cells);
        file_ << "      </Cells>\n    </Piece>\n  </UnstructuredGrid>\n";
        WriteAppended();
        file_ << "</VTKFile>\n";
        file_.Commit();
    }

  private:
    void WriteAttributes(const char* section, const std::vector<Attribute>& attributes) {
        file_ << "      <" << section << ">\n";
        for (const Attribute& a : attributes) WriteArray<double>(a.name, a.width, a.values);
        file_ << "      </" << section << ">\n";
    }

    void WriteCells(const VtkCells& cells) {
        WriteArray<Index>("connectivity", 1, cells.connectivity);
        // VTK keeps connectivity and offsets without a copy if both are of one type.
        if (cells.connectivity.size() <= static_cast<std::size_t>(std::numeric_limits<Index>::max())) {
            WriteArray<Index>("offsets", 1, std::vector<Index>(cells.ends.begin(), cells.ends.end()));
        } else {
            WriteArray<Offset>("offsets", 1, cells.ends);
        }
        WriteArray<std::uint8_t>("types", 1, cells.types);
        if (cells.stream_ends.empty()) return;
        WriteArray<Index>("faces", 1, cells.face_streams);
        WriteArray<Offset>("faceoffsets", 1, cells.stream_ends);
    }

    template <class T>
    void WriteArray(std::string_view name, int width, std::span<const T> values) {
        file_ << "        <DataArray type=\"" << VtkName<T>() << "\" Name=\"" << EscapedXml(name)
              << "\" NumberOfComponents=\"" << width;
        if (binary_) {
            file_ << "\" format=\"appended\" offset=\"" << appended_size_ << "\"/>\n";
            Append({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
            return;
        }
        file_ << "\" format=\"ascii\">\n";
        const std::size_t row = width > 1 ? static_cast<std::size_t>(width) : 12;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if constexpr (sizeof(T) == 1) {
                file_ << static_cast<int>(values[i]);
            } else {
                file_ << values[i];
            }
            file_ << ((i + 1) % row == 0 || i + 1 == values.size() ? '\n' : ' ');
        }
        file_ << "        </DataArray>\n";
    }

    void Append(std::string_view data) {
        const CompressedBlocks blocks = Compress(data);
        std::vector<std::uint64_t> header = {blocks.compressed_sizes.size(), blocks.block_size, blocks.last_block_size};
        header.insert(header.end(), blocks.compressed_sizes.begin(), blocks.compressed_sizes.end());
        std::string block(reinterpret_cast<const char*>(header.data()), header.size() * sizeof(std::uint64_t));
        block += blocks.bytes;
        appended_size_ += block.size();
        appended_.push_back(std::move(block));
    }

    void WriteAppended() {
        if (!binary_) return;
        file_ << "  <AppendedData encoding=\"raw\">\n   _";
        for (const std::string& block : appended_) file_.Write(block.data(), block.size());
        file_ << "\n  </AppendedData>\n";
    }

    OutputFile file_;
    bool binary_;
    std::vector<std::string> appended_;
    std::size_t appended_size_ = 0;
};

}  // namespace

void WriteVtu(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions& options) {
    VtuWriter writer(path, options.binary);
    if (options.keep_octahedra || mesh.topology.octs.empty()) return writer.Write(mesh);
    writer.Write(CutOctahedra(mesh));
}

}  // namespace SolidSubdiv::Io::Internal

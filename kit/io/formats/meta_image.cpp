// SPDX-License-Identifier: Apache-2.0
// Reads MetaImage (.mha, .mhd with its data in another file): a header of text, then numbers, raw, zlib or text.
#include <bit>
#include <optional>
#include <vector>

#include <solidsubdiv/kit/io/internal/header_fields.h>
#include <solidsubdiv/kit/io/internal/text.h>
#include <solidsubdiv/kit/io/internal/voxel_data.h>

namespace SolidSubdiv::Io::Internal {

namespace {

/// MET_LONG has four bytes, whatever a compiler thinks.
std::optional<NumberType> TypeNamed(std::string_view name) {
    constexpr std::pair<std::string_view, NumberType> names[] = {
        {"MET_CHAR", NumberType::Int8},       {"MET_UCHAR", NumberType::UInt8},
        {"MET_SHORT", NumberType::Int16},     {"MET_USHORT", NumberType::UInt16},
        {"MET_INT", NumberType::Int32},       {"MET_UINT", NumberType::UInt32},
        {"MET_LONG", NumberType::Int32},      {"MET_ULONG", NumberType::UInt32},
        {"MET_LONG_LONG", NumberType::Int64}, {"MET_ULONG_LONG", NumberType::UInt64},
        {"MET_FLOAT", NumberType::Float32},   {"MET_DOUBLE", NumberType::Float64}};
    for (const auto& [key, type] : names) {
        if (key == name) return type;
    }
    return std::nullopt;
}

class MetaImageReader {
  public:
    MetaImageReader(std::string_view bytes, const std::string& file, const ReadBeside& read_beside)
        : file_(file), text_(bytes, file), fields_(file), read_beside_(read_beside) {}

    Geometry::Volume Read() {
        ReadHeader();
        Geometry::Volume volume;
        SetGrid(volume);
        const VoxelLayout layout = Layout();
        const std::string_view name = fields_.Text("elementdatafile");
        if (name == "LOCAL" || name == "Local" || name == "local") {
            ReadVoxels(volume, layout, text_.Bytes(text_.remaining(), "the numbers"), file_);
        } else if (name.empty() || name.starts_with("LIST") || name.find('%') != name.npos) {
            fields_.FailAt("elementdatafile", "the numbers must be in one file; save it so");
        } else {
            ReadVoxels(volume, layout, read_beside_(std::filesystem::path(name)), std::string(name));
        }
        return volume;
    }

  private:
    /// Lines "Name = value"; ElementDataFile is the last of them.
    void ReadHeader() {
        while (!fields_.Has("elementdatafile")) {
            if (!text_.SkipSpace()) Fail(file_, "the header has no ElementDataFile; is it a complete MetaImage file?");
            const std::string_view line = text_.RestOfLine();
            const std::size_t equals = line.find('=');
            if (equals == line.npos) Fail(file_, "the line " + Quoted(line) + " is none of a MetaImage header");
            std::string_view name = line.substr(0, equals);
            while (!name.empty() && IsSpace(name.back())) name.remove_suffix(1);
            fields_.Set(name, line.substr(equals + 1));
        }
    }

    void SetGrid(Geometry::Volume& volume) const {
        if (const std::int64_t n = fields_.Integer("ndims"); n != 3) {
            fields_.FailAt("ndims", std::to_string(n) + " dimensions; a volume has 3");
        }
        if (fields_.Has("elementnumberofchannels") && fields_.Integer("elementnumberofchannels") != 1) {
            fields_.FailAt("elementnumberofchannels", "a volume has one number a voxel");
        }
        SetDims(volume, fields_.Integers("dimsize"), file_);

        std::vector<double> spacing = {1, 1, 1}, origin = {0, 0, 0};
        std::vector<double> directions = {1, 0, 0, 0, 1, 0, 0, 0, 1};
        const auto take = [&](std::vector<double>& numbers, std::initializer_list<std::string_view> names) {
            for (const std::string_view name : names) {
                if (!fields_.Has(name)) continue;
                numbers = fields_.Reals(name, numbers.size());
                return;
            }
        };
        take(spacing, {"elementspacing", "elementsize"});
        take(origin, {"offset", "origin", "position"});
        // One axis of the grid after the other, which makes them columns of the map.
        take(directions, {"transformmatrix", "rotation", "orientation"});
        std::array<std::array<double, 3>, 3> axes;
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t row = 0; row < 3; ++row) axes[k][row] = spacing[k] * directions[3 * k + row];
        }
        SetAxes(volume, axes, {origin[0], origin[1], origin[2]}, file_);
    }

    /// Whether a field says True; `otherwise` if it is not there.
    bool IsTrue(std::string_view name, bool otherwise) const {
        if (!fields_.Has(name)) return otherwise;
        const std::string value = LowerCase(fields_.Text(name));
        if (value != "true" && value != "false" && value != "1" && value != "0") {
            fields_.FailAt(name, "must be True or False");
        }
        return value == "true" || value == "1";
    }

    VoxelLayout Layout() const {
        VoxelLayout layout;
        const std::optional<NumberType> type = TypeNamed(fields_.Required("elementtype"));
        if (!type) fields_.FailAt("elementtype", Quoted(fields_.Text("elementtype")) + " can't be read");
        layout.type = *type;
        if (!IsTrue("binarydata", true)) {
            layout.encoding = VoxelEncoding::Text;
        } else if (IsTrue("compresseddata", false)) {
            layout.encoding = VoxelEncoding::Deflated;
        }
        const bool is_big = IsTrue("binarydatabyteordermsb", IsTrue("elementbyteordermsb", false));
        layout.swap_bytes = is_big != (std::endian::native == std::endian::big);
        if (fields_.Has("headersize")) layout.n_skipped = fields_.Integer("headersize");
        if (layout.n_skipped < -1) fields_.FailAt("headersize", "must be -1 or more");
        return layout;
    }

    const std::string& file_;
    TextCursor text_;
    HeaderFields fields_;
    const ReadBeside& read_beside_;
};

}  // namespace

Geometry::Volume ParseMetaImage(std::string_view bytes, const std::string& file, const ReadBeside& read_beside) {
    return MetaImageReader(bytes, file, read_beside).Read();
}

}  // namespace SolidSubdiv::Io::Internal

// SPDX-License-Identifier: Apache-2.0
// Reads NRRD (.nrrd, .nhdr with its data in another file): a header of text, then numbers, raw, gzip or text.
#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

#include <solidsubdiv/kit/io/internal/header_fields.h>
#include <solidsubdiv/kit/io/internal/text.h>
#include <solidsubdiv/kit/io/internal/voxel_data.h>

namespace SolidSubdiv::Io::Internal {

namespace {

std::optional<NumberType> TypeNamed(std::string_view name) {
    struct Names {
        NumberType type;
        std::vector<std::string_view> names;
    };
    static const std::vector<Names> types = {
        {NumberType::Int8, {"signed char", "int8", "int8_t"}},
        {NumberType::UInt8, {"uchar", "unsigned char", "uint8", "uint8_t"}},
        {NumberType::Int16, {"short", "short int", "signed short", "signed short int", "int16", "int16_t"}},
        {NumberType::UInt16, {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"}},
        {NumberType::Int32, {"int", "signed int", "int32", "int32_t"}},
        {NumberType::UInt32, {"uint", "unsigned int", "uint32", "uint32_t"}},
        {NumberType::Int64,
         {"longlong", "long long", "long long int", "signed long long", "signed long long int", "int64", "int64_t"}},
        {NumberType::UInt64, {"ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t"}},
        {NumberType::Float32, {"float"}},
        {NumberType::Float64, {"double"}},
    };
    for (const Names& t : types) {
        if (std::find(t.names.begin(), t.names.end(), name) != t.names.end()) return t.type;
    }
    return std::nullopt;
}

using Vector = std::array<double, 3>;

/// One axis of the array.
struct Axis {
    std::int64_t size = 0;
    std::string_view kind;
    Vector step{};     ///< to the next sample in the world, if it is spatial
    double first = 0;  ///< where its first sample is, if the axis is one of the world's
    bool is_spatial = true;
};

class NrrdReader {
  public:
    NrrdReader(std::string_view bytes, const std::string& file, const ReadBeside& read_beside)
        : file_(file), text_(bytes, file), fields_(file), read_beside_(read_beside) {}

    Geometry::Volume Read() {
        ReadHeader();
        Geometry::Volume volume;
        SetGrid(volume);
        std::string_view bytes = text_.Bytes(text_.remaining(), "the numbers");
        std::string beside, data_file = file_;
        if (const std::string_view name = FieldOf("data file", "datafile"); !name.empty()) {
            if (name.starts_with("LIST") || name.find('%') != name.npos) {
                Fail(file_, "its numbers are in several files (" + Quoted(name) + "); save it as one");
            }
            beside = read_beside_(std::filesystem::path(name));
            data_file = std::string(name);
            bytes = beside;
        }
        const VoxelLayout layout = Layout();
        ReadVoxels(volume, layout, SkipLines(bytes, data_file), data_file);
        return volume;
    }

  private:
    /// Lines "field: value" up to an empty one; "key:=value" and comments say nothing of the grid.
    void ReadHeader() {
        if (!text_.RestOfLine().starts_with("NRRD000")) Fail(file_, "is no NRRD file: it must start with 'NRRD000'");
        while (text_.remaining() > 0) {
            const std::string_view line = text_.RestOfLine();
            if (line.empty()) break;
            const std::size_t colon = line.find(": ");
            if (line.front() == '#' || line.find(":=") < colon) continue;
            if (colon == line.npos) Fail(file_, "the line " + Quoted(line) + " of its header is no field");
            fields_.Set(line.substr(0, colon), line.substr(colon + 1));
        }
    }

    /// The value of a field that has two spellings.
    std::string_view FieldOf(std::string_view name, std::string_view other) const {
        return fields_.Has(name) ? fields_.Text(name) : fields_.Text(other);
    }

    void SetGrid(Geometry::Volume& volume) const {
        std::vector<Axis> axes = Axes();
        std::vector<Axis> kept;
        for (std::size_t i = 0; i < axes.size(); ++i) {
            // Axes in front of or behind the three of space may be there if they hold one entry.
            if (axes[i].is_spatial && kept.size() < 3) {
                kept.push_back(axes[i]);
            } else if (axes[i].size != 1) {
                fields_.FailAt("sizes", "axis " + std::to_string(i) + " holds " + std::to_string(axes[i].size) +
                                            " values for each voxel; a volume has one number a voxel");
            }
        }
        std::vector<std::int64_t> dims;
        std::array<Vector, 3> steps{};
        Vector origin{};
        for (std::size_t k = 0; k < kept.size(); ++k) {
            dims.push_back(kept[k].size);
            steps[k] = kept[k].step;
            origin[k] = kept[k].first;
        }
        if (fields_.Has("space origin")) origin = Origin();
        SetDims(volume, dims, file_);
        SetAxes(volume, steps, origin, file_);
    }

    std::vector<Axis> Axes() const {
        const std::vector<std::int64_t> sizes = fields_.Integers("sizes");
        if (const std::int64_t n = fields_.Integer("dimension"); n != static_cast<std::int64_t>(sizes.size())) {
            fields_.FailAt("sizes", std::to_string(sizes.size()) + " sizes for " + std::to_string(n) + " dimensions");
        }
        std::vector<Axis> axes(sizes.size());
        for (std::size_t i = 0; i < sizes.size(); ++i) axes[i].size = sizes[i];
        if (fields_.Has("kinds")) SetKinds(axes);
        if (fields_.Has("space directions")) {
            SetDirections(axes);
        } else {
            SetSpacings(axes);
        }
        return axes;
    }

    void RequireOneAnAxis(std::string_view field, std::size_t n, std::size_t n_axes) const {
        if (n != n_axes) {
            fields_.FailAt(field, std::to_string(n) + " entries for " + std::to_string(n_axes) + " axes");
        }
    }

    void SetKinds(std::vector<Axis>& axes) const {
        const std::vector<std::string_view> kinds = fields_.Words("kinds");
        RequireOneAnAxis("kinds", kinds.size(), axes.size());
        for (std::size_t i = 0; i < axes.size(); ++i) {
            const std::string kind = LowerCase(kinds[i]);
            axes[i].is_spatial = kind == "domain" || kind == "space" || kind == "none" || kind == "???";
        }
    }

    std::string WithoutBrackets(std::string_view field) const {
        std::string text(fields_.Text(field));
        std::replace_if(
            text.begin(), text.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
        return text;
    }

    /// "(1,0,0) (0,1,0) none": an axis without a direction is none of space.
    void SetDirections(std::vector<Axis>& axes) const {
        const std::string plain = WithoutBrackets("space directions");
        TextCursor text(plain, file_, "the field space directions");
        for (Axis& axis : axes) {
            axis.is_spatial = text.PeekWord() != "none";
            if (!axis.is_spatial) {
                text.Word();
                continue;
            }
            for (double& x : axis.step) x = text.Real("three coordinates for each axis of space");
        }
        if (text.SkipSpace()) text.FailHere("more than a direction of three coordinates for each axis");
    }

    /// Without directions the axes of the array are those of the world.
    void SetSpacings(std::vector<Axis>& axes) const {
        std::vector<double> spacings(axes.size(), 1), mins(axes.size(), 0);
        std::vector<std::string_view> centers(axes.size());
        if (fields_.Has("spacings")) {
            spacings = fields_.Reals("spacings", axes.size());
        } else if (!FieldOf("axis maxs", "axismaxs").empty()) {
            Fail(file_, "has 'axis maxs' without 'spacings', which can't be used; save it with spacings");
        }
        const std::string_view mins_name = fields_.Has("axis mins") ? "axis mins" : "axismins";
        if (fields_.Has(mins_name)) mins = fields_.Reals(mins_name, axes.size());
        const std::string_view centers_name = fields_.Has("centers") ? "centers" : "centerings";
        if (fields_.Has(centers_name)) {
            centers = fields_.Words(centers_name);
            RequireOneAnAxis(centers_name, centers.size(), axes.size());
        }
        std::size_t n_spatial = 0;
        for (std::size_t i = 0; i < axes.size(); ++i) {
            if (!axes[i].is_spatial || n_spatial == 3) continue;
            axes[i].step[n_spatial++] = spacings[i];
            // Samples that stand for cells: the least coordinate is that of the first cell's border.
            if (std::isfinite(mins[i])) axes[i].first = mins[i] + (centers[i] == "cell" ? spacings[i] / 2 : 0);
        }
    }

    /// The centre of the first voxel.
    Vector Origin() const {
        const std::string plain = WithoutBrackets("space origin");
        TextCursor text(plain, file_, "the field space origin");
        Vector origin{};
        for (double& x : origin) x = text.Real("three coordinates");
        if (text.SkipSpace()) text.FailHere("more than three coordinates");
        return origin;
    }

    VoxelLayout Layout() const {
        VoxelLayout layout;
        const std::optional<NumberType> type = TypeNamed(LowerCase(fields_.Required("type")));
        if (!type) fields_.FailAt("type", "numbers of type " + Quoted(fields_.Text("type")) + " can't be read");
        layout.type = *type;

        const std::string encoding = LowerCase(fields_.Required("encoding"));
        if (encoding == "gzip" || encoding == "gz") {
            layout.encoding = VoxelEncoding::Deflated;
        } else if (encoding == "text" || encoding == "txt" || encoding == "ascii") {
            layout.encoding = VoxelEncoding::Text;
        } else if (encoding != "raw") {
            fields_.FailAt("encoding", Quoted(encoding) + " can't be read; save it with raw, gzip or text");
        }
        if (layout.encoding != VoxelEncoding::Text && SizeOf(layout.type) > 1) {
            const std::string endian = LowerCase(fields_.Required("endian"));
            if (endian != "little" && endian != "big") fields_.FailAt("endian", "must be little or big");
            layout.swap_bytes = (endian == "big") != (std::endian::native == std::endian::big);
        }
        if (fields_.Has("byte skip")) layout.n_skipped = fields_.Integer("byte skip");
        if (fields_.Has("byteskip")) layout.n_skipped = fields_.Integer("byteskip");
        if (layout.n_skipped < -1) fields_.FailAt("byte skip", "must be -1 or more");
        return layout;
    }

    std::string_view SkipLines(std::string_view bytes, const std::string& data_file) const {
        const std::string_view name = fields_.Has("line skip") ? "line skip" : "lineskip";
        if (!fields_.Has(name)) return bytes;
        TextCursor text(bytes, data_file);
        for (std::int64_t n = fields_.Integer(name); n > 0; --n) {
            if (text.remaining() == 0) fields_.FailAt(name, "the file has fewer lines");
            text.SkipPastNewline();
        }
        return text.Bytes(text.remaining(), "the numbers");
    }

    const std::string& file_;
    TextCursor text_;
    HeaderFields fields_;
    const ReadBeside& read_beside_;
};

}  // namespace

Geometry::Volume ParseNrrd(std::string_view bytes, const std::string& file, const ReadBeside& read_beside) {
    return NrrdReader(bytes, file, read_beside).Read();
}

}  // namespace SolidSubdiv::Io::Internal

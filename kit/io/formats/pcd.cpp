// SPDX-License-Identifier: Apache-2.0
// Reads the Point Cloud Library's files (.pcd): a header of text, then points as text, binary or compressed by LZF.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <solidsubdiv/kit/io/internal/header_fields.h>
#include <solidsubdiv/kit/io/internal/lzf.h>
#include <solidsubdiv/kit/io/internal/numbers.h>
#include <solidsubdiv/kit/io/internal/point_readers.h>

namespace SolidSubdiv::Io::Internal {

namespace {

std::optional<NumberType> TypeOf(std::string_view letter, std::int64_t size) {
    if (letter == "F" && size == 4) return NumberType::Float32;
    if (letter == "F" && size == 8) return NumberType::Float64;
    const auto of_size = [&](NumberType t1, NumberType t2, NumberType t4, NumberType t8) -> std::optional<NumberType> {
        if (size == 1) return t1;
        if (size == 2) return t2;
        if (size == 4) return t4;
        if (size == 8) return t8;
        return std::nullopt;
    };
    if (letter == "I") return of_size(NumberType::Int8, NumberType::Int16, NumberType::Int32, NumberType::Int64);
    if (letter == "U") return of_size(NumberType::UInt8, NumberType::UInt16, NumberType::UInt32, NumberType::UInt64);
    return std::nullopt;
}

class PcdReader {
  public:
    PcdReader(std::string_view bytes, const std::string& file) : file_(file), text_(bytes, file), header_(file) {}

    Geometry::PointCloud Read() {
        ReadHeader();
        const std::string_view data = header_.Required("data");
        if (data == "ascii") {
            ReadText();
        } else if (data == "binary") {
            RequirePoints(text_.remaining() / row_bytes_);
            const char* first = text_.Bytes(n_points_ * row_bytes_, "the points").data();
            for (std::int64_t i = 0; i < n_points_; ++i) {
                AddPoint([&](const Field& f) { return Load(f, first + i * row_bytes_ + f.offset); });
            }
        } else if (data == "binary_compressed") {
            ReadCompressed();
        } else {
            header_.FailAt("data", Quoted(data) + " is unknown; it must be ascii, binary or binary_compressed");
        }
        return Finished();
    }

  private:
    struct Field {
        NumberType type = NumberType::Float32;
        std::int64_t count = 1;
        std::int64_t offset = 0;  ///< in the bytes of a point
        std::size_t column = 0;   ///< among the words of a line
    };
    static constexpr std::string_view kWanted[] = {"x", "y", "z", "normal_x", "normal_y", "normal_z"};

    void ReadHeader() {
        while (!header_.Has("data")) {
            if (!text_.SkipComments('#')) Fail(file_, "the header has no DATA; is it a complete PCD file?");
            const std::string_view name = text_.Word();
            header_.Set(name, text_.RestOfLine());
        }
        ReadFields();
        n_points_ = header_.Has("points") ? header_.Integer("points") : header_.Integer("width");
        if (header_.Has("width") && header_.Has("height")) {
            const std::int64_t width = header_.Integer("width"), height = header_.Integer("height");
            const bool is_countable = width >= 0 && height >= 0 && width < INT32_MAX && height < INT32_MAX;
            if (!is_countable) header_.FailAt("width", "no width and height that can be");
            if (!header_.Has("points")) n_points_ = width * height;
            if (width * height != n_points_) {
                header_.FailAt("points", std::to_string(n_points_) + " points in " + std::to_string(width) + " x " +
                                             std::to_string(height));
            }
        }
        if (n_points_ < 0) header_.FailAt("points", "a negative number");
    }

    void ReadFields() {
        const std::vector<std::string_view> names = header_.Words("fields"), types = header_.Words("type");
        const std::vector<std::int64_t> sizes = header_.Integers("size");
        std::vector<std::int64_t> counts(names.size(), 1);
        if (header_.Has("count")) counts = header_.Integers("count");
        if (types.size() != names.size() || sizes.size() != names.size() || counts.size() != names.size()) {
            header_.FailAt("fields", "SIZE, TYPE and COUNT must have an entry for each");
        }
        for (std::size_t i = 0; i < names.size(); ++i) {
            const std::optional<NumberType> type = TypeOf(types[i], sizes[i]);
            if (!type) {
                header_.FailAt("type", Quoted(types[i]) + " of " + std::to_string(sizes[i]) + " bytes is unknown");
            }
            // Descriptors have some hundred numbers a point; more is damage, and would overflow the sums.
            if (counts[i] < 0 || counts[i] > 1'000'000) header_.FailAt("count", std::to_string(counts[i]) + " numbers");
            const Field field = {*type, counts[i], row_bytes_, n_columns_};
            for (std::size_t k = 0; k < 6; ++k) {
                if (names[i] == kWanted[k] && counts[i] == 1) wanted_[k] = field;
            }
            row_bytes_ += sizes[i] * counts[i];
            n_columns_ += static_cast<std::size_t>(counts[i]);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            if (!wanted_[k]) header_.FailAt("fields", "there is no " + std::string(kWanted[k]));
        }
        has_normals_ = wanted_[3] && wanted_[4] && wanted_[5];
    }

    void RequirePoints(std::int64_t most) const {
        if (n_points_ <= most) return;
        header_.FailAt("points", std::to_string(n_points_) + " points are announced, but only " +
                                     Counted(text_.remaining(), "byte", "bytes") + " follow; is the file complete?");
    }

    /// Binary numbers are those of the machine that wrote them: in effect little-endian.
    static double Load(const Field& field, const char* p) {
        constexpr bool swap_bytes = std::endian::native == std::endian::big;
        return VisitNumberType(
            field.type, [&](auto zero) { return static_cast<double>(LoadNumber<decltype(zero)>(p, swap_bytes)); });
    }

    void ReadText() {
        RequirePoints((text_.remaining() + 1) / (2 * static_cast<std::int64_t>(n_columns_)));
        if (n_points_ == 0) return;  // so that the columns of a point are bounded by the file's size
        std::vector<double> row(n_columns_);
        for (std::int64_t i = 0; i < n_points_; ++i) {
            for (double& number : row) number = text_.Real("a number of point " + std::to_string(i));
            AddPoint([&](const Field& f) { return row[f.column]; });
        }
    }

    /// Two sizes of 32 bits, then LZF; expanded, all points' numbers of a field stand together.
    void ReadCompressed() {
        const char* sizes = text_.Bytes(8, "the sizes of the compressed data").data();
        constexpr bool swap_bytes = std::endian::native == std::endian::big;
        const std::int64_t n_compressed = LoadNumber<std::uint32_t>(sizes, swap_bytes);
        const std::int64_t n_expanded = LoadNumber<std::uint32_t>(sizes + 4, swap_bytes);
        if (n_points_ > n_expanded / row_bytes_ || n_points_ * row_bytes_ != n_expanded) {
            Fail(file_, std::to_string(n_points_) + " points of " + std::to_string(row_bytes_) +
                            " bytes are announced, but " + std::to_string(n_expanded) + " bytes are compressed");
        }
        const std::string data = ExpandLzf(text_.Bytes(n_compressed, "the compressed data"), n_expanded, file_);
        for (std::int64_t i = 0; i < n_points_; ++i) {
            AddPoint([&](const Field& f) { return Load(f, data.data() + n_points_ * f.offset + i * SizeOf(f.type)); });
        }
    }

    template <class NumberOf>
    void AddPoint(NumberOf&& number_of) {
        std::array<double, 6> numbers{};
        for (std::size_t k = 0; k < (has_normals_ ? 6u : 3u); ++k) numbers[k] = number_of(*wanted_[k]);
        const auto is_finite = [](double x) { return std::isfinite(x); };
        if (!std::all_of(numbers.begin(), numbers.begin() + 3, is_finite)) {
            ++n_dropped_;
            return;
        }
        cloud_.positions.insert(cloud_.positions.end(), numbers.begin(), numbers.begin() + 3);
        if (!has_normals_) return;
        if (!std::all_of(numbers.begin() + 3, numbers.end(), is_finite)) {
            ++n_without_normal_;
            std::fill(numbers.begin() + 3, numbers.end(), 0.0);
        }
        cloud_.normals.insert(cloud_.normals.end(), numbers.begin() + 3, numbers.end());
    }

    Geometry::PointCloud Finished() {
        if (n_dropped_ > 0) {
            cloud_.notes.push_back(Counted(n_dropped_, "point is", "points are") + " marked as invalid and left out");
        }
        if (n_without_normal_ > 0) {
            cloud_.notes.push_back(Counted(n_without_normal_, "point has", "points have") + " no normal");
        }
        return std::move(cloud_);
    }

    const std::string& file_;
    TextCursor text_;
    HeaderFields header_;
    std::array<std::optional<Field>, 6> wanted_;
    bool has_normals_ = false;
    std::int64_t row_bytes_ = 0;
    std::size_t n_columns_ = 0;
    std::int64_t n_points_ = 0;
    Offset n_dropped_ = 0, n_without_normal_ = 0;
    Geometry::PointCloud cloud_;
};

}  // namespace

Geometry::PointCloud ParsePcd(std::string_view bytes, const std::string& file) { return PcdReader(bytes, file).Read(); }

}  // namespace SolidSubdiv::Io::Internal

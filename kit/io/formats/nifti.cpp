// SPDX-License-Identifier: Apache-2.0
// Reads NIfTI-1 (.nii, .nii.gz, .hdr with .img): a header of 348 bytes, then numbers.
//
// Our own reader rather than niftiio: what volumes need of the header is a dozen fields, zlib is here anyway, and so it
// is fuzzed like the others.
#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

#include <solidsubdiv/kit/io/internal/inflate.h>
#include <solidsubdiv/kit/io/internal/text.h>
#include <solidsubdiv/kit/io/internal/voxel_data.h>

namespace SolidSubdiv::Io::Internal {

namespace {

constexpr std::size_t kHeaderSize = 348;

// Where the fields of the header begin (nifti1.h of the NIfTI Data Format Working Group).
constexpr std::size_t kDim = 40, kDataType = 70, kPixDim = 76, kVoxOffset = 108, kSlope = 112, kIntercept = 116,
                      kQFormCode = 252, kSFormCode = 254, kQuaternion = 256, kQOffset = 268, kSRows = 280, kMagic = 344;

std::optional<NumberType> TypeOfCode(int code) {
    constexpr std::pair<int, NumberType> types[] = {
        {2, NumberType::UInt8},    {4, NumberType::Int16},    {8, NumberType::Int32},    {16, NumberType::Float32},
        {64, NumberType::Float64}, {256, NumberType::Int8},   {512, NumberType::UInt16}, {768, NumberType::UInt32},
        {1024, NumberType::Int64}, {1280, NumberType::UInt64}};
    for (const auto& [key, type] : types) {
        if (key == code) return type;
    }
    return std::nullopt;
}

class NiftiHeader {
  public:
    NiftiHeader(std::string bytes, const std::string& file) : bytes_(std::move(bytes)), file_(file) {
        const auto size = Number<std::int32_t>(0);
        swap_bytes_ = size != static_cast<std::int32_t>(kHeaderSize);
        const auto swapped = Number<std::int32_t>(0);
        if (size == 540 || swapped == 540) Fail(file_, "is a NIfTI-2 file; save it as NIfTI-1");
        if (swap_bytes_ && swapped != static_cast<std::int32_t>(kHeaderSize)) Fail(file_, "is no NIfTI-1 file");
        const std::string_view magic(bytes_.data() + kMagic, 4);
        is_pair_ = magic == std::string_view("ni1\0", 4);
        if (!is_pair_ && magic != std::string_view("n+1\0", 4)) {
            Fail(file_, "has no mark of NIfTI-1 (an ANALYZE header says too little of where its voxels lie)");
        }
    }

    bool is_pair() const { return is_pair_; }

    void SetDimsOf(Geometry::Volume& volume) const {
        const int n = Number<std::int16_t>(kDim);
        if (n < 1 || n > 7) Fail(file_, "has " + std::to_string(n) + " dimensions; NIfTI has 1 to 7");
        std::int64_t dims[3] = {1, 1, 1}, n_more = 1;
        for (int k = 1; k <= n; ++k) {
            const auto dim = Number<std::int16_t>(kDim + 2 * static_cast<std::size_t>(k));
            if (k <= 3) dims[k - 1] = dim;
            if (k > 3 && dim > 1) n_more *= dim;  // at most 2^60
        }
        if (n_more != 1) Fail(file_, "holds " + std::to_string(n_more) + " volumes; one is needed: save it alone");
        SetDims(volume, dims, file_);
    }

    VoxelLayout Layout() const {
        VoxelLayout layout;
        const int code = Number<std::int16_t>(kDataType);
        const std::optional<NumberType> type = TypeOfCode(code);
        if (!type) {
            Fail(file_, "has numbers of NIfTI's type " + std::to_string(code) +
                            ", which can't be read; save it with integers or real numbers of up to 64 bits");
        }
        layout.type = *type;
        layout.swap_bytes = swap_bytes_;
        const double offset = Number<float>(kVoxOffset), least = is_pair_ ? 0 : kHeaderSize + 4;
        if (!(offset >= 0 && offset < 1e9)) Fail(file_, "its field vox_offset is no place in a file");
        layout.n_skipped = static_cast<std::int64_t>(std::max(offset, least));
        const double slope = Number<float>(kSlope), intercept = Number<float>(kIntercept);
        // "If the scl_slope field is nonzero"; numbers that are not finite are in use for "no scaling" as well.
        if (slope != 0 && std::isfinite(slope) && std::isfinite(intercept)) {
            layout.slope = slope;
            layout.intercept = intercept;
        }
        return layout;
    }

    /// Method 3 of the standard (the sform) if there is one, else method 2 (the qform), else method 1.
    void SetAxesOf(Geometry::Volume& volume) const {
        std::array<std::array<double, 3>, 3> axes{};
        std::array<double, 3> origin{};
        if (Number<std::int16_t>(kSFormCode) > 0) {
            for (std::size_t row = 0; row < 3; ++row) {
                for (std::size_t k = 0; k < 3; ++k) axes[k][row] = Number<float>(kSRows + 16 * row + 4 * k);
                origin[row] = Number<float>(kSRows + 16 * row + 12);
            }
        } else if (Number<std::int16_t>(kQFormCode) > 0) {
            axes = QuaternionAxes();
            for (std::size_t row = 0; row < 3; ++row) origin[row] = Number<float>(kQOffset + 4 * row);
        } else {
            for (std::size_t k = 0; k < 3; ++k) axes[k][k] = VoxelSize(k);
            volume.notes.push_back("says nothing of where its voxels lie (neither sform nor qform) but their size");
        }
        SetAxes(volume, axes, origin, file_);
    }

  private:
    template <class T>
    T Number(std::size_t at) const {
        return LoadNumber<T>(bytes_.data() + at, swap_bytes_);
    }

    /// pixdim; 1 where it is missing, as along the third axis of a slice.
    double VoxelSize(std::size_t axis) const {
        const double size = std::abs(static_cast<double>(Number<float>(kPixDim + 4 * (axis + 1))));
        return size > 0 && std::isfinite(size) ? size : 1;
    }

    /// Columns of the rotation of the quaternion (a, b, c, d), a >= 0 and not stored, times the sizes of voxels; the
    /// third one the other way where pixdim[0] is negative.
    std::array<std::array<double, 3>, 3> QuaternionAxes() const {
        double q[3];
        for (std::size_t k = 0; k < 3; ++k) q[k] = Number<float>(kQuaternion + 4 * k);
        double a = 1 - (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]);
        if (a < 1e-7) {
            // By rounding of the 32-bit numbers: a half turn.
            const double scale = 1 / std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2]);
            for (double& x : q) x *= scale;
            a = 0;
        }
        a = std::sqrt(a);
        const double b = q[0], c = q[1], d = q[2];
        std::array<std::array<double, 3>, 3> axes = {{
            {a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
            {2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b)},
            {2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - b * b - c * c},
        }};
        for (std::size_t k = 0; k < 3; ++k) {
            const double sign = k == 2 && Number<float>(kPixDim) < 0 ? -1 : 1;
            for (double& x : axes[k]) x *= sign * VoxelSize(k);
        }
        return axes;
    }

    std::string bytes_;
    const std::string& file_;
    bool swap_bytes_ = false;
    bool is_pair_ = false;
};

}  // namespace

Geometry::Volume ParseNifti(std::string_view bytes, const std::string& file, const ReadBeside& read_beside) {
    const auto is_short = static_cast<std::int64_t>(bytes.size()) < static_cast<std::int64_t>(kHeaderSize);
    if (is_short && !IsGzip(bytes)) Fail(file, "is no NIfTI-1 file: it is shorter than the header of one");
    const NiftiHeader header(
        IsGzip(bytes) ? Inflate(bytes, kHeaderSize, file) : std::string(bytes.substr(0, kHeaderSize)), file);
    Geometry::Volume volume;
    header.SetDimsOf(volume);
    header.SetAxesOf(volume);
    VoxelLayout layout = header.Layout();

    std::string image, image_file = file;
    if (header.is_pair()) {
        const std::filesystem::path name = std::filesystem::path(file).filename().replace_extension(".img");
        image = read_beside(name);
        image_file = name.string();
        bytes = image;
    }
    if (IsGzip(bytes)) layout.encoding = VoxelEncoding::Deflated;
    ReadVoxels(volume, layout, bytes, image_file);
    return volume;
}

}  // namespace SolidSubdiv::Io::Internal

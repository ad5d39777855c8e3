// SPDX-License-Identifier: Apache-2.0
// Numbers of voxels, out of bytes.
#include <solidsubdiv/kit/io/internal/voxel_data.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <solidsubdiv/kit/io/internal/inflate.h>
#include <solidsubdiv/kit/io/internal/text.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Io::Internal {

namespace {

std::string DimsText(const Geometry::Volume& volume) {
    return std::to_string(volume.dims[0]) + " x " + std::to_string(volume.dims[1]) + " x " +
           std::to_string(volume.dims[2]) + " voxels";
}

/// The bytes of the numbers alone. `expanded` keeps them where they have to be made.
std::string_view NumberBytes(const Geometry::Volume& volume, const VoxelLayout& layout, std::string_view bytes,
                             std::string& expanded, const std::string& file) {
    const std::int64_t n = volume.n_voxels() * SizeOf(layout.type);
    if (layout.encoding == VoxelEncoding::Deflated) {
        if (layout.n_skipped < 0) Fail(file, "compressed numbers must not be counted from the end of the file");
        if (layout.n_skipped > std::numeric_limits<std::int64_t>::max() - n) Fail(file, "ends before its numbers");
        expanded = Inflate(bytes, layout.n_skipped + n, file);
        bytes = expanded;
    }
    const auto n_there = static_cast<std::int64_t>(bytes.size());
    const std::int64_t n_skipped = layout.n_skipped < 0 ? std::max<std::int64_t>(n_there - n, 0) : layout.n_skipped;
    if (n_skipped > n_there || n > n_there - n_skipped) {
        Fail(file, DimsText(volume) + " take " + std::to_string(n) + " bytes, but only " +
                       Counted(std::max<std::int64_t>(n_there - n_skipped, 0), "byte", "bytes") +
                       " are there; is the file complete?");
    }
    return bytes.substr(static_cast<std::size_t>(n_skipped), static_cast<std::size_t>(n));
}

std::vector<double> TextNumbers(const Geometry::Volume& volume, const VoxelLayout& layout, std::string_view bytes,
                                const std::string& file) {
    if (layout.n_skipped > static_cast<std::int64_t>(bytes.size())) Fail(file, "ends before its numbers");
    TextCursor text(bytes.substr(static_cast<std::size_t>(std::max<std::int64_t>(layout.n_skipped, 0))), file,
                    "the numbers");
    if (volume.n_voxels() > (text.remaining() + 1) / 2) {
        text.FailHere(DimsText(volume) + " are announced, but only " + Counted(text.remaining(), "byte", "bytes") +
                      " follow; is the file complete?");
    }
    std::vector<double> values(static_cast<std::size_t>(volume.n_voxels()));
    for (double& value : values) value = text.Real("a value");
    return values;
}

}  // namespace

void SetDims(Geometry::Volume& volume, std::span<const std::int64_t> dims, const std::string& file) {
    // With eight bytes a value, sizes in bytes can be counted too.
    std::int64_t most = std::numeric_limits<std::int64_t>::max() / 8;
    if (dims.size() != 3) Fail(file, "has " + std::to_string(dims.size()) + " dimensions; a volume has 3");
    for (std::size_t k = 0; k < 3; ++k) {
        if (dims[k] < 1) Fail(file, "has " + std::to_string(dims[k]) + " voxels along axis " + std::to_string(k));
        if (dims[k] > most) Fail(file, "has more voxels than can be counted; is its header damaged?");
        most /= dims[k];
        volume.dims[k] = dims[k];
    }
}

void SetAxes(Geometry::Volume& volume, const std::array<std::array<double, 3>, 3>& axes,
             const std::array<double, 3>& origin, const std::string& file) {
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t k = 0; k < 3; ++k) volume.voxel_to_world[4 * row + k] = axes[k][row];
        volume.voxel_to_world[4 * row + 3] = origin[row];
    }
    if (Geometry::IsSingular(volume.voxel_to_world)) {
        Fail(file,
             "its voxels have no volume in the world: the directions of its axes and its spacing must be finite "
             "and span space");
    }
}

void ReadVoxels(Geometry::Volume& volume, const VoxelLayout& layout, std::string_view bytes, const std::string& file) {
    const bool is_scaled = layout.slope != 1 || layout.intercept != 0;
    if (layout.encoding == VoxelEncoding::Text) {
        volume.values = TextNumbers(volume, layout, bytes, file);
    } else {
        std::string expanded;
        const char* first = NumberBytes(volume, layout, bytes, expanded, file).data();
        volume.values.resize(static_cast<std::size_t>(volume.n_voxels()));
        VisitNumberType(layout.type, [&](auto zero) {
            using Number = decltype(zero);
            Sdc::ParallelFor(volume.n_voxels(), 1 << 16, [&](Offset begin, Offset end) {
                for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
                    const char* p = first + i * sizeof(Number);
                    volume.values[i] = static_cast<double>(LoadNumber<Number>(p, layout.swap_bytes));
                }
            });
        });
    }
    if (is_scaled) {
        for (double& value : volume.values) value = layout.slope * value + layout.intercept;
    }
    // Integers from here on may have been rounded, which would mix labels up.
    constexpr double first_inexact = 9007199254740992.0;  // 2^53
    const double most = IsInteger(layout.type) && !is_scaled ? first_inexact - 1 : std::numeric_limits<double>::max();
    const auto bad = std::find_if(volume.values.begin(), volume.values.end(),
                                  [&](double value) { return !(std::abs(value) <= most); });
    if (bad == volume.values.end()) return;
    const Offset at = bad - volume.values.begin();
    const std::string voxel = "voxel (" + std::to_string(at % volume.dims[0]) + ", " +
                              std::to_string(at / volume.dims[0] % volume.dims[1]) + ", " +
                              std::to_string(at / volume.dims[0] / volume.dims[1]) + ")";
    Fail(file, voxel + (std::isfinite(*bad) ? " is an integer beyond 2^53; save the volume with smaller ones"
                                            : " is not a finite number; give it a value"));
}

}  // namespace SolidSubdiv::Io::Internal

// SPDX-License-Identifier: Apache-2.0
// The numbers of a volume as a file stores them, and what is the same for volumes of every format.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include <solidsubdiv/kit/geometry/volume.h>
#include <solidsubdiv/kit/io/internal/numbers.h>

namespace SolidSubdiv::Io::Internal {

enum class VoxelEncoding { Raw, Deflated, Text };

/// What a header says of the numbers.
struct VoxelLayout {
    NumberType type = NumberType::UInt8;
    bool swap_bytes = false;
    VoxelEncoding encoding = VoxelEncoding::Raw;
    /// Bytes in front of the numbers (of the expanded data where they are compressed); -1: the numbers are the last.
    std::int64_t n_skipped = 0;
    /// What a number x of the file stands for: slope * x + intercept.
    double slope = 1, intercept = 0;
};

/// Sets volume.dims. @throws IoError unless there are three numbers above 0 whose product can be counted
void SetDims(Geometry::Volume& volume, std::span<const std::int64_t> dims, const std::string& file);

/// Sets volume.voxel_to_world by columns: the steps along the three axes and the centre of the first voxel.
/// @throws IoError if that map has no inverse
void SetAxes(Geometry::Volume& volume, const std::array<std::array<double, 3>, 3>& axes,
             const std::array<double, 3>& origin, const std::string& file);

/// Reads the values of volume.dims voxels. @throws IoError, before anything is allocated if the bytes are too few; if a
/// value isn't finite or is an integer that a double can't hold, naming the voxel
void ReadVoxels(Geometry::Volume& volume, const VoxelLayout& layout, std::string_view bytes, const std::string& file);

/// Reads the file in which a header says that its numbers are, beside the header's own.
using ReadBeside = std::function<std::string(const std::filesystem::path& name)>;

// The readers on bytes in memory, for the tests and the fuzzers too.
Geometry::Volume ParseNifti(std::string_view bytes, const std::string& file, const ReadBeside& read_beside);
Geometry::Volume ParseNrrd(std::string_view bytes, const std::string& file, const ReadBeside& read_beside);
Geometry::Volume ParseMetaImage(std::string_view bytes, const std::string& file, const ReadBeside& read_beside);

}  // namespace SolidSubdiv::Io::Internal

// SPDX-License-Identifier: Apache-2.0
// Files of volumes, chosen by the file name's extension, and the one visible list of their formats.
//
//     Geometry::Volume brain = Io::ReadVolume("brain.nii.gz");
//
//     .nii .nii.gz .hdr .img   NIfTI-1: one file, or a header and its image of the same name. World coordinates are
//                              those of the sform, else of the qform, else voxel sizes alone; scl_slope and scl_inter
//                              are applied.
//     .nrrd .nhdr              NRRD: the numbers in the file or in one that its header names; raw, gzip, text. World
//                              coordinates are those of the space directions and origin, else of the spacings.
//     .mha .mhd                MetaImage, the same way: binary, compressed, text
//
// All number types of one value a voxel are read, in either byte order. World coordinates keep the file's own sense of
// directions (NIfTI counts to the right and the front, NRRD says in `space`, MetaImage mostly counts to the left and
// the back) and its unit. A file of several volumes, or of several values a voxel, is refused.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include <solidsubdiv/kit/geometry/volume.h>

namespace SolidSubdiv::Io {

struct VolumeFormat {
    std::string_view extension;  ///< lower case, with the dot
    std::string_view name;
    Geometry::Volume (*read)(const std::filesystem::path&);
};

/// The list; a new format is a file in formats/ and a line in volumes.cpp.
std::span<const VolumeFormat> VolumeFormats();

/// The format of a file name, or null if it is none of volumes.
const VolumeFormat* FindVolumeFormat(const std::filesystem::path& path);

/// Reads a volume. What comes back is consistent: at least one voxel, every value finite, a map to the world that has
/// an inverse. Sizes that the file can't hold are refused before anything is allocated for them.
/// @throws IoError with one line: the file, what is wrong, where.
Geometry::Volume ReadVolume(const std::filesystem::path& path);

}  // namespace SolidSubdiv::Io

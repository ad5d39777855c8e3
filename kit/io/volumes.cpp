// SPDX-License-Identifier: Apache-2.0
// The list of formats of volumes, and reading through it.
#include <solidsubdiv/kit/io/volumes.h>

#include <array>

#include <solidsubdiv/kit/io/internal/format_choice.h>
#include <solidsubdiv/kit/io/internal/voxel_data.h>

namespace SolidSubdiv::Io {

namespace {

namespace fs = std::filesystem;

template <Geometry::Volume (*Parse)(std::string_view, const std::string&, const Internal::ReadBeside&)>
Geometry::Volume ReadHeaderAndMore(const fs::path& path) {
    return Parse(Internal::ReadWholeFile(path), Internal::NameOf(path),
                 [&](const fs::path& name) { return Internal::ReadWholeFile(path.parent_path() / name); });
}

/// The image of a pair was named; its header says what is in it.
Geometry::Volume ReadNiftiImage(const fs::path& path) {
    fs::path header = path;
    return ReadHeaderAndMore<Internal::ParseNifti>(header.replace_extension(".hdr"));
}

constexpr std::array kFormats = {
    VolumeFormat{".nii", "NIfTI", ReadHeaderAndMore<Internal::ParseNifti>},
    VolumeFormat{".nii.gz", "NIfTI", ReadHeaderAndMore<Internal::ParseNifti>},
    VolumeFormat{".hdr", "NIfTI", ReadHeaderAndMore<Internal::ParseNifti>},
    VolumeFormat{".img", "NIfTI", ReadNiftiImage},
    VolumeFormat{".nrrd", "NRRD", ReadHeaderAndMore<Internal::ParseNrrd>},
    VolumeFormat{".nhdr", "NRRD", ReadHeaderAndMore<Internal::ParseNrrd>},
    VolumeFormat{".mha", "MetaImage", ReadHeaderAndMore<Internal::ParseMetaImage>},
    VolumeFormat{".mhd", "MetaImage", ReadHeaderAndMore<Internal::ParseMetaImage>},
};

}  // namespace

std::span<const VolumeFormat> VolumeFormats() { return kFormats; }

const VolumeFormat* FindVolumeFormat(const fs::path& path) { return Internal::FindFormat(VolumeFormats(), path); }

Geometry::Volume ReadVolume(const fs::path& path) {
    return Internal::ReadWithinMemory(path, "crop or resample the volume",
                                      [&] { return Internal::ChooseFormat(VolumeFormats(), path).read(path); });
}

}  // namespace SolidSubdiv::Io

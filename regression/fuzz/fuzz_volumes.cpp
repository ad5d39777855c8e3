// SPDX-License-Identifier: Apache-2.0
// Fuzzes the readers of volumes: every one of them on the same bytes, which are the file beside a header's too.
#include <cstdint>

#include <solidsubdiv/kit/io/internal/voxel_data.h>

#include "reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace SolidSubdiv;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const Io::Internal::ReadBeside beside = [&](const std::filesystem::path&) { return std::string(bytes); };
    for (const auto parse : {Io::Internal::ParseNifti, Io::Internal::ParseNrrd, Io::Internal::ParseMetaImage}) {
        try {
            const Geometry::Volume volume = parse(bytes, "fuzz", beside);
            Fuzz::Require(volume.n_voxels() > 0 && !Geometry::IsSingular(volume.voxel_to_world));
            Fuzz::Require(volume.values.size() == static_cast<std::size_t>(volume.n_voxels()));
            for (const double x : volume.values) Fuzz::Require(std::isfinite(x));
        } catch (const IoError& error) {
            Fuzz::Require(std::string(error.what()).find_first_of("\r\n") == std::string::npos);
        }
    }
    return 0;
}

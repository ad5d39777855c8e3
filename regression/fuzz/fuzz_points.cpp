// SPDX-License-Identifier: Apache-2.0
// Fuzzes the readers of points: every one of them on the same bytes, since most refuse at the first.
#include <cstdint>

#include <solidsubdiv/kit/io/internal/point_readers.h>

#include "reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace SolidSubdiv;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    for (const auto parse : {Io::Internal::ParseXyz, Io::Internal::ParsePcd, Io::Internal::ParsePlyPoints}) {
        try {
            const Geometry::PointCloud cloud = parse(bytes, "fuzz");
            Fuzz::Require(cloud.positions.size() % 3 == 0);
            Fuzz::Require(!cloud.has_normals() || cloud.normals.size() == cloud.positions.size());
            for (const double x : cloud.positions) Fuzz::Require(std::isfinite(x));
            for (const double x : cloud.normals) Fuzz::Require(std::isfinite(x));
        } catch (const IoError& error) {
            Fuzz::Require(std::string(error.what()).find_first_of("\r\n") == std::string::npos);
        }
    }
    return 0;
}

// SPDX-License-Identifier: Apache-2.0
// Fuzzes the reader of Gmsh files.
#include <cstdint>

#include "reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    return SolidSubdiv::Fuzz::CheckReader([&] { return SolidSubdiv::Io::Internal::ParseGmsh(bytes, "fuzz"); });
}

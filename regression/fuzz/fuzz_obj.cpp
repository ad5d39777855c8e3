// SPDX-License-Identifier: Apache-2.0
// Fuzzes the reader of OBJ files, with their creases.
#include <cstdint>

#include <solidsubdiv/kit/io/creases.h>

#include "reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    return SolidSubdiv::Fuzz::CheckReader([&] {
        SolidSubdiv::Io::Mesh mesh = SolidSubdiv::Io::Internal::ParseObj(bytes, "fuzz");
        // What tags say can be used as it is; setting it once more adds no elements.
        const SolidSubdiv::Io::Creases creases = SolidSubdiv::Io::CreasesOf(mesh);
        const SolidSubdiv::Offset n_elements = mesh.topology.n_elements();
        SolidSubdiv::Io::SetCreases(mesh, creases);
        SolidSubdiv::Fuzz::Require(mesh.topology.n_elements() == n_elements);
        return mesh;
    });
}

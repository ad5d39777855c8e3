// SPDX-License-Identifier: Apache-2.0
// Fuzzes the reader of TetGen's two files: the input is the points, a zero byte, and the tetrahedra.
#include <cstdint>

#include "reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const std::string_view nodes = bytes.substr(0, bytes.find('\0'));
    const std::string_view elements = nodes.size() < size ? bytes.substr(nodes.size() + 1) : std::string_view();
    return SolidSubdiv::Fuzz::CheckReader(
        [&] { return SolidSubdiv::Io::Internal::ParseTetgen(nodes, "nodes", elements, "elements"); });
}

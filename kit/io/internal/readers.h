// SPDX-License-Identifier: Apache-2.0
// The readers on bytes in memory: what the files' readers, the tests and the fuzzers call. `file` is for messages.
#pragma once

#include <string>
#include <string_view>

#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Io::Internal {

Mesh ParseVtu(std::string_view bytes, const std::string& file);
Mesh ParseVtk(std::string_view bytes, const std::string& file);
Mesh ParseObj(std::string_view bytes, const std::string& file);

}  // namespace SolidSubdiv::Io::Internal

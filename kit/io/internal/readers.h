// SPDX-License-Identifier: Apache-2.0
// The readers on bytes in memory: what the files' readers, the tests and the fuzzers call. `file` is for messages.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Io::Internal {

Mesh ParseVtu(std::string_view bytes, const std::string& file);
Mesh ParseVtk(std::string_view bytes, const std::string& file);
Mesh ParseObj(std::string_view bytes, const std::string& file);
Mesh ParseGmsh(std::string_view bytes, const std::string& file);
Mesh ParseMedit(std::string_view bytes, const std::string& file);
Mesh ParsePly(std::string_view bytes, const std::string& file);
Mesh ParseStl(std::string_view bytes, const std::string& file);
/// TetGen's two files.
Mesh ParseTetgen(std::string_view nodes, const std::string& nodes_file, std::string_view elements,
                 const std::string& elements_file);
Mesh ReadTetgen(const std::filesystem::path& path);

}  // namespace SolidSubdiv::Io::Internal

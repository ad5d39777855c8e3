// SPDX-License-Identifier: Apache-2.0
// The writers behind Io::WriteMesh, which checks the mesh first. Each leaves a whole file or none.
#pragma once

#include <filesystem>

#include <solidsubdiv/kit/io/formats.h>

namespace SolidSubdiv::Io::Internal {

void WriteVtu(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions& options);
void WriteVtk(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions& options);
void WriteGmsh(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions& options);
void WriteMedit(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions& options);
void WriteTetgen(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions& options);
void WritePly(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions& options);
void WriteStl(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions& options);
void WriteObj(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions& options);

/// Whether the format carries an attribute of the mesh. Those without such a function carry all.
bool MeditCarries(const Mesh& mesh, const Attribute& attribute);
bool StlCarries(const Mesh& mesh, const Attribute& attribute);
bool ObjCarries(const Mesh& mesh, const Attribute& attribute);

}  // namespace SolidSubdiv::Io::Internal

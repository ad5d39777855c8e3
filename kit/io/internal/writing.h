// SPDX-License-Identifier: Apache-2.0
// What writers share: refusing what a format can't hold, and octahedra cut where they must be.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/kit/io/internal/elements.h>

namespace SolidSubdiv::Io::Internal {

/// @throws IoError naming the first kind of element of the mesh that isn't among `kinds`
void RequireKinds(const std::filesystem::path& path, const Mesh& mesh, std::string_view format,
                  std::span<const ElementKind> kinds);

/// @throws InvalidInput if the mesh is not consistent in itself (a caller's mistake)
void RequireConsistent(const Mesh& mesh);

}  // namespace SolidSubdiv::Io::Internal

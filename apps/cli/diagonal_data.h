// SPDX-License-Identifier: Apache-2.0
// The cell data `diagonal`: which pair of opposite edges (tets) or vertices (octs) is in use, 0, 1 or 2.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Cli {

inline constexpr std::string_view kDiagonalName = "diagonal";

/// The mesh's diagonals, tets then octs; nothing if it has none, or values other than 0, 1 and 2.
std::optional<std::vector<std::uint8_t>> FindDiagonalData(const Io::Mesh& mesh);

/// The same. @throws InvalidInput that says which cell is wrong, or that there is no such data
std::vector<std::uint8_t> RequireDiagonalData(const Io::Mesh& mesh);

}  // namespace SolidSubdiv::Cli

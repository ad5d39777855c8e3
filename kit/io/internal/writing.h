// SPDX-License-Identifier: Apache-2.0
// What writers share: refusing what a format can't hold, and octahedra cut where they must be.
#pragma once

#include <array>
#include <cstdint>
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

/// Cell or point data that hold one 32-bit integer a row, so that a format can carry them as labels; null if there are
/// none.
const Attribute* FindLabels(std::span<const Attribute> attributes, std::string_view name);

/// The label of a row; 0 without labels.
inline std::int64_t LabelOf(const Attribute* labels, std::size_t row) {
    return labels ? static_cast<std::int64_t>(labels->values[row]) : 0;
}

/// Vertex i of our (VTK's) wedge is vertex kTurnedWedge[i] of other programs' prisms, and the other way round: VTK's
/// first triangle is counterclockwise seen from outside, theirs seen from the other triangle.
inline constexpr std::array<std::size_t, 6> kTurnedWedge = {0, 2, 1, 3, 5, 4};

}  // namespace SolidSubdiv::Io::Internal

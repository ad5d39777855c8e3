// SPDX-License-Identifier: Apache-2.0
// Orders of an element's vertices that their numbers alone decide.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Far::Internal {

/// Numbers of a few vertices, ascending, in one number that orders them.
std::uint64_t Pack(std::span<const Index> numbers);
/// Starts a cycle at its least number.
void Rotate(std::vector<Index>& cycle);
/// Tets and octahedra: each pair ascending and pairs in order, but for an octahedron's first, the major diagonal.
void SortPairs(std::vector<Index>& corners);
/// Hexahedra: the least of the orders that turn into each other.
void SortHex(std::vector<Index>& corners);

}  // namespace SolidSubdiv::Far::Internal

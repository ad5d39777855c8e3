// SPDX-License-Identifier: Apache-2.0
// A walk through a .vdb file ahead of OpenVDB, which trusts what it reads: sizes, counts and masks of damaged files
// make it write past its buffers, ask for all memory, or lose what it has read so far.
#pragma once

#include <iosfwd>

namespace SolidSubdiv::Voxel::Internal {

/// Checks that every count, size and mask fits what OpenVDB will make of it and what is left of the file. A file that
/// passes may still hold wrong numbers, or ones that can't be unpacked, which OpenVDB refuses by itself.
/// Grids of points are refused: OpenVDB can't read them from streams.
/// Cost: the file is read once, and what the inner nodes hold unpacked.
/// @pre file can seek, and throws at its end
/// @throws std::exception saying what is wrong
void CheckVdbFile(std::istream& file);

}  // namespace SolidSubdiv::Voxel::Internal

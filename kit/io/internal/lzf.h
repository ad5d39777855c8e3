// SPDX-License-Identifier: Apache-2.0
// Expanding LZF, the compression of PCD files.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace SolidSubdiv::Io::Internal {

/// The n bytes that were compressed. n that the bytes can't give is refused before anything is allocated.
///
/// The stream is a row of items, each begun by a byte c. Below 32, c + 1 bytes follow that are taken as they are.
/// Otherwise bytes from before are repeated: their number is 2 more than the upper three bits of c, and if these are 7
/// the next byte is added; how far back they begin is 1 more than the 13 bits that the lower five of c and the next
/// byte make. They may reach into what they give.
/// @throws IoError
std::string ExpandLzf(std::string_view bytes, std::int64_t n, const std::string& file);

}  // namespace SolidSubdiv::Io::Internal

// SPDX-License-Identifier: Apache-2.0
// Expanding a gzip or zlib stream to a number of bytes that is known before.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace SolidSubdiv::Io::Internal {

/// Whether the bytes begin as a gzip file does.
inline bool IsGzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

/// The first n bytes that a gzip (also of several members) or zlib stream holds. Where they are all of a member, its
/// checksum is checked. n that the stream can't give is refused before anything is allocated. @throws IoError
std::string Inflate(std::string_view stream, std::int64_t n, const std::string& file);

}  // namespace SolidSubdiv::Io::Internal

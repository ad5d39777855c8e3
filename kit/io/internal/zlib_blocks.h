// SPDX-License-Identifier: Apache-2.0
// Blocks of zlib-compressed bytes, as VTK's XML files hold them, compressed and expanded in parallel.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace SolidSubdiv::Io::Internal {

/// Data cut into blocks of block_size bytes (the last one may be shorter), each compressed by itself.
struct CompressedBlocks {
    std::uint64_t block_size = 0;
    std::uint64_t last_block_size = 0;  ///< 0: the last block is a full one
    std::vector<std::uint64_t> compressed_sizes;
    std::string bytes;  ///< all compressed blocks, one after another
};

CompressedBlocks Compress(std::string_view data);

/// The whole data. `bytes` holds all compressed blocks. @throws IoError; sizes that the compressed ones can't give are
/// refused before anything is allocated
std::string Expand(const CompressedBlocks& sizes, std::string_view bytes, const std::string& file,
                   const std::string& place);

}  // namespace SolidSubdiv::Io::Internal

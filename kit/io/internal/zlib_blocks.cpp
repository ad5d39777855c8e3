// SPDX-License-Identifier: Apache-2.0
// Blocks of zlib-compressed bytes.
#include <solidsubdiv/kit/io/internal/zlib_blocks.h>

#include <zlib.h>

#include <algorithm>
#include <stdexcept>

#include <solidsubdiv/kit/io/internal/text.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Io::Internal {

CompressedBlocks Compress(std::string_view data) {
    CompressedBlocks result;
    result.block_size = std::uint64_t{1} << 20;
    result.last_block_size = data.size() % result.block_size;
    const std::size_t n_blocks = (data.size() + result.block_size - 1) / result.block_size;

    std::vector<std::string> blocks(n_blocks);
    Sdc::ParallelFor(static_cast<Offset>(n_blocks), 1, [&](Offset begin, Offset end) {
        for (auto block = static_cast<std::size_t>(begin); block < static_cast<std::size_t>(end); ++block) {
            const std::string_view part = data.substr(block * result.block_size, result.block_size);
            uLongf size = compressBound(static_cast<uLong>(part.size()));
            blocks[block].resize(size);
            // The fastest level: coordinates hardly compress, and indices do so at any level.
            if (compress2(reinterpret_cast<Bytef*>(blocks[block].data()), &size,
                          reinterpret_cast<const Bytef*>(part.data()), static_cast<uLong>(part.size()),
                          Z_BEST_SPEED) != Z_OK) {
                throw std::bad_alloc();  // zlib's only other reason is a buffer below compressBound
            }
            blocks[block].resize(size);
        }
    });
    for (const std::string& block : blocks) {
        result.compressed_sizes.push_back(block.size());
        result.bytes += block;
    }
    return result;
}

std::string Expand(const CompressedBlocks& sizes, std::string_view bytes, const std::string& file,
                   const std::string& place) {
    const auto fail = [&](const std::string& what) { Fail(file, place + ": " + what); };
    const std::size_t n_blocks = sizes.compressed_sizes.size();
    std::vector<std::size_t> begins;
    std::size_t begin = 0;
    for (std::size_t block = 0; block < n_blocks; ++block) {
        const std::uint64_t compressed_size = sizes.compressed_sizes[block];
        const bool shorter = block + 1 == n_blocks && sizes.last_block_size != 0;
        const std::uint64_t size = shorter ? sizes.last_block_size : sizes.block_size;
        if (compressed_size > bytes.size() - begin) fail("the file ends within its compressed data; is it complete?");
        // deflate's best ratio is below 1032.
        if (size > sizes.block_size || size > compressed_size * 1032)
            fail("the sizes of its compressed blocks can't be right");
        begins.push_back(begin);
        begin += compressed_size;
    }
    if (n_blocks == 0) return {};
    const std::uint64_t total = sizes.last_block_size == 0 ? n_blocks * sizes.block_size
                                                           : (n_blocks - 1) * sizes.block_size + sizes.last_block_size;
    std::string data(total, '\0');
    Sdc::ParallelFor(static_cast<Offset>(n_blocks), 1, [&](Offset first, Offset last) {
        for (auto block = static_cast<std::size_t>(first); block < static_cast<std::size_t>(last); ++block) {
            const std::size_t at = block * sizes.block_size;
            const uLong expected = static_cast<uLong>(std::min<std::uint64_t>(sizes.block_size, total - at));
            uLongf size = expected;
            const int status = uncompress(reinterpret_cast<Bytef*>(data.data() + at), &size,
                                          reinterpret_cast<const Bytef*>(bytes.data() + begins[block]),
                                          static_cast<uLong>(sizes.compressed_sizes[block]));
            if (status != Z_OK || size != expected) fail("its compressed data are damaged");
        }
    });
    return data;
}

}  // namespace SolidSubdiv::Io::Internal

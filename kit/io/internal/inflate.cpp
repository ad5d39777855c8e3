// SPDX-License-Identifier: Apache-2.0
// Expanding gzip and zlib streams, piece by piece: zlib counts in 32 bits.
#include <solidsubdiv/kit/io/internal/inflate.h>

#include <zlib.h>

#include <algorithm>
#include <memory>
#include <new>

#include <solidsubdiv/kit/io/internal/text.h>

namespace SolidSubdiv::Io::Internal {

namespace {

struct End {
    void operator()(z_stream* stream) const { inflateEnd(stream); }
};

constexpr std::size_t kMostAtOnce = std::size_t{1} << 30;
constexpr int kGzipOrZlib = 15 + 32;  // the largest window, and zlib's sign for "find out which"

}  // namespace

std::string Inflate(std::string_view stream, std::int64_t n, const std::string& file) {
    // deflate's best ratio is below 1032.
    if (n < 0 || n / 1032 > static_cast<std::int64_t>(stream.size())) {
        Fail(file, std::to_string(n) + " bytes can't be compressed in " +
                       Counted(static_cast<std::int64_t>(stream.size()), "byte", "bytes") + "; is the file complete?");
    }
    z_stream state{};
    if (inflateInit2(&state, kGzipOrZlib) != Z_OK) throw std::bad_alloc();
    const std::unique_ptr<z_stream, End> end(&state);

    std::string data(static_cast<std::size_t>(n), '\0');
    std::size_t n_read = 0, n_written = 0;
    for (;;) {
        // Behind the last byte a place for one more, so that zlib goes on to the checksum.
        char more = 0;
        const bool is_full = n_written == data.size();
        const std::size_t room = is_full ? 1 : std::min(data.size() - n_written, kMostAtOnce);
        const std::size_t rest = std::min(stream.size() - n_read, kMostAtOnce);
        state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(stream.data() + n_read));
        state.avail_in = static_cast<uInt>(rest);
        state.next_out = reinterpret_cast<Bytef*>(is_full ? &more : data.data() + n_written);
        state.avail_out = static_cast<uInt>(room);
        const int status = inflate(&state, Z_NO_FLUSH);
        if (status == Z_MEM_ERROR) throw std::bad_alloc();
        if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR) {
            Fail(file, "its compressed data are damaged");
        }
        n_read += rest - state.avail_in;
        if (is_full) return data;
        n_written += room - state.avail_out;
        const bool is_stuck = status == Z_BUF_ERROR || (status == Z_STREAM_END && n_read == stream.size());
        if (n_written < data.size() && is_stuck) {
            Fail(file, "holds only " + std::to_string(n_written) + " of " + std::to_string(n) +
                           " bytes in its compressed data; is the file complete?");
        }
        if (status == Z_STREAM_END) {
            if (n_written == data.size()) return data;
            inflateReset(&state);  // the next member
        }
    }
}

}  // namespace SolidSubdiv::Io::Internal

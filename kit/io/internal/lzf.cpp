// SPDX-License-Identifier: Apache-2.0
// Expanding LZF.
#include <solidsubdiv/kit/io/internal/lzf.h>

#include <solidsubdiv/kit/io/internal/text.h>

namespace SolidSubdiv::Io::Internal {

std::string ExpandLzf(std::string_view bytes, std::int64_t n, const std::string& file) {
    const auto fail = [&]() { Fail(file, "its compressed data are damaged"); };
    // The longest item makes 264 bytes of 3.
    if (n < 0 || n / 88 > static_cast<std::int64_t>(bytes.size())) fail();
    const auto size = static_cast<std::size_t>(n);
    std::string data;
    data.reserve(size);
    std::size_t at = 0;
    const auto next = [&]() -> std::size_t {
        if (at == bytes.size()) fail();
        return static_cast<unsigned char>(bytes[at++]);
    };
    while (at < bytes.size()) {
        const std::size_t control = next();
        if (control < 32) {
            const std::size_t length = control + 1;
            if (length > bytes.size() - at || length > size - data.size()) fail();
            data += bytes.substr(at, length);
            at += length;
            continue;
        }
        std::size_t length = (control >> 5) + 2;
        if (length == 9) length += next();
        const std::size_t back = ((control & 31) << 8 | next()) + 1;
        if (back > data.size() || length > size - data.size()) fail();
        for (; length > 0; --length) data += data[data.size() - back];
    }
    if (data.size() != size) fail();
    return data;
}

}  // namespace SolidSubdiv::Io::Internal

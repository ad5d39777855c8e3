// SPDX-License-Identifier: Apache-2.0
// Base64 text as a stream of bytes.
#include <solidsubdiv/kit/io/internal/base64.h>

#include <algorithm>

#include <solidsubdiv/kit/io/internal/text.h>

namespace SolidSubdiv::Io::Internal {

namespace {

int ValueOf(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    if (c == '+') return 62;
    if (c == '/') return 63;
    return -1;
}

}  // namespace

bool Base64Stream::DecodeGroup() {
    unsigned bits = 0;
    int n_digits = 0, n_padding = 0;
    for (; n_digits + n_padding < 4; ++at_) {
        if (at_ == text_.size()) return false;
        const char c = text_[at_];
        if (IsSpace(c)) continue;
        if (c == '=') {
            ++n_padding;
            bits <<= 6;
            continue;
        }
        const int value = ValueOf(c);
        if (value < 0 || n_padding > 0) return false;
        bits = bits << 6 | static_cast<unsigned>(value);
        ++n_digits;
    }
    if (n_padding > 2) return false;
    for (int i = 0; i < 3 - n_padding; ++i) waiting_ += static_cast<char>(bits >> (16 - 8 * i) & 0xff);
    return true;
}

std::string Base64Stream::Read(std::uint64_t n) {
    std::string bytes;
    // What the rest of the text can give at most bounds the allocation.
    bytes.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(n, (text_.size() - at_) / 4 * 3 + 3)));
    while (bytes.size() < n) {
        if (waiting_.empty() && !DecodeGroup()) break;
        const std::size_t take = static_cast<std::size_t>(std::min<std::uint64_t>(n - bytes.size(), waiting_.size()));
        bytes.append(waiting_, 0, take);
        waiting_.erase(0, take);
    }
    return bytes;
}

}  // namespace SolidSubdiv::Io::Internal

// SPDX-License-Identifier: Apache-2.0
// Names as one word.
#include <solidsubdiv/kit/io/internal/percents.h>

namespace SolidSubdiv::Io::Internal {

std::string EncodePercents(std::string_view name) {
    if (name.empty()) return "unnamed";
    constexpr char digits[] = "0123456789ABCDEF";
    std::string encoded;
    for (const char c : name) {
        if (c > ' ' && c <= '~' && c != '%' && c != '"') {
            encoded += c;
        } else {
            encoded += '%';
            encoded += digits[static_cast<unsigned char>(c) >> 4];
            encoded += digits[static_cast<unsigned char>(c) & 15];
        }
    }
    return encoded;
}

std::string DecodePercents(std::string_view word) {
    const auto digit = [](char c) {
        if (c >= '0' && c <= '9') return c - '0';
        const char lower = static_cast<char>(c | 0x20);
        return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
    };
    std::string decoded;
    for (std::size_t i = 0; i < word.size(); ++i) {
        if (word[i] == '%' && i + 2 < word.size() && digit(word[i + 1]) >= 0 && digit(word[i + 2]) >= 0) {
            decoded += static_cast<char>(digit(word[i + 1]) * 16 + digit(word[i + 2]));
            i += 2;
        } else {
            decoded += word[i];
        }
    }
    return decoded;
}

}  // namespace SolidSubdiv::Io::Internal

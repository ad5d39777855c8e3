// SPDX-License-Identifier: Apache-2.0
// Numbers as files store them: ten types, in either byte order.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <vector>

namespace SolidSubdiv::Io::Internal {

enum class NumberType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float32, Float64 };

inline bool IsInteger(NumberType type) { return type < NumberType::Float32; }

/// The number at p, which may be at any address.
template <class T>
T LoadNumber(const char* p, bool swap_bytes) {
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), p, sizeof(T));
    if (swap_bytes) std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<T>(bytes);
}

/// Calls f(T{}) with the C++ type.
template <class Function>
auto VisitNumberType(NumberType type, Function&& f) {
    switch (type) {
        case NumberType::Int8:
            return f(std::int8_t{});
        case NumberType::UInt8:
            return f(std::uint8_t{});
        case NumberType::Int16:
            return f(std::int16_t{});
        case NumberType::UInt16:
            return f(std::uint16_t{});
        case NumberType::Int32:
            return f(std::int32_t{});
        case NumberType::UInt32:
            return f(std::uint32_t{});
        case NumberType::Int64:
            return f(std::int64_t{});
        case NumberType::UInt64:
            return f(std::uint64_t{});
        case NumberType::Float32:
            return f(float{});
        case NumberType::Float64:
            break;
    }
    return f(double{});
}

inline std::int64_t SizeOf(NumberType type) {
    return VisitNumberType(type, [](auto zero) { return static_cast<std::int64_t>(sizeof(zero)); });
}

/// All whole numbers of that type in the bytes, converted to To (double, or std::int64_t for integer types).
template <class To>
std::vector<To> ConvertNumbers(std::string_view bytes, NumberType type, bool swap_bytes) {
    return VisitNumberType(type, [&](auto zero) {
        using From = decltype(zero);
        assert(std::is_floating_point_v<To> || std::is_integral_v<From>);
        std::vector<To> numbers(bytes.size() / sizeof(From));
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            numbers[i] = static_cast<To>(LoadNumber<From>(bytes.data() + i * sizeof(From), swap_bytes));
        }
        return numbers;
    });
}

}  // namespace SolidSubdiv::Io::Internal

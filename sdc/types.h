// SPDX-License-Identifier: Apache-2.0
// The two integer types of the framework, and arrays that do not clear memory which is about to be overwritten.
#pragma once

#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace SolidSubdiv {

/// A vertex, edge, face or cell of one level. A level holds at most 2^31 - 1 of each.
using Index = std::int32_t;

/// A place in a table (a sum of row lengths): may pass 2^31.
using Offset = std::int64_t;

/// No such element.
inline constexpr Index kNoIndex = -1;

/// Allocator that leaves trivial elements uninitialized on resize(n); every other operation is std::allocator's.
template <class T>
struct UninitializedAllocator : std::allocator<T> {
    template <class U>
    struct rebind {
        using other = UninitializedAllocator<U>;
    };
    UninitializedAllocator() = default;
    template <class U>
    UninitializedAllocator(const UninitializedAllocator<U>&) {}

    template <class U>
    void construct(U* p) noexcept(std::is_nothrow_default_constructible_v<U>) {
        ::new (static_cast<void*>(p)) U;
    }
    template <class U, class... Args>
    void construct(U* p, Args&&... args) {
        ::new (static_cast<void*>(p)) U(std::forward<Args>(args)...);
    }
};

/// A std::vector whose resize(n) leaves new numbers uninitialized: filled in parallel right after, in place.
template <class T>
using Array = std::vector<T, UninitializedAllocator<T>>;

}  // namespace SolidSubdiv

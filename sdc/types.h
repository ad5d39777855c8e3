// SPDX-License-Identifier: Apache-2.0
// The two integer types of the framework, and arrays that do not clear memory which is about to be overwritten.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
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

/// Memory for arrays of `bytes` >= kLargeBytes, in huge pages where the system has them: touching fresh memory page by
/// page costs more than filling a table with topology. @throws std::bad_alloc
void* AllocateLarge(std::size_t bytes);
void FreeLarge(void* memory);
inline constexpr std::size_t kLargeBytes = std::size_t{256} << 10;

/// Allocator that leaves trivial elements uninitialized on resize(n).
template <class T>
struct UninitializedAllocator {
    using value_type = T;
    UninitializedAllocator() = default;
    template <class U>
    UninitializedAllocator(const UninitializedAllocator<U>&) {}

    T* allocate(std::size_t n) {
        if (n > std::size_t(-1) / sizeof(T)) throw std::bad_array_new_length();
        return n * sizeof(T) < kLargeBytes ? std::allocator<T>().allocate(n)
                                           : static_cast<T*>(AllocateLarge(n * sizeof(T)));
    }
    void deallocate(T* p, std::size_t n) {
        if (n * sizeof(T) < kLargeBytes) {
            std::allocator<T>().deallocate(p, n);
        } else {
            FreeLarge(p);
        }
    }
    friend bool operator==(const UninitializedAllocator&, const UninitializedAllocator&) { return true; }

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

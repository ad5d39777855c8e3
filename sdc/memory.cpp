// SPDX-License-Identifier: Apache-2.0
// Large arrays, in huge pages where the system has them.
#include <cstdlib>
#include <new>

#include <solidsubdiv/sdc/types.h>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace SolidSubdiv {

void* AllocateLarge(std::size_t bytes) {
    constexpr std::size_t kHugePage = std::size_t{2} << 20;
    const std::size_t rounded = (bytes + kHugePage - 1) / kHugePage * kHugePage;
    void* const memory = rounded < bytes ? nullptr : std::aligned_alloc(kHugePage, rounded);
    if (!memory) throw std::bad_alloc();
#if defined(__linux__)
    madvise(memory, rounded, MADV_HUGEPAGE);  // a wish: without it all works as well, slower
#endif
    return memory;
}

void FreeLarge(void* memory) { std::free(memory); }

}  // namespace SolidSubdiv

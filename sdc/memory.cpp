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
    constexpr std::size_t kPage = 4096, kHugePage = std::size_t{2} << 20;
    const std::size_t rounded = (bytes + kPage - 1) / kPage * kPage, in_huge_pages = rounded / kHugePage * kHugePage;
    void* memory = nullptr;
    if (rounded < bytes || posix_memalign(&memory, in_huge_pages > 0 ? kHugePage : kPage, rounded) != 0) {
        throw std::bad_alloc();
    }
#if defined(__linux__)
    // Wishes: without them all works as well, slower. What fills no huge page is asked for in one call, since a fault
    // for each small page costs more than what is written to it; not where the last page, and so probably all, is
    // there.
    if (in_huge_pages > 0) madvise(memory, in_huge_pages, MADV_HUGEPAGE);
#if defined(MADV_POPULATE_WRITE)
    if (rounded > in_huge_pages) {
        char* const start = static_cast<char*>(memory);
        unsigned char is_there = 0;
        const bool is_known = mincore(start + rounded - kPage, kPage, &is_there) == 0;
        if (!is_known || (is_there & 1) == 0) {
            madvise(start + in_huge_pages, rounded - in_huge_pages, MADV_POPULATE_WRITE);
        }
    }
#endif
#endif
    return memory;
}

void FreeLarge(void* memory) { std::free(memory); }

}  // namespace SolidSubdiv

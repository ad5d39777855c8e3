// SPDX-License-Identifier: Apache-2.0
// Whether a sanitizer watches the tests: it needs each path through the code once or twice, not again and again.
//
// TEST(Shapes, OfEverySize) {
//     SOLIDSUBDIV_LONG_TEST();
//     ...
#pragma once

#include <cstdlib>

#ifndef __has_feature  // GCC, which has macros instead
#define __has_feature(name) 0
#endif

namespace SolidSubdiv {

#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || defined(__SANITIZE_ADDRESS__) || \
    defined(__SANITIZE_THREAD__)
inline constexpr bool kIsSanitized = true;
#else
inline constexpr bool kIsSanitized = false;
#endif

/// A fifth of n, at least 1; n itself without a sanitizer, where errors are measured.
inline constexpr int FewerIfSanitized(int n) { return kIsSanitized ? (n + 4) / 5 : n; }

inline bool IsSkippedAsLong() { return kIsSanitized && std::getenv("SOLIDSUBDIV_LONG_TESTS") == nullptr; }

}  // namespace SolidSubdiv

/// For tests that take a quarter of a minute under a sanitizer and go where shorter ones go: not run there unless asked
/// for.
#define SOLIDSUBDIV_LONG_TEST()                                                                                 \
    do {                                                                                                        \
        if (SolidSubdiv::IsSkippedAsLong())                                                                     \
            GTEST_SKIP() << "long under a sanitizer; run where SOLIDSUBDIV_LONG_TESTS is set, and without one"; \
    } while (false)

// SPDX-License-Identifier: Apache-2.0
// Tests that need another program, and are skipped with the reason where it is not there.
#pragma once

#include <gtest/gtest.h>

#include "validation/findings.h"

namespace SolidSubdiv::Validation {

/// Runs the body of a test or of its set-up; Unavailable makes the test a skipped one.
template <class Body>
void OrSkip(Body&& body) {
    try {
        body();
    } catch (const Unavailable& unavailable) {
        GTEST_SKIP() << unavailable.reason;
    }
}

}  // namespace SolidSubdiv::Validation

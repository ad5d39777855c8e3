// SPDX-License-Identifier: Apache-2.0
// What OpenSubdiv's refiner wants of a value.
#pragma once

namespace SolidSubdiv::Validation {

struct Position {
    double x[3] = {0, 0, 0};

    void Clear() { x[0] = x[1] = x[2] = 0; }
    void AddWithWeight(const Position& other, double weight) {
        for (int i = 0; i < 3; ++i) x[i] += weight * other.x[i];
    }
};

}  // namespace SolidSubdiv::Validation

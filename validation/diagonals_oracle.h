// SPDX-License-Identifier: Apache-2.0
// Which faces between two cells are matched, by definition: both cells choose the same edge of it. An oracle: it shares
// no code with the library.
#pragma once

#include <cstdint>

#include "cells_oracle.h"

namespace SolidSubdiv::Validation {

struct MatchedFaces {
    std::int64_t n_inner = 0;  ///< faces between two cells
    std::int64_t n_matched = 0;

    double Share() const { return n_inner == 0 ? 1 : static_cast<double>(n_matched) / static_cast<double>(n_inner); }
};

/// A tet (v0 v1 v2 v3) chooses the edges v0v1 and v2v3, of each of its faces the one that the face has; an octahedron
/// (v0 v1 | ...) of each face the edge that does not touch v0 or v1.
MatchedFaces CountMatchedFaces(const Complex& complex);

/// Whether b is the cell a with its vertices in another order that keeps its orientation; octahedra: with its pairs
/// turned round in a cycle.
bool IsSameCell(const std::array<int, 4>& a, const std::array<int, 4>& b);
bool IsSameCell(const std::array<int, 6>& a, const std::array<int, 6>& b);

}  // namespace SolidSubdiv::Validation

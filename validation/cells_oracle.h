// SPDX-License-Identifier: Apache-2.0
// Complexes of tets and octahedra looked at the plain way: sets of vertices, and the formulas of docs/concepts.md. An
// oracle: it shares no code with the library.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace SolidSubdiv::Validation {

using Triangle = std::array<int, 3>;

/// Tets (v0 v1 v2 v3), positive when det(v1-v0, v2-v0, v3-v0) > 0; octahedra (v0 v1 | v2 v3 | v4 v5): opposite pairs,
/// positive when det(v0-c, v2-c, v4-c) < 0.
struct Complex {
    std::vector<std::array<int, 4>> tets;
    std::vector<std::array<int, 6>> octs;
};

struct PartCounts {
    std::int64_t n_vertices = 0, n_edges = 0, n_faces = 0, n_tets = 0, n_octs = 0;

    std::int64_t n_cells() const { return n_tets + n_octs; }
    friend bool operator==(const PartCounts&, const PartCounts&) = default;
};

/// Counts by collecting the vertex sets of all edges and faces of all cells.
PartCounts CountParts(const Complex& complex);

/// Counts after one split: V' = V + E + O, E' = 2E + 3F + 12O, F' = 4F + 4T + 24O, T' = 4T + 8O, O' = T + 6O.
PartCounts CountsAfterSplit(const PartCounts& n);

/// Faces of one cell only, counterclockwise from outside where the cell is positive, in ascending order of their sets.
std::vector<Triangle> BoundaryTriangles(const Complex& complex);

}  // namespace SolidSubdiv::Validation

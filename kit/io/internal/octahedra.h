// SPDX-License-Identifier: Apache-2.0
// Octahedra in files: as polyhedra with eight triangles, or cut into four tetrahedra around the major diagonal.
#pragma once

#include <array>
#include <span>

#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Io::Internal {

/// The eight triangles of the octahedron (v0 v1 | v2 v3 | v4 v5), counterclockwise seen from outside when it is
/// positive. The first one is v0 v2 v5: whoever collects the vertices from the faces meets the pairs in our order.
std::array<std::array<Index, 3>, 8> OctahedronFaces(std::span<const Index> oct);

/// Whether eight triangles (24 vertices) form an octahedron. If so, `oct` has its three pairs of opposite vertices, in
/// the order in which `listed` names them (the order of the faces if it is empty); the last pair is turned so that the
/// octahedron is positive when the triangles are counterclockwise seen from outside.
bool RecognizeOctahedron(std::span<const Index> listed, std::span<const Index> triangles, std::array<Index, 6>& oct);

/// The mesh with each octahedron replaced by four tetrahedra around its major diagonal, with its row of cell data each.
/// They follow the tetrahedra that are there already.
Mesh CutOctahedra(const Mesh& mesh);

}  // namespace SolidSubdiv::Io::Internal

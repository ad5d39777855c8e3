// SPDX-License-Identifier: Apache-2.0
// What the fuzz targets of the readers share: bytes give a consistent mesh or an IoError of one line.
#pragma once

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <solidsubdiv/kit/io/internal/elements.h>
#include <solidsubdiv/kit/io/internal/readers.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Fuzz {

inline void Require(bool holds) {
    if (!holds) std::abort();
}

inline void CheckAttribute(const Io::Attribute& attribute, Offset n_rows) {
    Require(static_cast<Offset>(attribute.values.size()) == n_rows * attribute.width);
    for (const double x : attribute.values) Require(std::isfinite(x));
}

inline void CheckOffsets(const std::vector<Offset>& offsets, std::size_t n) {
    if (offsets.empty()) return Require(n == 0);
    Require(offsets.front() == 0 && offsets.back() == static_cast<Offset>(n));
    for (std::size_t i = 1; i < offsets.size(); ++i) Require(offsets[i] >= offsets[i - 1]);
}

inline void CheckMesh(const Io::Mesh& mesh) {
    const Io::Topology& t = mesh.topology;
    Require(mesh.positions.size() == 3 * static_cast<std::size_t>(t.n_vertices));
    for (const double x : mesh.positions) Require(std::isfinite(x));
    for (const Io::Internal::ElementKind kind : Io::Internal::kAllElementKinds) {
        for (const Index v : Io::Internal::VerticesOf(t, kind)) Require(v >= 0 && v < t.n_vertices);
    }
    CheckOffsets(t.polygon_offsets, t.polygon_vertices.size());
    CheckOffsets(t.polyhedron_face_offsets, t.polyhedron_vertices.size());
    CheckOffsets(t.polyhedron_offsets, t.polyhedron_face_offsets.empty() ? 0 : t.polyhedron_face_offsets.size() - 1);
    for (const Io::Attribute& a : mesh.point_data) CheckAttribute(a, t.n_vertices);
    for (const Io::Attribute& a : mesh.cell_data) CheckAttribute(a, t.n_elements());
}

/// Runs a reader; parse() returns the mesh.
template <class Parse>
int CheckReader(Parse&& parse) {
    try {
        CheckMesh(parse());
    } catch (const IoError& error) {
        const std::string message = error.what();
        Require(message.find_first_of("\r\n") == message.npos);
    }
    return 0;
}

}  // namespace SolidSubdiv::Fuzz

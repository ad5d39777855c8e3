// SPDX-License-Identifier: Apache-2.0
// The corners of cells, and how well shaped they are at them.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <solidsubdiv/apps/fit/control_mesh.h>
#include <solidsubdiv/apps/fit/internal/vec3.h>

namespace SolidSubdiv::Fit::Starting {

using namespace Internal;

/// A vertex of a cell and the ends of the three edges from it, seen counterclockwise from them.
struct CellCorner {
    std::array<Index, 4> v;
    double ideal;  ///< the determinant of the directions of its edges in the best cell

    struct Edges {
        Vec3 a, b, c;
        double Determinant() const { return Dot(a, Cross(b, c)); }
    };
    Edges EdgesIn(std::span<const double> positions) const {
        const Vec3 p = PointAt(positions, v[0]);
        return {PointAt(positions, v[1]) - p, PointAt(positions, v[2]) - p, PointAt(positions, v[3]) - p};
    }
    /// 1 in a cube and a regular tet, 0 where it is flat; negative where it is folded.
    double Quality(std::span<const double> positions) const {
        const Edges e = EdgesIn(positions);
        const double lengths = Length(e.a) * Length(e.b) * Length(e.c);
        return lengths > 0 ? e.Determinant() / (ideal * lengths) : 0;
    }
    /// 1 in a cube and a regular tet, more in others, without bound where it gets flat; infinite where it is.
    double Energy(std::span<const double> positions) const {
        const Edges e = EdgesIn(positions);
        const double det = e.Determinant(), square = (Dot(e.a, e.a) + Dot(e.b, e.b) + Dot(e.c, e.c)) / 3;
        return det > 0 ? ideal * square * std::sqrt(square) / det : std::numeric_limits<double>::infinity();
    }
};

/// Of hexahedra eight each, of tets four, of octahedra those of the four tets around the major diagonal.
std::vector<CellCorner> CornersOf(const ControlMesh& mesh);

}  // namespace SolidSubdiv::Fit::Starting

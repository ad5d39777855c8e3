// SPDX-License-Identifier: Apache-2.0
// Normals that a model carries, and how they follow a deformation: by two tangents each, as points beside the vertex.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Cli {

/// Normals at vertices of a model; a vertex may have several, or none.
struct ModelNormals {
    std::vector<Index> vertices;  ///< (n)
    std::vector<double> normals;  ///< (n, 3); of length 0: stays so

    bool empty() const { return vertices.empty(); }
};

/// Point data `Normals` (three numbers; the name in any case), or PLY's nx, ny, nz.
ModelNormals NormalsOf(const Io::Mesh& model);
/// Puts them back.
void SetNormals(Io::Mesh& model, std::span<const double> normals);

/// The positions, followed by the two points beside each normal.
/// @param step how far they lie: small against what deforms, large against rounding
std::vector<double> WithTangents(std::span<const double> positions, const ModelNormals& normals, double step);
/// Normals of length 1 from what WithTangents' points have become.
std::vector<double> TurnedNormals(std::span<const double> points, const ModelNormals& normals);

}  // namespace SolidSubdiv::Cli

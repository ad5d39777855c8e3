// SPDX-License-Identifier: Apache-2.0
// Normals that a model carries, and how they follow a deformation: by two tangents each, as points beside the vertex.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Cli {

/// Point data `Normals` (three numbers; the name in any case), or PLY's nx, ny, nz.
class ModelNormals {
  public:
    /// @param step how far the points beside lie: small against what deforms, large against rounding
    ModelNormals(const Io::Mesh& model, double step);

    bool empty() const { return normals_.empty(); }
    /// The vertices, followed by the two points beside each; without normals the vertices alone.
    std::vector<double> WithTangents() const;
    /// Puts what WithTangents() has become into a copy of the model: positions and normals of length 1. Normals of
    /// length 0 stay so.
    Io::Mesh Deformed(std::span<const double> points) const;

  private:
    const Io::Mesh& model_;
    double step_;
    std::vector<std::size_t> attributes_;  // one of width 3, or three of width 1
    std::vector<double> normals_;          // (n, 3) or empty
};

}  // namespace SolidSubdiv::Cli

// SPDX-License-Identifier: Apache-2.0
// What pictures of solids share: what is seen of a mesh, control lattices, how wide lines are, where a solid is cut.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include <solidsubdiv/kit/io/mesh.h>
#include <solidsubdiv/kit/picture/camera.h>
#include <solidsubdiv/kit/picture/cut.h>
#include <solidsubdiv/kit/picture/render.h>

namespace SolidSubdiv::Picture::Internal {

/// Lines as wide as a picture with that many edges bears.
inline double LineWidth(std::size_t n_edges, const RenderOptions& render, double most) {
    const double spacing =
        std::min(render.width, render.height) / std::sqrt(static_cast<double>(std::max<std::size_t>(1, n_edges)));
    return std::clamp(0.14 * spacing, 0.4, most);
}

/// The triangles that are seen of a mesh: a solid's boundary, otherwise its surface elements.
std::vector<Index> VisibleTriangles(const Io::Mesh& mesh);

/// Edges of the mesh's elements among the sides of those triangles: not the diagonals that cut faces into triangles.
/// Of a mesh without cells all edges.
std::vector<Index> VisibleEdges(const Io::Mesh& mesh, const std::vector<Index>& triangles);

/// Adds a control lattice: edges as lit tubes with balls at their ends.
void AddLattice(Scene& scene, const Io::Mesh& lattice, const std::vector<Index>& edges, const RenderOptions& render);

/// Through the middle of the mesh, facing the viewer but for a small turn that shows that there is something behind.
inline Plane CutPlane(const Io::Mesh& mesh, const View& view) {
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        low[i % 3] = std::min(low[i % 3], mesh.positions[i]);
        high[i % 3] = std::max(high[i % 3], mesh.positions[i]);
    }
    const double angle = (view.azimuth - 6) * std::numbers::pi / 180, x = std::sin(angle), back = std::cos(angle);
    Plane plane;
    plane.normal = view.up == UpAxis::Y ? std::array{x, 0.0, back} : std::array{x, -back, 0.0};
    for (std::size_t k = 0; k < 3; ++k) plane.point[k] = 0.5 * (low[k] + high[k]);
    return plane;
}

}  // namespace SolidSubdiv::Picture::Internal

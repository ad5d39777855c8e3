// SPDX-License-Identifier: Apache-2.0
// An octahedron, refined and blown up level by level.
#include <solidsubdiv/apps/fit/internal/start/ellipsoid.h>

#include <algorithm>
#include <utility>

#include <solidsubdiv/apps/fit/internal/vec3.h>
#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/kit/geometry/oriented_box.h>

namespace SolidSubdiv::Fit::Starting {

using namespace Internal;

Ellipsoid MakeEllipsoid(std::span<const double> points, Index n_control) {
    Ellipsoid made;
    made.positions = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
    const std::vector<Index> octahedron = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    int n_levels = 0;
    for (Offset n = 8; n < std::max<Offset>(4096, Offset{10} * n_control); n *= 4) ++n_levels;
    auto refiner = Far::TopologyRefiner::Create({.n_vertices = 6, .triangles = octahedron}, Sdc::Split::TetOct);
    refiner.RefineUniform({.max_level = n_levels});
    const Far::PrimvarRefiner primvars(refiner, Sdc::LinearSurface{});
    for (int l = 1; l <= n_levels; ++l) {
        std::vector<double> finer(3 * static_cast<std::size_t>(refiner.n_vertices(l)));
        primvars.Interpolate<double>(l, made.positions, finer, 3);
        made.positions = std::move(finer);
        for (Index v = 0; v < refiner.n_vertices(l); ++v) {
            SetPoint(made.positions, v, Unit(PointAt(made.positions, v)));
        }
    }
    const auto& last = refiner.level(n_levels);
    for (Index f = 0; f < last.n_boundary_faces; ++f) {
        const auto v = last.BoundaryVertices(f);
        made.triangles.insert(made.triangles.end(), v.begin(), v.end());
    }
    Geometry::OrientedBox box = Geometry::MakeBox(points, Geometry::BoxKind::Oriented);
    const auto middle = box.At({.5 * box.lengths[0], .5 * box.lengths[1], .5 * box.lengths[2]});
    const double least = .01 * *std::max_element(box.lengths.begin(), box.lengths.end());
    for (Index v = 0; static_cast<std::size_t>(v) < made.positions.size() / 3; ++v) {
        const Vec3 unit = PointAt(made.positions, v);
        Vec3 p{middle[0], middle[1], middle[2]};
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 axis{box.axes[k][0], box.axes[k][1], box.axes[k][2]};
            p = p + .5 * std::max(box.lengths[k], least) * unit[k] * axis;
        }
        SetPoint(made.positions, v, p);
    }
    return made;
}

}  // namespace SolidSubdiv::Fit::Starting

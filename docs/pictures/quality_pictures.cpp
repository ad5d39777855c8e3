// SPDX-License-Identifier: Apache-2.0
// A bar of hexahedra, twisted and shaken, by the quality of its cells.
#include "quality_pictures.h"

#include <cmath>
#include <random>
#include <vector>

#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/geometry/cell_quality.h>
#include <solidsubdiv/kit/io/mesh.h>
#include <solidsubdiv/kit/picture/quality_picture.h>

namespace SolidSubdiv::Picture {

namespace {

constexpr int kWide = 8, kLong = 20;

/// kWide * kWide * kLong cubes, twisted about the long axis. Vertices are shaken by 0.42 of an edge inside, the more
/// the nearer to the middle of the bar.
Io::Mesh TwistedBar() {
    Io::Mesh mesh;
    std::mt19937 engine(2);
    const auto shake = [&](double amount) { return amount * (static_cast<double>(engine()) / 2147483648.0 - 1); };
    constexpr int m = kWide + 1;
    for (int x = 0; x <= kLong; ++x) {
        for (int y = 0; y < m; ++y) {
            for (int z = 0; z < m; ++z) {
                const bool is_inside = x > 0 && x < kLong && y > 0 && y < kWide && z > 0 && z < kWide;
                const double nearness = 1 - std::abs(x - 0.5 * kLong) / (0.5 * kLong);
                const double amount = is_inside ? 0.42 * nearness : 0;
                const double a = 0.09 * x, p = y - 0.5 * kWide + shake(amount), q = z - 0.5 * kWide + shake(amount);
                mesh.positions.insert(mesh.positions.end(), {x + shake(amount), std::cos(a) * p - std::sin(a) * q,
                                                             std::sin(a) * p + std::cos(a) * q});
                ++mesh.topology.n_vertices;
            }
        }
    }
    const auto id = [&](int x, int y, int z) { return z + m * (y + m * x); };
    for (int x = 0; x < kLong; ++x) {
        for (int y = 0; y < kWide; ++y) {
            for (int z = 0; z < kWide; ++z) {
                for (int up = 0; up < 2; ++up) {
                    mesh.topology.hexes.insert(
                        mesh.topology.hexes.end(),
                        {id(x, y, z + up), id(x + 1, y, z + up), id(x + 1, y + 1, z + up), id(x, y + 1, z + up)});
                }
            }
        }
    }
    return mesh;
}

}  // namespace

Image QualityOfATwistedBar() {
    const Io::Mesh mesh = TwistedBar();
    const auto refiner = Far::TopologyRefiner::Create(mesh.topology, Sdc::Split::Polyhedral);
    std::vector<double> scaled;
    for (const Geometry::CellQuality& q : Geometry::MeasureQuality(refiner, 0, mesh.positions)) {
        scaled.push_back(q.sign == Geometry::MinimumSign::Positive ? q.scaled_jacobian : 0);
    }
    return QualityPicture(mesh, scaled,
                          {.view = {.azimuth = 25, .elevation = 24}, .render = {.width = 560, .height = 400}});
}

}  // namespace SolidSubdiv::Picture

// SPDX-License-Identifier: Apache-2.0
// Blocks of hexahedra that are joined where their vertices meet.
#include "voxel_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace SolidSubdiv::Validation {

namespace {

using Point = std::array<double, 3>;

double Dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The columns of a rotation.
constexpr std::array<Point, 3> kTurn{{{0.8, 0.6, 0}, {-0.48, 0.64, 0.6}, {0.36, -0.48, 0.8}}};
constexpr Point kHalfSides{1, 0.7, 0.5};
constexpr double kRing = 1, kTube = 0.4, kCore = 0.45;

class Blocks {
  public:
    /// n[0] * n[1] * n[2] hexahedra with corners at point(u, v, w), each in [0, 1].
    template <class PointAt>
    void Add(const std::array<int, 3>& n, PointAt&& point) {
        const auto vertex = [&](int x, int y, int z) {
            return Vertex(point(1.0 * x / n[0], 1.0 * y / n[1], 1.0 * z / n[2]));
        };
        for (int x = 0; x < n[0]; ++x) {
            for (int y = 0; y < n[1]; ++y) {
                for (int z = 0; z < n[2]; ++z) {
                    std::array<Index, 8> hex{vertex(x, y, z),
                                             vertex(x + 1, y, z),
                                             vertex(x + 1, y + 1, z),
                                             vertex(x, y + 1, z),
                                             vertex(x, y, z + 1),
                                             vertex(x + 1, y, z + 1),
                                             vertex(x + 1, y + 1, z + 1),
                                             vertex(x, y + 1, z + 1)};
                    if (IsMirrored(hex)) std::rotate(hex.begin(), hex.begin() + 4, hex.end());
                    hexes_.insert(hexes_.end(), hex.begin(), hex.end());
                }
            }
        }
    }
    VoxelShape Shape(std::string name) const {
        auto refiner = Far::TopologyRefiner::Create(
            {.n_vertices = static_cast<Index>(positions_.size() / 3), .hexes = hexes_}, Sdc::Split::Polyhedral);
        return {std::move(name), std::move(refiner), 0, positions_};
    }

  private:
    Index Vertex(const Point& p) {
        std::array<long, 3> key;
        for (std::size_t c = 0; c < 3; ++c) key[c] = std::lround(1e9 * p[c]);
        const auto [place, is_new] = ids_.emplace(key, static_cast<Index>(ids_.size()));
        if (is_new) positions_.insert(positions_.end(), p.begin(), p.end());
        return place->second;
    }
    Point Edge(Index a, Index b) const {
        const double *const p = &positions_[3 * static_cast<std::size_t>(a)],
                            *const q = &positions_[3 * static_cast<std::size_t>(b)];
        return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
    }
    bool IsMirrored(const std::array<Index, 8>& hex) const {
        const Point a = Edge(hex[0], hex[1]), b = Edge(hex[0], hex[3]), c = Edge(hex[0], hex[4]);
        return Dot(a, {b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]}) < 0;
    }

    std::map<std::array<long, 3>, Index> ids_;  // by coordinates in billionths
    std::vector<double> positions_;
    std::vector<Index> hexes_;
};

/// A part of the way from kCore of a point to where its ray leaves the unit ball.
Point Outwards(const Point& p, double part) {
    const double scale = (1 - part) * kCore + part / std::sqrt(Dot(p, p));
    return {scale * p[0], scale * p[1], scale * p[2]};
}

}  // namespace

VoxelShape MakeBall(int n) {
    Blocks blocks;
    blocks.Add({n, n, n}, [](double u, double v, double w) {
        return Point{kCore * (2 * u - 1), kCore * (2 * v - 1), kCore * (2 * w - 1)};
    });
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (double side : {-1.0, 1.0}) {
            blocks.Add({n, n, n}, [&](double u, double v, double part) {
                Point q;
                q[axis] = side;
                q[(axis + 1) % 3] = 2 * u - 1;
                q[(axis + 2) % 3] = 2 * v - 1;
                return Outwards(q, part);
            });
        }
    }
    return blocks.Shape("ball");
}

VoxelShape MakeTorus(int n) {
    // A place in the disc and a turn around the axis.
    const auto point = [](const Point& p, double turn) {
        const double angle = 2 * std::acos(-1.0) * turn, r = kRing + kTube * p[0];
        return Point{r * std::cos(angle), r * std::sin(angle), kTube * p[1]};
    };
    Blocks blocks;
    blocks.Add({n, n, 12 * n}, [&](double u, double v, double turn) {
        return point({kCore * (2 * u - 1), kCore * (2 * v - 1), 0}, turn);
    });
    for (std::size_t axis = 0; axis < 2; ++axis) {
        for (double side : {-1.0, 1.0}) {
            blocks.Add({n, n, 12 * n}, [&](double u, double part, double turn) {
                Point q{};
                q[axis] = side;
                q[1 - axis] = 2 * u - 1;
                return point(Outwards(q, part), turn);
            });
        }
    }
    return blocks.Shape("torus");
}

VoxelShape MakeTurnedBox(int n) {
    Blocks blocks;
    blocks.Add({n, n, n}, [](double u, double v, double w) {
        Point p{};
        for (std::size_t c = 0; c < 3; ++c) {
            p[c] = kHalfSides[0] * (2 * u - 1) * kTurn[0][c] + kHalfSides[1] * (2 * v - 1) * kTurn[1][c] +
                   kHalfSides[2] * (2 * w - 1) * kTurn[2][c];
        }
        return p;
    });
    return blocks.Shape("box");
}

double DistanceToBall(const Point& p) { return std::sqrt(Dot(p, p)) - 1; }
double DistanceToTorus(const Point& p) { return std::hypot(std::hypot(p[0], p[1]) - kRing, p[2]) - kTube; }
double DistanceToTurnedBox(const Point& p) {
    double largest = -HUGE_VAL, outside = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const double beyond = std::abs(Dot(kTurn[c], p)) - kHalfSides[c];
        largest = std::max(largest, beyond);
        outside += std::pow(std::max(beyond, 0.0), 2);
    }
    return largest > 0 ? std::sqrt(outside) : largest;
}

}  // namespace SolidSubdiv::Validation

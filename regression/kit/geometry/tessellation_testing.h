// SPDX-License-Identifier: Apache-2.0
// What tests of tessellations share: complexes with the schemes that refine them, what is watertight, distances.
#pragma once

#include <solidsubdiv/kit/geometry/compact_surface.h>
#include <solidsubdiv/kit/geometry/surface_components.h>
#include <solidsubdiv/kit/geometry/tessellation.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "far/far_testing.h"
#include "sanitized.h"

namespace SolidSubdiv::Geometry {

struct TestComplex {
    std::string name;
    Far::TopologyRefiner refiner;
    std::vector<double> positions;
    std::vector<std::pair<std::string, Sdc::Scheme>> schemes;  ///< all that refine it, with their default options
};

template <class Shape>
TestComplex MakeComplex(std::string name, const Shape& shape, Sdc::Split split) {
    TestComplex complex{
        std::move(name), Far::TopologyRefiner::Create(TestFar::Describe(shape), split), shape.positions, {}};
    Sdc::ForEachScheme([&](auto scheme) {
        if (Sdc::Takes(scheme, split) && (scheme.kSolids || complex.refiner.n_cells(0) == 0)) {
            complex.schemes.emplace_back(scheme.kName, scheme);
        }
    });
    return complex;
}

inline std::vector<TestComplex> TestComplexes() {
    std::vector<TestComplex> all;
    for (const auto& [name, shape] : TestShapes::AllShapes()) {
        all.push_back(MakeComplex(name, shape, Sdc::Split::TetOct));
    }
    for (auto [name, shape] : TestShapes::PolyhedralShapes()) {
        TestShapes::Random random(5);
        for (double& x : shape.positions) x += 0.05 * random.Uniform();
        all.push_back(MakeComplex(name, shape, Sdc::Split::Polyhedral));
    }
    return all;
}

/// For what takes long: one random complex with one scheme (their neighbourhoods are all different), and of the others
/// no schemes whose boundaries are flat or another scheme's. Under a sanitizer by turns one scheme a complex.
inline std::vector<TestComplex> TestComplexesInShort() {
    std::vector<TestComplex> all = TestComplexes();
    std::erase_if(all, [](const TestComplex& c) { return c.name == "random 60%"; });
    for (TestComplex& complex : all) {
        if (complex.name == "random 30%") complex.schemes.resize(1);
        std::erase_if(complex.schemes,
                      [](const auto& s) { return s.first == "smooth-tet" || s.first.starts_with("linear"); });
    }
    for (std::size_t i = 0; kIsSanitized && i < all.size(); ++i) {
        all[i].schemes = {all[i].schemes[i % all[i].schemes.size()]};
    }
    return all;
}

/// An octahedron's surface, whose limits are round, under Loop's scheme.
inline TestComplex Ball() {
    return MakeComplex("octahedron surface", TestShapes::OctahedronSurface(), Sdc::Split::TetOct);
}

/// Everything that refining a surface must keep.
struct SurfaceKind {
    Offset euler_characteristic = 0, n_border_loops = 0, n_border_edges = 0, n_non_manifold_edges = 0,
           n_flipped_edges = 0, n_non_manifold_vertices = 0;
    std::size_t n_pieces = 0;

    friend bool operator==(const SurfaceKind&, const SurfaceKind&) = default;
};

inline SurfaceKind KindOf(const std::vector<SurfaceComponent>& pieces) {
    SurfaceKind shape;
    shape.n_pieces = pieces.size();
    for (const SurfaceComponent& piece : pieces) {
        shape.euler_characteristic += piece.EulerCharacteristic();
        shape.n_border_loops += piece.n_border_loops;
        shape.n_border_edges += piece.n_border_edges;
        shape.n_non_manifold_edges += piece.n_non_manifold_edges;
        shape.n_flipped_edges += piece.n_flipped_edges;
        shape.n_non_manifold_vertices += piece.n_non_manifold_vertices;
    }
    return shape;
}

inline SurfaceKind KindOf(const Far::TopologyRefiner& refiner) {
    const BoundarySurface surface =
        refiner.is_polyhedral() ? ExtractBoundary(refiner.polyhedral_level(0)) : ExtractBoundary(refiner.level(0));
    std::vector<Offset> offsets{0};
    while (offsets.back() < static_cast<Offset>(surface.corners.size())) {
        const auto face = static_cast<Index>(offsets.size()) - 1;
        offsets.push_back(offsets.back() + surface.rows.Count(face));
    }
    return KindOf(SurfaceComponents(offsets, surface.corners, static_cast<Index>(surface.vertices.size())));
}

inline SurfaceKind KindOf(const Tessellation& t) {
    std::vector<Index> corners = t.triangles;
    corners.insert(corners.end(), t.quads.begin(), t.quads.end());
    std::vector<Offset> offsets{0};
    for (std::size_t i = 0; i < t.triangles.size() / 3; ++i) offsets.push_back(offsets.back() + 3);
    for (std::size_t i = 0; i < t.quads.size() / 4; ++i) offsets.push_back(offsets.back() + 4);
    return KindOf(SurfaceComponents(offsets, corners, t.n_vertices()));
}

/// Whether it hangs together as the control boundary does; edges that are borders or not manifold may have been cut,
/// but only `cuts` times (0: as often as it likes).
inline bool IsWatertight(const Far::TopologyRefiner& refiner, const Tessellation& t, Offset cuts) {
    SurfaceKind before = KindOf(refiner);
    SurfaceKind after = KindOf(t);
    if (cuts == 0) {
        for (Offset SurfaceKind::*count :
             {&SurfaceKind::n_border_edges, &SurfaceKind::n_non_manifold_edges, &SurfaceKind::n_flipped_edges}) {
            if ((before.*count == 0) != (after.*count == 0) || after.*count < before.*count) return false;
            before.*count = after.*count = 0;
        }
    } else {
        before.n_border_edges *= cuts;
        before.n_non_manifold_edges *= cuts;
        before.n_flipped_edges *= cuts;
    }
    // Vertices inside edges where more than two faces meet are not manifold either.
    if (before.n_non_manifold_edges > 0 || after.n_non_manifold_edges > 0 || KindOf(refiner).n_non_manifold_edges > 0) {
        before.n_non_manifold_vertices = after.n_non_manifold_vertices = 0;
    }
    return before == after;
}

struct Point {
    double x, y, z;
    friend Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
};
inline double Dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Point Cross(const Point& a, const Point& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double Length(const Point& a) { return std::sqrt(Dot(a, a)); }
inline Point PointOf(const std::vector<double>& positions, Index v) {
    const double* p = &positions[3 * static_cast<std::size_t>(v)];
    return {p[0], p[1], p[2]};
}

/// The distance of p to a triangle: to its plane where it lies over it, else to the nearest edge.
inline double DistanceToTriangle(const Point& p, const std::array<Point, 3>& t) {
    const Point n = Cross(t[1] - t[0], t[2] - t[0]);
    bool is_over = Length(n) > 0;
    double nearest = INFINITY;
    for (std::size_t k = 0; k < 3; ++k) {
        const Point &a = t[k], &b = t[(k + 1) % 3];
        const Point edge = b - a;
        is_over = is_over && Dot(Cross(n, edge), p - a) >= 0;
        const double size = Dot(edge, edge), at = size > 0 ? std::clamp(Dot(p - a, edge) / size, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, Length(p - Point{a.x + at * edge.x, a.y + at * edge.y, a.z + at * edge.z}));
    }
    return is_over ? std::abs(Dot(n, p - t[0])) / Length(n) : nearest;
}

/// The largest distance of random points of the limit to the tessellation's triangles, the one that covers a point and
/// those that share a vertex with it: an estimate of its own.
inline double LargestDistance(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme, const Tessellation& t,
                              const std::vector<double>& control, int n_per_triangle) {
    TestShapes::Random random(23);
    std::vector<Far::Place> places;
    std::vector<std::vector<std::size_t>> triangles_of(static_cast<std::size_t>(t.n_vertices()));
    for (std::size_t i = 0; i < t.triangles.size(); ++i) {
        triangles_of[static_cast<std::size_t>(t.triangles[i])].push_back(i / 3);
    }
    for (const FacetDomain& domain : t.domains) {
        for (int i = 0; i < n_per_triangle; ++i) {
            double u = 0.5 + 0.5 * random.Uniform(), v = 0.5 + 0.5 * random.Uniform();
            if (u + v > 1) {
                u = 1 - u;
                v = 1 - v;
            }
            places.push_back(domain.At({1 - u - v, u, v, 0}));
        }
    }
    const auto table =
        Far::LimitStencilTable::Create(refiner, scheme, places, {.elements = Far::Elements::BoundaryFaces});
    const std::vector<double> limits = TestFar::Limits(table, control), vertices = t.Positions(control);
    double largest = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t own = i / static_cast<std::size_t>(n_per_triangle);
        double nearest = INFINITY;
        const auto measure = [&](std::size_t triangle) {
            const Index* v = &t.triangles[3 * triangle];
            const std::array<Point, 3> corners{PointOf(vertices, v[0]), PointOf(vertices, v[1]),
                                               PointOf(vertices, v[2])};
            nearest = std::min(nearest, DistanceToTriangle(PointOf(limits, static_cast<Index>(i)), corners));
        };
        measure(own);
        for (std::size_t k = 0; k < 3 && nearest > largest; ++k) {
            for (std::size_t near : triangles_of[static_cast<std::size_t>(t.triangles[3 * own + k])]) measure(near);
        }
        largest = std::max(largest, nearest);
    }
    return largest;
}

}  // namespace SolidSubdiv::Geometry

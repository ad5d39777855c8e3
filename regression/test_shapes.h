// SPDX-License-Identifier: Apache-2.0
// Complexes made in code for tests: blocks, random subsets that touch in faces, edges and vertices, mixed dimensions.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::TestShapes {

/// A complex with positions.
struct Shape {
    Index n_vertices = 0;
    std::vector<Index> tets, octs, triangles, edges;
    std::vector<double> positions;  ///< (n_vertices, 3)
};

/// The same numbers everywhere (SplitMix64).
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t Next() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }
    /// In [0, n).
    int Below(int n) { return static_cast<int>(Next() % static_cast<std::uint64_t>(n)); }
    /// In [-1, 1).
    double Uniform() { return static_cast<double>(Next() >> 11) * (2.0 / 9007199254740992.0) - 1.0; }
    template <class T>
    void Shuffle(std::vector<T>& v) {
        for (std::size_t i = v.size(); i > 1; --i) std::swap(v[i - 1], v[Next() % i]);
    }

  private:
    std::uint64_t state_;
};

/// Cube of n^3 cubes, each cut into six positive tets along its main diagonal (Kuhn).
inline Shape KuhnBlock(int n) {
    Shape s;
    const int m = n + 1;
    s.n_vertices = m * m * m;
    for (int z = 0; z < m; ++z) {
        for (int y = 0; y < m; ++y) {
            for (int x = 0; x < m; ++x) {
                for (int c : {x, y, z}) s.positions.push_back(c);
            }
        }
    }
    const auto id = [&](std::array<int, 3> p) { return static_cast<Index>(p[0] + m * (p[1] + m * p[2])); };
    for (int z = 0; z < n; ++z) {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                std::array<int, 3> axes{0, 1, 2};
                int sign = 1;
                do {
                    std::array<std::array<int, 3>, 4> p{{{x, y, z}, {}, {}, {}}};
                    for (int k = 0; k < 3; ++k) {
                        p[k + 1] = p[k];
                        ++p[k + 1][axes[k]];
                    }
                    const int inversions = (axes[0] > axes[1]) + (axes[1] > axes[2]) + (axes[0] > axes[2]);
                    sign = inversions % 2 ? -1 : 1;
                    if (sign < 0) std::swap(p[2], p[3]);
                    for (const auto& q : p) s.tets.push_back(id(q));
                } while (std::next_permutation(axes.begin(), axes.end()));
            }
        }
    }
    return s;
}

inline Shape SingleTet() { return {4, {0, 1, 2, 3}, {}, {}, {}, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}}; }

/// v0 = +x, v1 = -x, v2 = +y, v3 = -y, v4 = -z, v5 = +z: positive.
inline Shape SingleOct() {
    return {6, {}, {0, 1, 2, 3, 4, 5}, {}, {}, {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, -1, 0, 0, 1}};
}

/// Keeps about `percent` of the elements of one kind.
inline std::vector<Index> Some(const std::vector<Index>& elements, std::size_t arity, int percent, std::uint64_t seed) {
    Random random(seed);
    std::vector<Index> some;
    for (std::size_t i = 0; i < elements.size(); i += arity) {
        if (random.Below(100) < percent) some.insert(some.end(), &elements[i], &elements[i] + arity);
    }
    return some;
}

/// Keeps some of the tets: they meet in faces, edges and vertices in every way.
inline Shape RandomSubset(Shape s, int percent, std::uint64_t seed) {
    s.tets = Some(s.tets, 4, percent, seed);
    return s;
}

/// Moves every vertex a little, so that no symmetry hides a fault.
inline void Jitter(Shape& s, double amount, std::uint64_t seed) {
    Random random(seed);
    for (double& x : s.positions) x += amount * random.Uniform();
}

/// Octahedra in a row, each sharing a face with a tet of its own, and tets between some of them.
inline Shape OctsAndTets() {
    Shape s = SingleOct();
    // A tet on face (0, 2, 5), one on face (1, 4, 3), a second oct on face (0, 4, 2).
    const auto add = [&](double x, double y, double z) {
        s.positions.insert(s.positions.end(), {x, y, z});
        return s.n_vertices++;
    };
    const Index a = add(1.2, 1.1, 1.3), b = add(-1.2, -1.1, -1.2);
    s.tets = {0, 2, 5, a, 1, 4, 3, b};
    // The oct with faces (0, 2, 4) and an opposite triangle (c, d, e): opposite vertices 0-c, 2-d, 4-e.
    const Index c = add(0.6, 1.7, -1.6), d = add(1.7, 0.6, -1.5), e = add(1.6, 1.6, -0.7);
    s.octs.insert(s.octs.end(), {0, c, 2, d, 4, e});
    return s;
}

/// A solid with a sheet along an edge, a sheet through its inside, a rod at a vertex, a loose triangle fan and a
/// polyline.
inline Shape MixedDimensions() {
    Shape s = KuhnBlock(2);
    const auto add = [&](double x, double y, double z) {
        s.positions.insert(s.positions.end(), {x, y, z});
        return s.n_vertices++;
    };
    const Index sail = add(-1, -1, 0.5), rod = add(3, 3, 3), rod_end = add(4, 4, 3);
    s.triangles = {0, 9, sail};         // along the block's vertical edge (0,0,0)-(0,0,1)
    s.edges = {26, rod, rod, rod_end};  // from the corner (2,2,2)
    const Index hub = add(6, 0, 0);
    std::vector<Index> rim;
    for (int i = 0; i < 5; ++i) rim.push_back(add(6 + (i % 2), i - 2.0, 1.0));
    for (int i = 0; i < 4; ++i) s.triangles.insert(s.triangles.end(), {hub, rim[i], rim[i + 1]});
    s.triangles.insert(s.triangles.end(), {13, hub, add(1, 1, 9)});  // from the block's inner vertex (1,1,1)
    s.edges.insert(s.edges.end(), {rim[4], add(9, 9, 9)});
    return s;
}

/// Subdivided-cube-like closed triangle surface: an octahedron's eight faces.
inline Shape OctahedronSurface() {
    Shape s = SingleOct();
    s.octs.clear();
    s.triangles = {0, 4, 2, 0, 2, 5, 0, 3, 4, 0, 5, 3, 1, 2, 4, 1, 5, 2, 1, 4, 3, 1, 3, 5};
    return s;
}

/// n by n squares in the plane, each cut into two triangles: regular inside.
inline Shape TriangleGrid(int n) {
    Shape s;
    const Index m = n + 1;
    s.n_vertices = m * m;
    for (Index y = 0; y < m; ++y) {
        for (Index x = 0; x < m; ++x) {
            for (Index c : {x, y, 0}) s.positions.push_back(c);
            if (x == n || y == n) continue;
            const Index v = x + m * y;
            s.triangles.insert(s.triangles.end(), {v, v + 1, v + m + 1, v, v + m + 1, v + m});
        }
    }
    return s;
}

/// Keeps some of the triangles: borders of every kind, holes, fans that meet in a vertex.
inline Shape RandomTriangles(Shape s, int percent, std::uint64_t seed) {
    s.triangles = Some(s.triangles, 3, percent, seed);
    return s;
}

/// n triangles around vertex 0 and `rings` - 1 rings around them, all regular: a valence of n, a border, its corners.
inline Shape Disc(int n, int rings) {
    Shape s;
    const auto add = [&](double radius, double turn) {
        const double angle = 2 * 3.14159265358979323846 * turn;
        s.positions.insert(s.positions.end(),
                           {radius * std::cos(angle), radius * std::sin(angle), 0.1 * radius * radius});
        return s.n_vertices++;
    };
    std::vector<Index> inner{add(0, 0)}, outer;
    for (int r = 1; r <= rings; ++r) {
        outer.clear();
        for (int i = 0; i < n * r; ++i) outer.push_back(add(r, static_cast<double>(i) / (n * r)));
        const int n_inner = static_cast<int>(inner.size()), n_outer = static_cast<int>(outer.size());
        for (int side = 0; side < n; ++side) {
            for (int i = 0; i < r; ++i) {
                const Index a = inner[(side * (r - 1) + i) % n_inner], b = outer[side * r + i],
                            c = outer[(side * r + i + 1) % n_outer];
                s.triangles.insert(s.triangles.end(), {a, b, c});
                if (i + 1 < r) s.triangles.insert(s.triangles.end(), {a, c, inner[(side * (r - 1) + i + 1) % n_inner]});
            }
        }
        inner = outer;
    }
    return s;
}

/// Every shape above with its name, for tests that run over all.
inline std::vector<std::pair<const char*, Shape>> AllShapes() {
    std::vector<std::pair<const char*, Shape>> all{{"tet", SingleTet()},
                                                   {"oct", SingleOct()},
                                                   {"kuhn 3", KuhnBlock(3)},
                                                   {"random 30%", RandomSubset(KuhnBlock(3), 30, 1)},
                                                   {"random 60%", RandomSubset(KuhnBlock(3), 60, 2)},
                                                   {"octs and tets", OctsAndTets()},
                                                   {"mixed dimensions", MixedDimensions()},
                                                   {"octahedron surface", OctahedronSurface()},
                                                   {"disc of five", Disc(5, 2)},
                                                   {"random triangles", RandomTriangles(TriangleGrid(5), 75, 4)}};
    for (std::size_t i = 0; i < all.size(); ++i) Jitter(all[i].second, 0.05, i + 10);
    return all;
}

}  // namespace SolidSubdiv::TestShapes

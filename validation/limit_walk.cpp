// SPDX-License-Identifier: Apache-2.0
// Refining, cutting, and fitting quadratics to what the split's points tend to.
#include "limit_walk.h"

#include <algorithm>
#include <cmath>

#include "limit_cut.h"
#include "limit_steps.h"
#include "points.h"

namespace SolidSubdiv::Validation {

namespace {

/// Masks reach one ring of elements around a vertex, or around both ends of an edge. New points within two rings of a
/// child lie within one of its parent, so two rings are enough to go on for ever.
constexpr int kRings = 2;

/// A point that the scheme tends to at a vertex, from two levels: errors fall by 4.
Vector3 LimitAt(const std::vector<double>& before, Index v, const std::vector<double>& after, Index w) {
    Vector3 limit;
    for (std::size_t i = 0; i < 3; ++i) {
        limit[i] = (4 * after[3 * static_cast<std::size_t>(w) + i] - before[3 * static_cast<std::size_t>(v) + i]) / 3;
    }
    return limit;
}

/// Monomials up to the second degree: 1, x, y, ..., xx, xy, ...
std::vector<double> Monomials(const Vector3& x, std::size_t d) {
    std::vector<double> m{1};
    for (std::size_t i = 0; i < d; ++i) m.push_back(x[i]);
    for (std::size_t i = 0; i < d; ++i) {
        for (std::size_t j = i; j < d; ++j) m.push_back(x[i] * x[j]);
    }
    return m;
}

/// Least squares: the coefficients of a quadratic, a row each. Empty where the points don't determine it.
std::vector<Vector3> FitQuadratic(const std::vector<std::vector<double>>& rows, const std::vector<Vector3>& values) {
    const std::size_t n = rows.empty() ? 0 : rows[0].size();
    std::vector<std::vector<double>> m(n, std::vector<double>(n + 3, 0.0));  // the normal equations
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) m[i][j] += rows[r][i] * rows[r][j];
            for (std::size_t c = 0; c < 3; ++c) m[i][n + c] += rows[r][i] * values[r][c];
        }
    }
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k; i < n; ++i) {
            if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
        }
        std::swap(m[k], m[pivot]);
        if (std::abs(m[k][k]) < 1e-9) return {};
        for (std::size_t i = 0; i < n; ++i) {
            if (i == k) continue;
            const double factor = m[i][k] / m[k][k];
            for (std::size_t j = k; j < n + 3; ++j) m[i][j] -= factor * m[k][j];
        }
    }
    std::vector<Vector3> coefficients;
    for (std::size_t k = 0; k < n; ++k) {
        coefficients.push_back({m[k][n] / m[k][k], m[k][n + 1] / m[k][k], m[k][n + 2] / m[k][k]});
    }
    return coefficients;
}

/// Coefficients around the place, by `at`, to derivatives by the control element's coordinates.
LimitEstimate ByControl(const std::vector<Vector3>& coefficients, const PlaceByVertices& place) {
    const std::size_t d = static_cast<std::size_t>(place.d);
    LimitEstimate estimate{coefficients[0], {}, {}};
    const Matrix3& by = place.by_control;
    for (std::size_t a = 0; a < d; ++a) {
        Vector3& slope = estimate.slopes.emplace_back();
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t i = 0; i < d; ++i) slope[c] += coefficients[1 + i][c] * by[i][a];
        }
        for (std::size_t b = a; b < d; ++b) {
            Vector3& curvature = estimate.curvatures.emplace_back();
            for (std::size_t c = 0; c < 3; ++c) {
                std::size_t k = 1 + d;
                for (std::size_t i = 0; i < d; ++i) {
                    for (std::size_t j = i; j < d; ++j, ++k) {
                        curvature[c] += coefficients[k][c] * (by[i][a] * by[j][b] + by[j][a] * by[i][b]);
                    }
                }
            }
        }
    }
    return estimate;
}

}  // namespace

Far::TopologyDescriptor OwnedMesh::Descriptor() const {
    Far::TopologyDescriptor d{.n_vertices = n_vertices};
    d.tets = tets;
    d.octs = octs;
    d.hexes = hexes;
    d.triangles = triangles;
    d.edges = edges;
    if (polyhedron_offsets.size() > 1) {
        d.polyhedron_offsets = polyhedron_offsets;
        d.polyhedron_face_offsets = polyhedron_face_offsets;
        d.polyhedron_vertices = polyhedron_vertices;
    }
    if (polygon_offsets.size() > 1) {
        d.polygon_offsets = polygon_offsets;
        d.polygon_vertices = polygon_vertices;
    }
    d.crease_edges = creases.edges;
    d.crease_sharpness = creases.edge_sharpness;
    d.corner_vertices = creases.vertices;
    d.corner_sharpness = creases.vertex_sharpness;
    return d;
}

Estimates WalkToPlace(const OwnedMesh& mesh, Sdc::Split split, const std::vector<Sdc::Scheme>& schemes,
                      const std::vector<double>& positions, const Far::Place& place, Far::Elements elements,
                      int n_levels) {
    Estimates estimates(schemes.size());
    std::vector<std::vector<double>> values(schemes.size(), positions);
    const bool has_cells =
        !mesh.tets.empty() || !mesh.octs.empty() || !mesh.hexes.empty() || mesh.polyhedron_offsets.size() > 1;
    const bool is_mixed = has_cells && (!mesh.triangles.empty() || !mesh.edges.empty());
    OwnedMesh here = mesh;
    PlaceByVertices parent, child;
    std::vector<SplitPoint> points;  // of the parent, in the mesh here
    for (int l = 0; l < n_levels; ++l) {
        auto refiner = Far::TopologyRefiner::Create(here.Descriptor(), split);
        refiner.RefineUniform({.max_level = 1, .full_topology_in_last_level = is_mixed});
        std::vector<SplitPoint> next_points;
        PlaceByVertices next =
            l == 0 ? FirstStep(refiner, place, elements, next_points) : StepDown(refiner, child, next_points);
        const Far::Creases creases = Far::CreasesAt(refiner, schemes[0], 1);
        const CutOut cut = CutAround(refiner, 1, next.vertices, kRings, is_mixed, creases);

        std::vector<std::vector<double>> rows;
        for (const SplitPoint& p : points) {
            Vector3 from_place;
            for (std::size_t i = 0; i < 3; ++i) from_place[i] = p.at[i] - parent.at[i];
            rows.push_back(Monomials(from_place, static_cast<std::size_t>(parent.d)));
        }
        for (std::size_t s = 0; s < schemes.size(); ++s) {
            const auto table = Far::StencilTable::Create(refiner, schemes[s]);
            const std::vector<double> refined = Apply(table.level(1), values[s]);
            std::vector<Vector3> limits;
            for (const SplitPoint& p : points) limits.push_back(LimitAt(values[s], p.vertex, refined, p.vertex));
            if (const auto fit = FitQuadratic(rows, limits); !fit.empty()) {
                estimates[s].push_back(ByControl(fit, parent));
            }
            values[s].clear();
            for (Index v : cut.vertices) {
                const auto from = refined.begin() + 3 * v;
                values[s].insert(values[s].end(), from, from + 3);
            }
        }

        const auto number = [&](Index v) { return cut.number[static_cast<std::size_t>(v)]; };
        // For the next fit: the place in what is the parent then.
        points.clear();  // not of the control element, whose children may be those of a part
        for (const SplitPoint& p : l == 0 ? std::vector<SplitPoint>() : next_points) {
            const Index v = number(p.vertex);
            if (v != kNoIndex && cut.is_complete[static_cast<std::size_t>(v)]) points.push_back({v, p.at});
        }
        parent = child;
        for (Index& v : next.vertices) v = number(v);
        child = std::move(next);
        here = cut.mesh;
    }
    return estimates;
}

}  // namespace SolidSubdiv::Validation

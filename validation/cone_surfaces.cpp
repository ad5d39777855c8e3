// SPDX-License-Identifier: Apache-2.0
// Places, triangles and matrices of cones.
#include "cone_surfaces.h"

#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

namespace SolidSubdiv::Validation {

namespace {

/// The one way to write a place.
ConePlace Normal(const Cone& cone, ConePlace place) {
    auto& [sector, p, q] = place;
    if (p == 0 && q == 0) return {0, 0, 0};
    if (p == 0) {
        ++sector;
        std::swap(p, q);
    }
    if (cone.is_closed) sector %= cone.n_sectors;
    return place;
}

int RayAfter(const Cone& cone, int sector) { return cone.is_closed ? (sector + 1) % cone.n_sectors : sector + 1; }

bool IsIn(const Cone& cone, const ConePlace& place, int sector) {
    const auto& [s, p, q] = place;
    return s == sector || (p == 0 && q == 0) || (s == RayAfter(cone, sector) && q == 0);
}

/// p and q in a sector that the place is in. A ray may be the first of its sector and the last of another.
std::array<int, 2> In(const ConePlace& place, int sector) {
    const auto& [s, p, q] = place;
    return s == sector ? std::array<int, 2>{p, q} : std::array<int, 2>{q, p};
}

}  // namespace

Cone MakeCone(int n_sectors, bool is_closed, int n_rings) {
    Cone cone{n_sectors, is_closed, n_rings, {}, {}};
    std::map<ConePlace, int> number;
    const auto add = [&](const ConePlace& place) {
        number[place] = static_cast<int>(cone.places.size());
        cone.places.push_back(place);
    };
    add({0, 0, 0});
    for (int radius = 1; radius <= n_rings; ++radius) {
        for (int s = 0; s < cone.n_rays(); ++s) {
            for (int q = 0; q < (s < n_sectors ? radius : 1); ++q) add({s, radius - q, q});
        }
    }
    const auto vertex = [&](int s, int p, int q) { return number.at(Normal(cone, {s, p, q})); };
    for (int s = 0; s < n_sectors; ++s) {
        for (int p = 0; p < n_rings; ++p) {
            for (int q = 0; p + q < n_rings; ++q) {
                cone.surface.triangles.push_back({vertex(s, p, q), vertex(s, p + 1, q), vertex(s, p, q + 1)});
                if (p + q + 1 == n_rings) continue;
                cone.surface.triangles.push_back({vertex(s, p + 1, q), vertex(s, p + 1, q + 1), vertex(s, p, q + 1)});
            }
        }
    }
    const double angle = (is_closed ? 2 : 1) * std::numbers::pi / n_sectors;
    for (const auto& [s, p, q] : cone.places) {
        const double x = p * std::cos(s * angle) + q * std::cos((s + 1) * angle);
        const double y = p * std::sin(s * angle) + q * std::sin((s + 1) * angle);
        cone.surface.positions.insert(cone.surface.positions.end(), {x, y, 0});
    }
    cone.surface.n_vertices = static_cast<int>(cone.places.size());
    return cone;
}

std::vector<ConePlace> PlacesOfChildren(const Cone& cone, const SurfaceLevel& control) {
    std::vector<ConePlace> places(control.children_of_vertices.size() + control.children_of_edges.size());
    for (std::size_t v = 0; v < cone.places.size(); ++v) {
        const auto [s, p, q] = cone.places[v];
        places.at(control.children_of_vertices[v]) = {s, 2 * p, 2 * q};
    }
    for (std::size_t e = 0; e < control.edges.size(); ++e) {
        const ConePlace &a = cone.places[control.edges[e][0]], &b = cone.places[control.edges[e][1]];
        int sector = 0;
        while (!(IsIn(cone, a, sector) && IsIn(cone, b, sector))) {
            if (++sector == cone.n_sectors) throw std::runtime_error("cone: an edge in no sector");
        }
        const auto [pa, qa] = In(a, sector);
        const auto [pb, qb] = In(b, sector);
        places.at(control.children_of_edges[e]) = Normal(cone, {sector, pa + pb, qa + qb});
    }
    return places;
}

std::vector<double> SubdivisionMatrix(const Cone& cone, int radius, const std::vector<ConePlace>& places,
                                      const std::vector<std::vector<double>>& rows) {
    std::map<ConePlace, std::size_t> row_of;
    for (std::size_t r = 0; r < places.size(); ++r) row_of[places[r]] = r;
    std::vector<double> matrix;
    for (int i = 0; i < cone.surface.n_vertices; ++i) {
        if (!cone.IsWithin(i, radius)) continue;
        const auto found = row_of.find(cone.places[i]);
        if (found == row_of.end()) throw std::runtime_error("cone: no vertex of the next level at a place");
        const std::vector<double>& row = rows.at(found->second);
        for (int j = 0; j < cone.surface.n_vertices; ++j) {
            if (cone.IsWithin(j, radius)) {
                matrix.push_back(row[j]);
            } else if (row[j] != 0) {
                throw std::runtime_error("cone: a row reaches beyond the radius");
            }
        }
    }
    return matrix;
}

}  // namespace SolidSubdiv::Validation

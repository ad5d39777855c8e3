// SPDX-License-Identifier: Apache-2.0
// Small meshes with such a place in the middle.
#include <solidsubdiv/kit/analysis/places.h>

#include <string>

namespace SolidSubdiv::Analysis {

namespace {

/// n hexahedra around the edge of the vertices 0 and 2n + 1.
std::vector<Index> HexesAroundEdge(int n) {
    std::vector<Index> hexes;
    for (int i = 0; i < n; ++i) {
        for (int at : {0, 2 * n + 1}) {
            hexes.insert(hexes.end(), {at, at + 1 + 2 * i, at + 2 + 2 * i, at + 1 + 2 * ((i + 1) % n)});
        }
    }
    return hexes;
}

/// n tets around the edge of the vertices 0 and 1.
std::vector<Index> TetsAroundEdge(int n) {
    std::vector<Index> tets;
    for (int i = 0; i < n; ++i) {
        const Index a = 2 + i, b = 2 + (i + 1) % n;
        if (n < 6 || n % 2 == 1) {
            tets.insert(tets.end(), {0, 1, a, b});
        } else if (i % 2 == 0) {
            tets.insert(tets.end(), {0, a, b, 1});  // its pair: 0 a, b 1
        } else {
            tets.insert(tets.end(), {0, b, 1, a});
        }
    }
    return tets;
}

/// Refined often enough, one tet or triangle has regular vertices inside.
Star InsideOneCell(bool is_solid) {
    const std::vector<Index> tet{0, 1, 2, 3}, triangle{0, 1, 2};
    Far::TopologyDescriptor descriptor{.n_vertices = is_solid ? 4 : 3};
    (is_solid ? descriptor.tets : descriptor.triangles) = is_solid ? tet : triangle;
    auto refiner = Far::TopologyRefiner::Create(descriptor, Sdc::Split::TetOct);
    refiner.RefineUniform({.max_level = 2, .full_topology_in_last_level = true});
    const Far::Level& level = refiner.level(2);
    Index v = 0;
    while (level.vertex_tags[v].rule() != (is_solid ? Vtr::Rule::Solid : Vtr::Rule::Surface)) ++v;
    return StarOf(refiner, 2, v, !is_solid);
}

void RequireSolid(const Sdc::Scheme& scheme, const char* what) {
    if (IsSolid(scheme)) return;
    throw InvalidInput("scheme " + std::string(Sdc::NameOf(scheme)) + " refines surfaces: " + what);
}

}  // namespace

bool IsSolid(const Sdc::Scheme& scheme) {
    return std::visit([](const auto& s) { return s.kSolids; }, scheme);
}

Star RegularStar(const Sdc::Scheme& scheme) {
    const bool is_solid = IsSolid(scheme);
    if (Sdc::Takes(scheme, Sdc::Split::TetOct)) return InsideOneCell(is_solid);
    Star star = is_solid ? EdgeStar(scheme, 4) : SurfaceStar(scheme, 4, false);
    star.is_on_edge = false;
    return star;
}

Star EdgeStar(const Sdc::Scheme& scheme, int n) {
    RequireSolid(scheme, "edges inside have two faces");
    if (n < 3) throw InvalidInput("an inner edge has at least 3 cells, not " + std::to_string(n));
    if (!Sdc::Takes(scheme, Sdc::Split::TetOct)) {
        const std::vector<Index> hexes = HexesAroundEdge(n);
        Far::TopologyDescriptor mesh{.n_vertices = 2 * (2 * n + 1)};
        mesh.hexes = hexes;
        const auto refiner = Far::TopologyRefiner::Create(mesh, Sdc::Split::Polyhedral);
        return PointOnEdge(refiner, 0, refiner.polyhedral_level(0).FindEdge(0, 2 * n + 1));
    }
    const std::vector<Index> tets = TetsAroundEdge(n);
    const auto refiner = Far::TopologyRefiner::Create({.n_vertices = 2 + n, .tets = tets}, Sdc::Split::TetOct);
    return PointOnEdge(refiner, 0, refiner.level(0).FindEdge(0, 1));
}

Star FaceStar(const Sdc::Scheme& scheme, bool is_matched) {
    RequireSolid(scheme, "it has no faces between cells");
    if (!Sdc::Takes(scheme, Sdc::Split::TetOct)) {
        throw InvalidInput("scheme " + std::string(Sdc::NameOf(scheme)) + " is not for tets: faces don't match or not");
    }
    const std::vector<Index> tets =
        is_matched ? std::vector<Index>{0, 1, 2, 3, 1, 0, 2, 4} : std::vector<Index>{0, 1, 2, 3, 0, 2, 1, 4};
    const auto refiner = Far::TopologyRefiner::Create({.n_vertices = 5, .tets = tets}, Sdc::Split::TetOct);
    const Far::Level& level = refiner.level(0);
    Index f = 0;
    while (level.face_tags[f].n_cells() != 2) ++f;
    return PointInFace(refiner, 0, f);
}

Star SurfaceStar(const Sdc::Scheme& scheme, int n, bool is_on_border) {
    const int least = is_on_border ? 1 : 3;
    if (n < least) {
        throw InvalidInput(std::string(is_on_border ? "a vertex on a border has" : "a vertex inside a surface has") +
                           " at least " + std::to_string(least) + " faces, not " + std::to_string(n));
    }
    const bool of_triangles = Sdc::Takes(scheme, Sdc::Split::TetOct);
    Star star{.split = of_triangles ? Sdc::Split::TetOct : Sdc::Split::Polyhedral, .dimension = 2};
    const int n_ends = is_on_border ? n + 1 : n;  // of edges
    star.n_vertices = 1 + n_ends + (of_triangles ? 0 : n);
    for (int i = 0; i < n; ++i) {
        const Index a = 1 + i, b = 1 + (i + 1) % n_ends;
        if (of_triangles) {
            star.triangles.insert(star.triangles.end(), {0, a, b});
        } else {
            star.quads.insert(star.quads.end(), {0, a, 1 + n_ends + i, b});
        }
    }
    return star;
}

}  // namespace SolidSubdiv::Analysis

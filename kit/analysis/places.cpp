// SPDX-License-Identifier: Apache-2.0
// Small meshes with such a place in the middle.
#include <solidsubdiv/kit/analysis/places.h>

#include <string>
#include <vector>

#include <solidsubdiv/kit/analysis/subdivision_matrix.h>

namespace SolidSubdiv::Analysis {

namespace {

bool IsSolid(const Sdc::Scheme& scheme) {
    return std::visit([](const auto& s) { return s.kSolids; }, scheme);
}

/// Two layers of n hexahedra around an edge: its middle is vertex 2n + 1.
std::vector<Index> HexesAroundEdge(int n) {
    std::vector<Index> hexes;
    const int layer = 2 * n + 1;
    for (int z = 0; z < 2; ++z) {
        for (int i = 0; i < n; ++i) {
            for (int at : {layer * z, layer * (z + 1)}) {
                hexes.insert(hexes.end(), {at, at + 1 + 2 * i, at + 2 + 2 * i, at + 1 + 2 * ((i + 1) % n)});
            }
        }
    }
    return hexes;
}

Far::LocalMatrix MatrixAmongHexes(const Sdc::Scheme& scheme, int n) {
    const std::vector<Index> hexes = HexesAroundEdge(n);
    Far::TopologyDescriptor mesh{.n_vertices = 3 * (2 * n + 1)};
    mesh.hexes = hexes;
    const auto refiner = Far::TopologyRefiner::Create(mesh, Sdc::Split::Polyhedral);
    return Far::MakeLocalMatrix(refiner.polyhedral_level(0), scheme, 2 * n + 1).value();
}

/// At a vertex that four quadrilaterals share.
Far::LocalMatrix MatrixAmongQuads(const Sdc::Scheme& scheme) {
    const std::vector<Index> quads{0, 1, 4, 3, 1, 2, 5, 4, 3, 4, 7, 6, 4, 5, 8, 7};
    Far::TopologyDescriptor mesh{.n_vertices = 9};
    mesh.quads = quads;
    const auto refiner = Far::TopologyRefiner::Create(mesh, Sdc::Split::Polyhedral);
    return Far::MakeLocalMatrix(refiner.polyhedral_level(0), scheme, 4).value();
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

}  // namespace

Far::LocalMatrix RegularLocalMatrix(const Sdc::Scheme& scheme) {
    const bool solid = IsSolid(scheme);
    if (!Sdc::Takes(scheme, Sdc::Split::TetOct)) return solid ? MatrixAmongHexes(scheme, 4) : MatrixAmongQuads(scheme);
    // Refined often enough, one cell has regular vertices inside.
    const std::vector<Index> tet{0, 1, 2, 3}, triangle{0, 1, 2};
    Far::TopologyDescriptor descriptor{.n_vertices = solid ? 4 : 3};
    (solid ? descriptor.tets : descriptor.triangles) = solid ? tet : triangle;
    constexpr int kLevel = 2;
    auto refiner = Far::TopologyRefiner::Create(descriptor, Sdc::Split::TetOct);
    refiner.RefineUniform({.max_level = kLevel + 3});
    const Far::Level& level = refiner.level(kLevel);
    for (Index v = 0; v < level.n_vertices; ++v) {
        if (level.vertex_tags[v].rule() != (solid ? Vtr::Rule::Solid : Vtr::Rule::Surface)) continue;
        if (auto m = MatrixAround(refiner, kLevel, v, scheme)) return *m;
    }
    return {};
}

Far::LocalMatrix EdgeLocalMatrix(const Sdc::Scheme& scheme, int n) {
    if (!IsSolid(scheme)) {
        throw InvalidInput("scheme " + std::string(Sdc::NameOf(scheme)) +
                           " refines surfaces: edges inside have two faces");
    }
    if (n < 3) throw InvalidInput("an inner edge has at least 3 cells, not " + std::to_string(n));
    if (!Sdc::Takes(scheme, Sdc::Split::TetOct)) return MatrixAmongHexes(scheme, n);
    const std::vector<Index> tets = TetsAroundEdge(n);
    Far::TopologyDescriptor mesh{.n_vertices = 2 + n};
    mesh.tets = tets;
    auto refiner = Far::TopologyRefiner::Create(mesh, Sdc::Split::TetOct);
    constexpr int kLevel = 1;  // the first with the middle
    refiner.RefineUniform({.max_level = kLevel + 3});
    const Index middle = refiner.level(0).n_vertices + refiner.level(0).FindEdge(0, 1);
    if (auto m = MatrixAround(refiner, kLevel, middle, scheme)) return *m;
    throw SolverError("the rows around the edge reach the boundary");
}

}  // namespace SolidSubdiv::Analysis

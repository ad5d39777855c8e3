// SPDX-License-Identifier: Apache-2.0
// Plain copies between arrays.
#include "meshes.h"

#include <algorithm>

#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Validation {

CellArrays::CellArrays(const Complex& complex) {
    for (const auto& tet : complex.tets) tets.insert(tets.end(), tet.begin(), tet.end());
    for (const auto& oct : complex.octs) octs.insert(octs.end(), oct.begin(), oct.end());
}

Far::TopologyDescriptor CellArrays::Descriptor(Index n_vertices) const {
    Far::TopologyDescriptor descriptor;
    descriptor.n_vertices = n_vertices;
    descriptor.tets = tets;
    descriptor.octs = octs;
    return descriptor;
}

Complex ComplexOf(std::span<const Index> tets, std::span<const Index> octs) {
    Complex complex;
    complex.tets.resize(tets.size() / 4);
    complex.octs.resize(octs.size() / 6);
    for (std::size_t t = 0; t < complex.tets.size(); ++t) std::copy_n(&tets[4 * t], 4, complex.tets[t].begin());
    for (std::size_t o = 0; o < complex.octs.size(); ++o) std::copy_n(&octs[6 * o], 6, complex.octs[o].begin());
    return complex;
}

Complex ComplexOf(const Far::Level& level) { return ComplexOf(level.tet_vertices, level.oct_vertices); }

SolidShape ReadSolidShape(const std::filesystem::path& path, std::string feature) {
    const Io::Mesh mesh = Io::ReadSolid(path);
    const Io::Topology& t = mesh.topology;
    if (t.n_cells() != t.n_tets() + t.n_octs()) {
        throw InvalidInput(path.string() + ": a validator's solid has tets and octahedra only");
    }
    return {path.filename().string(), std::move(feature), ComplexOf(t.tets, t.octs), mesh.positions};
}

std::vector<SolidShape> SolidsOfEveryKind(const std::filesystem::path& shapes) {
    std::vector<SolidShape> solids = ManifoldShapes();
    for (SolidShape& shape : NonManifoldShapes()) solids.push_back(std::move(shape));
    for (std::uint32_t seed = 0; seed < 20; ++seed) solids.push_back(RandomPiece(seed));
    solids.push_back(ReadSolidShape(shapes / "demo" / "bunny_lattice.vtu", "a real lattice"));
    return solids;
}

}  // namespace SolidSubdiv::Validation

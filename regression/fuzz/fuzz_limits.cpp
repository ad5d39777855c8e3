// SPDX-License-Identifier: Apache-2.0
// Fuzzes limit rows at places of complexes read from bytes: pockets of cells that touch in every way.
//
// Rows sum to one, or the place is listed as one without a limit; at a corner of an element they are the row of the
// vertex there, which is found in another way.
#include <cmath>
#include <vector>

#include <solidsubdiv/far/limit_stencil_table.h>

#include "complexes.h"

using namespace SolidSubdiv;
using Fuzz::Require;

namespace {

/// The weight that a row gives a vertex.
double WeightOf(const Far::StencilRows<double>& rows, Index row, Index vertex) {
    double weight = 0;
    for (std::size_t k = 0; k < rows.Indices(row).size(); ++k) {
        if (rows.Indices(row)[k] == vertex) weight += rows.Weights(row)[k];
    }
    return weight;
}

void CheckLimits(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme, Far::Elements elements,
                 const Far::Place& place, Index corner) {
    const std::vector<Far::Place> places{place, {place.element, place.part, {0, 0, 0}}};
    const auto table = Far::LimitStencilTable::Create(refiner, scheme, places, {.elements = elements, .order = 1});
    Fuzz::CheckRows(table.rows(), true);
    if (corner == kNoIndex) return;
    const auto vertices = Far::LimitStencilTable::Create(refiner, scheme, {.level = 0});
    const auto &rows = table.rows(), &vertex_rows = vertices.rows();
    if (rows.Indices(1).empty() || vertex_rows.Indices(corner).empty()) return;  // creases that fade first
    for (Index v : vertex_rows.Indices(corner)) {
        Require(std::abs(WeightOf(rows, 1, v) - WeightOf(vertex_rows, corner, v)) < 1e-9);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Fuzz::Bytes bytes(data, size);
    const bool is_polyhedral = bytes.Next() % 2 == 1;
    int n_before = bytes.Next() % 12;  // of the schemes that take the split, which one
    Far::Place place;
    const int which = bytes.Next();
    for (double& x : place.at) x = bytes.Next() / 768.0;  // within every kind of element
    const Index n_vertices = bytes.Next() % 24;
    const auto check = [&](const Far::TopologyDescriptor& mesh, Sdc::Split split) {
        const auto refiner = Far::TopologyRefiner::Create(mesh, split);
        const Index n_cells = static_cast<Index>(refiner.n_cells(0));
        const Index n_faces =
            is_polyhedral ? refiner.polyhedral_level(0).n_boundary_faces : refiner.level(0).n_boundary_faces;
        Sdc::ForEachScheme([&](auto scheme) {
            if (!Sdc::Takes(scheme, split) || (!scheme.kSolids && n_cells > 0) || n_before-- != 0) return;
            if (scheme.kSolids && n_cells > 0) {
                place.element = which % n_cells;
                // Of a tet and a hexahedron, the first vertex has the coordinates 0.
                const bool has_corner = is_polyhedral ? refiner.polyhedral_level(0).IsHex(place.element)
                                                      : place.element < refiner.level(0).n_tets;
                const Index corner = !has_corner     ? kNoIndex
                                     : is_polyhedral ? refiner.polyhedral_level(0).CellVertices(place.element)[0]
                                                     : refiner.level(0).TetVertices(place.element)[0];
                CheckLimits(refiner, scheme, Far::Elements::Cells, place, corner);
            }
            if (n_faces > 0) {
                place.element = which % n_faces;
                const bool has_corner =
                    !is_polyhedral || refiner.polyhedral_level(0).BoundaryVertices(place.element).size() == 4;
                const Index corner = !has_corner     ? kNoIndex
                                     : is_polyhedral ? refiner.polyhedral_level(0).BoundaryVertices(place.element)[0]
                                                     : refiner.level(0).BoundaryVertices(place.element)[0];
                CheckLimits(refiner, scheme, Far::Elements::BoundaryFaces, place, corner);
            }
        });
    };
    try {
        if (is_polyhedral) {
            check(Fuzz::PolyhedralComplex(bytes, n_vertices).Descriptor(), Sdc::Split::Polyhedral);
        } else {
            check(Fuzz::TetOctComplex(bytes, n_vertices).Descriptor(), Sdc::Split::TetOct);
        }
    } catch (const InvalidInput&) {  // of which fuzz_refiner and fuzz_polyhedra ask more
    }
    return 0;
}

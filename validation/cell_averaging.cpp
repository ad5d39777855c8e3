// SPDX-License-Identifier: Apache-2.0
// Validator cell-averaging: smooth-tet and mlca against a split and averages made the plain way.
#include "cell_averaging.h"

#include <algorithm>
#include <cmath>

#include "cell_averaging_oracle.h"
#include "cell_shapes.h"
#include "meshes.h"
#include "points.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

/// Compares children with the oracle's points of one kind.
class Children {
  public:
    Children(const std::vector<double>& ours, double size, int level, Findings& findings)
        : ours_(ours), size_(size), level_(level), findings_(findings) {}

    template <class Vertices>
    void Compare(const std::map<Parent, Point>& points, const Vertices& of_parent, Index child) {
        Parent parent(of_parent.begin(), of_parent.end());
        std::sort(parent.begin(), parent.end());
        const auto found = points.find(parent);
        if (found == points.end()) return;
        ++n_found;
        for (std::size_t c = 0; c < 3; ++c) {
            const double error = std::abs(ours_[3 * static_cast<std::size_t>(child) + c] - found->second[c]);
            findings_.Error(error / size_, [&] {
                return "vertex " + std::to_string(child) + " of level " + std::to_string(level_ + 1);
            });
        }
    }

    std::size_t n_found = 0;

  private:
    const std::vector<double>& ours_;
    double size_;
    int level_;
    Findings& findings_;
};

void CheckNumber(std::size_t n_found, const NewPoints& expected, int level, Findings& findings) {
    const std::size_t n = expected.of_vertices_and_edges.size() + expected.of_faces.size() + expected.of_cells.size();
    if (n_found != n) {
        findings.Fault("level " + std::to_string(level + 1) + ": " + std::to_string(n_found) + " of the oracle's " +
                       std::to_string(n) + " points are ours");
    }
}

std::vector<std::vector<Polygon>> CellsOf(const Vtr::PolyhedralLevel& level) {
    std::vector<std::vector<Polygon>> cells(static_cast<std::size_t>(level.n_cells()));
    for (std::size_t c = 0; c < cells.size(); ++c) {
        for (Index f : level.CellFaces(static_cast<Index>(c))) {
            const auto v = level.FaceVertices(f);
            cells[c].emplace_back(v.begin(), v.end());
        }
    }
    return cells;
}

}  // namespace

void CompareWithTetOctAverages(const Far::TopologyRefiner& refiner, const Far::StencilTable& table,
                               const std::vector<double>& positions, double size, Findings& findings) {
    std::vector<double> values = positions;
    for (int l = 0; l < refiner.max_level(); ++l) {
        const Far::Level& level = refiner.level(l);
        const std::vector<double> ours = Apply(table.level(l + 1), values);
        const NewPoints expected = AverageTetOct(ComplexOf(level), values);
        Children children(ours, size, l, findings);
        for (Index v = 0; v < level.n_vertices; ++v) {
            children.Compare(expected.of_vertices_and_edges, std::array{v}, v);
        }
        for (Index e = 0; e < level.n_edges; ++e) {
            children.Compare(expected.of_vertices_and_edges, level.EdgeVertices(e), level.n_vertices + e);
        }
        for (Index o = 0; o < level.n_octs; ++o) {
            children.Compare(expected.of_cells, level.OctVertices(o), level.n_vertices + level.n_edges + o);
        }
        CheckNumber(children.n_found, expected, l, findings);
        values = ours;
    }
}

void CompareWithPolyhedralAverages(const Far::TopologyRefiner& refiner, const Far::StencilTable& table,
                                   const std::vector<double>& positions, double size, bool sharp, Findings& findings) {
    std::vector<double> values = positions;
    for (int l = 0; l < refiner.max_level(); ++l) {
        const Vtr::PolyhedralLevel& level = refiner.polyhedral_level(l);
        const std::vector<double> ours = Apply(table.level(l + 1), values);
        const NewPoints expected = AveragePolyhedra(CellsOf(level), values, sharp);
        Children children(ours, size, l, findings);
        Index child = 0;
        for (Index v = 0; v < level.n_vertices; ++v) {
            children.Compare(expected.of_vertices_and_edges, std::array{v}, child++);
        }
        for (Index e = 0; e < level.n_edges; ++e) {
            children.Compare(expected.of_vertices_and_edges, level.EdgeVertices(e), child++);
        }
        for (Index f = 0; f < level.n_faces; ++f) {
            children.Compare(expected.of_faces, level.FaceVertices(f), child++);
        }
        for (Index c = 0; c < static_cast<Index>(level.n_cells()); ++c) {
            children.Compare(expected.of_cells, level.CellVertices(c), child++);
        }
        CheckNumber(children.n_found, expected, l, findings);
        values = ours;
    }
}

Findings ValidateCellAveraging(const Context& context) {
    Findings findings;
    const std::vector<SolidShape> tets = SolidsOfEveryKind(context.shapes);
    for (const SolidShape& shape : tets) {
        const CellArrays cells(shape.complex);
        auto refiner = Far::TopologyRefiner::Create(cells.Descriptor(shape.n_vertices()), Sdc::Split::TetOct);
        const int levels = shape.complex.tets.size() > 1000 ? 1 : 2;  // the oracle is slow
        refiner.RefineUniform({.max_level = levels});
        Findings found;
        CompareWithTetOctAverages(refiner, Far::StencilTable::Create(refiner, Sdc::SmoothTet{}), shape.positions,
                                  SizeOf(shape.positions), found);
        findings.Merge(found, "smooth-tet, " + shape.name);
    }
    const std::vector<CellShape> polyhedra = CellShapes();
    for (const CellShape& shape : polyhedra) {
        const DescribedCells mesh(shape);
        auto refiner = Far::TopologyRefiner::Create(mesh.descriptor, Sdc::Split::Polyhedral);
        refiner.RefineUniform({.max_level = 2});
        for (const bool sharp : {false, true}) {
            const Sdc::Mlca scheme{.features = sharp ? Sdc::Features::Sharp : Sdc::Features::Smooth};
            Findings found;
            CompareWithPolyhedralAverages(refiner, Far::StencilTable::Create(refiner, scheme), shape.positions,
                                          SizeOf(shape.positions), sharp, found);
            findings.Merge(found, std::string("mlca, ") + (sharp ? "sharp, " : "smooth, ") + shape.name);
        }
    }
    findings.notes.push_back(std::to_string(tets.size()) + " solids of tets and octahedra, " +
                             std::to_string(polyhedra.size()) + " of other cells, levels 1-2");
    return findings;
}

}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
// Validator counts: how many vertices, edges, faces, tets and octahedra each level has.
#include "counts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "meshes.h"
#include "solid_shapes.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

std::vector<CountedLevel> LevelsOf(const Far::TopologyRefiner& refiner) {
    std::vector<CountedLevel> levels;
    for (int l = 0; l <= refiner.max_level(); ++l) {
        const Far::Level& level = refiner.level(l);
        levels.push_back(
            {{level.n_vertices, level.n_edges, level.n_faces, level.n_tets, level.n_octs}, ComplexOf(level)});
    }
    return levels;
}

namespace {

void Compare(const PartCounts& ours, const PartCounts& expected, const std::string& what, Findings& findings) {
    const auto compare = [&](std::int64_t a, std::int64_t b, const char* part) {
        findings.Error(std::abs(static_cast<double>(a - b)), [&] {
            return what + ": " + std::to_string(a) + " " + part + ", expected " + std::to_string(b);
        });
    };
    compare(ours.n_vertices, expected.n_vertices, "vertices");
    compare(ours.n_edges, expected.n_edges, "edges");
    compare(ours.n_faces, expected.n_faces, "faces");
    compare(ours.n_tets, expected.n_tets, "tets");
    compare(ours.n_octs, expected.n_octs, "octahedra");
}

std::vector<CountedLevel> Refine(const SolidShape& shape, int max_level) {
    const CellArrays cells(shape.complex);
    auto refiner = Far::TopologyRefiner::Create(cells.Descriptor(shape.n_vertices()), Sdc::Split::TetOct);
    Far::UniformRefinementOptions options;
    options.max_level = max_level;
    refiner.RefineUniform(options);
    return LevelsOf(refiner);
}

}  // namespace

void CompareCounts(std::span<const CountedLevel> levels, Findings& findings) {
    if (levels.empty()) return;
    PartCounts by_formula = CountParts(levels[0].cells);
    for (std::size_t l = 0; l < levels.size(); ++l) {
        const std::string name = "level " + std::to_string(l);
        Compare(levels[l].counts, CountParts(levels[l].cells), name + ", by vertex sets", findings);
        Compare(levels[l].counts, by_formula, name + ", by formula", findings);
        by_formula = CountsAfterSplit(by_formula);
    }
}

void ComparePublished(std::span<const CountedLevel> levels, std::span<const std::int64_t> n_cells, Findings& findings) {
    if (levels.size() != n_cells.size()) findings.Fault("not as many levels as published");
    for (std::size_t l = 0; l < std::min(levels.size(), n_cells.size()); ++l) {
        const std::int64_t ours = levels[l].counts.n_cells();
        findings.Error(std::abs(static_cast<double>(ours - n_cells[l])), [&] {
            return "level " + std::to_string(l) + ": " + std::to_string(ours) + " cells, published " +
                   std::to_string(n_cells[l]);
        });
    }
}

Findings ValidateCounts(const Context& context) {
    Findings findings;
    constexpr std::uint32_t kPieces = 20;
    for (std::uint32_t seed = 0; seed < kPieces; ++seed) {
        const SolidShape shape = RandomPiece(seed);
        if (shape.n_vertices() == 0) continue;
        Findings piece;
        CompareCounts(Refine(shape, 2), piece);
        findings.Merge(piece, shape.name);
    }

    // Chang, McDonnell, Qin 2002, Fig. 1: 16 control points (printed with 24 cells at level 0, which can't give the
    // others; 28 tets do), and its filter, 5200 cells at level 3, from 20 tets.
    constexpr std::array<std::int64_t, 4> kFigure1 = {28, 140, 952, 7280};
    const SolidShape lattice = ReadSolidShape(context.shapes / "validation" / "lattice_28.vtu", "Fig. 1");
    if (lattice.n_vertices() != 16) findings.Fault(lattice.name + " must have 16 control points");
    Findings figure1, filter;
    const auto levels = Refine(lattice, 3);
    ComparePublished(levels, kFigure1, figure1);
    CompareCounts(levels, figure1);
    findings.Merge(figure1, lattice.name);

    constexpr std::array<std::int64_t, 4> kFilter = {20, 100, 680, 5200};
    const SolidShape lattice20 = ReadSolidShape(context.shapes / "validation" / "lattice_20.vtu", "the filter");
    ComparePublished(Refine(lattice20, 3), kFilter, filter);
    findings.Merge(filter, lattice20.name);
    findings.notes.push_back(std::to_string(kPieces) +
                             " random complexes, levels 0-2; 28 -> 140 -> 952 -> 7280 and 20 "
                             "-> 5200 cells");
    return findings;
}

}  // namespace SolidSubdiv::Validation

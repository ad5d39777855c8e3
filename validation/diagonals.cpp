// SPDX-License-Identifier: Apache-2.0
// Validator diagonals: how many faces the policy `matched` makes agree.
#include "diagonals.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "meshes.h"
#include "octet_truss.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

template <class T>
void ShuffleRows(std::vector<T>& rows, Shaker& shaker) {
    for (std::size_t i = rows.size(); i > 1; --i) std::swap(rows[i - 1], rows[shaker.Below(static_cast<int>(i))]);
}

std::string Percent(const MatchedFaces& faces) {
    char text[80];
    std::snprintf(text, sizeof text, "%.1f %% of %lld inner faces matched", 100 * faces.Share(),
                  static_cast<long long>(faces.n_inner));
    return text;
}

Findings CompareMatched(const SolidShape& shape, double least_share) {
    Findings findings;
    const CellArrays cells(shape.complex);
    const auto choice =
        Far::ChooseDiagonals(cells.Descriptor(shape.n_vertices()), Far::DiagonalPolicy::Matched, {}, {});
    CompareChoice(shape, choice, least_share, findings);
    findings.notes.push_back(Percent(CountMatchedFaces(ComplexOf(choice.tets, choice.octs))) + "; " +
                             Percent(CountMatchedFaces(shape.complex)) + " as ordered");
    return findings;
}

}  // namespace

SolidShape Shuffle(const SolidShape& shape, std::uint32_t seed) {
    SolidShape shuffled{shape.name + ", shuffled", shape.feature, shape.complex, shape.positions};
    Shaker shaker(seed);
    std::vector<int> number(static_cast<std::size_t>(shape.n_vertices()));
    std::iota(number.begin(), number.end(), 0);
    ShuffleRows(number, shaker);
    for (std::size_t v = 0; v < number.size(); ++v) {
        std::copy_n(&shape.positions[3 * v], 3, &shuffled.positions[3 * static_cast<std::size_t>(number[v])]);
    }
    for (auto& tet : shuffled.complex.tets) {
        for (int& v : tet) v = number[v];
        for (int turns = shaker.Below(3); turns > 0; --turns) std::rotate(&tet[1], &tet[2], &tet[0] + 4);
        if (shaker.Below(2)) {
            std::swap(tet[0], tet[1]);
            std::swap(tet[2], tet[3]);
        }
    }
    for (auto& oct : shuffled.complex.octs) {
        for (int& v : oct) v = number[v];
        std::rotate(oct.begin(), oct.begin() + 2 * shaker.Below(3), oct.end());
    }
    ShuffleRows(shuffled.complex.tets, shaker);
    ShuffleRows(shuffled.complex.octs, shaker);
    return shuffled;
}

void CompareChoice(const SolidShape& shape, const Far::DiagonalChoice& choice, double least_share, Findings& findings) {
    const Complex chosen = ComplexOf(choice.tets, choice.octs);
    const auto compare_cells = [&](const auto& before, const auto& after, const char* kind) {
        if (before.size() != after.size()) {
            findings.Fault(std::string("another number of ") + kind);
            return;
        }
        for (std::size_t c = 0; c < before.size(); ++c) {
            if (!IsSameCell(before[c], after[c]))
                findings.Fault(std::string(kind) + " " + std::to_string(c) + " changed");
        }
    };
    compare_cells(shape.complex.tets, chosen.tets, "tets");
    compare_cells(shape.complex.octs, chosen.octs, "octs");

    const MatchedFaces faces = CountMatchedFaces(chosen);
    if (faces.n_inner != choice.n_inner_faces || faces.n_matched != choice.n_matched_faces) {
        findings.Fault(std::to_string(choice.n_matched_faces) + " of " + std::to_string(choice.n_inner_faces) +
                       " faces said to be matched; by definition " + std::to_string(faces.n_matched) + " of " +
                       std::to_string(faces.n_inner));
    }
    findings.Error(std::max(0.0, least_share - faces.Share()), [&] { return Percent(faces); });
}

Findings ValidateDiagonals(const Context& context) {
    Findings findings;
    const auto check = [&](const SolidShape& shape, double least_share) {
        findings.Merge(CompareMatched(shape, least_share), shape.name);
    };
    const auto block = [](const char* name, const LatticePoint& size, TrussCells cells) {
        const TrussBlock truss = MakeTrussBlock(size, cells);
        return SolidShape{name, "", {truss.tets, truss.octs}, std::vector<double>(3 * truss.vertices.size())};
    };
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
        check(Shuffle(block("block of tets", {8, 7, 6}, TrussCells::Tets), seed), 1.0);
    }
    check(Shuffle(block("octet truss", {6, 6, 6}, TrussCells::ParallelDiagonals), 4), 1.0);

    constexpr double kLeastShare = 0.75;
    check(ReadSolidShape(context.shapes / "demo" / "bunny_lattice.vtu", ""), kLeastShare);
    for (const char* name : {"poly_bunny.msh", "sofa_liver.msh", "pbd_armadillo_4k.node"}) {
        const std::filesystem::path path = context.tets / name;
        if (std::filesystem::exists(path)) {
            check(ReadSolidShape(path, ""), kLeastShare);
        } else {
            findings.skipped.push_back(std::string(name) + ": there is no " + path.string());
        }
    }
    return findings;
}

}  // namespace SolidSubdiv::Validation

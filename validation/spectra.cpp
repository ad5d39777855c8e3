// SPDX-License-Identifier: Apache-2.0
// Validator spectra: eigenvalues of the schemes in the regular lattice and inside faces of the control mesh, as quoted
// in docs/schemes.
#include "spectra.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <stdexcept>

#include <solidsubdiv/far/local_matrix.h>

#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

LatticePoint Plus(const LatticePoint& a, const LatticePoint& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
LatticePoint Minus(const LatticePoint& a, const LatticePoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

LatticePoint Times(int n, const LatticePoint& a) { return {n * a[0], n * a[1], n * a[2]}; }

std::map<LatticePoint, Index> Places(const std::vector<LatticePoint>& points) {
    std::map<LatticePoint, Index> places;
    for (std::size_t v = 0; v < points.size(); ++v) places.emplace(points[v], static_cast<Index>(v));
    return places;
}

Index At(const std::map<LatticePoint, Index>& places, const LatticePoint& p) {
    const auto found = places.find(p);
    if (found == places.end()) throw std::runtime_error("spectra: no vertex where one should be");
    return found->second;
}

}  // namespace

LocalSubdivision SubdivisionAround(const RefinedPoints& refined, const Far::StencilRows<double>& rows, int level,
                                   Index vertex, int n_rings) {
    const LatticePoint centre = refined.points[level][vertex], fine_centre = Plus(centre, centre);
    const std::map<LatticePoint, Index> fine_places = Places(refined.points[level + 1]);
    LocalSubdivision local;
    const Vtr::Level& topology = refined.refiner.level(level);
    std::vector<Index> near{vertex};
    std::map<LatticePoint, std::size_t> number;
    const auto add = [&](Index v) {
        const LatticePoint offset = Minus(refined.points[level][v], centre);
        const auto [place, is_new] = number.emplace(offset, number.size());
        if (is_new) local.offsets.push_back(offset);
        return std::pair(place->second, is_new);
    };
    add(vertex);
    std::size_t ring_start = 0;
    for (int r = 0; r < n_rings; ++r) {  // where vertices stay, their rows name no neighbours
        const std::size_t ring_end = near.size();
        for (std::size_t i = ring_start; i < ring_end; ++i) {
            for (Index e : topology.vertex_edges[near[i]]) {
                for (Index end : topology.EdgeVertices(e)) {
                    if (add(end).second) near.push_back(end);
                }
            }
        }
        ring_start = ring_end;
    }
    std::vector<std::map<std::size_t, double>> weights;
    for (std::size_t i = 0; i < local.offsets.size(); ++i) {  // grows while it runs
        const Index row = At(fine_places, Plus(fine_centre, local.offsets[i]));
        weights.emplace_back();
        for (std::size_t k = 0; k < rows.Indices(row).size(); ++k) {
            weights.back()[add(rows.Indices(row)[k]).first] += rows.Weights(row)[k];
        }
    }
    const std::size_t n = local.offsets.size();
    local.matrix.assign(n * n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        for (const auto& [j, weight] : weights[i]) local.matrix[i * n + j] = weight;
    }
    return local;
}

void CompareSpectrum(const std::vector<Eigenvalue>& spectrum, const std::vector<QuotedEigenvalue>& quoted,
                     Findings& findings) {
    std::vector<std::complex<double>> ours;
    for (const Eigenvalue& e : spectrum) ours.insert(ours.end(), static_cast<std::size_t>(e.multiplicity), e.value);
    std::size_t next = 0;
    for (const QuotedEigenvalue& q : quoted) {
        for (int m = 0; m < q.multiplicity; ++m, ++next) {
            if (next >= ours.size()) {
                findings.Fault("fewer eigenvalues than quoted");
                return;
            }
            findings.Error(std::max(0.0, std::abs(ours[next] - q.value) - q.rounding), [&] {
                return "eigenvalue " + std::to_string(next + 1) + ": " + std::to_string(ours[next].real()) +
                       ", quoted " + std::to_string(q.value);
            });
        }
    }
}

Findings ValidateSpectra(const Context&) {
    Findings findings;
    const auto text_of = [](const std::vector<Eigenvalue>& spectrum) {
        std::string text;
        for (const Eigenvalue& e : spectrum) {
            char part[60];
            std::snprintf(part, sizeof part, "%s%.6g", text.empty() ? "" : ", ", e.value.real());
            text += part;
            if (std::abs(e.value.imag()) > 1e-9) text += " + " + std::to_string(e.value.imag()) + " i";
            if (e.multiplicity > 1) text += " x " + std::to_string(e.multiplicity);
        }
        return text;
    };
    const auto check = [&](const std::string& name, const RefinedPoints& refined, int level, Index vertex,
                           const Sdc::Scheme& scheme, const std::vector<QuotedEigenvalue>& quoted, int n_rings = 1) {
        const auto table = Far::StencilTable::Create(refined.refiner, scheme);
        const LocalSubdivision local = SubdivisionAround(refined, table.level(level + 1), level, vertex, n_rings);
        const auto spectrum = Spectrum(local.matrix, static_cast<int>(local.offsets.size()));
        Findings found;
        CompareSpectrum(spectrum, quoted, found);
        found.notes.push_back(text_of(spectrum));
        findings.Merge(found, name);
        // Rows of the interpolatory scheme look further than a local matrix.
        if (std::holds_alternative<Sdc::Interpolatory>(scheme) || n_rings > 1) return;

        const auto matrix = Far::MakeLocalMatrix(refined.refiner.level(level), scheme, vertex);
        Findings by_matrix;
        if (matrix) {
            CompareSpectrum(Spectrum(matrix->weights, matrix->size()), quoted, by_matrix);
        } else {
            by_matrix.Fault("no local matrix");
        }
        findings.Merge(by_matrix, name + ", by Far::MakeLocalMatrix");
    };

    Sdc::BoxSpline directional, averaged, printed;
    averaged.diagonals = Sdc::Diagonals::Averaged;
    printed.edge_rule = Sdc::EdgeRule::Printed2002;

    // The middle of a block of the octet truss, and of one made of tets alone, where no octahedron touches it.
    const TrussBlock truss = MakeTrussBlock({4, 4, 4}, TrussCells::ParallelDiagonals);
    const TrussBlock tets = MakeTrussBlock({2, 2, 2}, TrussCells::Tets);
    const RefinedPoints with_octs = RefinePoints(truss.vertices, truss.tets, truss.octs, 2);
    const RefinedPoints without = RefinePoints(tets.vertices, tets.tets, tets.octs, 2);
    const Index middle = truss.VertexAt({2, 2, 2}), middle_of_tets = tets.VertexAt({1, 1, 1});
    const std::vector<QuotedEigenvalue> box_spline = {{1, 1}, {0.5, 3}, {0.25, 6}, {0.125, 4}, {0.0625, 1}};
    for (const int level : {0, 1}) {
        const std::string at = ", level " + std::to_string(level);
        check("octet truss" + at, with_octs, level, middle, directional, box_spline);
        check("octet truss, averaged" + at, with_octs, level, middle, averaged,
              {{1, 1}, {0.5, 3}, {0.25, 6}, {0.1458, 1, 5e-5}, {0.125, 1}});
        check("octet truss, as printed in 2002" + at, with_octs, level, middle, printed,
              {{1, 1}, {0.5, 3}, {0.3125, 1, 5e-5}, {0.2759, 1, 5e-5}, {0.25, 1}});
        check("lattice of tets" + at, without, level, middle_of_tets, directional, box_spline);
        check("lattice of tets, averaged" + at, without, level, middle_of_tets, averaged, box_spline);
    }

    // Two tets that share the face 0 1 2, and the vertices inside it: middles of the edges of its middle triangle.
    const std::vector<LatticePoint> points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 4}, {1, 1, -4}};
    const auto check_inside = [&](const std::string& name, const std::array<int, 4>& lower, const Sdc::Scheme& scheme,
                                  const std::vector<QuotedEigenvalue>& quoted, int n_rings = 1) {
        // Wide rows need more room before they meet the face's border.
        const bool is_wide = std::holds_alternative<Sdc::Interpolatory>(scheme) || n_rings > 1;
        const int level = is_wide ? 4 : 2, scale = 1 << level;
        const RefinedPoints refined = RefinePoints(points, {{0, 1, 2, 3}, lower}, {}, level + 1);
        for (const LatticePoint& inside : {LatticePoint{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}) {
            const LatticePoint place = {scale * inside[0], scale * inside[1], 0};
            check(name, refined, level, At(Places(refined.points[level]), place), scheme, quoted, n_rings);
        }
    };
    // The upper tet chooses the edge 01 of the face, the lower one 01, 12 or 02.
    const std::array<int, 4> matched = {1, 0, 2, 4}, unmatched = {2, 1, 0, 4}, unmatched_too = {0, 2, 1, 4};
    const std::vector<QuotedEigenvalue> broken = {{1, 1}, {0.512, 1, 5e-4}, {0.5, 2}, {0.274, 1, 5e-4}};
    const std::vector<QuotedEigenvalue> mean = {{1, 1}, {0.5, 3}, {0.25, 6}, {0.1458, 1, 5e-5}};
    check_inside("inside a matched face", matched, directional, {{1, 1}, {0.5, 3}, {0.25, 6}});
    check_inside("inside an unmatched face", unmatched, directional, broken);
    check_inside("inside another unmatched face", unmatched_too, directional, broken);
    check_inside("inside a matched face, averaged", matched, averaged, mean);
    check_inside("inside an unmatched face, averaged", unmatched, averaged, mean);

    // docs/schemes/smooth-tet.md.
    for (const int level : {0, 1}) {
        check("octet truss, smooth-tet, level " + std::to_string(level), with_octs, level, middle, Sdc::SmoothTet{},
              {{1, 1}, {0.5, 3}, {0.25, 6}, {0.125, 1}});
    }
    for (const auto& lower : {matched, unmatched}) {
        check_inside("inside a face, smooth-tet", lower, Sdc::SmoothTet{},
                     {{1, 1}, {0.5, 3}, {0.25, 6}, {0.1367, 3, 5e-5}}, 2);
    }

    // docs/schemes/interpolatory.md.
    const RefinedPoints wide = RefinePoints(truss.vertices, truss.tets, truss.octs, 3);
    const Index middle_of_wide = At(Places(wide.points[2]), Times(4, truss.vertices[middle]));
    const std::vector<QuotedEigenvalue> interpolatory = {{1, 1}, {0.5, 3}};
    check("octet truss, interpolatory", wide, 2, middle_of_wide, Sdc::Interpolatory{}, interpolatory);
    check_inside("inside a matched face, interpolatory", matched, Sdc::Interpolatory{}, interpolatory);
    check_inside("inside an unmatched face, interpolatory", unmatched, Sdc::Interpolatory{},
                 {{1, 1}, {0.698, 1, 5e-4}});
    return findings;
}

}  // namespace SolidSubdiv::Validation

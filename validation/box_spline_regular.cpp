// SPDX-License-Identifier: Apache-2.0
// Validator box-spline-regular: where the mesh is the octet truss, the scheme is the box spline N(2,2,2,2).
#include "box_spline_regular.h"

#include <cmath>
#include <map>

#include <solidsubdiv/osd/evaluator.h>

#include "refined_points.h"
#include "solid_shapes.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

constexpr int kWidth = 3;

std::string Text(const LatticePoint& p, int level) {
    return "(" + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + ")/2^" +
           std::to_string(level);
}

/// Values of every level, control values first.
std::vector<std::vector<double>> EvaluateLevels(const Far::StencilTable& cascaded, const std::vector<double>& control) {
    std::vector<std::vector<double>> values = {control};
    Osd::Evaluator evaluator(cascaded, Osd::Backend::Reference());
    for (int l = 1; l <= cascaded.n_levels(); ++l) {
        const Index n = cascaded.level(l).n_rows();
        std::vector<double> finer(kWidth * static_cast<std::size_t>(n));
        evaluator.EvaluateRange(l, Osd::BufferView<const double>(values.back(), kWidth),
                                Osd::BufferView<double>(finer, kWidth), 0, n);
        values.push_back(std::move(finer));
    }
    return values;
}

}  // namespace

RefinedBlock RefineBlock(const TrussBlock& block, int max_level) {
    RefinedPoints refined = RefinePoints(block.vertices, block.tets, block.octs, max_level);
    return {block, std::move(refined.refiner), std::move(refined.points)};
}

void CompareValues(const RefinedBlock& refined, const Far::StencilTable& cascaded, const std::vector<double>& control,
                   Findings& findings) {
    const auto values = EvaluateLevels(cascaded, control);
    const LatticeValues lattice = ValuesOnBlock(refined.block.size, kWidth, control);
    for (int l = 1; l < static_cast<int>(values.size()); ++l) {
        const std::vector<LatticePoint>& points = refined.points[l];
        if (values[l].size() != kWidth * points.size()) {
            findings.Fault("level " + std::to_string(l) + " has " + std::to_string(points.size()) +
                           " vertices, the table another number");
            return;
        }
        const ExpectedValues expected = ExpectedAtLevel(lattice, l, points);
        for (std::size_t v = 0; v < points.size(); ++v) {
            for (std::size_t i = kWidth * v; i < kWidth * (v + 1) && expected.known[v]; ++i) {
                findings.Error(std::abs(values[l][i] - expected.values[i]),
                               [&] { return "value at " + Text(points[v], l); });
            }
        }
    }
}

std::vector<Index> RegularVertices(const RefinedBlock& refined, int level) {
    const LatticeValues zeros = ValuesOnBlock(refined.block.size, 1, std::vector<double>(refined.points[0].size()));
    const ExpectedValues expected = ExpectedAtLevel(zeros, level, refined.points[level]);
    std::vector<Index> vertices;
    for (std::size_t v = 0; v < expected.known.size(); ++v) {
        if (expected.known[v]) vertices.push_back(static_cast<Index>(v));
    }
    return vertices;
}

void CompareRows(const RefinedBlock& refined, const Far::StencilRows<double>& rows, int level,
                 const std::vector<Index>& vertices, Findings& findings) {
    if (rows.n_rows() != static_cast<Index>(vertices.size())) {
        findings.Fault("level " + std::to_string(level) + ": the table has " + std::to_string(rows.n_rows()) +
                       " rows for " + std::to_string(vertices.size()) + " vertices");
        return;
    }
    std::map<Index, double> difference;
    for (Index r = 0; r < rows.n_rows(); ++r) {
        difference.clear();
        const LatticePoint& point = refined.points[level][vertices[r]];
        const auto indices = rows.Indices(r);
        for (std::size_t k = 0; k < indices.size(); ++k) difference[indices[k]] += rows.Weights(r)[k];
        for (const auto& [control, weight] : SubdivisionRow(point, level)) {
            difference[refined.block.VertexAt(control)] -= weight;
        }
        for (const auto& entry : difference) {
            findings.Error(std::abs(entry.second), [&] {
                return "row of " + Text(point, level) + ", weight of control vertex " + std::to_string(entry.first);
            });
        }
    }
}

void CompareLimitOfValues(const RefinedBlock& refined, const Far::StencilTable& cascaded,
                          const std::vector<double>& control, Findings& findings) {
    const int level = cascaded.n_levels();
    const LatticeValues coarse = ValuesOnBlock(refined.block.size, kWidth, control);
    LatticeValues fine = coarse;
    for (int l = 0; l < level; ++l) fine = Subdivide(fine);  // for its box only: the values come from the table
    const auto values = EvaluateLevels(cascaded, control);
    for (std::size_t v = 0; v < refined.points[level].size(); ++v) {
        if (!fine.Contains(refined.points[level][v])) continue;
        std::copy_n(&values[level][kWidth * v], kWidth, &fine.values[fine.Offset(refined.points[level][v])]);
    }

    constexpr int kSamples = 200;
    Shaker shaker(2);
    const double scale = 1.0 / (1 << level);
    for (int s = 0; s < kSamples; ++s) {
        Point3 x{}, coarse_x{};
        for (int i = 0; i < 3; ++i) {
            const double low = fine.lo[i] + 1, high = fine.hi[i] - 1;
            x[i] = low + (high - low) * (shaker.Next() + 1) / 2;
            coarse_x[i] = x[i] * scale;  // inside the coarse box less 1, as the fine box lies in it
        }
        const auto expected = ExpectedLimit(coarse, coarse_x), ours = ExpectedLimit(fine, x);
        for (int i = 0; i < kWidth; ++i) {
            findings.Error(std::abs(ours[i].value - expected[i].value), [&] { return "limit of refined values"; });
        }
    }
}

void CompareLimitRows(const RefinedBlock& refined, const Far::StencilTable& cascaded,
                      const Far::StencilRows<double>& limits, int level, const std::vector<double>& control,
                      Findings& findings) {
    const auto values = EvaluateLevels(cascaded, control);
    const LatticeValues lattice = ValuesOnBlock(refined.block.size, kWidth, control);
    const double scale = 1.0 / (1 << level);
    for (const Index v : RegularVertices(refined, level)) {
        const LatticePoint& p = refined.points[level][v];
        // The limit mask reaches one step further than the vertex itself.
        bool inside = true;
        for (int i = 0; i < 3; ++i) inside &= p[i] >= 1 << level && p[i] <= (refined.block.size[i] - 1) << level;
        if (!inside) continue;
        const auto expected = ExpectedLimit(lattice, {p[0] * scale, p[1] * scale, p[2] * scale});
        const auto indices = limits.Indices(v);
        if (indices.empty()) findings.Fault("no limit at " + Text(p, level));
        for (int i = 0; i < kWidth; ++i) {
            double sum = 0;
            for (std::size_t k = 0; k < indices.size(); ++k) {
                sum += limits.Weights(v)[k] * values[level][kWidth * static_cast<std::size_t>(indices[k]) + i];
            }
            findings.Error(std::abs(sum - expected[i].value), [&] { return "limit at " + Text(p, level); });
        }
    }
}

Findings ValidateBoxSplineRegular(const Context& context) {
    Findings findings;
    struct Case {
        const char* name;
        TrussCells cells;
        int axis;
    };
    constexpr Case kCases[] = {{"tets", TrussCells::Tets, 2},
                               {"octahedra along x", TrussCells::ParallelDiagonals, 0},
                               {"octahedra along y", TrussCells::ParallelDiagonals, 1},
                               {"octahedra along z", TrussCells::ParallelDiagonals, 2},
                               {"tets and octahedra of a split", TrussCells::RefinedOnce, 2}};
    const int n_levels = context.is_quick ? 2 : 3;
    for (const Case& c : kCases) {
        Findings found;
        const RefinedBlock refined = RefineBlock(MakeTrussBlock({4, 4, 4}, c.cells, c.axis), n_levels);
        Shaker shaker(1);
        std::vector<double> control(kWidth * refined.block.vertices.size());
        for (double& x : control) x = shaker.Next();

        const auto cascaded = Far::StencilTable::Create(refined.refiner, Sdc::BoxSpline{});
        CompareValues(refined, cascaded, control, found);
        CompareLimitOfValues(refined, cascaded, control, found);
        for (int l = 1; l <= n_levels; ++l) {
            const std::vector<Index> vertices = RegularVertices(refined, l);
            const auto table = Far::StencilTable::CreateComposite(refined.refiner, Sdc::BoxSpline{},
                                                                  {Far::CompositeRows{l, vertices}});
            CompareRows(refined, table.level(1), l, vertices, found);
        }
        for (int l = 0; l <= n_levels; ++l) {
            Far::LimitStencilTableOptions options;
            options.level = l;
            const auto limits = Far::LimitStencilTable::Create(refined.refiner, Sdc::BoxSpline{}, options);
            CompareLimitRows(refined, cascaded, limits.rows(), l, control, found);
        }
        findings.Merge(found, c.name);
    }
    findings.notes.push_back("five blocks of 4 x 4 x 4 unit cubes, levels 1-3; limits at vertices of levels 0-3");
    return findings;
}

}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
// What tests of far share: refiners of shapes, tables applied, schemes with every option.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <solidsubdiv/far/limit_stencil_table.h>
#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/far/topology_refiner.h>

#include "polyhedral_shapes.h"

namespace SolidSubdiv::TestFar {

inline Far::TopologyDescriptor Describe(const TestShapes::Shape& s) {
    return {.n_vertices = s.n_vertices, .tets = s.tets, .octs = s.octs, .triangles = s.triangles, .edges = s.edges};
}

inline Far::TopologyDescriptor Describe(const TestShapes::PolyhedralShape& s) {
    Far::TopologyDescriptor d{.n_vertices = s.n_vertices};
    d.hexes = s.hexes;
    d.polyhedron_offsets = s.cell_offsets;
    d.polyhedron_face_offsets = s.face_offsets;
    d.polyhedron_vertices = s.face_vertices;
    d.polygon_offsets = s.polygon_offsets;
    d.polygon_vertices = s.polygon_vertices;
    d.edges = s.edges;
    return d;
}

inline Far::TopologyRefiner Refined(const TestShapes::Shape& s, int levels, bool full = false) {
    auto refiner = Far::TopologyRefiner::Create(Describe(s), Sdc::Split::TetOct);
    refiner.RefineUniform({.max_level = levels, .full_topology_in_last_level = full});
    return refiner;
}

/// Values to try of an option: all choices, two numbers.
inline std::vector<std::string> ValuesOf(const Sdc::OptionInfo& option) {
    if (option.values == Sdc::kNumber) return {std::string(option.initial), "0.03"};
    std::vector<std::string> values;
    std::istringstream choices{std::string(option.values)};
    for (std::string value; std::getline(choices, value, '|');) values.push_back(value);
    return values;
}

/// Every scheme with every combination of options that it accepts, but for how creases fade: test shapes have none.
inline std::vector<std::pair<std::string, Sdc::Scheme>> AllSchemes(Sdc::Split split = Sdc::Split::TetOct) {
    std::vector<std::pair<std::string, Sdc::Scheme>> all;
    Sdc::ForEachScheme([&](auto scheme) {
        if (!Sdc::Takes(scheme, split)) return;
        std::vector<std::pair<std::string, decltype(scheme)>> variants{{std::string(scheme.kName), scheme}};
        for (const Sdc::OptionInfo& option : scheme.kOptions) {
            if (option.name == Sdc::kCreasingOption.name) continue;
            const auto before = variants;
            variants.clear();
            for (const std::string& value : ValuesOf(option)) {
                for (auto [name, s] : before) {
                    s.SetOption(option.name, value);
                    variants.emplace_back(name + " " + value, s);
                }
            }
        }
        for (const auto& [name, s] : variants) {
            try {
                s.Validate();
            } catch (const InvalidInput&) {
                continue;
            }
            all.emplace_back(name, s);
        }
    });
    return all;
}

inline bool IsSolid(const Sdc::Scheme& scheme) {
    return std::visit([](const auto& s) { return s.kSolids; }, scheme);
}

/// The table's last level on packed values, by the plainest loop.
inline std::vector<double> Apply(const Far::StencilTable& table, std::vector<double> values, int width = 3) {
    for (int l = 1; l <= table.n_levels(); ++l) {
        const auto& rows = table.level(l);
        std::vector<double> next(static_cast<std::size_t>(rows.n_rows()) * width, 0.0);
        for (Index i = 0; i < rows.n_rows(); ++i) {
            const auto indices = rows.Indices(i);
            const auto weights = rows.Weights(i);
            for (std::size_t k = 0; k < indices.size(); ++k) {
                for (int c = 0; c < width; ++c) next[i * width + c] += weights[k] * values[indices[k] * width + c];
            }
        }
        values = std::move(next);
    }
    return values;
}

inline void ExpectNear(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
    ASSERT_EQ(a.size(), b.size());
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    EXPECT_LE(largest, tolerance);
}

inline std::vector<double> Limits(const Far::LimitStencilTable& table, const std::vector<double>& values) {
    return Apply(Far::StencilTable::FromRows(table.rows().n_sources, {table.rows()}), values);
}

/// Limits at the vertices of levels 0 and 1 are those of the same vertices one level on. @param refiner two full levels
inline void ExpectLimitsAreFixedPoints(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                                       std::vector<double> values, double tolerance) {
    const auto table = Far::StencilTable::Create(refiner, scheme);
    for (int l = 0; l < 2; ++l) {
        const auto before = Far::LimitStencilTable::Create(refiner, scheme, {.level = l});
        const auto after = Far::LimitStencilTable::Create(refiner, scheme, {.level = l + 1});
        EXPECT_TRUE(before.without_limit().empty());
        const auto next = Apply(Far::StencilTable::FromRows(refiner.n_vertices(l), {table.level(l + 1)}), values);
        const auto a = Limits(before, values);
        auto b = Limits(after, next);
        b.resize(a.size());  // vertices come first among the children
        ExpectNear(a, b, tolerance);
        values = next;
    }
}

/// Points in an order that does not depend on their numbers; coordinates rounded to 1e-10, so that round-off can't
/// reorder.
inline std::vector<std::array<double, 3>> SortedPoints(const std::vector<double>& positions) {
    std::vector<std::array<double, 3>> points(positions.size() / 3);
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (int k = 0; k < 3; ++k) points[i][k] = std::round(positions[3 * i + k] * 1e10) / 1e10;
    }
    std::sort(points.begin(), points.end());
    return points;
}

/// A full level as a shape: its cells, free triangles and free edges.
inline TestShapes::Shape AsShape(const Far::Level& level, std::vector<double> positions) {
    TestShapes::Shape s;
    s.n_vertices = level.n_vertices;
    s.positions = std::move(positions);
    s.tets.assign(level.tet_vertices.begin(), level.tet_vertices.end());
    s.octs.assign(level.oct_vertices.begin(), level.oct_vertices.end());
    for (Index b = 0; b < level.n_boundary_faces; ++b) {
        if (level.face_tags[level.boundary_faces[b]].n_cells() > 0) continue;
        for (Index v : level.BoundaryVertices(b)) s.triangles.push_back(v);
    }
    for (Index e = 0; e < level.n_edges; ++e) {
        if (level.edge_faces.Count(e) > 0) continue;
        for (Index v : level.EdgeVertices(e)) s.edges.push_back(v);
    }
    return s;
}

}  // namespace SolidSubdiv::TestFar

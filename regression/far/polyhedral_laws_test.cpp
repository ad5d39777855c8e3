// SPDX-License-Identifier: Apache-2.0
// Laws of the schemes of the polyhedral split on cells and faces of every kind.
#include <array>
#include <map>

#include <gtest/gtest.h>
#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/sdc/parallel.h>

#include "far/far_testing.h"

namespace SolidSubdiv {
namespace {

using Far::TopologyDescriptor;
using Far::TopologyRefiner;
using TestFar::Describe;
using TestShapes::PolyhedralShape;

TEST(PolyhedralLaws, RowsSumToOneAndNameNoVertexTwice) {
    for (const auto& [name, shape] : TestShapes::PolyhedralShapes()) {
        auto refiner = TopologyRefiner::Create(Describe(shape), Sdc::Split::Polyhedral);
        refiner.RefineUniform({.max_level = 2});
        for (const auto& [scheme_name, scheme] : TestFar::AllSchemes(Sdc::Split::Polyhedral)) {
            if (!std::visit([](const auto& s) { return s.kSolids; }, scheme)) continue;
            const auto table = Far::StencilTable::Create(refiner, scheme);
            for (int l = 1; l <= 2; ++l) {
                const auto& rows = table.level(l);
                ASSERT_EQ(rows.n_rows(), refiner.n_vertices(l));
                for (Index i = 0; i < rows.n_rows(); ++i) {
                    double sum = 0;
                    std::set<Index> seen;
                    for (double w : rows.Weights(i)) sum += w;
                    for (Index v : rows.Indices(i)) EXPECT_TRUE(seen.insert(v).second) << name;
                    ASSERT_NEAR(sum, 1, 1e-14) << name << ", " << scheme_name << ", row " << i;
                }
            }
        }
    }
}

TEST(PolyhedralLaws, LinearFunctionsOfRegularBlocksAreKeptInside) {
    // Wherever a cube's neighbourhood is regular: every point is the mean that its numbering says.
    const PolyhedralShape shape = TestShapes::HexBlock(3);
    auto refiner = TopologyRefiner::Create(Describe(shape), Sdc::Split::Polyhedral);
    refiner.RefineUniform({.max_level = 1});
    std::vector<double> fine(3 * static_cast<std::size_t>(refiner.n_vertices(1))), linear = fine;
    for (const Sdc::Scheme& scheme : {Sdc::Scheme(Sdc::CatmullClarkSolid{}), Sdc::Scheme(Sdc::LinearSolid{})}) {
        auto& out = std::holds_alternative<Sdc::LinearSolid>(scheme) ? linear : fine;
        Far::PrimvarRefiner(refiner, scheme).Interpolate<double>(1, shape.positions, out, 3);
    }
    // Sharp edges and corners keep the block a block, and inside cubic B-splines reproduce linear functions.
    for (std::size_t i = 0; i < fine.size(); ++i) {
        const double x = linear[i];
        EXPECT_NEAR(fine[i], x < 0.25 || x > 2.75 || (x > 0.75 && x < 2.25) ? x : fine[i], 1e-15) << i;
        EXPECT_LE(fine[i], 3);
        EXPECT_GE(fine[i], 0);
    }
}

/// Weights of cubic B-splines at a vertex and in a middle.
std::map<int, double> Cubic(bool is_middle) {
    if (is_middle) return {{0, 0.5}, {1, 0.5}};
    return {{-1, 0.125}, {0, 0.75}, {1, 0.125}};
}

TEST(PolyhedralLaws, InsideARegularBlockRowsAreTensorProducts) {
    const PolyhedralShape shape = TestShapes::HexBlock(4);
    auto refiner = TopologyRefiner::Create(Describe(shape), Sdc::Split::Polyhedral);
    refiner.RefineUniform({.max_level = 1});
    std::vector<double> places(3 * static_cast<std::size_t>(refiner.n_vertices(1)));
    Far::PrimvarRefiner(refiner, Sdc::LinearSolid{}).Interpolate<double>(1, shape.positions, places, 3);
    int n_checked = 0;
    for (const Sdc::Scheme& scheme : {Sdc::Scheme(Sdc::CatmullClarkSolid{}), Sdc::Scheme(Sdc::Mlca{})}) {
        const auto table = Far::StencilTable::Create(refiner, scheme);
        for (Index i = 0; i < refiner.n_vertices(1); ++i) {
            const double* const p = places.data() + 3 * static_cast<std::size_t>(i);
            const auto is_inside = [&](double x) { return x > 0.75 && x < 3.25; };
            if (!is_inside(p[0]) || !is_inside(p[1]) || !is_inside(p[2])) continue;
            std::map<Index, double> expected;
            const auto weights = [&](int axis) { return Cubic(p[axis] != std::floor(p[axis])); };
            const auto base = [&](int axis) { return static_cast<int>(std::floor(p[axis])); };
            for (auto [x, wx] : weights(0)) {
                for (auto [y, wy] : weights(1)) {
                    for (auto [z, wz] : weights(2)) {
                        expected[base(0) + x + 5 * (base(1) + y + 5 * (base(2) + z))] = wx * wy * wz;
                    }
                }
            }
            const auto indices = table.level(1).Indices(i);
            const auto row = table.level(1).Weights(i);
            ASSERT_EQ(indices.size(), expected.size()) << i;
            for (std::size_t k = 0; k < row.size(); ++k) EXPECT_NEAR(row[k], expected[indices[k]], 2e-16) << i;
            ++n_checked;
        }
    }
    EXPECT_EQ(n_checked, 2 * 5 * 5 * 5);
}

/// n hexahedra around an edge, two layers; vertex 2n + 1 is in the middle.
PolyhedralShape HexesAroundEdge(int n) {
    PolyhedralShape s;
    const int layer = 2 * n + 1;
    s.n_vertices = 3 * layer;
    for (int z = 0; z < 2; ++z) {
        for (int i = 0; i < n; ++i) {
            for (int at : {layer * z, layer * (z + 1)}) {
                s.hexes.insert(s.hexes.end(), {at, at + 1 + 2 * i, at + 2 + 2 * i, at + 1 + 2 * ((i + 1) % n)});
            }
        }
    }
    return s;
}

// Hexahedra have rows of their own; as polyhedra they have the general ones.
TEST(PolyhedralLaws, HexahedraAsPolyhedraHaveTheSameRows) {
    for (PolyhedralShape shape :
         {TestShapes::HexBlock(3), TestShapes::TouchingCubes(), HexesAroundEdge(3), HexesAroundEdge(5)}) {
        PolyhedralShape general = shape;
        general.hexes.clear();
        for (std::size_t c = 0; c < shape.hexes.size(); c += 8) {
            general.AddCell(Sdc::Hex::faces, std::span<const Index, 8>(shape.hexes.data() + c, 8));
        }
        auto ours = TopologyRefiner::Create(Describe(shape), Sdc::Split::Polyhedral),
             theirs = TopologyRefiner::Create(Describe(general), Sdc::Split::Polyhedral);
        ours.RefineUniform({.max_level = 1});
        theirs.RefineUniform({.max_level = 1});
        ASSERT_GT(theirs.polyhedral_level(0).n_polyhedra(), 0);
        for (const auto& [name, scheme] : TestFar::AllSchemes(Sdc::Split::Polyhedral)) {
            if (!TestFar::IsSolid(scheme)) continue;
            const auto a = Far::StencilTable::Create(ours, scheme), b = Far::StencilTable::Create(theirs, scheme);
            ASSERT_EQ(a.level(1).n_rows(), b.level(1).n_rows());
            std::vector<double> difference(static_cast<std::size_t>(shape.n_vertices));
            for (Index row = 0; row < a.level(1).n_rows(); ++row) {
                std::fill(difference.begin(), difference.end(), 0.0);
                for (std::size_t k = 0; k < a.level(1).Indices(row).size(); ++k) {
                    difference[static_cast<std::size_t>(a.level(1).Indices(row)[k])] += a.level(1).Weights(row)[k];
                }
                for (std::size_t k = 0; k < b.level(1).Indices(row).size(); ++k) {
                    difference[static_cast<std::size_t>(b.level(1).Indices(row)[k])] -= b.level(1).Weights(row)[k];
                }
                for (double d : difference) ASSERT_NEAR(d, 0, 1e-15) << name << " " << row;
            }
        }
    }
}

TEST(PolyhedralLaws, ValuesAreThoseOfTheTables) {
    for (const auto& [name, shape] : TestShapes::PolyhedralShapes()) {
        auto refiner = TopologyRefiner::Create(Describe(shape), Sdc::Split::Polyhedral);
        refiner.RefineUniform({.max_level = 2});
        for (const auto& [scheme_name, scheme] : TestFar::AllSchemes(Sdc::Split::Polyhedral)) {
            if (!TestFar::IsSolid(scheme)) continue;
            std::vector<double> values = shape.positions;
            for (int l = 1; l <= 2; ++l) {
                std::vector<double> next(3 * static_cast<std::size_t>(refiner.n_vertices(l)));
                Far::PrimvarRefiner(refiner, scheme).Interpolate<double>(l, values, next, 3);
                values = next;
            }
            TestFar::ExpectNear(values, TestFar::Apply(Far::StencilTable::Create(refiner, scheme), shape.positions),
                                1e-14);
        }
    }
}

// What is constant along an edge stays so under mlca. Under Catmull-Clark it does not: rules.md section 4 has the
// figures.
TEST(PolyhedralLaws, ExtrudedDataStayExtrudedAlongEdgesUnderMlcaAlone) {
    const std::map<int, std::array<double, 2>> classic = {{3, {0.417, 0.575}}, {5, {0.650, 0.554}}};
    for (int n = 3; n <= 8; ++n) {
        const PolyhedralShape shape = HexesAroundEdge(n);
        auto refiner = TopologyRefiner::Create(Describe(shape), Sdc::Split::Polyhedral);
        refiner.RefineUniform({.max_level = 1});
        const Index layer = 2 * n + 1, middle = layer;
        const Index on_edge = shape.n_vertices + refiner.polyhedral_level(0).FindEdge(0, middle);
        // A spike along the edge, and noise.
        std::vector<double> spike(static_cast<std::size_t>(shape.n_vertices), 0.0), noise = spike;
        for (std::size_t v = 0; v < spike.size(); ++v) {
            const std::size_t column = v % static_cast<std::size_t>(layer);
            spike[v] = column == 0;
            noise[v] = std::sin(3.0 * static_cast<double>(column));
        }
        const auto at = [&](const Sdc::Scheme& scheme, const std::vector<double>& values, Index v) {
            std::vector<double> fine(static_cast<std::size_t>(refiner.n_vertices(1)));
            Far::PrimvarRefiner(refiner, scheme).Interpolate<double>(1, values, fine, 1);
            return fine[static_cast<std::size_t>(v)];
        };
        EXPECT_NEAR(at(Sdc::Mlca{}, noise, on_edge), at(Sdc::Mlca{}, noise, middle), 1e-15) << n;
        const double edge = at(Sdc::CatmullClarkSolid{}, spike, on_edge),
                     vertex = at(Sdc::CatmullClarkSolid{}, spike, middle);
        if (n == 4) {
            EXPECT_NEAR(edge, vertex, 1e-15);
        } else {
            EXPECT_GT(std::abs(edge - vertex), 0.05) << n;
        }
        if (const auto quoted = classic.find(n); quoted != classic.end()) {
            EXPECT_NEAR(edge, quoted->second[0], 5e-4);
            EXPECT_NEAR(vertex, quoted->second[1], 5e-4);
        }
    }
}

TEST(PolyhedralLaws, TheBoundaryOfASolidIsTheSurfaceOfItsBoundary) {
    PolyhedralShape shape = TestShapes::HexBlock(3, 3, 2, [](int x, int y, int z) { return z == 0 || x + y < 3; });
    for (double& x : shape.positions) x += 0.1 * std::sin(7 * x + 3 * static_cast<double>(&x - shape.positions.data()));
    for (const Sdc::Features features : {Sdc::Features::Smooth, Sdc::Features::Sharp}) {
        auto solid = TopologyRefiner::Create(Describe(shape), Sdc::Split::Polyhedral);
        solid.RefineUniform({.max_level = 2});
        // The boundary by itself, over the same vertices; what is in one cell of the solid is sharp.
        const Vtr::PolyhedralLevel& base = solid.polyhedral_level(0);
        PolyhedralShape boundary;
        boundary.n_vertices = shape.n_vertices;
        for (Index b = 0; b < base.n_boundary_faces; ++b) {
            const auto v = base.BoundaryVertices(b);
            boundary.polygon_vertices.insert(boundary.polygon_vertices.end(), v.begin(), v.end());
            boundary.polygon_offsets.push_back(static_cast<Offset>(boundary.polygon_vertices.size()));
        }
        std::vector<Index> creases, corners;
        if (features == Sdc::Features::Sharp) {
            for (Index e = 0; e < base.n_edges; ++e) {
                if (!base.edge_tags[e].one_cell()) continue;
                for (Index v : base.EdgeVertices(e)) creases.push_back(v);
            }
            for (Index v = 0; v < base.n_vertices; ++v) {
                if (base.vertex_tags[v].one_cell()) corners.push_back(v);
            }
        }
        const std::vector<float> edge_sharpness(creases.size() / 2, 10.0f), vertex_sharpness(corners.size(), 10.0f);
        TopologyDescriptor d = Describe(boundary);
        d.crease_edges = creases, d.crease_sharpness = edge_sharpness;
        d.corner_vertices = corners, d.corner_sharpness = vertex_sharpness;
        auto surface = TopologyRefiner::Create(d, Sdc::Split::Polyhedral);
        surface.RefineUniform({.max_level = 2});
        const auto refine = [&](const TopologyRefiner& refiner, const Sdc::Scheme& scheme) {
            std::vector<double> values = shape.positions;
            for (int l = 1; l <= 2; ++l) {
                std::vector<double> fine(3 * static_cast<std::size_t>(refiner.n_vertices(l)));
                Far::PrimvarRefiner(refiner, scheme).Interpolate<double>(l, values, fine, 3);
                values = fine;
            }
            return values;
        };
        const auto a = refine(solid, Sdc::CatmullClarkSolid{.features = features}),
                   b = refine(surface, Sdc::CatmullClark{});
        // Both list the children of boundary faces in the same order.
        const Vtr::PolyhedralLevel &fa = solid.polyhedral_level(2), &fb = surface.polyhedral_level(2);
        ASSERT_EQ(fa.n_boundary_faces, fb.n_boundary_faces);
        for (std::size_t i = 0; i < fa.boundary_vertices.size(); ++i) {
            for (int axis = 0; axis < 3; ++axis) {
                ASSERT_NEAR(a[3 * static_cast<std::size_t>(fa.boundary_vertices[i]) + static_cast<std::size_t>(axis)],
                            b[3 * static_cast<std::size_t>(fb.boundary_vertices[i]) + static_cast<std::size_t>(axis)],
                            1e-14)
                    << i;
            }
        }
    }
}

TEST(PolyhedralLaws, ComposedRowsAreTheProductsAndThreadsChangeNothing) {
    const PolyhedralShape shape = TestShapes::MixedCells();
    auto refiner = TopologyRefiner::Create(Describe(shape), Sdc::Split::Polyhedral);
    refiner.RefineUniform({.max_level = 2});
    const Sdc::Scheme scheme = Sdc::CatmullClarkSolid{};
    std::vector<double> values = shape.positions;
    for (int l = 1; l <= 2; ++l) {
        std::vector<double> fine(3 * static_cast<std::size_t>(refiner.n_vertices(l)));
        Far::PrimvarRefiner(refiner, scheme).Interpolate<double>(l, values, fine, 3);
        values = fine;
    }
    const auto composite = Far::StencilTable::CreateComposite(refiner, scheme, {{.level = 2, .vertices = {}}});
    for (Index i = 0; i < refiner.n_vertices(2); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            double sum = 0;
            for (std::size_t k = 0; k < composite.level(1).Indices(i).size(); ++k) {
                sum += composite.level(1).Weights(i)[k] *
                       shape.positions[3 * static_cast<std::size_t>(composite.level(1).Indices(i)[k]) + axis];
            }
            ASSERT_NEAR(sum, values[3 * static_cast<std::size_t>(i) + axis], 1e-14);
        }
    }
    const auto rows_with = [&](int n_threads) {
        const Sdc::ThreadLimit limit(n_threads);
        return Far::StencilTable::Create(refiner, scheme);
    };
    EXPECT_EQ(rows_with(1).level(2).weights, rows_with(4).level(2).weights);
    EXPECT_EQ(rows_with(1).level(2).indices, rows_with(4).level(2).indices);
}

TEST(PolyhedralLaws, SchemesOfTheOtherSplitAreRefused) {
    const PolyhedralShape shape = TestShapes::HexBlock(1);
    const auto polyhedral = TopologyRefiner::Create(Describe(shape), Sdc::Split::Polyhedral);
    EXPECT_THROW(Far::StencilTable::Create(polyhedral, Sdc::BoxSpline{}), InvalidInput);
    EXPECT_THROW(Far::StencilTable::Create(polyhedral, Sdc::CatmullClark{}), InvalidInput) << "cells";
    const auto tet = TestShapes::SingleTet();
    const auto tet_oct = TopologyRefiner::Create(TestFar::Describe(tet), Sdc::Split::TetOct);
    EXPECT_THROW(Far::StencilTable::Create(tet_oct, Sdc::CatmullClarkSolid{}), InvalidInput);
}

}  // namespace
}  // namespace SolidSubdiv

// SPDX-License-Identifier: Apache-2.0
// Sharp edges of targets cut into lattices of tets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solidsubdiv/apps/fit/creases.h>
#include <solidsubdiv/apps/fit/cut_creases.h>
#include <solidsubdiv/apps/fit/fit_solid.h>
#include <solidsubdiv/apps/fit/internal/vec3.h>
#include <solidsubdiv/apps/fit/start.h>
#include <solidsubdiv/far/choose_diagonals.h>
#include <solidsubdiv/kit/geometry/cell_quality.h>
#include <solidsubdiv/sdc/errors.h>

#include <algorithm>
#include <map>
#include <set>

#include "apps/fit/fit_testing.h"
#include "apps/fit/start_testing.h"
#include "sanitized.h"

namespace SolidSubdiv::Fit {
namespace {

using namespace Internal;
using testing::Each;
using Edge = std::pair<Index, Index>;

ControlMesh TetsIn(const Surface& target, double degrees, Index n_control = 120) {
    return MakeSolidStart(target.View(), {.n_control = n_control, .tets = true, .creases = degrees});
}

std::vector<Geometry::CellQuality> QualityOf(const ControlMesh& mesh) {
    return Geometry::MeasureQuality(Far::TopologyRefiner::Create(mesh.View(), Sdc::Split::TetOct), 0, mesh.positions);
}

double VolumeOf(const ControlMesh& mesh) {
    double volume = 0;
    const auto add = [&](const Index* v, std::initializer_list<std::array<int, 4>> tets) {
        for (const auto& t : tets) {
            const Vec3 a = PointAt(mesh.positions, v[t[0]]);
            const auto edge = [&](int k) { return PointAt(mesh.positions, v[t[static_cast<std::size_t>(k)]]) - a; };
            volume += Dot(Cross(edge(1), edge(2)), edge(3)) / 6;
        }
    };
    for (std::size_t i = 0; i < mesh.tets.size(); i += 4) add(&mesh.tets[i], {{0, 1, 2, 3}});
    for (std::size_t i = 0; i < mesh.octs.size(); i += 6)
        add(&mesh.octs[i], {{0, 1, 2, 4}, {0, 1, 4, 3}, {0, 1, 3, 5}, {0, 1, 5, 2}});
    return volume;
}

/// Tets with two faces on the boundary whose common edge is no crease.
int CountFlat(const ControlMesh& mesh) {
    std::set<Edge> creases;
    for (std::size_t i = 0; i < mesh.crease_edges.size(); i += 2)
        creases.insert(std::minmax({mesh.crease_edges[i], mesh.crease_edges[i + 1]}));
    const auto refiner = Far::TopologyRefiner::Create(mesh.View(), Sdc::Split::TetOct);
    std::set<std::set<Index>> faces;
    for (Index b = 0; b < refiner.level(0).n_boundary_faces; ++b) {
        const auto v = refiner.level(0).BoundaryVertices(b);
        faces.insert({v[0], v[1], v[2]});
    }
    int n = 0;
    for (std::size_t i = 0; i < mesh.tets.size(); i += 4) {
        const Index* const v = &mesh.tets[i];
        bool is_flat = false;
        for (const auto& [a, b, c, d] : {std::array{0, 1, 2, 3}, std::array{0, 2, 1, 3}, std::array{0, 3, 1, 2},
                                         std::array{1, 2, 0, 3}, std::array{1, 3, 0, 2}, std::array{2, 3, 0, 1}}) {
            is_flat = is_flat || (faces.count({v[a], v[b], v[c]}) > 0 && faces.count({v[a], v[b], v[d]}) > 0 &&
                                  creases.count(std::minmax({v[a], v[b]})) == 0);
        }
        n += is_flat;
    }
    return n;
}

TEST(CutCreases, ACubeGetsItsTwelveEdgesAndEightCorners) {
    SOLIDSUBDIV_LONG_TEST();
    for (double size : {1e-9, 1.0, 1e9}) {
        const Surface cube = Cube(6, size);
        const ControlMesh mesh = TetsIn(cube, 50);
        ASSERT_FALSE(mesh.crease_edges.empty());
        EXPECT_THAT(mesh.crease_sharpness, Each(10.f));
        double length = 0;
        std::map<Index, int> n_at;
        for (std::size_t i = 0; i < mesh.crease_edges.size(); i += 2) {
            const Index u = mesh.crease_edges[i], v = mesh.crease_edges[i + 1];
            const Vec3 a = PointAt(mesh.positions, u), b = PointAt(mesh.positions, v);
            length += Length(b - a);
            ++n_at[u], ++n_at[v];
            int n_common = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const auto is_at = [&](double x) {
                    return std::abs(a[c] - x) < 5e-3 * size && std::abs(b[c] - x) < 5e-3 * size;
                };
                n_common += is_at(0) || is_at(size);
            }
            EXPECT_EQ(n_common, 2) << i;
        }
        // A few hundredths of an edge are lost to cells that keep their shape.
        EXPECT_NEAR(length / size, 12, 0.15);
        EXPECT_EQ(std::count_if(n_at.begin(), n_at.end(), [](const auto& n) { return n.second == 3; }), 8);
        for (const auto& [v, n] : n_at) EXPECT_TRUE(n == 2 || n == 3) << v;
        // Then the boundary is the cube.
        EXPECT_NEAR(VolumeOf(mesh) / (size * size * size), 1, 1e-3);
    }
}

TEST(CutCreases, CellsStayPositiveAndNoneIsFlatOnASmoothBoundary) {
    const Surface cube = Cube(6);
    const ControlMesh before = TetsIn(cube, 0);
    ASSERT_GT(CountFlat(before), 0);
    ControlMesh after = before;
    const CutReport report = CutCreases(after, cube.View(), 50);
    EXPECT_EQ(CountFlat(after), 0);
    for (const auto& cell : QualityOf(after)) EXPECT_EQ(cell.sign, Geometry::MinimumSign::Positive);
    EXPECT_GT(report.n_creases, 0);
    EXPECT_EQ(report.n_corners, 8);
    EXPECT_EQ(report.n_added, after.n_vertices() - before.n_vertices());
    const auto components = BoundaryOf(after);
    ASSERT_EQ(components.size(), 1u);
    EXPECT_TRUE(components[0].IsManifold() && components[0].IsClosed());
    EXPECT_EQ(components[0].EulerCharacteristic(), 2);
}

TEST(CutCreases, ATargetWithoutSharpEdgesGetsNone) {
    SOLIDSUBDIV_LONG_TEST();
    const Surface ball = SphereAt({1, 2, 3}, 2);
    ControlMesh mesh = TetsIn(ball, 0);
    const double volume = VolumeOf(mesh);
    const CutReport report = CutCreases(mesh, ball.View(), 50);
    EXPECT_EQ(report.n_creases, 0);
    EXPECT_EQ(report.n_corners, 0);
    EXPECT_EQ(CountFlat(mesh), 0);
    EXPECT_NEAR(VolumeOf(mesh), volume, 1e-9 * volume);
}

TEST(CutCreases, EdgesNarrowerThanTheLatticeStillEnd) {
    // A cube with a groove: patches of a thirtieth of its side.
    const Surface plate = [] {
        Surface s = Cube(30);
        for (std::size_t i = 0; i < s.positions.size(); i += 3) {
            if (s.positions[i + 2] == 1 && std::abs(s.positions[i] - 0.5) < 1e-9) s.positions[i + 2] = 0.8;
        }
        return s;
    }();
    ASSERT_GT(SharpEdges(plate.View(), 50).size(), SharpEdges(Cube(30).View(), 50).size());
    const ControlMesh mesh = TetsIn(plate, 50);
    for (const auto& cell : QualityOf(mesh)) EXPECT_EQ(cell.sign, Geometry::MinimumSign::Positive);
}

TEST(CutCreases, WhatCantBeCutIsRefused) {
    const Surface cube = Cube(4);
    ControlMesh hexes = BulgedHexes(2);
    EXPECT_THROW(CutCreases(hexes, cube.View(), 50), InvalidInput);
    ControlMesh nothing;
    EXPECT_THROW(CutCreases(nothing, cube.View(), 50), InvalidInput);
    ControlMesh tets = BulgedTets(2);
    for (double degrees : {-1.0, 180.0, std::nan("")}) {
        EXPECT_THROW(CutCreases(tets, cube.View(), degrees), InvalidInput) << degrees;
        EXPECT_THROW(TetsIn(cube, degrees), InvalidInput) << degrees;
    }
}

TEST(CutCreases, AFitWithThemMeetsACubeAndFoldsNothing) {
    SOLIDSUBDIV_LONG_TEST();
    const Surface cube = Cube(10);
    const auto fit_with = [&](double degrees) {
        ControlMesh start = TetsIn(cube, degrees);
        Far::DiagonalChoice choice = Far::ChooseDiagonals(start.View(), Far::DiagonalPolicy::Matched);
        start.tets = std::move(choice.tets);
        start.octs = std::move(choice.octs);
        return FitSolid(start, Sdc::BoxSpline{}, cube.View(), {});
    };
    const SolidFit sharp = fit_with(50), round = fit_with(0);
    EXPECT_EQ(sharp.n_folded, 0);
    EXPECT_LT(sharp.result.from_target.most, 0.5 * round.result.from_target.most);
    EXPECT_LT(sharp.result.from_target.rms, 0.3 * round.result.from_target.rms);
    EXPECT_LT(sharp.result.to_target.rms, 0.3 * round.result.to_target.rms);
}

}  // namespace
}  // namespace SolidSubdiv::Fit

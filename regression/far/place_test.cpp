// SPDX-License-Identifier: Apache-2.0
// Places: weights sum to one, corners and centroids are where place.h says, affine maps, refusals.
#include <random>

#include <solidsubdiv/far/place.h>

#include "far_testing.h"

namespace SolidSubdiv::TestFar {
namespace {

using Far::Elements;
using Far::Place;

std::array<double, 3> PointAt(const Far::TopologyRefiner& refiner, const std::vector<double>& positions,
                              const Place& place, Elements elements = Elements::Cells) {
    const auto rows = Far::MakePlaceRows(refiner, 0, {&place, 1}, elements);
    std::array<double, 3> point{};
    double sum = 0;
    for (std::size_t k = 0; k < rows.Indices(0).size(); ++k) {
        sum += rows.Weights(0)[k];
        for (std::size_t c = 0; c < 3; ++c) {
            point[c] += rows.Weights(0)[k] * positions[3 * static_cast<std::size_t>(rows.Indices(0)[k]) + c];
        }
    }
    EXPECT_NEAR(sum, 1, 1e-15);
    return point;
}

void ExpectPoint(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 1e-15);
}

TEST(Place, Cells_HaveTheirVerticesWherePlaceSays) {
    const std::vector<double> unit{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const std::vector<Index> tet{0, 1, 2, 3};
    Far::TopologyDescriptor mesh{.n_vertices = 4, .tets = tet};
    ExpectPoint(PointAt(Far::TopologyRefiner::Create(mesh, Sdc::Split::TetOct), unit, {0, 0, {.2, .3, .1}}),
                {.2, .3, .1});

    const std::vector<double> axes{1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
    const std::vector<Index> oct{0, 1, 2, 3, 4, 5};
    mesh = {.n_vertices = 6, .octs = oct};
    const auto octs = Far::TopologyRefiner::Create(mesh, Sdc::Split::TetOct);
    for (const std::array<double, 3> at : {std::array{.2, .3, .1}, {-.2, .3, -.4}, {.1, -.7, .2}, {-.3, -.2, -.5}}) {
        ExpectPoint(PointAt(octs, axes, {0, 0, at}), at);
    }

    const std::vector<double> cube{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
    const std::vector<Index> hex{0, 1, 2, 3, 4, 5, 6, 7};
    mesh = {.n_vertices = 8};
    mesh.hexes = hex;
    const auto hexes = Far::TopologyRefiner::Create(mesh, Sdc::Split::Polyhedral);
    ExpectPoint(PointAt(hexes, cube, {0, 0, {.2, .3, .9}}), {.2, .3, .9});
    // Its face z = 0, listed 0 3 2 1.
    ExpectPoint(PointAt(hexes, cube, {0, 0, {.25, .5, 0}}, Elements::BoundaryFaces), {.5, .25, 0});

    const std::vector<double> pyramid{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, .5, .5, 1};
    const std::vector<Index> cell{0, 1, 2, 3, 4};
    mesh = {.n_vertices = 5};
    mesh.pyramids = cell;
    const auto pyramids = Far::TopologyRefiner::Create(mesh, Sdc::Split::Polyhedral);
    // The first face is the base 0 3 2 1.
    ExpectPoint(PointAt(pyramids, pyramid, {0, 0, {0, 0, 0}}), {.5, .5, .2});
    ExpectPoint(PointAt(pyramids, pyramid, {0, 1, {1, 0, 0}}), {.5, .5, 0});
    ExpectPoint(PointAt(pyramids, pyramid, {0, 1, {0, 1, 0}}), {0, 1, 0});
    ExpectPoint(PointAt(pyramids, pyramid, {0, 1, {0, 0, 1}}), {1, 1, 0});
}

TEST(Place, WhatIsNotThere_IsRefusedByName) {
    const std::vector<Index> tet{0, 1, 2, 3};
    const Far::TopologyDescriptor mesh{.n_vertices = 4, .tets = tet};
    const auto refiner = Far::TopologyRefiner::Create(mesh, Sdc::Split::TetOct);
    const auto message = [&](const Place& place, int level = 0, Elements elements = Elements::Cells) -> std::string {
        try {
            Far::MakePlaceRows(refiner, level, {&place, 1}, elements);
        } catch (const InvalidInput& e) {
            return e.what();
        }
        return "taken";
    };
    EXPECT_EQ(message({1}), "place 0: there is no cell 1 in level 0");
    EXPECT_EQ(message({4}, 0, Elements::BoundaryFaces), "place 0: there is no boundary face 4 in level 0");
    EXPECT_EQ(message({0, 1}), "place 0: cell 0 has 1 parts, no part 1");
    EXPECT_EQ(message({0, 0, {NAN, 0, 0}}), "place 0: a coordinate is not finite");
    EXPECT_EQ(message({0}, 1), "places of level 1: the refiner's last is 0");
    EXPECT_EQ(message({0}), "taken");
}

}  // namespace
}  // namespace SolidSubdiv::TestFar

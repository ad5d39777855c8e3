// SPDX-License-Identifier: Apache-2.0
// Laws of lattices of tets and octahedra cut from bricks: they fill the same space, and are the octet truss inside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/apps/deform/octree_lattices.h>
#include <solidsubdiv/apps/deform/tet_lattice.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/geometry/cell_quality.h>
#include <solidsubdiv/kit/geometry/cell_volume.h>
#include <solidsubdiv/kit/geometry/valence.h>

#include <numeric>
#include <set>

#include "apps/deform/octree_testing.h"

namespace SolidSubdiv::Deform {
namespace {

using Place = std::array<Index, 3>;

/// Levels of lattices around models: full ones, cut ones, ones that touch in edges and vertices.
std::vector<std::pair<std::string, LatticeLevel>> Levels() {
    std::vector<std::pair<std::string, LatticeLevel>> levels;
    for (const Model& model : Models()) {
        for (Cut cut : {Cut::None, Cut::Vertices, Cut::Triangles, Cut::Outside}) {
            const auto h = MakeOctreeLattices(model.points, model.triangles,
                                              {.box = Geometry::BoxKind::Oriented, .levels = 3, .cut = cut});
            for (const LatticeLevel& level : h.levels) levels.emplace_back(model.name, level);
        }
    }
    return levels;
}

Far::TopologyRefiner TetRefiner(const ControlLattice& lattice) {
    return Far::TopologyRefiner::Create(lattice.View(), Sdc::Split::TetOct);
}

double Sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.); }

TEST(TetLattice, CellsArePositiveAndFillWhatTheBricksFill) {
    for (const auto& [name, level] : Levels()) {
        const TetLattice tets = MakeTetLattice(level.lattice, level.cells);
        const auto refiner = TetRefiner(tets.lattice);  // no fatal defect
        for (const auto& q : Geometry::MeasureQuality(refiner, 0, tets.lattice.positions)) {
            EXPECT_EQ(q.sign, Geometry::MinimumSign::Positive) << name;
        }
        const auto volumes = Geometry::CellVolumes(tets.lattice.View(), tets.lattice.positions);
        const double expected = Sum(Geometry::CellVolumes(level.lattice.View(), level.lattice.positions));
        EXPECT_NEAR(Sum(volumes) / expected, 1, 1e-6) << name;  // coordinates are up to 1e6 times the size
        for (const auto& defect : refiner.defects()) {
            EXPECT_NE(defect.code, Far::DefectCode::InvertedCell) << name;
            EXPECT_NE(defect.code, Far::DefectCode::IsolatedVertex) << name;
        }
    }
}

TEST(TetLattice, TheBoundaryIsTheBricksCutAlongEvenDiagonals) {
    for (const auto& [name, level] : Levels()) {
        const TetLattice tets = MakeTetLattice(level.lattice, level.cells);
        std::vector<Place> places(static_cast<std::size_t>(level.lattice.n_control_points()));
        constexpr Index kCorners[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                          {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
        for (std::size_t c = 0; c < level.cells.size(); ++c) {
            for (std::size_t j = 0; j < 8; ++j) {
                for (std::size_t k = 0; k < 3; ++k) {
                    places[static_cast<std::size_t>(level.lattice.hexes[8 * c + j])][k] =
                        level.cells[c][k] + kCorners[j][k];
                }
            }
        }
        const auto first_lowest = [](std::array<Index, 3> t) {  // the same way round
            std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
            return t;
        };
        std::set<std::array<Index, 3>> expected, found;
        const auto bricks = RefinerOf(level.lattice);
        const auto& faces = bricks.polyhedral_level(0);
        for (Index b = 0; b < faces.n_boundary_faces; ++b) {
            const auto v = faces.BoundaryVertices(b);
            const Place& p = places[static_cast<std::size_t>(v[0])];
            const std::size_t even = (p[0] + p[1] + p[2]) % 2 == 0 ? 0 : 1;
            expected.insert(first_lowest({v[even], v[even + 1], v[even + 2]}));
            expected.insert(first_lowest({v[even + 2], v[(even + 3) % 4], v[even]}));
        }
        const auto refiner = TetRefiner(tets.lattice);
        for (Index b = 0; b < refiner.level(0).n_boundary_faces; ++b) {
            std::array<Index, 3> t;
            for (std::size_t k = 0; k < 3; ++k) {
                t[k] = tets.control_points[static_cast<std::size_t>(refiner.level(0).BoundaryVertices(b)[k])];
            }
            found.insert(first_lowest(t));
        }
        EXPECT_EQ(found, expected) << name;
    }
}

TEST(TetLattice, PositionsAndParentsAreThoseOfTheBricks) {
    const auto h = MakeOctreeLattices(Torus(24).points, {}, {.levels = 3});
    const LatticeLevel& level = h.levels[3];
    const TetLattice tets = MakeTetLattice(level.lattice, level.cells);
    for (std::size_t v = 0; v < tets.control_points.size(); ++v) {
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_EQ(tets.lattice.positions[3 * v + k],
                      level.lattice.positions[3 * static_cast<std::size_t>(tets.control_points[v]) + k]);
        }
    }
    ASSERT_EQ(tets.parents.size(), tets.lattice.tets.size() / 4);
    for (std::size_t t = 0; t < tets.parents.size(); ++t) {
        const auto first = level.lattice.hexes.begin() + 8 * std::ptrdiff_t{tets.parents[t]};
        for (std::size_t k = 0; k < 4; ++k) {
            const Index v = tets.control_points[static_cast<std::size_t>(tets.lattice.tets[4 * t + k])];
            EXPECT_NE(std::find(first, first + 8, v), first + 8);
        }
    }
    // Points go where there are centres, and nowhere else.
    EXPECT_EQ(tets.control_points.size() + tets.centres.size(),
              static_cast<std::size_t>(level.lattice.n_control_points()));
}

TEST(TetLattice, InsideItIsTheOctetTruss) {
    const auto h = MakeOctreeLattices(Torus(4).points, {}, {.levels = 3, .cut = Cut::None});
    const LatticeLevel& level = h.levels[3];
    const TetLattice tets = MakeTetLattice(level.lattice, level.cells);
    const auto refiner = TetRefiner(tets.lattice);
    const auto& complex = refiner.level(0);
    // Deep are control points two cells or more from the faces of the box: all odd corners beside them are centres.
    const auto is_deep = [&](Index v) {
        const auto t =
            h.box.CoordinatesOf(std::span(tets.lattice.positions).subspan(3 * static_cast<std::size_t>(v)).first<3>());
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = t[k] / h.box.lengths[k] * 8;
            if (x < 1.5 || x > 6.5) return false;
        }
        return true;
    };
    Index n_deep = 0;
    for (Index e = 0; e < complex.n_edges; ++e) {
        const auto ends = complex.EdgeVertices(e);
        if (!is_deep(ends[0]) || !is_deep(ends[1])) continue;
        ++n_deep;
        const auto octs = complex.edge_octs[e];
        EXPECT_EQ(octs.size(), 2u);  // two octahedra and two tets in turn
        EXPECT_EQ(complex.edge_faces[e].size(), 4u);
        // In the tetrahedral view 4 cells around edges across z, 6 around the others.
        int link = 2;
        for (Sdc::Local local : complex.edge_octs.Locals(e)) link += local < Sdc::Oct::kDiagonalEdges ? 2 : 1;
        const double* p = &tets.lattice.positions[3 * static_cast<std::size_t>(ends[0])];
        const double* q = &tets.lattice.positions[3 * static_cast<std::size_t>(ends[1])];
        EXPECT_EQ(link, std::abs(p[2] - q[2]) < 1e-9 ? 4 : 6);
    }
    EXPECT_GT(n_deep, 100);
    for (Index v = 0; v < complex.n_vertices; ++v) {
        if (!is_deep(v)) continue;
        EXPECT_EQ(complex.vertex_edges[v].size(), 12u);
        EXPECT_EQ(complex.vertex_octs[v].size(), 6u);
    }
}

TEST(TetLattice, NeighboursAgreeOnTheDiagonalsOfAllFaces) {
    // A tet's pair in use has one edge of each of its faces, an octahedron's cut around its major diagonal as well:
    // where all agree the refined lattice is regular across the face.
    for (const auto& [name, level] : Levels()) {
        const TetLattice tets = MakeTetLattice(level.lattice, level.cells);
        const auto refiner = TetRefiner(tets.lattice);
        const auto& complex = refiner.level(0);
        std::vector<std::set<Index>> chosen(static_cast<std::size_t>(complex.n_faces));
        for (Index t = 0; t < complex.n_tets; ++t) {
            for (Index f : complex.TetFaces(t)) {
                for (std::size_t local : {0, 5}) {
                    const Index e = complex.TetEdges(t)[local];
                    const auto edges = complex.FaceEdges(f);
                    if (std::find(edges.begin(), edges.end(), e) != edges.end())
                        chosen[static_cast<std::size_t>(f)].insert(e);
                }
            }
        }
        for (Index o = 0; o < complex.n_octs; ++o) {
            for (Index f : complex.OctFaces(o)) {
                for (std::size_t local = Sdc::Oct::kDiagonalEdges; local < Sdc::Oct::kEdges; ++local) {
                    const Index e = complex.OctEdges(o)[local];
                    const auto edges = complex.FaceEdges(f);
                    if (std::find(edges.begin(), edges.end(), e) != edges.end())
                        chosen[static_cast<std::size_t>(f)].insert(e);
                }
            }
        }
        for (const auto& edges : chosen) EXPECT_EQ(edges.size(), 1u) << name;
    }
}

TEST(TetLattice, PlantedFaultsAreFoundByTheLawsAbove) {
    // Two bricks cut one by one; the second as if it were one place farther: the shared face is cut along both
    // diagonals.
    const auto h = MakeOctreeLattices(Torus(4).points, {}, {.levels = 1, .cut = Cut::None});
    const LatticeLevel& level = h.levels[1];
    for (Index shift : {0, 1}) {
        ControlLattice both;
        both.positions = level.lattice.positions;
        for (std::size_t c = 0; c < 2; ++c) {
            ControlLattice brick;
            brick.positions = level.lattice.positions;
            const auto first = level.lattice.hexes.begin() + 8 * static_cast<std::ptrdiff_t>(c);
            brick.hexes.assign(first, first + 8);
            Place place = level.cells[c];
            place[1] += c == 1 ? shift : 0;
            const TetLattice tets = MakeTetLattice(brick, {&place, 1});
            for (Index v : tets.lattice.tets) both.tets.push_back(tets.control_points[static_cast<std::size_t>(v)]);
        }
        EXPECT_EQ(TetRefiner(both).level(0).n_boundary_faces, 20 + 4 * shift);  // 10 faces of bricks, cut in two
        std::swap(both.tets[2], both.tets[3]);
        const auto refiner = TetRefiner(both);
        EXPECT_EQ(Geometry::MeasureQuality(refiner, 0, both.positions)[0].sign, Geometry::MinimumSign::Negative);
    }
}

TEST(TetLattice, PlacesThatDoNotFitAreNamed) {
    const auto h = MakeOctreeLattices(Torus(4).points, {}, {.levels = 1, .cut = Cut::None});
    const LatticeLevel& level = h.levels[1];
    const auto message = [&](const ControlLattice& lattice, const std::vector<Place>& cells) -> std::string {
        try {
            MakeTetLattice(lattice, cells);
        } catch (const InvalidInput& e) {
            return e.what();
        }
        return {};
    };
    using testing::HasSubstr;
    EXPECT_THAT(message(level.lattice, {}), HasSubstr("8 cells, 8 of them hexahedra, and 0 places"));
    auto cells = level.cells;
    cells[3][0] += 1;
    EXPECT_THAT(message(level.lattice, cells), HasSubstr("at two places"));
    ControlLattice twice = level.lattice;
    twice.hexes.insert(twice.hexes.end(), twice.hexes.begin(), twice.hexes.begin() + 8);
    cells = level.cells;
    cells.push_back(cells[0]);
    EXPECT_THAT(message(twice, cells), HasSubstr("cell 8 is where another cell is"));
    ControlLattice bad = level.lattice;
    bad.hexes[5] = 99;
    EXPECT_THAT(message(bad, level.cells), HasSubstr("cell 0 has the corner 99"));
    ControlLattice mixed = level.lattice;
    mixed.tets = {0, 1, 3, 9};
    EXPECT_THAT(message(mixed, level.cells), HasSubstr("9 cells"));
}

}  // namespace
}  // namespace SolidSubdiv::Deform

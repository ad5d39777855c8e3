// SPDX-License-Identifier: Apache-2.0
// The polyhedral split by the public API: every kind of element is taken, what is wrong is named.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solidsubdiv/far/topology_refiner.h>

namespace SolidSubdiv {
namespace {

using Far::TopologyDescriptor;
using Far::TopologyRefiner;
using testing::HasSubstr;

std::string Refusal(const TopologyDescriptor& d) {
    try {
        TopologyRefiner::Create(d, Sdc::Split::Polyhedral);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "";
}

TEST(PolyhedralRefiner, TakesEveryKindOfElement) {
    const std::vector<Index> tets{8, 9, 10, 11}, octs{12, 13, 14, 15, 16, 17}, hexes{0, 1, 2, 3, 4, 5, 6, 7},
        wedges{18, 19, 20, 21, 22, 23}, pyramids{24, 25, 26, 27, 28},
        cube{0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
    std::vector<Index> polyhedron = cube;
    for (Index& v : polyhedron) v += 29;
    const std::vector<Offset> polyhedron_offsets{0, 6}, face_offsets{0, 4, 8, 12, 16, 20, 24}, polygon_offsets{0, 5};
    const std::vector<Index> triangles{37, 38, 39}, quads{37, 38, 40, 41}, polygons{38, 39, 42, 43, 44}, edges{44, 45};
    TopologyDescriptor d{.n_vertices = 46};
    d.tets = tets, d.octs = octs, d.hexes = hexes, d.wedges = wedges, d.pyramids = pyramids;
    d.polyhedron_offsets = polyhedron_offsets, d.polyhedron_face_offsets = face_offsets;
    d.polyhedron_vertices = polyhedron;
    d.triangles = triangles, d.quads = quads, d.polygon_offsets = polygon_offsets, d.polygon_vertices = polygons;
    d.edges = edges;

    TopologyRefiner refiner = TopologyRefiner::Create(d, Sdc::Split::Polyhedral);
    EXPECT_TRUE(refiner.is_polyhedral());
    const Vtr::PolyhedralLevel& base = refiner.polyhedral_level(0);
    EXPECT_EQ(base.n_hexes, 1);
    EXPECT_EQ(base.n_polyhedra(), 5);
    EXPECT_EQ(base.CellVertices(1).size(), 4u);
    EXPECT_EQ(base.CellVertices(2).size(), 6u);
    EXPECT_EQ(base.CellVertices(3).size(), 6u);
    EXPECT_EQ(base.CellFaces(3).size(), 5u);
    EXPECT_EQ(base.CellVertices(4).size(), 5u);
    EXPECT_EQ(base.CellVertices(5).size(), 8u);
    EXPECT_EQ(base.n_boundary_faces, 6 + 4 + 8 + 5 + 5 + 6 + 3);
    refiner.RefineUniform({.max_level = 2});
    EXPECT_EQ(refiner.max_level(), 2);
    // Hexahedra: 8 of the cube, 4 of the tet, 6 of the wedge, 4 of the pyramid, 8 of the polyhedron; the pyramid's apex
    // and the octahedron's corners keep four edges each.
    EXPECT_EQ(refiner.PolyhedralCountsAt(1).n_hexes, 8 + 4 + 6 + 4 + 8);
    EXPECT_EQ(refiner.PolyhedralCountsAt(1).n_polyhedra, 7);
    EXPECT_EQ(refiner.polyhedral_level(2).n_hexes, refiner.PolyhedralCountsAt(2).n_hexes);
    EXPECT_EQ(refiner.n_vertices(2), refiner.PolyhedralCountsAt(2).n_vertices);
    EXPECT_GT(refiner.Bytes(), 0);
}

TEST(PolyhedralRefiner, NamesWhatIsWrong) {
    const std::vector<Index> hex{0, 1, 2, 3, 4, 5, 6, 7}, short_row{0, 1, 2}, far{0, 1, 2, 3, 4, 5, 6, 8},
        twice{0, 1, 2, 3, 4, 5, 6, 6}, wedges{0, 1, 2, 3, 4, 5, 0, 2, 1, 3, 5, 4};
    EXPECT_THAT(Refusal({.n_vertices = 8, .hexes = short_row}),
                HasSubstr("hexahedron: 3 indices are no multiple of 8"));
    EXPECT_THAT(Refusal({.n_vertices = 8, .hexes = far}), HasSubstr("hexahedron 0 names vertex 8"));
    EXPECT_THAT(Refusal({.n_vertices = 8, .hexes = twice}), HasSubstr("names vertex 6 twice"));
    EXPECT_THAT(Refusal({.n_vertices = 6, .wedges = wedges}),
                HasSubstr("wedge 1 has the same vertices as another cell"));

    // A polyhedron without its last face, and offsets that lead nowhere.
    const std::vector<Offset> one_cell{0, 3}, faces{0, 3, 6, 9}, bad{0, 2}, two{0, 2, 5, 9};
    const std::vector<Index> three_sides{0, 2, 1, 0, 3, 1, 2, 3, 0};
    TopologyDescriptor d{.n_vertices = 4};
    d.polyhedron_offsets = one_cell, d.polyhedron_face_offsets = faces, d.polyhedron_vertices = three_sides;
    EXPECT_THAT(Refusal(d), HasSubstr("polyhedron 0: its faces do not close"));
    d.polyhedron_offsets = bad;
    EXPECT_THAT(Refusal(d), HasSubstr("polyhedra: offsets do not ascend from 0 to 3"));
    d.polyhedron_offsets = one_cell, d.polyhedron_face_offsets = two;
    EXPECT_THAT(Refusal(d), HasSubstr("face of polyhedra 0 has 2 vertices"));

    const std::vector<Index> quads{0, 1, 2, 3, 0, 2, 1, 3};
    EXPECT_THAT(Refusal({.n_vertices = 4, .quads = quads}), HasSubstr("vertices in another order"));
    const std::vector<Index> same{0, 1, 2, 3, 3, 2, 1, 0};
    EXPECT_THAT(Refusal({.n_vertices = 4, .quads = same}), HasSubstr("quad 1 has the same vertices as an earlier one"));
}

TEST(PolyhedralRefiner, RefusesSizesThatDoNotFitBeforeAnyWork) {
    const std::vector<Index> hex{0, 1, 2, 3, 4, 5, 6, 7};
    TopologyRefiner refiner = TopologyRefiner::Create({.n_vertices = 8, .hexes = hex}, Sdc::Split::Polyhedral);
    const auto refusal = [&](const Far::UniformRefinementOptions& options) -> std::string {
        try {
            refiner.RefineUniform(options);
        } catch (const InvalidInput& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_THAT(refusal({.max_level = 12}), HasSubstr("more than the 2147483647 that indices count"));
    EXPECT_THAT(refusal({.max_level = 3, .max_bytes = 1000}), HasSubstr("refine fewer times"));
    EXPECT_EQ(refiner.max_level(), 0);
}

TEST(PolyhedralRefiner, SurfacesOrientedAgainstEachOtherAreNamedByTheirEdge) {
    const std::vector<Index> alike{0, 1, 4, 3, 1, 2, 5, 4}, against{0, 1, 4, 3, 1, 4, 5, 2};
    TopologyDescriptor d{.n_vertices = 6};
    d.quads = alike;
    EXPECT_TRUE(TopologyRefiner::Create(d, Sdc::Split::Polyhedral).defects().empty());
    d.quads = against;
    const auto defects = TopologyRefiner::Create(d, Sdc::Split::Polyhedral).defects();
    ASSERT_EQ(defects.size(), 1U);
    EXPECT_EQ(defects[0].code, Far::DefectCode::InvertedCell);
    EXPECT_EQ(defects[0].text, "the faces on the two sides of edge (1 4) are oriented against each other");
}

TEST(PolyhedralRefiner, ValidateListsDefectsOfAnyCells) {
    const std::vector<Index> hexes{0, 1, 2, 3, 4, 5, 6, 7, 4, 5, 6, 7, 8, 9, 10, 11};
    std::vector<Index> turned = hexes;
    for (int i = 0; i < 4; ++i) std::swap(turned[8 + i], turned[12 + i]);
    EXPECT_TRUE(Far::Validate({.n_vertices = 12, .hexes = hexes}).empty());
    const auto defects = Far::Validate({.n_vertices = 13, .hexes = turned});
    ASSERT_EQ(defects.size(), 2u);
    EXPECT_EQ(defects[0].code, Far::DefectCode::InvertedCell);
    EXPECT_EQ(defects[1].code, Far::DefectCode::IsolatedVertex);
}

}  // namespace
}  // namespace SolidSubdiv

// SPDX-License-Identifier: Apache-2.0
// Octahedra in files: which polyhedra they are, in which order and orientation they come, how they are cut.
#include <algorithm>
#include <random>

#include <solidsubdiv/kit/io/internal/octahedra.h>

#include "kit/io/support.h"

namespace SolidSubdiv::Io {
namespace {

using Oct = std::array<Index, 6>;
using Point = std::array<double, 3>;

// A positive octahedron around the origin: det(v0, v2, v4) = -1.
const std::vector<double> kPositions = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, -1, 0, 0, 1};

Point At(Index v) {
    const auto at = 3 * static_cast<std::size_t>(v);
    return {kPositions[at], kPositions[at + 1], kPositions[at + 2]};
}
Point Minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double Det(const Point& a, const Point& b, const Point& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}
double TetVolume(Index a, Index b, Index c, Index d) {
    return Det(Minus(At(b), At(a)), Minus(At(c), At(a)), Minus(At(d), At(a))) / 6;
}

std::vector<Index> Flat(const std::array<std::array<Index, 3>, 8>& faces) {
    std::vector<Index> flat;
    for (const auto& face : faces) flat.insert(flat.end(), face.begin(), face.end());
    return flat;
}

TEST(Octahedron, FacesOfAPositiveOneTurnOutward) {
    const Oct oct = {0, 1, 2, 3, 4, 5};
    for (const auto& f : Internal::OctahedronFaces(oct)) {
        EXPECT_GT(Det(At(f[0]), At(f[1]), At(f[2])), 0) << f[0] << f[1] << f[2];  // the origin is inside
    }
}

TEST(Octahedron, RecognizedFromShuffledTurnedFacesInListedOrder) {
    std::mt19937 random(7);
    std::array<std::array<Index, 3>, 8> faces = Internal::OctahedronFaces(Oct{0, 1, 2, 3, 4, 5});
    std::vector<Index> listed = {0, 1, 2, 3, 4, 5};
    for (int trial = 0; trial < 1000; ++trial) {
        std::shuffle(faces.begin(), faces.end(), random);
        for (auto& face : faces) std::rotate(face.begin(), face.begin() + random() % 3, face.end());
        std::shuffle(listed.begin(), listed.end(), random);

        Oct oct;
        ASSERT_TRUE(Internal::RecognizeOctahedron(listed, Flat(faces), oct));
        EXPECT_EQ(oct[0], listed[0]);
        const auto later = [&](Index v) { return std::find(listed.begin(), listed.end(), v); };
        for (int pair = 0; pair < 3; ++pair) {
            EXPECT_EQ(oct[2 * pair] / 2, oct[2 * pair + 1] / 2) << "opposite vertices";
            // The last pair may be turned, for the orientation.
            if (pair < 2) {
                EXPECT_LT(later(oct[2 * pair]), later(oct[2 * pair + 1])) << "the first listed one first";
            }
        }
        EXPECT_LT(later(oct[2]), std::min(later(oct[4]), later(oct[5]))) << "pairs in the order of appearance";
        EXPECT_EQ(Det(At(oct[0]), At(oct[2]), At(oct[4])), -1) << "positive";
    }
}

TEST(Octahedron, FacesSeenFromInsideMakeANegativeOne) {
    std::array<std::array<Index, 3>, 8> faces = Internal::OctahedronFaces(Oct{0, 1, 2, 3, 4, 5});
    for (auto& face : faces) std::swap(face[0], face[1]);
    Oct oct;
    ASSERT_TRUE(Internal::RecognizeOctahedron({}, Flat(faces), oct));
    EXPECT_EQ(Det(At(oct[0]), At(oct[2]), At(oct[4])), 1);
}

TEST(Octahedron, OrderOfItsOwnFacesGivesItBackWithoutAList) {
    Oct oct;
    ASSERT_TRUE(Internal::RecognizeOctahedron({}, Flat(Internal::OctahedronFaces(Oct{5, 3, 8, 1, 0, 2})), oct));
    EXPECT_EQ(oct, (Oct{5, 3, 8, 1, 0, 2}));
}

TEST(Octahedron, OtherPolyhedraOfSixVerticesAndEightTrianglesAreNone) {
    // Two tetrahedra glued on two faces of a third: vertices 0 and 5 have valence 3.
    const std::vector<Index> stacked = {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 4, 1, 4, 2, 5, 3, 2, 5, 2, 4, 5, 4, 3};
    Oct oct;
    EXPECT_FALSE(Internal::RecognizeOctahedron({}, stacked, oct));

    std::vector<Index> doubled = Flat(Internal::OctahedronFaces(Oct{0, 1, 2, 3, 4, 5}));
    std::copy_n(doubled.begin(), 3, doubled.begin() + 21);  // one face twice, one missing
    EXPECT_FALSE(Internal::RecognizeOctahedron({}, doubled, oct));

    // Four vertices whose only opposite is the same fifth: more than three pairs, if one counts before it is asked.
    const std::vector<Index> one_for_all = {0, 1, 2, 0, 3, 4, 1, 3, 4, 2, 3, 4, 0, 1, 2, 0, 1, 2, 0, 1, 2, 4, 5, 4};
    EXPECT_FALSE(Internal::RecognizeOctahedron({}, one_for_all, oct));
}

TEST(Octahedron, CutIntoFourPositiveTetsAroundTheMajorDiagonal) {
    Mesh mesh;
    mesh.topology.n_vertices = 6;
    mesh.topology.tets = {0, 2, 5, 1};
    mesh.topology.octs = {0, 1, 2, 3, 4, 5};
    mesh.topology.edges = {0, 1};
    mesh.positions = kPositions;
    mesh.cell_data = {{"pair", 2, {1, 2, 3, 4, 5, 6}}};
    const Mesh cut = Internal::CutOctahedra(mesh);
    EXPECT_EQ(cut.topology.octs.size(), 0u);
    ASSERT_EQ(cut.topology.tets.size(), 20u);
    double volume = 0;
    for (std::size_t at = 4; at < 20; at += 4) {
        const Index* v = cut.topology.tets.data() + at;
        EXPECT_EQ(v[0], 0);
        EXPECT_EQ(v[1], 1);
        EXPECT_GT(TetVolume(v[0], v[1], v[2], v[3]), 0);
        volume += TetVolume(v[0], v[1], v[2], v[3]);
    }
    EXPECT_DOUBLE_EQ(volume, 4.0 / 3);  // of the regular octahedron of radius 1
    EXPECT_THAT(cut.cell_data[0].values, testing::ElementsAre(1, 2, 3, 4, 3, 4, 3, 4, 3, 4, 5, 6));
}

TEST(Octahedron, WithoutKeepOctahedraEveryFormatGetsTheTets) {
    TemporaryFolder folder;
    const Mesh mesh = MeshOf("to");
    const Mesh cut = Internal::CutOctahedra(mesh);
    for (const char* name : {"a.vtu", "a.vtk", "a.msh", "a.ele"}) {
        SCOPED_TRACE(name);
        WriteMesh(folder / name, mesh);
        ExpectSameMesh(ReadMesh(folder / name), cut);
    }
}

TEST(Octahedron, FormatsWithoutPolyhedraCutEvenIfAskedToKeep) {
    TemporaryFolder folder;
    const Mesh mesh = MeshOf("to");
    for (const char* name : {"a.msh", "a.ele"}) {
        WriteMesh(folder / name, mesh, {.keep_octahedra = true});
        EXPECT_EQ(ReadMesh(folder / name).topology.n_tets(), 11) << name;
    }
}

TEST(Octahedron, DiagonalOfTheFileStaysInTheCellData) {
    const Mesh mesh = ReadMesh(Corpus("hand_new_polyhedra.vtu"));
    EXPECT_EQ(mesh.topology.octs, (std::vector<Index>{0, 1, 2, 3, 4, 5}));
    // The file has oct, tet, polyhedron; the mesh tets first.
    EXPECT_THAT(mesh.FindCellData("diagonal")->values, testing::ElementsAre(0, 2, 1));
}

}  // namespace
}  // namespace SolidSubdiv::Io

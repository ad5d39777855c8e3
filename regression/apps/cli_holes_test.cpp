// SPDX-License-Identifier: Apache-2.0
// Holes: refined with all others, and left out of what is written.
#include <cmath>

#include "apps/cli_testing.h"

namespace SolidSubdiv::CliTesting {
namespace {

using testing::HasSubstr;

constexpr int kRound = 6, kAcross = 4;

/// A torus of quads, or of triangles, with a tail of text.
std::string Torus(bool has_triangles, const std::string& tail) {
    std::ostringstream text;
    text.precision(17);
    for (int i = 0; i < kRound; ++i) {
        for (int j = 0; j < kAcross; ++j) {
            const double a = 2 * M_PI * i / kRound, b = 2 * M_PI * (j + 0.2 * i) / kAcross, r = 3 + std::cos(b);
            text << "v " << r * std::cos(a) << ' ' << r * std::sin(a) << ' ' << std::sin(b) << '\n';
        }
    }
    const auto id = [](int i, int j) { return 1 + i % kRound * kAcross + j % kAcross; };
    for (int i = 0; i < kRound; ++i) {
        for (int j = 0; j < kAcross; ++j) {
            const int v[] = {id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)};
            if (has_triangles) {
                text << "f " << v[0] << ' ' << v[1] << ' ' << v[2] << "\nf " << v[0] << ' ' << v[2] << ' ' << v[3]
                     << '\n';
            } else {
                text << "f " << v[0] << ' ' << v[1] << ' ' << v[2] << ' ' << v[3] << '\n';
            }
        }
    }
    return text.str() + tail;
}

/// Corners of all faces, each with its position.
std::vector<std::array<double, 3>> Corners(const Io::Mesh& mesh) {
    std::vector<std::array<double, 3>> corners;
    for (const auto* faces : {&mesh.topology.triangles, &mesh.topology.quads}) {
        for (Index v : *faces) {
            const double* p = &mesh.positions[3 * static_cast<std::size_t>(v)];
            corners.push_back({p[0], p[1], p[2]});
        }
    }
    return corners;
}

class CliHoles : public CliTest {
  protected:
    /// The refined mesh without holes and the one with them, which must be the first less the children of its holes.
    void ExpectLess(bool has_triangles, const std::vector<std::size_t>& holes, const std::string& arguments,
                    int levels) {
        SCOPED_TRACE(arguments);
        std::string tags;
        for (std::size_t hole : holes) tags += "t hole 1/0/0 " + std::to_string(hole) + "\n";
        WriteText("whole.obj", Torus(has_triangles, ""));
        WriteText("holes.obj", Torus(has_triangles, tags));
        const std::string rest = " --levels " + std::to_string(levels) + " " + arguments;
        MustRun("refine whole.obj -o fine_whole.obj" + rest);
        const auto json = Json("refine holes.obj -o fine_holes.obj" + rest);
        const Io::Mesh whole = ReadMesh("fine_whole.obj"), left = ReadMesh("fine_holes.obj");

        auto expected = Corners(whole);
        // Of a face's children: triangles are cut into four, or, like other polygons, into a quad a corner.
        const bool makes_quads = whole.topology.n_quads() > 0;
        const std::size_t n_corners =
            has_triangles && makes_quads ? (3u * 4u) << (2 * (levels - 1)) : (has_triangles ? 3u : 4u) << (2 * levels);
        for (std::size_t i = holes.size(); i-- > 0;) {  // ascending, so from the end
            const auto first = expected.begin() + static_cast<std::ptrdiff_t>(holes[i] * n_corners);
            expected.erase(first, first + static_cast<std::ptrdiff_t>(n_corners));
        }
        EXPECT_EQ(Corners(left), expected);

        // The vertices that are left are those of the faces that are left, in the order that they had.
        std::set<Index> used;
        const std::size_t n_before = whole.positions.size() / 3;
        for (const auto* faces : {&left.topology.triangles, &left.topology.quads}) {
            used.insert(faces->begin(), faces->end());
        }
        EXPECT_EQ(used.size(), static_cast<std::size_t>(left.topology.n_vertices));
        EXPECT_EQ(json["left_out"]["faces"], holes.size());
        EXPECT_EQ(json["left_out"]["vertices"].get<std::size_t>(), n_before - used.size());
        std::size_t at = 0;
        for (std::size_t v = 0; v < left.positions.size(); v += 3, at += 3) {
            while (at < whole.positions.size() &&
                   !std::equal(&left.positions[v], &left.positions[v] + 3, &whole.positions[at])) {
                at += 3;
            }
            ASSERT_LT(at, whole.positions.size()) << v / 3;
        }
    }
};

TEST_F(CliHoles, ATorusWithTwoIsTheWholeOneLessTheirChildren) {
    for (const char* scheme : {"catmull-clark", "linear-surface"}) {
        ExpectLess(false, {3, 17}, std::string("--scheme ") + scheme, 2);
    }
    for (const char* scheme : {"loop", "butterfly", "modified-butterfly", "linear-surface", "catmull-clark"}) {
        ExpectLess(true, {5, 40}, std::string("--scheme ") + scheme, 2);
    }
    ExpectLess(true, {5, 40}, "--scheme loop --limit", 1);
}

TEST_F(CliHoles, NeighboursLoseTheVerticesBetweenThem) {
    ExpectLess(false, {0, 1, 2, 3}, "", 3);  // a whole ring
    WriteText("holes.obj", Torus(false, "t hole 4/0/0 0 1 2 3\n"));
    MustRun("refine holes.obj -o tube.obj --levels 1");
    const auto json = Json("info tube.obj");
    EXPECT_EQ(json["surface"]["components"][0]["border_loops"], 2);
    // Of the ring's 4 x 1 quads at level 1: 4 face points and 4 edge points between them.
    EXPECT_EQ(json["counts"]["vertices"], 4 * kRound * kAcross - 8);
}

TEST_F(CliHoles, DataBoundaryStencilsAndCreasesGoWithThem) {
    Io::Mesh mesh;
    mesh.positions = {0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0, 3, 0, 1, 3, 1, 1};
    mesh.topology.n_vertices = 8;
    mesh.topology.quads = {0, 1, 4, 3, 1, 2, 5, 4, 2, 6, 7, 5};
    mesh.point_data = {{"t", 1, {0, 1, 2, 3, 4, 5, 6, 7}}};
    mesh.cell_data = {{"hole", 1, {0, 1, 1, 0, 0}}, {"number", 1, {1, 2, 3, 0, 0}}, {"sharpness", 1, {0, 0, 0, 3, 3}}};
    mesh.topology.edges = {2, 5, 1, 4};  // between the holes, and at the first one's border
    WriteMesh("a.vtu", mesh);
    EXPECT_EQ(Json("info a.vtu")["holes"], 2);
    EXPECT_THAT(MustRun("info a.vtu").out, HasSubstr("holes             2 faces"));
    const auto json = Json("refine a.vtu -o b.vtu --scheme catmull-clark --boundary c.obj --stencils d.mtx --levels 1");
    EXPECT_EQ(json["creases"]["edges"], 2);
    EXPECT_EQ(json["creases"]["edges_still_sharp"], 2) << "the children of one edge";
    const Io::Mesh fine = ReadMesh("b.vtu");
    EXPECT_EQ(fine.topology.n_vertices, 9);
    EXPECT_EQ(fine.topology.n_quads(), 4);
    EXPECT_EQ(fine.topology.n_edges(), 2);
    EXPECT_EQ(fine.FindCellData("hole"), nullptr);
    EXPECT_EQ(fine.FindCellData("number")->values[0], 1);
    ASSERT_EQ(fine.point_data[0].values.size(), 9u);
    const Io::Mesh boundary = ReadMesh("c.obj");
    EXPECT_EQ(boundary.positions, fine.positions);
    EXPECT_EQ(boundary.topology.quads, fine.topology.quads);

    // Rows of the stencils are the vertices that are written.
    std::ifstream file(folder / "d.mtx");
    std::string line;
    while (std::getline(file, line) && line[0] == '%') continue;
    int n_rows = 0, n_columns = 0, n_weights = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%d %d %d", &n_rows, &n_columns, &n_weights), 3);
    EXPECT_EQ(n_rows, 9);
    EXPECT_EQ(n_columns, 8);
    std::vector<double> sums(9, 0.0);
    for (int i = 0, row, column; i < n_weights; ++i) {
        double weight;
        file >> row >> column >> weight;
        sums[static_cast<std::size_t>(row) - 1] +=
            weight * mesh.point_data[0].values[static_cast<std::size_t>(column) - 1];
    }
    EXPECT_LT(Difference(sums, fine.point_data[0].values), 1e-14);
}

TEST_F(CliHoles, SheetsOfSolidsHaveThemToo) {
    Io::Mesh mesh = OneTet();
    mesh.positions.insert(mesh.positions.end(), {-1, -1, 0, -2, 1, 0, 5, 5, 5});
    mesh.topology.n_vertices = 7;  // the last is in no element
    mesh.topology.triangles = {0, 4, 5, 0, 3, 4};
    mesh.cell_data = {{"hole", 1, {1, 1, 0}}};  // of the tet it means nothing
    WriteMesh("a.vtu", mesh);
    MustRun("refine a.vtu -o b.vtu --levels 2 --keep-octahedra");
    const Io::Mesh fine = ReadMesh("b.vtu");
    EXPECT_EQ(fine.topology.n_triangles(), 16);
    EXPECT_EQ(fine.topology.n_tets() + fine.topology.n_octs(), 4 * 4 + 8 + 4 + 6);
    const double* last = nullptr;
    for (std::size_t v = 0; v < fine.positions.size(); v += 3) {
        if (fine.positions[v] == 5) last = &fine.positions[v];
    }
    EXPECT_NE(last, nullptr) << "a vertex that was in no element stays";
    mesh.cell_data.clear();
    WriteMesh("whole.vtu", mesh);
    MustRun("refine whole.vtu -o whole_fine.vtu --levels 2 --keep-octahedra");
    // 15 points of a triangle refined twice, 5 of them on the edge that it shares with the other.
    EXPECT_EQ(ReadMesh("whole_fine.vtu").topology.n_vertices - fine.topology.n_vertices, 10);
}

TEST_F(CliHoles, LevelZeroKeepsThemAndTheirTags) {
    WriteText("holes.obj", Torus(false, "t hole 2/0/0 3 17\nt interpolateboundary 1/0/0 1\n"));
    MustRun("refine holes.obj -o same.obj --levels 0");
    const std::string text = ReadText(folder / "same.obj");
    EXPECT_THAT(text, HasSubstr("t hole 1/0/0 3\nt hole 1/0/0 17\n"));
    EXPECT_THAT(text, HasSubstr("t interpolateboundary 1/0/0 1\n"));
    EXPECT_EQ(ReadMesh("same.obj").topology.n_quads(), kRound * kAcross);
}

TEST_F(CliHoles, BadOnesAreRefusedWithTheirLine) {
    WriteText("bad.obj", Torus(false, "t hole 1/0/0 24\n"));
    const Outcome bad = Run("refine bad.obj -o out.obj");
    EXPECT_EQ(bad.status, 1);
    EXPECT_EQ(bad.err,
              "solidsubdiv: error: bad.obj: line 49: a tag names face 24, but there are 24 faces, counted from 0 "
              "in tags\n");
    WriteText("all.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nt hole 1/0/0 0\n");
    const Outcome all = Run("refine all.obj -o out.obj");
    EXPECT_EQ(all.status, 1);
    EXPECT_THAT(all.err, HasSubstr("all.obj: all its faces are holes"));
    EXPECT_EQ(Names(), (std::set<std::string>{"all.obj", "bad.obj"}));
}

}  // namespace
}  // namespace SolidSubdiv::CliTesting

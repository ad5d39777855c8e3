// SPDX-License-Identifier: Apache-2.0
// solidsubdiv refine and info on hexahedra, mixed cells and polygons.
#include <map>

#include "apps/cli_testing.h"

namespace SolidSubdiv::CliTesting {
namespace {

class CliPolyhedra : public CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        // A cube, a pyramid on it, a wedge beside it, a tet as a polyhedron on the wedge; a loose quad and a pentagon;
        // a polyline. Cell data: the number of each element in the file's order.
        Io::Topology& t = mesh_.topology;
        mesh_.positions = {0, 0, 0, 1, 0, 0,   1,   1, 0, 0, 1,   0,  0, 0,   1,   1,  0,   1, 1,
                           1, 1, 0, 1, 1, 0.5, 0.5, 2, 2, 0, 0.5, 2,  1, 0.5, 1.6, -1, 0.6, 5, 0,
                           0, 6, 0, 0, 6, 1,   0,   5, 1, 0, 5.5, -1, 0, 4.5, -1,  1,  4,   0, 0};
        t.n_vertices = static_cast<Index>(mesh_.positions.size() / 3);
        t.hexes = {0, 1, 2, 3, 4, 5, 6, 7};
        t.pyramids = {4, 5, 6, 7, 8};
        t.wedges = {1, 9, 5, 2, 10, 6};
        t.polyhedron_offsets = {0, 4};
        t.polyhedron_face_offsets = {0, 3, 6, 9, 12};
        t.polyhedron_vertices = {1, 5, 9, 1, 11, 5, 5, 11, 9, 9, 11, 1};
        t.quads = {12, 13, 14, 15};
        t.polygon_offsets = {0, 5};
        t.polygon_vertices = {13, 12, 18, 17, 16};
        t.edges = {14, 0};
        mesh_.cell_data = {{"number", 1, {0, 1, 2, 3, 4, 5, 6}}};
        Io::WriteMesh(folder / "mixed.vtu", mesh_, {});
    }
    Io::Mesh mesh_;
};

/// Corners of the elements, in the order of cell data.
std::vector<std::vector<Index>> Elements(const Io::Topology& t) {
    std::vector<std::vector<Index>> elements;
    const auto add = [&](const std::vector<Index>& all, std::size_t arity) {
        for (std::size_t i = 0; i < all.size(); i += arity) {
            elements.emplace_back(all.begin() + static_cast<std::ptrdiff_t>(i),
                                  all.begin() + static_cast<std::ptrdiff_t>(i + arity));
        }
    };
    add(t.hexes, 8);
    add(t.wedges, 6);
    add(t.pyramids, 5);
    for (Offset c = 0; c < t.n_polyhedra(); ++c) {
        elements.emplace_back(t.polyhedron_vertices.begin() + t.polyhedron_face_offsets[t.polyhedron_offsets[c]],
                              t.polyhedron_vertices.begin() + t.polyhedron_face_offsets[t.polyhedron_offsets[c + 1]]);
    }
    add(t.quads, 4);
    for (Offset i = 0; i < t.n_polygons(); ++i) {
        elements.emplace_back(t.polygon_vertices.begin() + t.polygon_offsets[i],
                              t.polygon_vertices.begin() + t.polygon_offsets[i + 1]);
    }
    add(t.edges, 2);
    return elements;
}

std::array<double, 6> BoxOf(const Io::Mesh& mesh, const std::vector<Index>& vertices) {
    std::array<double, 6> box{1e9, 1e9, 1e9, -1e9, -1e9, -1e9};
    for (Index v : vertices) {
        for (int axis = 0; axis < 3; ++axis) {
            const double x = mesh.positions[3 * static_cast<std::size_t>(v) + static_cast<std::size_t>(axis)];
            box[axis] = std::min(box[axis], x);
            box[3 + axis] = std::max(box[3 + axis], x);
        }
    }
    return box;
}

TEST_F(CliPolyhedra, ElementsInheritTheDataOfTheElementsThatTheyLieIn) {
    MustRun("refine mixed.vtu -o fine.vtu --scheme linear-solid --levels 2");
    const Io::Mesh fine = Io::ReadMesh(folder / "fine.vtu");
    const auto parents = Elements(mesh_.topology), elements = Elements(fine.topology);
    const Io::Attribute* number = fine.FindCellData("number");
    ASSERT_NE(number, nullptr);
    ASSERT_EQ(number->values.size(), elements.size());
    std::map<int, int> counts;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const int parent = static_cast<int>(number->values[i]);
        ++counts[parent];
        const auto mine = BoxOf(fine, elements[i]), theirs = BoxOf(mesh_, parents[static_cast<std::size_t>(parent)]);
        for (int k = 0; k < 3; ++k) {
            ASSERT_GE(mine[k], theirs[k] - 1e-12) << i << " of " << parent;
            ASSERT_LE(mine[3 + k], theirs[3 + k] + 1e-12) << i << " of " << parent;
        }
    }
    // Corners, and theirs: the pyramid's apex leaves a cell with ten corners beside its four hexahedra.
    const std::map<int, int> expected{{0, 64}, {1, 48}, {2, 4 * 8 + 10}, {3, 32}, {4, 16}, {5, 20}, {6, 4}};
    EXPECT_EQ(counts, expected);
}

TEST_F(CliPolyhedra, TheBoundaryIsWrittenWithItsQuadrilaterals) {
    MustRun("refine mixed.vtu -o fine.vtu --levels 1 --boundary fine.obj --json j.json");
    const Io::Mesh boundary = Io::ReadMesh(folder / "fine.obj");
    const auto json = nlohmann::json::parse(ReadText(folder / "j.json"));
    EXPECT_EQ(json["settings"]["scheme"], "catmull-clark-solid");
    EXPECT_EQ(json["levels"][1]["boundary_faces"].get<Offset>(), boundary.topology.n_quads());
    EXPECT_EQ(json["levels"][1]["other_cells"], 1);
    EXPECT_EQ(json["levels"][1]["hexahedra"], 8 + 6 + 4 + 4);
    MustRun("refine mixed.vtu -o same.vtu --levels 0 --boundary base.obj");
    const Io::Mesh base = Io::ReadMesh(folder / "base.obj");
    EXPECT_EQ(base.topology.n_triangles(), 4 + 1 + 3);
    EXPECT_EQ(base.topology.n_polygons(), 1);
}

// A limit is where refinement goes: nearer at each level.
TEST_F(CliPolyhedra, VerticesGoToTheirLimits) {
    for (const std::string scheme : {"catmull-clark-solid", "mlca"}) {
        const auto refined = [&](const std::string& options) {
            MustRun("refine mixed.vtu -o out.vtu --scheme " + scheme + " " + options);
            return Io::ReadMesh(folder / "out.vtu").positions;
        };
        const std::vector<double> limit = refined("--levels 1 --limit");
        double before = 1;
        for (const std::string levels : {"1", "2", "3"}) {
            const std::vector<double> points = refined("--levels " + levels);
            double distance = 0;  // of the vertices of level 1, which come first
            for (std::size_t i = 0; i < limit.size(); ++i) {
                distance = std::max(distance, std::abs(points[i] - limit[i]));
            }
            EXPECT_GT(distance, 0);
            EXPECT_LT(distance, before / 2) << levels;
            before = distance;
        }
    }
}

TEST_F(CliPolyhedra, InvertedCellsAreTurnedWithAWord) {
    Io::Mesh turned = mesh_;
    turned.topology.hexes = {4, 5, 6, 7, 0, 1, 2, 3};
    turned.topology.pyramids = {4, 7, 6, 5, 8};
    Io::WriteMesh(folder / "turned.vtu", turned, {});
    EXPECT_THAT(MustRun("info turned.vtu").out, testing::HasSubstr("inverted: 2 hexahedra"));
    const Outcome outcome = MustRun("refine turned.vtu -o a.vtu --levels 1 --ascii");
    EXPECT_THAT(outcome.err, testing::HasSubstr("2 inverted cells turned (--orient)"));
    EXPECT_THAT(MustRun("info a.vtu").out, testing::Not(testing::HasSubstr("inverted")));
    MustRun("refine mixed.vtu -o b.vtu --levels 1");
    EXPECT_EQ(Io::ReadMesh(folder / "a.vtu").positions.size(), Io::ReadMesh(folder / "b.vtu").positions.size());
}

TEST_F(CliPolyhedra, ASurfaceOfPolygonsFollowsCatmullClark) {
    // A cube's surface: after one split every old vertex is at 5/9 of its place.
    WriteText("cube.obj",
              "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
              "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    MustRun("refine cube.obj -o fine.obj --levels 1");
    const Io::Mesh fine = Io::ReadMesh(folder / "fine.obj");
    EXPECT_EQ(fine.topology.n_quads(), 24);
    for (std::size_t i = 0; i < 24; ++i) EXPECT_NEAR(std::abs(fine.positions[i]), 5.0 / 9, 1e-15);
}

TEST_F(CliPolyhedra, SchemesRefuseKindsThatTheyDoNotTakeAndNameThoseThatDo) {
    const auto refused = [&](const std::string& file, const std::string& scheme) {
        const Outcome outcome = Run("refine " + file + " -o out.vtu --scheme " + scheme);
        EXPECT_EQ(outcome.status, 1) << file << " " << scheme;
        EXPECT_FALSE(fs::exists(folder / "out.vtu"));
        return outcome.err;
    };
    const std::string error = "solidsubdiv: error: ";
    EXPECT_EQ(
        refused("mixed.vtu", "box-spline"),
        error +
            "mixed.vtu: has 1 hexahedron, 1 wedge, 1 pyramid, 1 polyhedron, 1 quadrilateral and 1 polygon; scheme "
            "box-spline takes tetrahedra, octahedra, triangles and edges only: choose catmull-clark-solid, mlca "
            "or linear-solid\n");
    Io::Mesh hexes = mesh_;
    hexes.topology = {};
    hexes.topology.n_vertices = mesh_.topology.n_vertices;
    hexes.topology.hexes = mesh_.topology.hexes;
    hexes.cell_data.clear();
    WriteMesh("hexes.vtu", hexes);
    EXPECT_EQ(refused("hexes.vtu", "loop"),
              error +
                  "hexes.vtu: has 1 hexahedron; scheme loop takes triangles and edges only: choose "
                  "catmull-clark-solid, mlca or linear-solid, or refine the boundary alone\n");
    WriteText("two.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nf 1 2 3 4\nf 2 5 6 3\n");
    for (const char* scheme : {"interpolatory", "butterfly"}) {
        EXPECT_THAT(refused("two.obj", scheme), testing::HasSubstr("two.obj: has 2 quadrilaterals; scheme "));
        EXPECT_THAT(refused("two.obj", scheme), testing::EndsWith("only: choose catmull-clark or linear-surface\n"));
    }
    WriteMesh("tet.vtu", OneTet());
    EXPECT_EQ(
        refused("tet.vtu", "catmull-clark"),
        error +
            "tet.vtu: has 1 tetrahedron; scheme catmull-clark takes triangles, quadrilaterals, polygons and edges "
            "only: choose box-spline, smooth-tet, interpolatory, catmull-clark-solid, mlca or linear-solid, or refine "
            "the "
            "boundary alone\n");
    // Every scheme takes what the messages say.
    for (const char* scheme : {"catmull-clark-solid", "linear-solid"}) {
        MustRun("refine hexes.vtu -o hexes_out.vtu --scheme " + std::string(scheme));
    }
    for (const char* scheme : {"catmull-clark", "linear-surface"}) {
        MustRun("refine two.obj -o two_out.obj --scheme " + std::string(scheme));
    }
    for (const char* scheme : {"box-spline", "interpolatory", "catmull-clark-solid", "linear-solid"}) {
        MustRun("refine tet.vtu -o tet_out.vtu --scheme " + std::string(scheme));
    }
}

TEST_F(CliPolyhedra, PicturesShowCellsOfEveryKindAndPolygons) {
    if (MustRun("refine --help").out.find("--picture") == std::string::npos) {
        GTEST_SKIP() << "built without pictures (no Embree or libpng)";
    }
    WriteText("roof.obj", "v 0 0 0\nv 2 0 0\nv 3 1 0\nv 1 2 1\nv -1 1 0\nv 1 -1 1\nf 1 2 3 4 5\nf 2 1 6\n");
    for (const char* arguments : {"mixed.vtu -o a.vtu --levels 1", "roof.obj -o a.obj --levels 1"}) {
        const auto json = Json("refine " + std::string(arguments) + " --picture picture.png");
        EXPECT_EQ(json["outputs"][1]["what"], "picture") << arguments;
        EXPECT_GT(fs::file_size(folder / "picture.png"), 50000u) << arguments << ": an empty picture is much smaller";
    }
}

}  // namespace
}  // namespace SolidSubdiv::CliTesting

// SPDX-License-Identifier: Apache-2.0
// OpenSubdiv's tags in OBJ files: every form of them, what is wrong with the others, its catalogue of shapes.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>
#include <sstream>

#include <solidsubdiv/kit/io/creases.h>
#include <solidsubdiv/kit/io/holes.h>
#include <solidsubdiv/kit/io/internal/readers.h>
#include <solidsubdiv/kit/io/internal/text.h>

#include "kit/io/support.h"

namespace SolidSubdiv::Io {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

Mesh Parse(const std::string& text) { return Internal::ParseObj(text, "a.obj"); }
Mesh SquareWith(const std::string& tags) { return Parse(kSquare + tags); }

std::vector<double> SharpnessOf(const Mesh& mesh) {
    const Attribute* const sharpness = FindSharpness(mesh);
    return sharpness ? sharpness->values : std::vector<double>();
}

TEST(ObjTags, CreasesAndCornersAreElementsCountedFromZero) {
    const Mesh mesh = SquareWith("t crease 2/1/0 0 1 2.5\nt corner 1/1/0 3 10\nt crease 2/1/0 3 0 0.1\n");
    EXPECT_THAT(mesh.topology.edges, ElementsAre(0, 1, 3, 0));
    EXPECT_THAT(mesh.topology.vertices, ElementsAre(3));
    EXPECT_THAT(SharpnessOf(mesh), ElementsAre(0, 2.5, 0.1, 10));
    EXPECT_THAT(mesh.notes, IsEmpty());
    EXPECT_THAT(mesh.scheme_options, IsEmpty());
}

TEST(ObjTags, OneTagHoldsSeveralElementsOfOneSharpnessOrOneEach) {
    const Mesh one = SquareWith("t crease 4/1/0 0 1 1 2 2.5\nt corner 2/1/0 3 0 7\n");
    EXPECT_THAT(one.topology.edges, ElementsAre(0, 1, 1, 2));
    EXPECT_THAT(one.topology.vertices, ElementsAre(3, 0));
    EXPECT_THAT(SharpnessOf(one), ElementsAre(0, 2.5, 2.5, 7, 7));
    const Mesh each = SquareWith("t crease 4/2/0 0 1 1 2 2.5 3\nt corner 2/2/0 3 0 7 8\n");
    EXPECT_THAT(SharpnessOf(each), ElementsAre(0, 2.5, 3, 7, 8));
}

TEST(ObjTags, BlanksCommentsContinuedLinesAndPlaceInTheFileDoNotMatter) {
    const Mesh mesh =
        Parse("t crease 2/1/0 0 1 2\r\n" + kSquare + "  t\tcorner 1/1/0   2  3 # round\nt crease 2/1/0 \\\n1 2 4  \n");
    EXPECT_THAT(mesh.topology.edges, ElementsAre(0, 1, 1, 2));
    EXPECT_THAT(SharpnessOf(mesh), ElementsAre(0, 2, 4, 3));
}

TEST(ObjTags, SharpnessOfZeroIsNoCrease) {
    const Mesh mesh = SquareWith("t crease 2/1/0 0 1 0\nt corner 2/2/0 1 2 0 3\n");
    EXPECT_THAT(mesh.topology.edges, IsEmpty());
    EXPECT_THAT(mesh.topology.vertices, ElementsAre(2));
    EXPECT_EQ(SquareWith("t crease 2/1/0 0 1 0.0\n").FindCellData("sharpness"), nullptr);
}

TEST(ObjTags, PairThatIsNoEdgeOfAFaceIsKept) {
    const Mesh mesh = SquareWith("t crease 2/1/0 0 2 2\n");
    EXPECT_THAT(mesh.topology.edges, ElementsAre(0, 2));
    EXPECT_THAT(SharpnessOf(mesh), ElementsAre(0, 2));
}

TEST(ObjTags, ElementInOnePlaceIsOneElementWithTheLargestSharpness) {
    const Mesh tags =
        SquareWith("t crease 2/1/0 0 1 2\nt crease 4/1/0 1 0 2 3 5\nt crease 2/1/0 0 1 3\nt corner 2/2/0 1 1 4 3\n");
    EXPECT_THAT(tags.topology.edges, ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(tags.topology.vertices, ElementsAre(1));
    EXPECT_THAT(SharpnessOf(tags), ElementsAre(0, 5, 5, 4));
    EXPECT_THAT(tags.notes, ElementsAre("3 creases or corners are there more than once; the largest sharpness counts"));

    const Mesh lines = SquareWith("l 3 2 1\np 3 4\nt crease 2/1/0 0 1 2\nt corner 1/1/0 3 6\nl 1 2\np 4\n");
    EXPECT_THAT(lines.topology.edges, ElementsAre(2, 1, 1, 0));
    EXPECT_THAT(lines.topology.vertices, ElementsAre(2, 3));
    EXPECT_THAT(SharpnessOf(lines), ElementsAre(0, 0, 2, 0, 6));
    EXPECT_THAT(lines.notes, IsEmpty());

    // Without tags nothing is merged, and a line from a vertex to itself is no point.
    const Mesh plain = SquareWith("l 1 2\nl 1 2\np 1 1\n");
    EXPECT_THAT(plain.topology.edges, ElementsAre(0, 1, 0, 1));
    EXPECT_THAT(plain.topology.vertices, ElementsAre(0, 0));
    const Mesh loop = SquareWith("l 1 1\nt corner 1/1/0 0 2\n");
    EXPECT_THAT(SharpnessOf(loop), ElementsAre(0, 0, 2));
}

TEST(ObjTags, HolesAreFacesCountedInTheFilesOrder) {
    // Faces of every size, lines and points between them: the mesh orders them by kind.
    const std::string text =
        "t hole 1/0/0 0\n" + kSquare + "v 2 0 0\nl 1 2\nf 1 2 5\nf 1 2 3 4 5\np 3\nf 2 3 5\nf 3 4 5\nf 5 4 3 2\n";
    const auto holes_of = [&](const std::string& tags) { return HolesOf(Parse(text + tags)); };
    EXPECT_THAT(holes_of(""), ElementsAre(3)) << "behind three triangles";
    EXPECT_THAT(holes_of("t hole 1/0/0 1\n"), ElementsAre(0, 3));
    EXPECT_THAT(holes_of("t hole 2/0/0 2 3\n"), ElementsAre(1, 3, 5));
    EXPECT_THAT(holes_of("t hole 2/0/0 4 5\nt hole 1/0/0 4\n"), ElementsAre(2, 3, 4));
    EXPECT_THAT(HolesOf(SquareWith("")), IsEmpty());
    EXPECT_EQ(SquareWith("").FindCellData("hole"), nullptr);
}

TEST(ObjTags, SettingsBecomeSchemeOptionsAndTheLastOneCounts) {
    const std::pair<const char*, const char*> boundaries[] = {
        {"0", "none"}, {"1", "edge-and-corner"}, {"2", "edge-only"}};
    for (const auto& [number, name] : boundaries) {
        EXPECT_THAT(SquareWith(std::string("t interpolateboundary 1/0/0 ") + number + "\n").scheme_options,
                    ElementsAre(Pair("boundary", name)));
    }
    EXPECT_THAT(SquareWith("t creasemethod 0/0/1 normal\n").scheme_options, ElementsAre(Pair("creasing", "uniform")));
    EXPECT_THAT(SquareWith("t creasemethod 0/0/1 normal\nt interpolateboundary 1/0/0 1\nt creasemethod 0/0/1 chaikin\n")
                    .scheme_options,
                ElementsAre(Pair("boundary", "edge-and-corner"), Pair("creasing", "chaikin")));
}

TEST(ObjTags, WhatHasNoMeaningHereIsNoted) {
    const Mesh mesh = SquareWith(
        "t smoothtriangles 0/0/1 smooth\nt vertexedit 4/3/3 3 0 1 0 0 0 1 add P value\n"
        "t facevaryinginterpolateboundary 1/0/0 1\nt facevaryingpropagatecorners 1/0/0 1\nt smoothtriangles 0/0/1 "
        "smooth\n"
        "t edgeedit 4/1/3 3 0 1 0 2 set P sharpness\nt faceedit 4/0/1 3 4 1 1 hole\nt other 1\nt more\n");
    EXPECT_THAT(mesh.notes,
                ElementsAre("2 OpenSubdiv tags 'smoothtriangles' not used", "1 OpenSubdiv tag 'vertexedit' not used",
                            "1 OpenSubdiv tag 'facevaryinginterpolateboundary' not used",
                            "1 OpenSubdiv tag 'facevaryingpropagatecorners' not used",
                            "1 OpenSubdiv tag 'edgeedit' not used", "1 OpenSubdiv tag 'faceedit' not used",
                            "2 unknown tags ('t' lines) skipped, the first is 'other'"));
    EXPECT_EQ(mesh.topology.n_elements(), 1);
}

TEST(ObjTags, CorpusFileWithEveryTagIsRead) {
    const Mesh mesh = ReadMesh(Corpus("hand_tags.obj"));
    EXPECT_THAT(mesh.topology.edges, ElementsAre(3, 4, 0, 1, 1, 2, 2, 3, 3, 0, 1, 4));
    EXPECT_THAT(mesh.topology.vertices, ElementsAre(3, 4));
    EXPECT_THAT(SharpnessOf(mesh), ElementsAre(0, 0, 0, 1, 10, 3, 0.5, 10, 10, 1.5, 10));
    EXPECT_THAT(mesh.scheme_options, ElementsAre(Pair("boundary", "edge-only"), Pair("creasing", "chaikin")));
    EXPECT_EQ(mesh.notes.size(), 8u);
    EXPECT_THAT(HolesOf(mesh), ElementsAre(1));
}

struct BadTag {
    std::string tag;
    std::string says;  // behind "a.obj: line 7: "
};

const std::vector<BadTag> kBadTags = {
    {"t", "expected the name of a tag, found the end; is it complete?"},
    {"t crease", "expected how many integers, numbers and words follow, as in 2/1/0, found the end; is it complete?"},
    {"t crease 2/1 0 1 2", "expected how many integers, numbers and words follow, as in 2/1/0, found '2/1'"},
    {"t crease 2/1/0/ 0 1 2", "expected how many integers, numbers and words follow, as in 2/1/0, found '2/1/0/'"},
    {"t crease 2//0 0 1 2", "expected how many integers, numbers and words follow, as in 2/1/0, found '2//0'"},
    {"t crease -2/1/0 0 1 2", "expected how many integers, numbers and words follow, as in 2/1/0, found '-2/1/0'"},
    {"t crease 2/1/99999999999999999999 0 1 2",
     "expected how many integers, numbers and words follow, as in 2/1/0, found '2/1/99999999999999999999'"},
    {"t crease 4000000000000000000/1/0 0 1 2",
     "tag 'crease' announces more values (4000000000000000000/1/0) than its line can hold"},
    {"t corner 1/2000000000/0 0 1", "tag 'corner' announces more values (1/2000000000/0) than its line can hold"},
    {"t crease 3/1/0 0 1 2 2",
     "tag 'crease' needs pairs of vertices and one sharpness, or one for each; it has 3 integers, 1 number and 0 "
     "words"},
    {"t crease 0/1/0 2",
     "tag 'crease' needs pairs of vertices and one sharpness, or one for each; it has 0 integers, 1 number and 0 "
     "words"},
    {"t crease 2/0/0 0 1",
     "tag 'crease' needs pairs of vertices and one sharpness, or one for each; it has 2 integers, 0 numbers and 0 "
     "words"},
    {"t crease 6/2/0 0 1 1 2 2 3 4 5",
     "tag 'crease' needs pairs of vertices and one sharpness, or one for each; it has 6 integers, 2 numbers and 0 "
     "words"},
    {"t crease 2/1/1 0 1 2 x",
     "tag 'crease' needs pairs of vertices and one sharpness, or one for each; it has 2 integers, 1 number and 1 word"},
    {"t corner 0/1/0 2",
     "tag 'corner' needs vertices and one sharpness, or one for each; it has 0 integers, 1 number and 0 words"},
    {"t crease 2/1/0 0 1", "expected a sharpness of tag 'crease', found the end; is it complete?"},
    {"t crease 2/1/0 0.5 1 2", "expected a vertex of tag 'crease', found '0.5'"},
    {"t crease 2/1/0 0 1 sharp", "expected a sharpness of tag 'crease', found 'sharp'"},
    {"t crease 2/1/0 0 1 2 3", "tag 'crease' has more values than it announces, from '3' on"},
    {"t crease 2/1/0 0 -1 2", "vertex -1 of tag 'crease': its vertices are counted from 0"},
    {"t crease 2/1/0 0 4 2", "a tag names vertex 4, but there are 4 vertices, counted from 0 in tags"},
    {"t corner 1/1/0 4000000000 2", "vertex 4000000000 of tag 'corner' is not there"},
    {"t corner 1/1/0 4 0", "a tag names vertex 4, but there are 4 vertices, counted from 0 in tags"},
    {"t crease 2/1/0 1 1 2", "tag 'crease' has vertex 1 twice in one pair"},
    {"t crease 2/1/0 0 1 -1",
     "sharpness -1 of tag 'crease': it must be 0 (no crease) or greater, 10 for infinitely sharp"},
    {"t crease 2/1/0 0 1 nan",
     "sharpness nan of tag 'crease': it must be 0 (no crease) or greater, 10 for infinitely sharp"},
    {"t corner 1/1/0 0 inf",
     "sharpness inf of tag 'corner': it must be 0 (no crease) or greater, 10 for infinitely sharp"},
    {"t corner 1/1/0 0 1e999",
     "sharpness 1e999 of tag 'corner': it must be 0 (no crease) or greater, 10 for infinitely sharp"},
    {"t hole 0/0/0", "tag 'hole' needs faces; it has 0 integers, 0 numbers and 0 words"},
    {"t hole 1/1/0 0 1", "tag 'hole' needs faces; it has 1 integer, 1 number and 0 words"},
    {"t hole 1/0/0", "expected a face of tag 'hole', found the end; is it complete?"},
    {"t hole 1/0/0 -1", "face -1 of tag 'hole': its faces are counted from 0"},
    {"t hole 1/0/0 1", "a tag names face 1, but there is 1 face, counted from 0 in tags"},
    {"t hole 2/0/0 0 9000000000000000000",
     "a tag names face 9000000000000000000, but there is 1 face, counted from 0 in tags"},
    {"t hole 1/0/0 0 0", "tag 'hole' has more values than it announces, from '0' on"},
    {"t interpolateboundary 0/0/0",
     "tag 'interpolateboundary' needs one integer; it has 0 integers, 0 numbers and 0 words"},
    {"t interpolateboundary 1/0/0 3", "tag 'interpolateboundary' must be 0, 1 or 2; it is 3"},
    {"t interpolateboundary 1/0/0 -1", "tag 'interpolateboundary' must be 0, 1 or 2; it is -1"},
    {"t interpolateboundary 1/0/0 1 1", "tag 'interpolateboundary' has more values than it announces, from '1' on"},
    {"t creasemethod 0/0/1", "expected 'normal' or 'chaikin' for tag 'creasemethod', found the end; is it complete?"},
    {"t creasemethod 0/0/1 round", "expected 'normal' or 'chaikin' for tag 'creasemethod', found 'round'"},
    {"t creasemethod 1/0/0 1", "tag 'creasemethod' needs one word; it has 1 integer, 0 numbers and 0 words"},
};

TEST(ObjTags, WhatIsWrongIsSaidInOneLineWithItsPlace) {
    for (const BadTag& bad : kBadTags) {
        const std::string text = kSquare + "t corner 1/1/0 3 1\n" + bad.tag;
        for (const char* rest : {"", "\n", " # comment\nt corner 1/1/0 2 1\n"}) {
            // A comment is no end of the text, but the message says what stands there.
            const std::string message = ErrorOf([&] { Parse(text + rest); });
            const bool found_end = bad.says.find("found the end") != bad.says.npos;
            if (found_end && rest[0] == ' ') {
                EXPECT_THAT(message, testing::StartsWith("a.obj: line 7: ")) << bad.tag;
            } else {
                EXPECT_EQ(message, "a.obj: line 7: " + bad.says) << bad.tag;
            }
        }
    }
}

// ---- Writing ----

TEST(ObjTags, SharpElementsAreWrittenAsTagsAndTheOthersAsLinesAndPoints) {
    TemporaryFolder folder;
    Mesh mesh = SquareWith("l 1 3\nt crease 2/1/0 0 1 0.1\np 1\nt corner 1/1/0 3 10\nl 3 4\n");
    mesh.scheme_options = {{"creasing", "chaikin"}, {"boundary", "edge-only"}, {"tension", "0.5"}};
    WriteMesh(folder / "a.obj", mesh);
    EXPECT_EQ(Load(folder / "a.obj"), "# written by SolidSubdiv\n" + kSquare +
                                          "l 1 3\nt crease 2/1/0 0 1 0.1\nl 3 4\np 1\nt corner 1/1/0 3 10\n"
                                          "t creasemethod 0/0/1 chaikin\nt interpolateboundary 1/0/0 2\n");
    mesh.scheme_options.pop_back();
    ExpectSameMesh(ReadMesh(folder / "a.obj"), mesh);
}

TEST(ObjTags, EverySettingComesBack) {
    TemporaryFolder folder;
    for (const char* boundary : {"none", "edge-only", "edge-and-corner"}) {
        for (const char* creasing : {"uniform", "chaikin"}) {
            Mesh mesh = SquareWith("");
            mesh.scheme_options = {{"boundary", boundary}, {"creasing", creasing}};
            WriteMesh(folder / "a.obj", mesh);
            ExpectSameMesh(ReadMesh(folder / "a.obj"), mesh);
        }
    }
}

TEST(ObjTags, ValueThatNoSettingHasIsTheCallersMistake) {
    TemporaryFolder folder;
    for (const char* option : {"boundary", "creasing"}) {
        Mesh mesh = SquareWith("");
        mesh.scheme_options = {{option, "round"}};
        EXPECT_THROW(WriteMesh(folder / "a.obj", mesh), InvalidInput);
    }
    EXPECT_THAT(folder.Files(), IsEmpty());
}

TEST(ObjTags, SharpnessOfFacesIsSaidToBeLeftOut) {
    Mesh mesh = SquareWith("t crease 2/1/0 0 1 2\n");
    EXPECT_THAT(AttributesLeftOut("a.obj", mesh), IsEmpty());
    mesh.cell_data[0].values[0] = 1;
    EXPECT_THAT(AttributesLeftOut("a.obj", mesh), ElementsAre("sharpness"));
    mesh.cell_data[0].values = {0, -1};
    EXPECT_THAT(AttributesLeftOut("a.obj", mesh), ElementsAre("sharpness"));
}

TEST(ObjTags, HolesComeBackFromFilesThatCarryThem) {
    TemporaryFolder folder;
    const Mesh mesh = SquareWith("v 2 0 0\nf 1 2 5\nt hole 1/0/0 0\nt corner 1/1/0 3 10\n");
    EXPECT_THAT(HolesOf(mesh), ElementsAre(1));
    for (const char* name : {"a.obj", "a.vtu", "a.vtk", "a.msh"}) {
        EXPECT_THAT(AttributesLeftOut(name, mesh), IsEmpty()) << name;
        WriteMesh(folder / name, mesh);
        EXPECT_THAT(HolesOf(ReadMesh(folder / name)), ElementsAre(1)) << name;
    }
    EXPECT_THAT(Load(folder / "a.obj"), testing::HasSubstr("\nt hole 1/0/0 1\n"));
    ExpectSameMesh(ReadMesh(folder / "a.obj"), mesh);
}

TEST(ObjTags, HolesThatAreNoFacesAreSaidToBeLeftOut) {
    Mesh mesh = SquareWith("l 1 2\nt hole 1/0/0 0\n");
    EXPECT_THAT(AttributesLeftOut("a.obj", mesh), IsEmpty());
    mesh.cell_data[0].values = {1, 1};
    EXPECT_THAT(AttributesLeftOut("a.obj", mesh), ElementsAre("hole"));
    EXPECT_THAT(HolesOf(mesh), ElementsAre(0));
    mesh.cell_data[0] = {"hole", 2, {0, 0, 0, 0}};
    EXPECT_THAT(AttributesLeftOut("a.obj", mesh), ElementsAre("hole"));
    EXPECT_THROW(HolesOf(mesh), InvalidInput);
    TemporaryFolder folder;
    WriteMesh(folder / "a.obj", mesh);
    EXPECT_THAT(HolesOf(ReadMesh(folder / "a.obj")), IsEmpty());
}

// ---- OpenSubdiv's catalogue ----

/// Sorted vertices (one or two) -> sharpness: of the tags as they stand, with streams instead of our reader.
using SharpParts = std::map<std::vector<int>, float>;

SharpParts PartsOfText(const std::string& text, std::map<std::string, int>& n_of_tag) {
    SharpParts parts;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string keyword, name, counts;
        words >> keyword >> name >> counts;
        if (keyword != "t") continue;
        ++n_of_tag[name];
        if (name != "crease" && name != "corner") continue;
        EXPECT_EQ(counts, name == "crease" ? "2/1/0" : "1/1/0");
        std::vector<int> vertices(name == "crease" ? 2 : 1);
        for (int& v : vertices) words >> v;
        std::sort(vertices.begin(), vertices.end());
        float sharpness = -1;
        words >> sharpness;
        if (sharpness > 0) parts[vertices] = std::max(parts[vertices], sharpness);
    }
    return parts;
}

SharpParts PartsOfMesh(const Mesh& mesh) {
    const Creases creases = CreasesOf(mesh);
    SharpParts parts;
    for (std::size_t i = 0; i < creases.edge_sharpness.size(); ++i) {
        std::vector<int> edge = {creases.edge_vertices[2 * i], creases.edge_vertices[2 * i + 1]};
        std::sort(edge.begin(), edge.end());
        EXPECT_TRUE(parts.emplace(edge, creases.edge_sharpness[i]).second);
    }
    for (std::size_t i = 0; i < creases.vertices.size(); ++i) {
        EXPECT_TRUE(parts.emplace(std::vector<int>{creases.vertices[i]}, creases.vertex_sharpness[i]).second);
    }
    return parts;
}

TEST(ObjCatalogue, CountingOfTagsSeesEveryDifference) {
    std::map<std::string, int> n;
    const std::string text = "t crease 2/1/0 0 1 2\nt corner 1/1/0 3 1\n";
    const SharpParts parts = PartsOfText(text, n);
    EXPECT_EQ(parts, PartsOfMesh(SquareWith(text)));
    for (const char* other :
         {"t crease 2/1/0 0 1 2\n", "t crease 2/1/0 0 1 2\nt corner 1/1/0 2 1\n",
          "t crease 2/1/0 0 1 3\nt corner 1/1/0 3 1\n", "t crease 2/1/0 1 2 2\nt corner 1/1/0 3 1\n"}) {
        EXPECT_NE(parts, PartsOfMesh(SquareWith(other))) << other;
    }
}

TEST(ObjCatalogue, EveryShapeIsReadWithItsTagsAndComesBack) {
    const auto shapes = RealData("opensubdiv_shapes");
    if (!std::filesystem::is_directory(shapes)) GTEST_SKIP() << "OpenSubdiv's shapes: there is no " << shapes;

    TemporaryFolder folder;
    std::size_t n_shapes = 0, n_parts = 0, n_holes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(shapes)) {
        if (entry.path().extension() != ".obj") continue;
        SCOPED_TRACE(entry.path().filename());
        const Mesh mesh = ReadMesh(entry.path());
        std::map<std::string, int> n_of_tag;
        const SharpParts parts = PartsOfText(Load(entry.path()), n_of_tag);
        EXPECT_EQ(PartsOfMesh(mesh), parts);
        EXPECT_EQ(mesh.topology.n_edges() + mesh.topology.n_point_elements(), static_cast<Offset>(parts.size()));
        EXPECT_EQ(mesh.scheme_options.size(),
                  (n_of_tag["interpolateboundary"] > 0 ? 1u : 0u) + (n_of_tag["creasemethod"] > 0 ? 1u : 0u));
        for (const std::string& note : mesh.notes) EXPECT_EQ(note.find("unknown"), note.npos) << note;
        for (const char* name : {"vertexedit", "edgeedit", "faceedit", "smoothtriangles"}) {
            const auto says = [&](const std::string& note) { return note.find(Internal::Quoted(name)) != note.npos; };
            EXPECT_EQ(std::any_of(mesh.notes.begin(), mesh.notes.end(), says), n_of_tag[name] > 0) << name;
        }
        EXPECT_EQ(!HolesOf(mesh).empty(), n_of_tag["hole"] > 0);
        WriteMesh(folder / "a.obj", mesh);
        ExpectSameMesh(ReadMesh(folder / "a.obj"), mesh);
        ++n_shapes;
        n_parts += parts.size();
        n_holes += HolesOf(mesh).size();
    }
    EXPECT_GT(n_shapes, 100u);
    EXPECT_GT(n_parts, 1000u);
    EXPECT_EQ(n_holes, 1u + 1u + 4u + 8u);
}

}  // namespace
}  // namespace SolidSubdiv::Io

// SPDX-License-Identifier: Apache-2.0
// Points of every format: the same cloud, what is left out, and what is refused.
#include <cmath>

#include <solidsubdiv/kit/io/internal/lzf.h>
#include <solidsubdiv/kit/io/internal/point_readers.h>
#include <solidsubdiv/kit/io/points.h>

#include "kit/io/damage.h"

namespace SolidSubdiv::Io {
namespace {

using Geometry::PointCloud;

/// The corpus's points (io_corpus/make_points_and_volumes.py).
std::vector<double> CorpusPositions() {
    std::vector<double> positions;
    for (int r = 0; r < 7; ++r) positions.insert(positions.end(), {r / 2.0, r * 1.0 * r, -1.0 * r});
    return positions;
}
std::vector<double> CorpusNormals() {
    std::vector<double> normals(21, 0);
    for (std::size_t r = 0; r < 7; ++r) normals[3 * r + r % 3] = 1;
    return normals;
}

TEST(Points, TextHoldsPositionsAndNormalsWithCommentsAndAnyLineEnds) {
    const PointCloud cloud = ReadPoints(Corpus("points_normals.xyz"));
    EXPECT_EQ(cloud.positions, CorpusPositions());
    EXPECT_EQ(cloud.normals, CorpusNormals());
    EXPECT_THAT(cloud.notes, testing::IsEmpty());
    EXPECT_EQ(cloud.n_points(), 7);
}

TEST(Points, MarksOfLinesAreSkippedAndOtherColumnsAreLeftOutWithANote) {
    for (const char* name : {"points_counted.pts", "points_bytes.txt"}) {
        const PointCloud cloud = ReadPoints(Corpus(name));
        EXPECT_EQ(cloud.positions, CorpusPositions()) << name;
        EXPECT_FALSE(cloud.has_normals()) << name;
        EXPECT_THAT(cloud.notes, testing::ElementsAre(testing::HasSubstr("left out"))) << name;
    }
    EXPECT_EQ(ReadPoints(Corpus("points_marked.pts")).positions, CorpusPositions());
}

TEST(Points, PcdDropsAndCountsInvalidPoints) {
    const PointCloud text = ReadPoints(Corpus("points_text.pcd"));
    EXPECT_EQ(text.positions, CorpusPositions());
    EXPECT_FALSE(text.has_normals());
    EXPECT_THAT(text.notes, testing::ElementsAre("1 point is marked as invalid and left out"));
    for (const char* name : {"points_binary.pcd", "points_compressed.pcd"}) {
        PointCloud cloud = ReadPoints(Corpus(name));
        ASSERT_EQ(cloud.n_points(), 8) << name;
        EXPECT_THAT(cloud.notes,
                    testing::ElementsAre("1 point is marked as invalid and left out", "1 point has no normal"));
        const std::vector<double> last(cloud.positions.end() - 3, cloud.positions.end());
        const std::vector<double> last_normal(cloud.normals.end() - 3, cloud.normals.end());
        EXPECT_THAT(last, testing::ElementsAre(1, 2, 3));
        EXPECT_THAT(last_normal, testing::ElementsAre(0, 0, 0));
        cloud.positions.resize(21);
        cloud.normals.resize(21);
        EXPECT_EQ(cloud.positions, CorpusPositions()) << name;
        EXPECT_EQ(cloud.normals, CorpusNormals()) << name;
    }
}

TEST(Points, PcdFieldsOfAnyTypeAndPlaceAreRead) {
    TemporaryFolder folder;
    const std::string head =
        "VERSION .7\nFIELDS id y hist x z\nSIZE 1 8 4 2 4\nTYPE U F F I I\nCOUNT 1 1 3 1 1\n"
        "WIDTH 1\nHEIGHT 2\nPOINTS 2\n";
    Save(folder / "a.pcd", head + "DATA ascii\n9 1.5 0 0 0 -2 3\n9 2.5 0 0 0 -3 4\n");
    EXPECT_THAT(ReadPoints(folder / "a.pcd").positions, testing::ElementsAre(-2, 1.5, 3, -3, 2.5, 4));
    // The same in the bytes of a little-endian machine: 1.5 and 2.5 are 0x3ff8 and 0x4004 on top.
    const std::string zeros(12, '\0');
    const auto row = [&](const std::string& y, char x, char z) {
        return "\x09" + std::string(6, '\0') + y + zeros + x + '\xff' + z + std::string(3, '\0');
    };
    Save(folder / "b.pcd", head + "DATA binary\n" + row("\xf8\x3f", '\xfe', 3) + row("\x04\x40", '\xfd', 4));
    EXPECT_THAT(ReadPoints(folder / "b.pcd").positions, testing::ElementsAre(-2, 1.5, 3, -3, 2.5, 4));
}

TEST(Points, PlyGivesVerticesWithTheirNormals) {
    const PointCloud cloud = ReadPoints(Corpus("points_normals.ply"));
    EXPECT_EQ(cloud.positions, CorpusPositions());
    EXPECT_EQ(cloud.normals, CorpusNormals());
    EXPECT_THAT(cloud.notes, testing::IsEmpty());
    const PointCloud mesh = ReadPoints(Corpus("ply_little.ply"));
    EXPECT_EQ(mesh.positions, ReadMesh(Corpus("ply_little.ply")).positions);
    EXPECT_FALSE(mesh.has_normals());
    EXPECT_THAT(mesh.notes, testing::Contains(testing::EndsWith("left out")));
}

TEST(Lzf, LiteralsAndRepetitionsThatReachIntoThemselvesAreExpanded) {
    using Internal::ExpandLzf;
    // "abc", then 3 + 4 bytes from 3 back, then a long item of 2 + 7 + 5 bytes from 1 back.
    const std::string stream = std::string("\x02") + "abc" + "\xa0\x02" + "\xe0\x05" + std::string(1, '\0');
    const std::string expected = "abcabcabca" + std::string(14, 'a');
    EXPECT_EQ(ExpandLzf(stream, 24, "f"), expected);
    for (const std::int64_t n : {0, 23, 25, 100000}) EXPECT_THROW(ExpandLzf(stream, n, "f"), IoError) << n;
    EXPECT_THROW(ExpandLzf(stream.substr(0, 7), 24, "f"), IoError);
    EXPECT_THROW(ExpandLzf("\x20\x05", 3, "f"), IoError) << "nothing lies before the beginning";
}

// ---- What is refused ----

struct BadFile {
    std::string name;
    std::string bytes;
    std::string says;
};

std::string Pcd(const std::string& rest) {
    return "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 1\n" + rest;
}

const std::vector<BadFile> kBadPoints = {
    {"unknown.stl", "x", "the extension '.stl' is unknown; known are .xyz, .pts"},
    {"comment.xyz", "# nothing\n", "holds no points"},
    {"two.xyz", "0 0 0\n1 1\n", "line 2: 2 numbers, but 3 in the lines before"},
    {"columns.xyz", "# a\n0 0\n", "line 2: 2 numbers; a point needs x y z"},
    {"word.xyz", "0 0 0\r1 a 1\r", "line 2: expected a coordinate, found 'a'"},
    {"nan.xyz", "0 0 0\n0 nan 0\n", "line 2: a coordinate is not a finite number"},
    {"large.xyz", "0 0 1e999\n", "line 1: a coordinate is not a finite number"},
    {"count.pts", "3\n0 0 0\n", "3 points are announced, 1 are there"},
    {"broken.pts", "2.5\n0 0 0\n", "line 1: a single number must be the number of points"},
    {"header.pcd", "# .PCD v0.7\nVERSION 0.7\n", "the header has no DATA"},
    {"fields.pcd", "FIELDS x y\nSIZE 4 4\nTYPE F F\nWIDTH 1\nHEIGHT 1\nDATA ascii\n0 0\n", "there is no z"},
    {"type.pcd", "FIELDS x y z\nSIZE 4 4 3\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nDATA ascii\n", "'F' of 3 bytes is unknown"},
    {"entries.pcd", "FIELDS x y z\nSIZE 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nDATA ascii\n", "an entry for each"},
    {"huge.pcd", "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 99999999999\nDATA binary\n", "99999999999 points are"},
    {"sizes.pcd", Pcd("POINTS 3\nDATA ascii\n"), "3 points in 2 x 1"},
    {"data.pcd", Pcd("DATA xml\n"), "'xml' is unknown"},
    {"short.pcd", Pcd("DATA ascii\n0.5 0.5 0.5 0.5 0.5\n"), "expected a number of point 1, found the end"},
    {"bytes.pcd", Pcd("DATA binary\n" + std::string(23, 'a')), "2 points are announced, but only 23 bytes follow"},
    {"bomb.pcd", Pcd("DATA binary_compressed\n" + std::string("\2\0\0\0\x18\0\0\0", 8) + "\xff\xff"), "damaged"},
    {"all.pcd", Pcd("DATA ascii\nnan 0 0 0 nan 0\n"), "holds no points"},
    {"nan.ply",
     "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
     "end_header\n0 nan 0\n",
     "not a finite number"},
};

class BadPoints : public testing::TestWithParam<BadFile> {};

TEST_P(BadPoints, FileGivesOneLineThatNamesIt) {
    TemporaryFolder folder;
    const auto path = folder / GetParam().name;
    Save(path, GetParam().bytes);
    const std::string message = ErrorOf([&] { ReadPoints(path); });
    EXPECT_THAT(message, testing::StartsWith(path.string() + ": "));
    EXPECT_THAT(message, testing::HasSubstr(GetParam().says));
    EXPECT_EQ(message.find('\n'), message.npos);
}

INSTANTIATE_TEST_SUITE_P(Files, BadPoints, testing::ValuesIn(kBadPoints),
                         [](const auto& bad) { return TestNameOf(bad.param.name); });

// ---- Damage ----

void ExpectConsistent(const PointCloud& cloud) {
    const auto finite = [](const std::vector<double>& values) {
        return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
    };
    ASSERT_EQ(cloud.positions.size() % 3, 0u);
    ASSERT_TRUE(!cloud.has_normals() || cloud.normals.size() == cloud.positions.size());
    ASSERT_TRUE(finite(cloud.positions) && finite(cloud.normals));
}

ReadDamaged PointReaderOf(const std::filesystem::path& path) {
    const std::string extension = path.extension();
    const auto parse = extension == ".pcd"   ? Internal::ParsePcd
                       : extension == ".ply" ? Internal::ParsePlyPoints
                                             : Internal::ParseXyz;
    return [parse](const std::string& bytes) { ExpectConsistent(parse(bytes, "damaged")); };
}

bool HoldsPoints(const std::filesystem::path& path) { return path.filename().string().starts_with("points_"); }

class DamagedPoints : public testing::TestWithParam<std::string> {};

TEST_P(DamagedPoints, TruncatedAnywhere) {
    TruncateAnywhere(PointReaderOf(Corpus(GetParam())), Load(Corpus(GetParam())));
}

TEST_P(DamagedPoints, ChangedAnywhere) { ChangeAnywhere(PointReaderOf(Corpus(GetParam())), Load(Corpus(GetParam()))); }

INSTANTIATE_TEST_SUITE_P(Corpus, DamagedPoints, testing::ValuesIn(CorpusFiles(HoldsPoints)),
                         [](const auto& file) { return TestNameOf(file.param); });

// ---- Elsewhere ----

TEST(RealPoints, AScanOfACactusIsRead) {
    const auto path = RealData("points/hoppe_cactus.pts");
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "the scan: there is no " << path;
    const PointCloud cloud = ReadPoints(path);
    EXPECT_EQ(cloud.n_points(), 3318);  // the data's own list says so
    EXPECT_FALSE(cloud.has_normals());
}

}  // namespace
}  // namespace SolidSubdiv::Io

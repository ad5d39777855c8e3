// SPDX-License-Identifier: Apache-2.0
// OBJ files whose vertices and normals are moved and whose other lines stay.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/kit/io/obj_text.h>
#include <solidsubdiv/sdc/errors.h>

#include <fstream>
#include <sstream>

#include "temporary_folder.h"

namespace SolidSubdiv::Io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ObjTexts : public testing::Test {
  protected:
    std::filesystem::path Write(const std::string& text) const {
        std::ofstream(folder_ / "in.obj", std::ios::binary) << text;
        return folder_ / "in.obj";
    }
    static std::string Read(const std::filesystem::path& path) {
        std::ostringstream text;
        text << std::ifstream(path, std::ios::binary).rdbuf();
        return text.str();
    }

    const TemporaryFolder folder_;
};

TEST_F(ObjTexts, KeepWhatTheyDoNotKnow) {
    const ObjText text(
        Write("# a comment\r\nmtllib x.mtl\nv 0 0 0 0.5 0.25 1 # red\nv 1 0 0\nv 0 1 0\nvt 0 1\n"
              "vn 0 0 1\nusemtl skin\ns 1\nf 1/1/1 2/1/1 3/1/-1 # face 1/1/1\nf 3 2 1\ncurv 0 1 1 2\n"
              "t crease 2/1/0 0 1 3\nl 1 2"));
    EXPECT_EQ(text.n_vertices(), 3);
    EXPECT_THAT(text.normal_vertices(), ElementsAre(0, 1, 2));
    EXPECT_THAT(text.normals(), ElementsAre(0, 0, 1, 0, 0, 1, 0, 0, 1));
    text.Write(folder_ / "out.obj", std::vector<double>{0, 0, 2, 1, 0, 2, 0, 1.5, 2},
               std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1});
    EXPECT_EQ(Read(folder_ / "out.obj"),
              "# a comment\r\nmtllib x.mtl\nv 0 0 2 0.5 0.25 1 # red\nv 1 0 2\nv 0 1.5 2\nvt 0 1\n"
              "usemtl skin\ns 1\nvn 1 0 0\nvn 0 1 0\nvn 0 0 1\nf 1/1/1 2/1/2 3/1/3\nf 3 2 1\ncurv 0 1 1 2\n"
              "t crease 2/1/0 0 1 3\nl 1 2");
}

TEST_F(ObjTexts, PairsOfAVertexAndANormal_StandOnce) {
    const ObjText text(
        Write("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\nvn 0 0 -1\n"
              "f 1//1 2//1 3//1\nf -2//1 2//1 \\\n 4//1\nf 1//2 3//2 2//-1\n"));
    EXPECT_THAT(text.normal_vertices(), ElementsAre(0, 1, 2, 3, 0, 2, 1));
    text.Write(folder_ / "out.obj", std::vector<double>(12), std::vector<double>(21));
    EXPECT_THAT(Read(folder_ / "out.obj"), HasSubstr("f 1//1 2//2 3//3\nf -2//3 2//2 4//4\nf 1//5 3//6 2//7\n"));
    EXPECT_EQ(ReadMesh(folder_ / "out.obj").topology.n_triangles(), 3);
}

TEST_F(ObjTexts, OfMovedPositions_AreReadWithTheirBits) {
    const std::vector<double> positions = {0.1, 1.0 / 3, -2e-300, 1e17, 0, -0.7, 5e-324, 1, 2};
    ObjText(Write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3")).Write(folder_ / "out.obj", positions, {});
    EXPECT_EQ(ReadMesh(folder_ / "out.obj").positions, positions);
}

TEST_F(ObjTexts, ThatAreWrong_AreRefused) {
    const auto message = [&](const std::string& bytes) -> std::string {
        try {
            ObjText text(Write(bytes));
        } catch (const IoError& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_THAT(message("v 0 0 0\nvn 0 0 1\nf 1//2 1//1 1//1\n"), HasSubstr("names normal 2 of vertex 1"));
    EXPECT_THAT(message("v 0 0 0\nvn 0 0 1\nf 1//-2 1//1 1//1\n"), HasSubstr("'-2' is none"));
    EXPECT_THAT(message("v 0 0 0\nvn 0 0 1\nf 9//1 1//1 1//1\n"), HasSubstr("normal 1 of vertex 9"));
    EXPECT_THAT(message("v 0 0 0\nvn 0 x 1\n"), HasSubstr("a normal"));
    EXPECT_THROW(ObjText(Write("v 0 0 0\n")).Write(folder_ / "out.obj", std::vector<double>(6), {}), InvalidInput);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out.obj"));
}

}  // namespace
}  // namespace SolidSubdiv::Io

// SPDX-License-Identifier: Apache-2.0
// Grids in files: what is written is read, what is no such file is refused, what fails leaves nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/sdc/errors.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "apps/voxel/voxel_testing.h"
#include "temporary_folder.h"

namespace SolidSubdiv::Voxel {
namespace {

using namespace TestShapes;
namespace fs = std::filesystem;

class VdbFiles : public testing::Test {
  protected:
    Grids AllKinds() const {
        return solid_.Voxelize({.voxel_size = 0.125,
                                .kind = Kind::Both,
                                .attributes = {{"height", 1, heights_}, {"position", 3, solid_.positions}},
                                .jacobian = true,
                                .cell_id = true,
                                .level_id = true});
    }
    static std::string ReadError(const fs::path& path) {
        try {
            Grids::Read(path);
        } catch (const IoError& error) {
            return error.what();
        }
        return "no error";
    }

    const TemporaryFolder folder_;
    Solid solid_ = SolidOf("mixed", Jittered(MixedCells(), 0.05, 2));
    std::vector<double> heights_ = [this] {
        std::vector<double> heights;
        for (std::size_t i = 2; i < solid_.positions.size(); i += 3) heights.push_back(solid_.positions[i] + 1.0 / 3);
        return heights;
    }();
};

TEST_F(VdbFiles, WhatIsWrittenIsRead) {
    const Grids written = AllKinds();
    written.Write(folder_ / "all.vdb");
    const Grids read = Grids::Read(folder_ / "all.vdb");
    const auto before = written.Describe(), after = read.Describe();
    ASSERT_EQ(before.size(), 7u);
    ASSERT_EQ(after.size(), before.size());
    const VoxelBox box = BoxAround(solid_, 0.125, 5);
    for (std::size_t i = 0; i < before.size(); ++i) {
        const GridInfo &a = before[i], &b = after[i];
        SCOPED_TRACE(a.name);
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.type, b.type);
        EXPECT_EQ(a.grid_class, b.grid_class);
        EXPECT_EQ(a.active_voxels, b.active_voxels);
        EXPECT_EQ(a.low, b.low);
        EXPECT_EQ(a.high, b.high);
        EXPECT_EQ(a.voxel_size, b.voxel_size);
        EXPECT_EQ(a.voxel_size, (std::array<double, 3>{0.125, 0.125, 0.125}));
        EXPECT_EQ(a.origin, b.origin);
        EXPECT_EQ(a.background, b.background);
        EXPECT_EQ(a.least, b.least);
        EXPECT_EQ(a.greatest, b.greatest);
        EXPECT_GT(a.active_voxels, 100);
        EXPECT_GT(a.bytes, 1000);
        if (a.name == "position") {
            EXPECT_EQ(written.Vectors(a.name, box.low, box.high), read.Vectors(a.name, box.low, box.high));
        } else {
            EXPECT_EQ(written.Values(a.name, box.low, box.high), read.Values(a.name, box.low, box.high));
        }
    }
    EXPECT_EQ(before[0].grid_class, "level set");
    EXPECT_EQ(before[1].grid_class, "fog volume");
    EXPECT_EQ(before[2].grid_class, "unknown");
    EXPECT_EQ(folder_.Files().size(), 1u);
}

TEST_F(VdbFiles, HalfFloatsHaveElevenBitsAndTakeLessRoom) {
    const Grids grids = AllKinds();
    grids.Write(folder_ / "whole.vdb");
    grids.Write(folder_ / "half.vdb", true);
    EXPECT_LT(fs::file_size(folder_ / "half.vdb"), fs::file_size(folder_ / "whole.vdb"));
    const Grids read = Grids::Read(folder_ / "half.vdb");
    const VoxelBox box = BoxAround(solid_, 0.125, 5);
    bool any_differs = false;
    for (const char* name : {"surface", "density", "height", "jacobian", "cell_id"}) {
        const auto a = grids.Values(name, box.low, box.high), b = read.Values(name, box.low, box.high);
        for (std::size_t i = 0; i < a.size(); ++i) {
            // Half a unit of eleven bits; smaller numbers than 6e-5 have steps of 6e-8.
            EXPECT_NEAR(b[i], a[i], std::abs(a[i]) / 2048 + 6e-8) << name;
            any_differs = any_differs || a[i] != b[i];
        }
    }
    EXPECT_TRUE(any_differs);
    EXPECT_EQ(grids.Values("cell_id", box.low, box.high), read.Values("cell_id", box.low, box.high));
    // Written whole again, nothing is lost.
    grids.Write(folder_ / "again.vdb");
    EXPECT_EQ(Grids::Read(folder_ / "again.vdb").Values("height", box.low, box.high),
              grids.Values("height", box.low, box.high));
}

TEST_F(VdbFiles, OtherFilesAreRefusedByName) {
    std::ofstream(folder_ / "text.vdb") << "this is a text, and no grid of any kind at all";
    std::ofstream(folder_ / "empty.vdb");
    for (const char* name : {"text.vdb", "empty.vdb", "missing.vdb", "."}) {
        EXPECT_THAT(ReadError(folder_ / name), testing::HasSubstr((folder_ / name).string())) << name;
    }
}

TEST_F(VdbFiles, FilesCutShortAreRefused) {
    AllKinds().Write(folder_ / "all.vdb");
    std::ostringstream text;
    text << std::ifstream(folder_ / "all.vdb", std::ios::binary).rdbuf();
    const std::string whole = text.str();
    std::vector<std::size_t> sizes;
    for (std::size_t n = 0; n < 40; ++n) sizes.push_back(n);
    for (std::size_t part = 1; part < 40; ++part) sizes.push_back(whole.size() * part / 40);
    for (std::size_t n : {1, 2, 8, 100}) sizes.push_back(whole.size() - n);
    for (std::size_t n : sizes) {
        std::ofstream(folder_ / "cut.vdb", std::ios::binary) << whole.substr(0, n);
        EXPECT_THAT(ReadError(folder_ / "cut.vdb"), testing::HasSubstr("cut.vdb")) << n << " of " << whole.size();
    }
}

TEST_F(VdbFiles, WhatCantBeWrittenLeavesNothing) {
    const Grids grids = AllKinds();
    fs::create_directories(folder_ / "taken.vdb" / "folder");
    std::ofstream(folder_ / "file") << "a file";
    EXPECT_THROW(grids.Write(folder_ / "missing" / "a.vdb"), IoError);
    EXPECT_THROW(grids.Write(folder_ / "file" / "a.vdb"), IoError);
    EXPECT_THROW(grids.Write(folder_ / "taken.vdb"), IoError);
    EXPECT_EQ(folder_.Files().size(), 2u);
    try {
        grids.Write(folder_ / "missing" / "a.vdb");
    } catch (const IoError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("missing/a.vdb"));
    }
}

TEST_F(VdbFiles, QuestionsThatHaveNoAnswerAreRefused) {
    const Grids grids = AllKinds();
    const Voxel3 zero{0, 0, 0};
    EXPECT_THROW(grids.Values("nothing", zero, zero), InvalidInput);
    EXPECT_THROW(grids.Values("position", zero, zero), InvalidInput);
    EXPECT_THROW(grids.Vectors("surface", zero, zero), InvalidInput);
    EXPECT_THROW(grids.Values("surface", zero, {0, -1, 0}), InvalidInput);
    EXPECT_THROW(grids.Values("surface", zero, {2000, 2000, 2000}), InvalidInput);
    EXPECT_THROW(grids.Surface("nothing", 0), InvalidInput);
    EXPECT_THROW(grids.Surface("cell_id", 0), InvalidInput);
}

}  // namespace
}  // namespace SolidSubdiv::Voxel

// SPDX-License-Identifier: Apache-2.0
// Grids in files whose bytes were changed: refused, or read as something else, but never the end of the program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/sdc/errors.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "apps/voxel/voxel_testing.h"
#include "sanitized.h"
#include "temporary_folder.h"

namespace SolidSubdiv::Voxel {
namespace {

using namespace TestShapes;
using testing::HasSubstr;
namespace fs = std::filesystem;

class DamagedFiles : public testing::Test {
  protected:
    void SetUp() override {
        const Solid solid = SolidOf("mixed", Jittered(MixedCells(), 0.05, 2));
        const Grids grids = solid.Voxelize({.voxel_size = 0.25,
                                            .kind = Kind::Both,
                                            .attributes = {{"place", 3, solid.positions}},
                                            .jacobian = true,
                                            .cell_id = true});
        for (bool half : {false, true}) {
            grids.Write(folder_ / "good.vdb", half);
            std::ostringstream text;
            text << std::ifstream(folder_ / "good.vdb", std::ios::binary).rdbuf();
            good_.push_back(text.str());
        }
    }

    /// What is wrong with these bytes; nothing if they can be read.
    std::string ErrorOf(const std::string& bytes) const {
        std::ofstream(folder_ / "bad.vdb", std::ios::binary) << bytes;
        try {
            Grids::Read(folder_ / "bad.vdb").Describe();
        } catch (const IoError& error) {
            EXPECT_THAT(error.what(), HasSubstr("bad.vdb"));
            return error.what();
        }
        return "";
    }
    template <class Number>
    static void Put(std::string& bytes, std::size_t at, Number number) {
        std::memcpy(&bytes[at], &number, sizeof(number));
    }
    template <class Number>
    static Number Get(const std::string& bytes, std::size_t at) {
        Number number;
        std::memcpy(&number, &bytes[at], sizeof(number));
        return number;
    }
    /// Places of bytes before which a number of 64 bits says how many they are, with a minus, and of how many.
    static std::vector<std::size_t> SizesOfUnpackedValues(const std::string& bytes) {
        std::vector<std::size_t> places;
        for (std::size_t i = 0; i + 8 <= bytes.size(); ++i) {
            const auto size = Get<std::int64_t>(bytes, i);
            if (size < 0 && size >= -6144 && size % 2 == 0) places.push_back(i);
        }
        return places;
    }

    const TemporaryFolder folder_;
    std::vector<std::string> good_;  ///< with numbers of 32 bits, and of 16
};

TEST_F(DamagedFiles, ChangedBytesNeverCrash) {
    Random random(1);
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random.Next() % n); };
    int n_refused = 0;
    const int n_files = FewerIfSanitized(600);
    for (int i = 0; i < n_files; ++i) {
        std::string bytes = good_[static_cast<std::size_t>(i) % 2];
        const std::size_t at = below(i % 3 == 0 ? 4000 : bytes.size() - 64);  // the beginning is full of lengths
        if (i % 5 == 0) bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
        if (i % 5 == 1) Put(bytes, at, static_cast<std::uint32_t>(random.Next()));
        if (i % 5 == 2) Put(bytes, at, std::uint64_t{1} << below(64));
        if (i % 5 == 3) bytes.erase(at, 1 + below(60));
        if (i % 5 == 4) {
            const auto sizes = SizesOfUnpackedValues(bytes);
            Put(bytes, sizes[below(sizes.size())], -static_cast<std::int64_t>(below(1000000)));
        }
        n_refused += !ErrorOf(bytes).empty();
    }
    EXPECT_GT(n_refused, n_files / 2);
    EXPECT_LT(n_refused, n_files);  // changed values are values
    for (const std::string& bytes : good_) EXPECT_EQ(ErrorOf(bytes), "");
}

TEST_F(DamagedFiles, ValuesThatDontFitTheirNodeAreRefused_WithTheirSizes) {
    // OpenVDB writes as many bytes as a file says into a buffer for those that it should say.
    int n_named = 0;
    for (std::size_t place : SizesOfUnpackedValues(good_[0])) {
        std::string bytes = good_[0];
        Put(bytes, place, Get<std::int64_t>(bytes, place) - 20000);
        const std::string error = ErrorOf(bytes);
        n_named += error.find("bytes are said to have 2") != std::string::npos;
    }
    EXPECT_GT(n_named, 0);
}

TEST_F(DamagedFiles, LengthsAndCountsBeyondTheFileAreRefused_BeforeMemoryIsTaken) {
    const struct {
        std::size_t place;
        const char* error;
    } cases[] = {{8, "its format has the number 2147483647"},
                 {57, "it ends too early"},  // a count of metadata
                 {61, "it can't have 2147483647 grids"},
                 {65, "it ends too early"}};  // the length of a name
    ASSERT_EQ(Get<std::int32_t>(good_[0], 61), 5);
    for (const auto& c : cases) {
        std::string bytes = good_[0];
        Put(bytes, c.place, std::int32_t{0x7fffffff});
        EXPECT_THAT(ErrorOf(bytes), HasSubstr(c.error));
    }
}

}  // namespace
}  // namespace SolidSubdiv::Voxel

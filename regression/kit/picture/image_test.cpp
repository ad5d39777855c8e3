// SPDX-License-Identifier: Apache-2.0
// Images and PNG files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/kit/picture/image.h>
#include <solidsubdiv/sdc/errors.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "temporary_folder.h"

namespace SolidSubdiv::Picture {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class PngTest : public testing::Test {
  protected:
    const TemporaryFolder folder_;
};

Image Gradient(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            image.Set(x, y,
                      {static_cast<float>(x) / 255.f, static_cast<float>(y) / 255.f,
                       static_cast<float>((7 * x + 3 * y) % 256) / 255.f});
        }
    }
    return image;
}

template <class Action>
std::string ErrorOf(Action&& action) {
    try {
        action();
    } catch (const IoError& error) {
        return error.what();
    }
    return "no IoError";
}

TEST_F(PngTest, WhatIsWrittenIsReadBackBitByBit) {
    const Image image = Gradient(201, 77);
    WritePng(folder_ / "a.png", image);
    EXPECT_EQ(ReadPng(folder_ / "a.png"), image);
    EXPECT_EQ(folder_.Files().size(), 1u);
}

TEST_F(PngTest, FileIsAPngOfTheImagesSize) {
    WritePng(folder_ / "a.png", Gradient(201, 77));
    std::ifstream file(folder_ / "a.png", std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    ASSERT_GT(bytes.size(), 33u);
    EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(bytes.substr(12, 4), "IHDR");
    EXPECT_EQ(bytes.substr(16, 8), std::string("\0\0\0\xc9\0\0\0\x4d", 8));
}

TEST_F(PngTest, EncodedBytesAreThoseOfTheFile) {
    WritePng(folder_ / "a.png", Gradient(201, 77));
    std::ifstream file(folder_ / "a.png", std::ios::binary);
    const std::vector<std::uint8_t> written{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(EncodePng(Gradient(201, 77)), written);
    EXPECT_THROW(EncodePng(Image()), InvalidInput);
}

TEST_F(PngTest, AnExistingFileIsReplaced) {
    WritePng(folder_ / "a.png", Gradient(20, 20));
    WritePng(folder_ / "a.png", Gradient(30, 10));
    EXPECT_EQ(ReadPng(folder_ / "a.png"), Gradient(30, 10));
}

TEST_F(PngTest, BadPathsThrowIoErrorNamingTheFileAndLeaveNothing) {
    const Image image = Gradient(4, 4);
    EXPECT_THAT(ErrorOf([&] { WritePng(folder_ / "missing" / "a.png", image); }),
                AllOf(StartsWith((folder_ / "missing" / "a.png").string()), HasSubstr("No such file or directory")));
    fs::create_directory(folder_ / "is_a_folder.png");
    EXPECT_THAT(ErrorOf([&] { WritePng(folder_ / "is_a_folder.png", image); }),
                HasSubstr("is_a_folder.png: cannot be written"));
    EXPECT_EQ(folder_.Files().size(), 1u);
}

TEST_F(PngTest, BrokenFilesAreRefused) {
    EXPECT_THAT(ErrorOf([&] { ReadPng(folder_ / "none.png"); }), HasSubstr("none.png: cannot be read"));
    WritePng(folder_ / "a.png", Gradient(50, 50));
    fs::resize_file(folder_ / "a.png", fs::file_size(folder_ / "a.png") / 2);
    EXPECT_THAT(ErrorOf([&] { ReadPng(folder_ / "a.png"); }), HasSubstr("a.png: cannot be read"));
    std::ofstream(folder_ / "text.png") << "not a picture";
    EXPECT_THAT(ErrorOf([&] { ReadPng(folder_ / "text.png"); }), HasSubstr("text.png: cannot be read"));
}

TEST(ImageTest, SizesOutOfRangeAreRefused) {
    EXPECT_THROW(Image(0, 5), InvalidInput);
    EXPECT_THROW(Image(5, -1), InvalidInput);
    EXPECT_THROW(Image(32769, 1), InvalidInput);
    EXPECT_THROW(Image::FromBytes(2, 2, std::vector<std::uint8_t>(11)), InvalidInput);
    EXPECT_NO_THROW(Image::FromBytes(2, 2, std::vector<std::uint8_t>(12)));
}

TEST(ImageTest, BlendMixesAndIgnoresWhatLiesOutside) {
    Image image(3, 1, {0, 0, 0});
    image.Blend(1, 0, {1, 1, 1}, 0.5f);
    image.Blend(2, 0, {1, 0, 0}, 1);
    for (auto [x, y] : {std::pair{-1, 0}, {3, 0}, {0, -1}, {0, 1}}) image.Blend(x, y, {1, 1, 1}, 1);
    EXPECT_EQ(image.bytes(), (std::vector<std::uint8_t>{0, 0, 0, 128, 128, 128, 255, 0, 0}));
}

TEST(ImageTest, PasteCutsOffWhatLiesOutside) {
    const Image small(3, 3, {1, 0, 0});
    for (auto [x, y, red] :
         {std::tuple{1, 1, 9}, {-2, -2, 1}, {4, 4, 1}, {-2, 1, 3}, {5, 0, 0}, {-3, 0, 0}, {0, 9, 0}}) {
        Image image(5, 5, {0, 0, 0});
        image.Paste(small, x, y);
        int n = 0;
        for (int py = 0; py < 5; ++py) {
            for (int px = 0; px < 5; ++px) {
                const bool inside = px >= x && px < x + 3 && py >= y && py < y + 3;
                EXPECT_EQ(image.At(px, py).r, inside ? 1.f : 0.f);
                n += inside ? 1 : 0;
            }
        }
        EXPECT_EQ(n, red);
    }
}

}  // namespace
}  // namespace SolidSubdiv::Picture

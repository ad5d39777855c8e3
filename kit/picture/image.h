// SPDX-License-Identifier: Apache-2.0
// An image in memory, and PNG files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include <solidsubdiv/kit/picture/color.h>

namespace SolidSubdiv::Picture {

/// Rows from the top, pixels from the left, three bytes each (red, green, blue, sRGB).
class Image {
  public:
    Image() = default;
    /// @throws InvalidInput unless both sizes are in [1, 32768]
    Image(int width, int height, Color fill = {1, 1, 1});
    /// Takes finished bytes. @throws InvalidInput also unless there are width * height * 3
    static Image FromBytes(int width, int height, std::vector<std::uint8_t> bytes);

    int width() const { return width_; }
    int height() const { return height_; }
    const std::vector<std::uint8_t>& bytes() const { return bytes_; }  ///< (height, width, 3)

    /// @pre 0 <= x < width, 0 <= y < height
    Color At(int x, int y) const;
    void Set(int x, int y, Color color);
    /// Mixes `color` over the pixel: cover 0 leaves it, 1 replaces it. Pixels outside are ignored.
    void Blend(int x, int y, Color color, float cover);
    /// Copies `other` with its upper left corner at (x, y); what lies outside is cut off.
    void Paste(const Image& other, int x, int y);

    friend bool operator==(const Image&, const Image&) = default;

  private:
    std::uint8_t* Pixel(int x, int y) { return &bytes_[(static_cast<std::size_t>(y) * width_ + x) * 3]; }
    const std::uint8_t* Pixel(int x, int y) const { return &bytes_[(static_cast<std::size_t>(y) * width_ + x) * 3]; }

    int width_ = 0, height_ = 0;
    std::vector<std::uint8_t> bytes_;
};

/// Writes beside the file and renames, so that no partial file is left. @throws IoError
void WritePng(const std::filesystem::path& path, const Image& image);

/// The bytes that WritePng writes.
std::vector<std::uint8_t> EncodePng(const Image& image);

/// Reads any PNG as sRGB without transparency (over white). @throws IoError
Image ReadPng(const std::filesystem::path& path);

}  // namespace SolidSubdiv::Picture

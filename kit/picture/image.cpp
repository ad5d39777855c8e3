// SPDX-License-Identifier: Apache-2.0
// Pixels in memory; see image.h.
#include <solidsubdiv/kit/picture/image.h>
#include <solidsubdiv/sdc/errors.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace SolidSubdiv::Picture {
namespace {

std::uint8_t ToByte(float x) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.f, 1.f))); }

std::size_t CheckedBytes(int width, int height) {
    if (width < 1 || height < 1 || width > 32768 || height > 32768) {
        throw InvalidInput("image: " + std::to_string(width) + " x " + std::to_string(height) +
                           " pixels; both sizes must be from 1 to 32768");
    }
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3;
}

}  // namespace

Image::Image(int width, int height, Color fill) : width_(width), height_(height), bytes_(CheckedBytes(width, height)) {
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) Set(x, y, fill);
    }
}

Image Image::FromBytes(int width, int height, std::vector<std::uint8_t> bytes) {
    const std::size_t expected = CheckedBytes(width, height);
    if (bytes.size() != expected) {
        throw InvalidInput("image: " + std::to_string(bytes.size()) + " bytes given where " + std::to_string(expected) +
                           " are needed");
    }
    Image image;
    image.width_ = width;
    image.height_ = height;
    image.bytes_ = std::move(bytes);
    return image;
}

Color Image::At(int x, int y) const {
    const std::uint8_t* p = Pixel(x, y);
    return {static_cast<float>(p[0]) / 255, static_cast<float>(p[1]) / 255, static_cast<float>(p[2]) / 255};
}

void Image::Set(int x, int y, Color color) {
    std::uint8_t* p = Pixel(x, y);
    p[0] = ToByte(color.r);
    p[1] = ToByte(color.g);
    p[2] = ToByte(color.b);
}

void Image::Blend(int x, int y, Color color, float cover) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
    const Color old = At(x, y);
    const auto mix = [cover](float a, float b) { return a + cover * (b - a); };
    Set(x, y, {mix(old.r, color.r), mix(old.g, color.g), mix(old.b, color.b)});
}

void Image::Paste(const Image& other, int x, int y) {
    const int first = std::max(0, -x), last = std::min(other.width_, width_ - x);
    if (first >= last) return;
    for (int row = std::max(0, -y); row < std::min(other.height_, height_ - y); ++row) {
        std::copy(other.Pixel(first, row), other.Pixel(first, row) + 3 * (last - first), Pixel(x + first, y + row));
    }
}

}  // namespace SolidSubdiv::Picture

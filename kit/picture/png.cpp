// SPDX-License-Identifier: Apache-2.0
// PNG files by libpng's simplified interface, which reports errors by value; see image.h.
#include <png.h>
#include <solidsubdiv/kit/picture/image.h>
#include <solidsubdiv/sdc/errors.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <system_error>

namespace SolidSubdiv::Picture {
namespace {

[[noreturn]] void Fail(const std::filesystem::path& path, const std::string& why) {
    throw IoError(path.string() + ": " + why);
}

/// Removes a half-written file unless told that it is complete.
struct PartialFile {
    std::filesystem::path path;
    bool complete = false;
    ~PartialFile() {
        std::error_code ignored;
        if (!complete) std::filesystem::remove(path, ignored);
    }
};

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

png_image Header(const Image& image) {
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32>(image.width());
    header.height = static_cast<png_uint_32>(image.height());
    header.format = PNG_FORMAT_RGB;
    return header;
}

}  // namespace

void WritePng(const std::filesystem::path& path, const Image& image) {
    if (image.width() == 0) throw InvalidInput("WritePng: the image for " + path.string() + " has no pixels");
    PartialFile partial{path.string() + ".partial"};
    File file(std::fopen(partial.path.c_str(), "wb"), &std::fclose);
    if (!file) {
        partial.complete = true;  // nothing of ours is there to be removed
        Fail(path, std::string("cannot be written: ") + std::strerror(errno));
    }
    png_image header = Header(image);
    const bool written = png_image_write_to_stdio(&header, file.get(), 0, image.bytes().data(), 0, nullptr) != 0;
    const std::string message = header.message;
    png_image_free(&header);
    if (!written) Fail(path, "cannot be written: " + message);
    if (std::fclose(file.release()) != 0) Fail(path, std::string("cannot be written: ") + std::strerror(errno));

    std::error_code error;
    std::filesystem::rename(partial.path, path, error);
    if (error) Fail(path, "cannot be written: " + error.message());
    partial.complete = true;
}

std::vector<std::uint8_t> EncodePng(const Image& image) {
    if (image.width() == 0) throw InvalidInput("EncodePng: the image has no pixels");
    png_image header = Header(image);
    // As much as the worst picture takes, cut to what this one took.
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
    std::vector<std::uint8_t> bytes(size);
    const bool encoded =
        png_image_write_to_memory(&header, bytes.data(), &size, 0, image.bytes().data(), 0, nullptr) != 0;
    const std::string message = header.message;
    png_image_free(&header);
    if (!encoded) throw Error("EncodePng: " + message);
    bytes.resize(size);
    return bytes;
}

Image ReadPng(const std::filesystem::path& path) {
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&header, path.c_str()))
        Fail(path, std::string("cannot be read: ") + header.message);
    const std::unique_ptr<png_image, void (*)(png_image*)> guard(&header, &png_image_free);
    if (header.width > 32768 || header.height > 32768)
        Fail(path, "cannot be read: more than 32768 pixels wide or high");
    header.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(header));
    const png_color white{255, 255, 255};
    if (!png_image_finish_read(&header, &white, bytes.data(), 0, nullptr)) {
        Fail(path, std::string("cannot be read: ") + header.message);
    }
    return Image::FromBytes(static_cast<int>(header.width), static_cast<int>(header.height), std::move(bytes));
}

}  // namespace SolidSubdiv::Picture

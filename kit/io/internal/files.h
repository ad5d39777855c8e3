// SPDX-License-Identifier: Apache-2.0
// Whole files in, whole files out: a file that could not be written completely is never seen under its name.
#pragma once

#include <charconv>
#include <concepts>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace SolidSubdiv::Io::Internal {

/// The file's bytes. @throws IoError if it isn't a readable regular file
std::string ReadWholeFile(const std::filesystem::path& path);

/// The file's name for messages.
inline std::string NameOf(const std::filesystem::path& path) { return path.string(); }

/// Writes to a new file beside `path`, which takes that name on Commit() and is removed otherwise.
class OutputFile {
  public:
    explicit OutputFile(const std::filesystem::path& path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void Write(const void* data, std::size_t n_bytes);
    OutputFile& operator<<(std::string_view text) { return Append(text.data(), text.size()); }
    OutputFile& operator<<(char c) { return Append(&c, 1); }
    /// Shortest text that reads back as the same number.
    OutputFile& operator<<(double value) { return AppendNumber(value); }
    template <std::integral T>
    OutputFile& operator<<(T value) {
        return AppendNumber(value);
    }

    /// Writes what is left; with several files, all are closed before the first is committed.
    /// @throws IoError if anything could not be written
    void Close();
    void Commit();

  private:
    OutputFile& Append(const char* text, std::size_t n);
    template <class T>
    OutputFile& AppendNumber(T value) {
        char digits[40];
        const auto result = std::to_chars(digits, digits + sizeof(digits), value);
        return Append(digits, static_cast<std::size_t>(result.ptr - digits));
    }
    void Flush();
    [[noreturn]] void FailToWrite();

    std::filesystem::path path_;
    std::filesystem::path temporary_;
    std::FILE* file_ = nullptr;
    std::string buffer_;
};

}  // namespace SolidSubdiv::Io::Internal

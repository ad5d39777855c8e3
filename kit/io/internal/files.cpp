// SPDX-License-Identifier: Apache-2.0
// Whole files in, whole files out.
#include <solidsubdiv/kit/io/internal/files.h>

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <memory>
#include <system_error>

#include <solidsubdiv/kit/io/internal/text.h>

namespace SolidSubdiv::Io::Internal {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kBufferSize = 1 << 20;

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

std::string SystemMessage(int code) { return std::generic_category().message(code); }

}  // namespace

std::string ReadWholeFile(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) Fail(NameOf(path), "there is no such file");
    if (fs::is_directory(status)) Fail(NameOf(path), "is a directory, not a file");
    if (!fs::is_regular_file(status)) Fail(NameOf(path), "is not a regular file");

    const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
    if (!file) Fail(NameOf(path), "can't be opened: " + SystemMessage(errno));
    const std::uintmax_t size = fs::file_size(path, error);
    if (error) Fail(NameOf(path), "can't be read: " + error.message());
    std::string bytes(static_cast<std::size_t>(size), '\0');
    const std::size_t n_read = std::fread(bytes.data(), 1, bytes.size(), file.get());
    if (n_read != bytes.size()) Fail(NameOf(path), "can't be read to its end");
    if (bytes.empty()) Fail(NameOf(path), "the file is empty");
    return bytes;
}

OutputFile::OutputFile(const fs::path& path) : path_(path) {
    if (fs::is_directory(path)) Fail(NameOf(path), "is a directory; name a file");
    // Another process may have our number, in a container that shares the folder, or had it and was stopped.
    static std::atomic<int> counter = 0;
    do {
        temporary_ = path.parent_path() /
                     (".solidsubdiv-" + std::to_string(getpid()) + "-" + std::to_string(counter++) + ".part");
        file_ = std::fopen(temporary_.c_str(), "wbx");
    } while (!file_ && errno == EEXIST);
    if (!file_) Fail(NameOf(path_), "can't be written: " + SystemMessage(errno));
    buffer_.reserve(kBufferSize);
}

OutputFile::~OutputFile() {
    if (file_) std::fclose(file_);
    if (!temporary_.empty()) std::remove(temporary_.c_str());
}

OutputFile& OutputFile::Append(const char* text, std::size_t n) {
    if (buffer_.size() + n > kBufferSize) Flush();
    buffer_.append(text, n);
    return *this;
}

void OutputFile::Write(const void* data, std::size_t n_bytes) {
    Flush();
    if (n_bytes != 0 && std::fwrite(data, 1, n_bytes, file_) != n_bytes) FailToWrite();
}

void OutputFile::Flush() {
    if (!buffer_.empty() && std::fwrite(buffer_.data(), 1, buffer_.size(), file_) != buffer_.size()) FailToWrite();
    buffer_.clear();
}

void OutputFile::Close() {
    if (!file_) return;
    Flush();
    std::FILE* file = file_;
    file_ = nullptr;
    if (std::fclose(file) != 0) FailToWrite();
}

void OutputFile::Commit() {
    Close();
    if (std::rename(temporary_.c_str(), path_.c_str()) != 0) FailToWrite();
    temporary_.clear();
}

void OutputFile::FailToWrite() { Fail(NameOf(path_), "can't be written: " + SystemMessage(errno)); }

}  // namespace SolidSubdiv::Io::Internal

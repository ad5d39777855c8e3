// SPDX-License-Identifier: Apache-2.0
// Output files that all appear when everything has succeeded, and otherwise not at all.
#include <solidsubdiv/apps/cli/outputs.h>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <system_error>

#include <solidsubdiv/apps/cli/common.h>

namespace SolidSubdiv::Cli {

namespace fs = std::filesystem;

Outputs::~Outputs() {
    std::error_code ignored;
    for (const fs::path& folder : folders_) fs::remove_all(folder, ignored);
    for (const fs::path& folder : made_) fs::remove(folder, ignored);  // only where it is empty
}

void Outputs::MakeFolder(const fs::path& folder) {
    std::error_code error;
    if (fs::exists(folder, error) && !fs::is_directory(folder, error)) {
        throw IoError(folder.string() + ": is no folder; name one for the results");
    }
    if (fs::create_directory(folder, error)) made_.push_back(fs::absolute(folder));
    if (error) throw IoError(folder.string() + ": can't be made: " + error.message());
}

fs::path Outputs::FolderBeside(const fs::path& file) {
    const auto known = std::find_if(folders_.begin(), folders_.end(),
                                    [&](const fs::path& folder) { return folder.parent_path() == file.parent_path(); });
    if (known != folders_.end()) return *known;
    std::error_code error;
    const fs::path parent = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (!fs::is_directory(parent, error)) {
        throw IoError(file.string() + ": can't be written: there is no folder " + parent.string() + "; create it");
    }
    // No name of our choice is surely free: numbers of processes repeat, in time and in containers.
    std::string folder = (file.parent_path() / ".solidsubdiv-XXXXXX").string();
    if (!mkdtemp(folder.data())) {
        error.assign(errno, std::generic_category());
        throw IoError(file.string() + ": can't be written: " + error.message());
    }
    folders_.push_back(folder);
    return folders_.back();
}

fs::path Outputs::Stage(const fs::path& file) {
    std::error_code error;
    if (file.filename().empty()) throw IoError("'" + file.string() + "': names no file");
    // What a link points to is written, and the link stays.
    const fs::path final = fs::is_symlink(file, error) ? fs::weakly_canonical(file, error) : file;
    if (fs::is_directory(final, error)) throw IoError(file.string() + ": is a directory; name a file");
    if (fs::exists(final, error) && !fs::is_regular_file(final, error)) {
        throw IoError(file.string() + ": is not a regular file");
    }
    const fs::path absolute = fs::absolute(final, error).lexically_normal();
    if (std::find(files_.begin(), files_.end(), absolute) != files_.end()) {
        throw UsageError(file.string() + ": two outputs have this name");
    }
    const fs::path temporary = FolderBeside(final) / final.filename();
    files_.push_back(absolute);
    return temporary;
}

void Outputs::Commit() {
    for (const fs::path& folder : folders_) {
        for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
            const fs::path final = folder.parent_path() / entry.path().filename();
            std::error_code error;
            fs::rename(entry.path(), final, error);
            if (error) throw IoError(final.string() + ": can't be written: " + error.message());
        }
    }
}

std::string Outputs::WithFinalNames(std::string text) const {
    for (const fs::path& folder : folders_) {
        const std::string hidden = (folder / "").string(), open = (folder.parent_path() / "").string();
        for (std::size_t at = text.find(hidden); at != std::string::npos; at = text.find(hidden, at)) {
            text.replace(at, hidden.size(), open);
        }
    }
    return text;
}

}  // namespace SolidSubdiv::Cli

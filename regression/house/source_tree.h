// SPDX-License-Identifier: Apache-2.0
// The source tree as text: every file that people write, with its lines and what it includes.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace SolidSubdiv::House {

struct Include {
    std::string path;
    bool is_quoted;
};

struct SourceFile {
    std::string path;  ///< relative to the tree's top, with '/'
    std::vector<std::string> lines;

    bool IsCpp() const { return path.ends_with(".h") || path.ends_with(".cpp"); }

    std::vector<Include> Includes() const {
        std::vector<Include> includes;
        for (const std::string& line : lines) {
            // "#", "include" and the name may stand apart by blanks.
            std::istringstream words(line);
            std::string rest;
            if ((words >> std::ws).get() != '#' || !(words >> rest) || !rest.starts_with("include")) continue;
            rest.erase(0, 7);
            std::string after;
            std::getline(words, after);
            rest += after;
            const std::size_t open = rest.find_first_of("<\"");
            const std::size_t close = rest.find_first_of(">\"", open + 1);
            if (open == std::string::npos || close == std::string::npos) continue;
            includes.push_back({rest.substr(open + 1, close - open - 1), rest[open] == '"'});
        }
        return includes;
    }
};

/// Sources, scripts and build files below `top`, without build folders and what git keeps; sorted by path.
inline std::vector<SourceFile> ReadSourceTree(const std::filesystem::path& top) {
    namespace fs = std::filesystem;
    static const std::vector<std::string> extensions = {".h", ".cpp", ".cmake", ".py", ".sh", ".js"};
    std::vector<SourceFile> files;
    for (auto it = fs::recursive_directory_iterator(top); it != fs::recursive_directory_iterator(); ++it) {
        const std::string name = it->path().filename().string();
        if (it->is_directory()) {
            if (name == ".git" || name == ".cache" || name == "__pycache__" || it->path() == top / "build") {
                it.disable_recursion_pending();
            }
            continue;
        }
        const bool is_source = std::count(extensions.begin(), extensions.end(), it->path().extension().string()) > 0;
        const std::string path = it->path().lexically_relative(top).generic_string();
        if (name.ends_with(".min.js")) continue;  // made by a script, from packages
        if (!is_source && name != "CMakeLists.txt" && path != "dev" && path != ".ci/run") continue;
        SourceFile& file = files.emplace_back();
        file.path = path;
        std::ifstream stream(it->path());
        for (std::string line; std::getline(stream, line);) file.lines.push_back(line);
    }
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    return files;
}

}  // namespace SolidSubdiv::House

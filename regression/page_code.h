// SPDX-License-Identifier: Apache-2.0
// The code of a page of the docs beside a test that runs it: both without blanks, comments and includes.
#pragma once

#include <fstream>
#include <string>

namespace SolidSubdiv {

/// Of a page what stands between ```cpp and ```, of other files all lines. Paths are the project's.
inline std::string CodeWithoutBlanks(const std::string& path) {
    std::ifstream stream(std::string(SOLIDSUBDIV_SOURCE) + path);
    const bool is_page = path.ends_with(".md");
    std::string text, line;
    bool is_code = !is_page;
    while (std::getline(stream, line)) {
        if (is_page && line.starts_with("```")) {
            is_code = line == "```cpp";
            continue;
        }
        if (!is_code || line.starts_with("#include")) continue;
        for (char c : line.substr(0, line.find("//"))) text += c == ' ' ? "" : std::string(1, c);
    }
    return text;
}

}  // namespace SolidSubdiv

// SPDX-License-Identifier: Apache-2.0
// The form of every source file: license line, a sentence of purpose, and a length that a reader can hold.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "house/source_tree.h"

namespace SolidSubdiv::House {
namespace {

constexpr std::size_t kLongestFile = 400;
constexpr std::size_t kLongestPublicHeader = 200;

/// What is wrong with the form of a file, or an empty text.
std::string BadForm(const SourceFile& file) {
    const bool has_slashes = file.IsCpp() || file.path.ends_with(".js");
    const std::string comment = has_slashes ? "// " : "# ";
    const bool has_shebang = !file.lines.empty() && file.lines[0].starts_with("#!");
    const std::size_t first = has_shebang ? 1 : 0;
    if (file.lines.size() <= first || file.lines[first] != comment + "SPDX-License-Identifier: Apache-2.0") {
        return "no SPDX line on top";
    }
    if (!has_slashes) return {};
    if (file.lines.size() <= first + 1 || !file.lines[first + 1].starts_with(comment)) return "no sentence of purpose";
    if (file.path.ends_with(".h") && std::count(file.lines.begin(), file.lines.end(), "#pragma once") != 1) {
        return "no #pragma once";
    }
    const bool is_internal = file.path.find("/internal/") != std::string::npos;
    const bool is_public = file.path.ends_with(".h") && !is_internal && !file.path.starts_with("regression/");
    const std::size_t longest = is_public ? kLongestPublicHeader : kLongestFile;
    if (file.lines.size() > longest) {
        return std::to_string(file.lines.size()) + " lines, more than " + std::to_string(longest);
    }
    return {};
}

std::vector<std::string> BadForms(const std::vector<SourceFile>& tree) {
    std::vector<std::string> found;
    for (const SourceFile& file : tree) {
        const std::string wrong = BadForm(file);
        if (!wrong.empty()) found.push_back(file.path + ": " + wrong);
    }
    return found;
}

TEST(Form, EverySourceHasLicensePurposeAndAReadableLength) {
    EXPECT_THAT(BadForms(ReadSourceTree(SOLIDSUBDIV_SOURCE)), testing::IsEmpty());
}

TEST(Form, PlantedFaultsAreCaught) {
    const std::string license = "// SPDX-License-Identifier: Apache-2.0";
    const std::vector<std::string> good = {license, "// A purpose.", "#pragma once"};
    std::vector<std::string> long_header = good;
    long_header.resize(kLongestPublicHeader + 1);
    const std::vector<SourceFile> tree = {
        {"far/good.h", good},
        {"far/internal/long.h", long_header},
        {"dev", {"#!/usr/bin/env bash", "# SPDX-License-Identifier: Apache-2.0"}},
        {"far/bare.h", {"// A purpose.", "#pragma once"}},
        {"far/mute.cpp", {license, "int x;"}},
        {"far/twice.h", {license, "// A purpose."}},
        {"far/long.h", long_header},
        {"kit/CMakeLists.txt", {"add_subdirectory(io)"}},
        {"kit/mute.js", {license, "let x;"}},
        {"sdc/empty.cpp", {}},
    };
    EXPECT_THAT(BadForms(tree),
                testing::ElementsAre("far/bare.h: no SPDX line on top", "far/mute.cpp: no sentence of purpose",
                                     "far/twice.h: no #pragma once", "far/long.h: 201 lines, more than 200",
                                     "kit/CMakeLists.txt: no SPDX line on top", "kit/mute.js: no sentence of purpose",
                                     "sdc/empty.cpp: no SPDX line on top"));
}

}  // namespace
}  // namespace SolidSubdiv::House

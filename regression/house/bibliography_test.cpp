// SPDX-License-Identifier: Apache-2.0
// Every work that a comment or a page cites by its key, like loop1987, is in docs/bibliography.bib.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "house/source_tree.h"

namespace SolidSubdiv::House {
namespace {

using Keys = std::set<std::string>;

/// Keys of the entries of a BibTeX file.
Keys EntriesOf(const std::string& bibliography) {
    static const std::regex entry(R"(@\w+\{\s*(\w+),)");
    Keys keys;
    for (std::sregex_iterator it(bibliography.begin(), bibliography.end(), entry), end; it != end; ++it) {
        keys.insert((*it)[1]);
    }
    return keys;
}

/// What looks like a key in a text: small letters, a year, a word.
Keys KeysIn(const std::string& text) {
    static const std::regex key(R"(\b[a-z]+(19|20)[0-9][0-9][a-z]*\b)");
    Keys keys;
    for (std::sregex_iterator it(text.begin(), text.end(), key), end; it != end; ++it) keys.insert(it->str());
    return keys;
}

std::string TextOf(const std::filesystem::path& path) {
    std::ifstream stream(path);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// "file: key" for each key that has no entry: of comments in sources, and of pages.
std::vector<std::string> CitedWithoutEntry(const std::vector<SourceFile>& tree,
                                           const std::map<std::string, std::string>& pages, const Keys& entries) {
    std::vector<std::string> missing;
    const auto check = [&](const std::string& path, const std::string& text) {
        for (const std::string& key : KeysIn(text)) {
            if (!entries.contains(key)) missing.push_back(path + ": " + key);
        }
    };
    for (const SourceFile& file : tree) {
        if (!file.IsCpp()) continue;
        std::string comments;
        for (const std::string& line : file.lines) {
            const std::size_t start = line.find("//");
            if (start != std::string::npos) comments += line.substr(start) + "\n";
        }
        check(file.path, comments);
    }
    for (const auto& [path, text] : pages) check(path, text);
    return missing;
}

TEST(Bibliography, HasEveryWorkThatIsCited) {
    namespace fs = std::filesystem;
    const fs::path top = SOLIDSUBDIV_SOURCE, docs = top / "docs";
    std::map<std::string, std::string> pages;
    for (const auto& entry : fs::recursive_directory_iterator(docs)) {
        const fs::path& path = entry.path();
        if (path.extension() == ".md") pages[path.lexically_relative(top).generic_string()] = TextOf(path);
    }
    ASSERT_GT(pages.size(), 5U);
    const Keys entries = EntriesOf(TextOf(docs / "bibliography.bib"));
    EXPECT_THAT(CitedWithoutEntry(ReadSourceTree(top), pages, entries), testing::IsEmpty());
}

TEST(Bibliography, KeysWithoutEntryAreCaught) {
    const Keys entries = EntriesOf("@article{known2001tale,\n  author = {A}, year = {2001}}\n@book{ other1999, x}");
    EXPECT_THAT(entries, testing::ElementsAre("known2001tale", "other1999"));
    const std::string slashes(2, '/');  // this file has no such comment itself
    const std::vector<SourceFile> tree = {{"sdc/a.h",
                                           {slashes + " Sources: known2001tale, nobody1987; Printed2002",
                                            "int year2020 = 1;", "int x;  " + slashes + " (lost2004)"}},
                                          {"sdc/b.py", {"# python2003"}}};
    const std::map<std::string, std::string> pages = {
        {"docs/a.md", "As in [other1999], not [gone2010word], printed-2002."}};
    EXPECT_THAT(CitedWithoutEntry(tree, pages, entries),
                testing::ElementsAre("sdc/a.h: lost2004", "sdc/a.h: nobody1987", "docs/a.md: gone2010word"));
}

}  // namespace
}  // namespace SolidSubdiv::House

// SPDX-License-Identifier: Apache-2.0
// Damaging a file's bytes: cut short anywhere, and changed at many places, always the same.
#pragma once

#include <algorithm>
#include <cctype>
#include <random>

#include "kit/io/support.h"

namespace SolidSubdiv::Io {

/// Reads bytes under the file name "damaged" and checks what comes of it.
using ReadDamaged = std::function<void(const std::string&)>;

/// Returns whether the bytes were read; otherwise there must be an IoError of one line that names the file.
inline bool ReadsOrRefuses(const ReadDamaged& read, const std::string& bytes) {
    try {
        read(bytes);
        return true;
    } catch (const IoError& error) {
        const std::string message = error.what();
        EXPECT_EQ(message.find_first_of("\r\n"), message.npos);
        EXPECT_EQ(message.rfind("damaged: ", 0), 0u) << message;
        return false;
    }
}

inline void TruncateAnywhere(const ReadDamaged& read, const std::string& bytes) {
    ASSERT_TRUE(ReadsOrRefuses(read, bytes));
    for (std::size_t n = 0; n < bytes.size(); ++n) ReadsOrRefuses(read, bytes.substr(0, n));
}

inline void ChangeAnywhere(const ReadDamaged& read, const std::string& bytes) {
    std::mt19937 random(20260802);
    const std::vector<std::string> splinters = {"-1",
                                                "99999999999",
                                                "0",
                                                "nan",
                                                "1e999",
                                                "-inf",
                                                "\"",
                                                "<",
                                                "\r\n",
                                                " ",
                                                "1e9",
                                                std::string(4, '\xff'),
                                                std::string(8, '\0'),
                                                "4294967295"};
    int n_refused = 0;
    constexpr int n_trials = 2000;
    for (int trial = 0; trial < n_trials; ++trial) {
        std::string changed = bytes;
        for (auto n_changes = 1 + random() % 3; n_changes > 0; --n_changes) {
            const std::size_t at = random() % changed.size();
            const std::size_t length = std::min<std::size_t>(random() % 9, changed.size() - at);
            switch (random() % 4) {
                case 0:
                    changed[at] = static_cast<char>(random());
                    break;
                case 1:
                    changed.erase(at, length);
                    break;
                case 2:
                    changed.insert(at, changed.substr(random() % changed.size(), length));
                    break;
                default:
                    changed.replace(at, length, splinters[random() % splinters.size()]);
                    break;
            }
            if (changed.empty()) break;
        }
        n_refused += !ReadsOrRefuses(read, changed);
    }
    EXPECT_GT(n_refused, n_trials / 20) << "the changes must hurt";
}

/// Names of the corpus's files that `is_wanted`, in order.
inline std::vector<std::string> CorpusFiles(const std::function<bool(const std::filesystem::path&)>& is_wanted) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(Corpus(""))) {
        if (is_wanted(entry.path())) names.push_back(entry.path().filename());
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// A file's name as that of a test.
inline std::string TestNameOf(std::string name) {
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
}

}  // namespace SolidSubdiv::Io

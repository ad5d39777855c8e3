// SPDX-License-Identifier: Apache-2.0
// Damaged files: every corpus file, cut short and changed at many places, gives a consistent mesh or one IoError.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <random>

#include <solidsubdiv/kit/io/internal/elements.h>
#include <solidsubdiv/kit/io/internal/readers.h>

#include "kit/io/support.h"

namespace SolidSubdiv::Io {
namespace {

using Parse = std::function<Mesh(const std::string&)>;

Parse ParserOf(const std::filesystem::path& path) {
    const std::string extension = path.extension();
    const auto one = [](Mesh (*parse)(std::string_view, const std::string&)) {
        return [parse](const std::string& bytes) { return parse(bytes, "damaged"); };
    };
    if (extension == ".vtu") return one(Internal::ParseVtu);
    if (extension == ".vtk") return one(Internal::ParseVtk);
    if (extension == ".msh") return one(Internal::ParseGmsh);
    if (extension == ".mesh") return one(Internal::ParseMedit);
    if (extension == ".ply") return one(Internal::ParsePly);
    if (extension == ".stl") return one(Internal::ParseStl);
    if (extension == ".obj") return one(Internal::ParseObj);
    // TetGen: the damaged file with the whole other one.
    auto other = path;
    other.replace_extension(extension == ".node" ? ".ele" : ".node");
    const std::string rest = Load(other);
    if (extension == ".node") {
        return [rest](const std::string& bytes) { return Internal::ParseTetgen(bytes, "damaged", rest, "damaged"); };
    }
    if (extension == ".ele") {
        return [rest](const std::string& bytes) { return Internal::ParseTetgen(rest, "damaged", bytes, "damaged"); };
    }
    return {};
}

/// What ReadMesh promises of every mesh that it returns.
void ExpectConsistent(const Mesh& mesh) {
    const auto finite = [](const std::vector<double>& values) {
        return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
    };
    ASSERT_EQ(mesh.positions.size(), 3 * static_cast<std::size_t>(mesh.topology.n_vertices));
    ASSERT_TRUE(finite(mesh.positions));
    for (const Internal::ElementKind kind : Internal::kAllElementKinds) {
        for (const Index v : Internal::VerticesOf(mesh.topology, kind)) {
            ASSERT_GE(v, 0);
            ASSERT_LT(v, mesh.topology.n_vertices);
        }
    }
    for (const Attribute& a : mesh.point_data) {
        ASSERT_EQ(a.values.size(),
                  static_cast<std::size_t>(mesh.topology.n_vertices) * static_cast<std::size_t>(a.width));
        ASSERT_TRUE(finite(a.values));
    }
    for (const Attribute& a : mesh.cell_data) {
        ASSERT_EQ(a.values.size(),
                  static_cast<std::size_t>(mesh.topology.n_elements()) * static_cast<std::size_t>(a.width));
        ASSERT_TRUE(finite(a.values));
    }
}

/// Returns whether the bytes were read.
bool ReadsOrRefuses(const Parse& parse, const std::string& bytes) {
    try {
        ExpectConsistent(parse(bytes));
        return true;
    } catch (const IoError& error) {
        const std::string message = error.what();
        EXPECT_EQ(message.find_first_of("\r\n"), message.npos);
        EXPECT_EQ(message.rfind("damaged: ", 0), 0u) << message;
        return false;
    }
}

class Damaged : public testing::TestWithParam<std::string> {};

TEST_P(Damaged, TruncatedAnywhere) {
    const std::string bytes = Load(Corpus(GetParam()));
    const Parse parse = ParserOf(Corpus(GetParam()));
    ASSERT_TRUE(ReadsOrRefuses(parse, bytes));
    for (std::size_t n = 0; n < bytes.size(); ++n) ReadsOrRefuses(parse, bytes.substr(0, n));
}

TEST_P(Damaged, ChangedAnywhere) {
    const std::string bytes = Load(Corpus(GetParam()));
    const Parse parse = ParserOf(Corpus(GetParam()));
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
        n_refused += !ReadsOrRefuses(parse, changed);
    }
    EXPECT_GT(n_refused, n_trials / 20) << "the changes must hurt";
}

std::vector<std::string> CorpusFiles() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(Corpus(""))) {
        const std::string name = entry.path().filename();
        if (ParserOf(entry.path())) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

INSTANTIATE_TEST_SUITE_P(Corpus, Damaged, testing::ValuesIn(CorpusFiles()), [](const auto& file) {
    std::string name = file.param;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
});

}  // namespace
}  // namespace SolidSubdiv::Io

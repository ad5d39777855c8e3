// SPDX-License-Identifier: Apache-2.0
// Damaged files: every corpus file, cut short and changed at many places, gives a consistent mesh or one IoError.
#include <algorithm>
#include <cmath>

#include <solidsubdiv/kit/io/internal/elements.h>
#include <solidsubdiv/kit/io/internal/readers.h>

#include "kit/io/damage.h"

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

class Damaged : public testing::TestWithParam<std::string> {};

ReadDamaged ReaderOf(const std::filesystem::path& path) {
    return [parse = ParserOf(path)](const std::string& bytes) { ExpectConsistent(parse(bytes)); };
}

TEST_P(Damaged, TruncatedAnywhere) { TruncateAnywhere(ReaderOf(Corpus(GetParam())), Load(Corpus(GetParam()))); }

TEST_P(Damaged, ChangedAnywhere) { ChangeAnywhere(ReaderOf(Corpus(GetParam())), Load(Corpus(GetParam()))); }

INSTANTIATE_TEST_SUITE_P(Corpus, Damaged, testing::ValuesIn(CorpusFiles([](const std::filesystem::path& path) {
                             return static_cast<bool>(ParserOf(path));
                         })),
                         [](const auto& file) { return TestNameOf(file.param); });

}  // namespace
}  // namespace SolidSubdiv::Io

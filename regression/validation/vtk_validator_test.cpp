// SPDX-License-Identifier: Apache-2.0
// The validator that reads our files by VTK: what it expects is right by hand, and it catches faults planted in files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <utility>

#include <solidsubdiv/kit/io/formats.h>

#include "temporary_folder.h"
#include "validation/vtk_files.h"

namespace SolidSubdiv::Validation {
namespace {

constexpr double kTolerance = 1e-12;  // that of the validator
const std::filesystem::path kScript = std::filesystem::path(SOLIDSUBDIV_SOURCE) / "validation" / "vtk_reader.py";

/// The octahedron of unit diagonals' halves with a tet on the face (v0 v4 v2): volumes 4/3 and 1/3.
Io::Mesh OctAndTet() {
    Io::Mesh mesh;
    mesh.topology.n_vertices = 7;
    mesh.topology.octs = {0, 1, 2, 3, 4, 5};
    mesh.topology.tets = {0, 4, 2, 6};
    mesh.positions = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, -1, 0, 0, 1, 1, 1, -1};
    mesh.point_data = {{"heat", 1, {1, 2, 3, 4, 5, 6, 7}}};
    mesh.cell_data = {{"diagonal", 1, {1, 2}}};
    return mesh;
}

class VtkValidator : public testing::Test {
  protected:
    /// What VTK finds in a file of the mesh; skips the test where VTK is missing.
    GridSummary Read(const Io::Mesh& mesh, bool binary = false, bool keep_octahedra = true) {
        Io::WriteOptions options;
        options.binary = binary;
        options.keep_octahedra = keep_octahedra;
        Io::WriteMesh(folder_ / "it's a file.vtu", mesh, options);
        return ReadByVtk(kScript, {folder_ / "it's a file.vtu"}).front();
    }

    bool HasVtk() {
        try {
            Read(OctAndTet());
            return true;
        } catch (const Unavailable&) {
            return false;
        }
    }

    const TemporaryFolder folder_;
    Findings findings_;
};

TEST(VtkExpectation, IsRightByHand) {
    const GridSummary kept = Expect(OctAndTet(), true), cut = Expect(OctAndTet(), false);
    EXPECT_EQ(kept.n_cells, (std::map<int, std::int64_t>{{10, 1}, {42, 1}}));
    EXPECT_EQ(cut.n_cells, (std::map<int, std::int64_t>{{10, 5}}));
    EXPECT_DOUBLE_EQ(kept.volume, 5.0 / 3);
    EXPECT_DOUBLE_EQ(cut.volume, 5.0 / 3);
    EXPECT_DOUBLE_EQ(kept.least_volume, 1.0 / 3);
    EXPECT_EQ(kept.n_inverted, 0);
    EXPECT_EQ(kept.arrays.at("point heat").sum, 28);
}

TEST_F(VtkValidator, PassesOnEveryFormThatWeWrite) {
    if (!HasVtk()) GTEST_SKIP() << "VTK's Python module is not there (Debian: python3-vtk9)";
    for (const bool binary : {false, true}) {
        for (const bool keep : {false, true}) {
            CompareGrids(Expect(OctAndTet(), keep), Read(OctAndTet(), binary, keep), findings_);
        }
    }
    EXPECT_TRUE(findings_.Passes(kTolerance)) << findings_.where << testing::PrintToString(findings_.faults);
}

TEST_F(VtkValidator, CatchesFaultsInTheFile) {
    if (!HasVtk()) GTEST_SKIP() << "VTK's Python module is not there (Debian: python3-vtk9)";
    const GridSummary expected = Expect(OctAndTet(), true);
    const auto faults_of = [&](const Io::Mesh& mesh) {
        Findings found;
        CompareGrids(expected, Read(mesh), found);
        EXPECT_FALSE(found.Passes(kTolerance));
        return found;
    };
    Io::Mesh inverted_tet = OctAndTet();
    std::swap(inverted_tet.topology.tets[0], inverted_tet.topology.tets[1]);
    EXPECT_THAT(faults_of(inverted_tet).faults, testing::ElementsAre(testing::HasSubstr("no positive volume")));

    Io::Mesh inverted_oct = OctAndTet();
    std::swap(inverted_oct.topology.octs[2], inverted_oct.topology.octs[3]);
    EXPECT_THAT(faults_of(inverted_oct).faults, testing::ElementsAre(testing::HasSubstr("no positive volume")));

    Io::Mesh fewer = OctAndTet();
    fewer.topology.tets.clear();
    fewer.cell_data[0].values.pop_back();
    EXPECT_THAT(faults_of(fewer).faults, testing::Contains(testing::HasSubstr("cells of type 10")));

    Io::Mesh moved = OctAndTet();
    moved.positions[18] += 1e-6;
    const Findings found = faults_of(moved);
    EXPECT_TRUE(found.faults.empty());
    EXPECT_LT(found.largest_error, 1e-6);

    Io::Mesh warmer = OctAndTet();
    warmer.point_data[0].values[3] += 1e-6;
    EXPECT_THAT(faults_of(warmer).where, testing::HasSubstr("heat"));

    Io::Mesh renamed = OctAndTet();
    renamed.cell_data[0].name = "other";
    EXPECT_THAT(faults_of(renamed).faults, testing::ElementsAre(testing::HasSubstr("no array 'cell diagonal'")));
}

TEST_F(VtkValidator, SaysThatVtkCantReadABrokenFile) {
    if (!HasVtk()) GTEST_SKIP() << "VTK's Python module is not there (Debian: python3-vtk9)";
    std::ofstream(folder_ / "broken.vtu") << "<VTKFile type=\"UnstructuredGrid\"><Unstruct";
    EXPECT_THROW(ReadByVtk(kScript, {folder_ / "broken.vtu"}), std::runtime_error);
}

}  // namespace
}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
// What the tests of the program share: a folder of their own, running it, and small meshes.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/kit/io/formats.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "temporary_folder.h"

namespace SolidSubdiv::CliTesting {

namespace fs = std::filesystem;

struct Outcome {
    int status = -1;
    std::string out, err;
};

/// An empty folder for one test, gone afterwards. Commands run in it.
class CliTest : public testing::Test {
  protected:
    void SetUp() override { fs::create_directories(folder); }
    static std::string Program() { return std::string(SOLIDSUBDIV_PROGRAMS) + "/solidsubdiv"; }

    /// Runs the program with arguments as a shell would see them.
    Outcome Run(const std::string& arguments) const {
        const std::string out = (top_ / "out").string(), err = (top_ / "err").string();
        const std::string command = "cd '" + folder.string() + "' && '" + Program() + "' " + arguments + " >'" + out +
                                    "' 2>'" + err + "' </dev/null";
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, ReadText(out), ReadText(err)};
    }

    /// Runs it, and it must succeed.
    Outcome MustRun(const std::string& arguments) const {
        const Outcome outcome = Run(arguments);
        EXPECT_EQ(outcome.status, 0) << arguments << "\n" << outcome.err;
        return outcome;
    }

    /// Runs it, and it must fail with one line, which it returns, and leave the folder as it was.
    std::string ErrorOf(const std::string& arguments, int status = 1) const {
        const auto before = Names();
        const Outcome outcome = Run(arguments);
        EXPECT_EQ(outcome.status, status) << arguments << "\n" << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << arguments << "\n" << outcome.err;
        EXPECT_EQ(Names(), before) << arguments;
        return outcome.err;
    }

    nlohmann::json Json(const std::string& arguments) const {
        const Outcome outcome = MustRun(arguments + " --json -");
        return nlohmann::json::parse(outcome.out, nullptr, false);
    }

    static std::string ReadText(const fs::path& path) {
        std::ifstream file(path, std::ios::binary);
        std::ostringstream text;
        text << file.rdbuf();
        return text.str();
    }

    void WriteText(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name, std::ios::binary) << text;
    }
    void WriteMesh(const std::string& name, const Io::Mesh& mesh, bool keep_octahedra = false) const {
        Io::WriteMesh(folder / name, mesh, {.keep_octahedra = keep_octahedra});
    }
    Io::Mesh ReadMesh(const std::string& name) const { return Io::ReadMesh(folder / name); }

    /// Names of everything in the folder, hidden files too.
    std::set<std::string> Names() const {
        std::set<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            names.insert(fs::relative(entry.path(), folder).string());
        }
        return names;
    }

  private:
    const TemporaryFolder top_;

  public:
    const fs::path folder = top_ / "work";
};

/// A mesh of tets over given positions.
inline Io::Mesh TetMesh(std::vector<double> positions, std::vector<Index> tets) {
    Io::Mesh mesh;
    mesh.topology.n_vertices = static_cast<Index>(positions.size() / 3);
    mesh.positions = std::move(positions);
    mesh.topology.tets = std::move(tets);
    return mesh;
}

inline Io::Mesh OneTet() { return TetMesh({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 1, 2, 3}); }

/// A lattice of 16 points and 28 tets, as many as that of chang2002boxspline, fig. 1: a tet with seven points put
/// inside, one on a face, and four tets put on faces.
inline Io::Mesh TwentyEightTets() {
    Io::Mesh mesh = TetMesh({0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4}, {0, 1, 2, 3});
    std::vector<Index>& tets = mesh.topology.tets;
    const auto add_mean = [&](std::vector<Index> of) {
        for (int axis = 0; axis < 3; ++axis) {
            double sum = 0;
            for (Index v : of) sum += mesh.positions[3 * static_cast<std::size_t>(v) + axis];
            mesh.positions.push_back(sum / static_cast<double>(of.size()));
        }
        return mesh.topology.n_vertices++;
    };
    for (std::size_t i = 0; i < 7; ++i) {  // the first tet not yet split, into four
        const std::size_t at = 4 * i;
        const std::vector<Index> t(tets.begin() + at, tets.begin() + at + 4);
        const Index m = add_mean(t);
        tets.insert(tets.end(), {t[0], m, t[2], t[3], t[0], t[1], m, t[3], t[0], t[1], t[2], m});
        tets[at] = m;
    }
    // The faces of the large tet are 1 2 3, 0 3 2, 0 1 3 and 0 2 1 from outside; 1 2 3 is cut at its mean ...
    for (std::size_t at = 0; at < tets.size(); at += 4) {
        std::vector<Index> t(tets.begin() + at, tets.begin() + at + 4);
        const auto apex = std::find_if(t.begin(), t.end(), [](Index v) { return v == 0 || v > 3; });
        if (std::count_if(t.begin(), t.end(), [](Index v) { return v >= 1 && v <= 3; }) != 3) continue;
        const std::size_t k = static_cast<std::size_t>(apex - t.begin());
        const Index m = add_mean({1, 2, 3});
        for (int i = 1; i < 3; ++i) {
            std::vector<Index> child = t;
            child[(k + i) % 4] = m;
            tets.insert(tets.end(), child.begin(), child.end());
        }
        tets[at + (k + 3) % 4] = m;
        break;
    }
    // ... and these four get a tet each (the first of the three parts of 1 2 3 with it).
    const Index m = mesh.topology.n_vertices - 1;
    const std::array<std::array<Index, 3>, 4> faces = {{{m, 1, 2}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
    const std::array<std::array<double, 3>, 4> outward = {{{1, 1, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
    for (std::size_t f = 0; f < 4; ++f) {
        const Index apex = add_mean({faces[f][0], faces[f][1], faces[f][2]});
        for (int axis = 0; axis < 3; ++axis)
            mesh.positions[3 * static_cast<std::size_t>(apex) + axis] += outward[f][axis];
        tets.insert(tets.end(), {faces[f][0], faces[f][1], faces[f][2], apex});
    }
    return mesh;
}

/// The largest difference of two lists of numbers, relative to the largest number.
inline double Difference(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
    double difference = 0, size = 1e-300;
    for (std::size_t i = 0; i < a.size(); ++i) {
        difference = std::max(difference, std::abs(a[i] - b[i]));
        size = std::max(size, std::abs(a[i]));
    }
    return difference / size;
}

}  // namespace SolidSubdiv::CliTesting

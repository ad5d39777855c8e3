// SPDX-License-Identifier: Apache-2.0
// Refined positions of every test shape under every scheme stay what they were when the goldens were written.
//
// The laws say what is right; goldens only say that nothing changed unnoticed. To write them anew, after a change that
// is meant: SOLIDSUBDIV_WRITE_GOLDENS=1 build/release/bin/test_far --gtest_filter='Goldens*'
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <solidsubdiv/far/limit_stencil_table.h>

#include "far/far_testing.h"

namespace {

using namespace SolidSubdiv;
using namespace SolidSubdiv::TestFar;

const char* const kFile = SOLIDSUBDIV_SOURCE "/regression/goldens/refined.txt";

/// Sums that any change of any coordinate changes: weights grow with the place.
std::vector<double> Digest(const std::vector<double>& positions) {
    std::vector<double> digest(6, 0.0);
    const double n = static_cast<double>(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        digest[i % 3] += positions[i];
        digest[3 + i % 3] += positions[i] * (static_cast<double>(i) / n);
    }
    return digest;
}

struct Golden {
    std::string name;
    Index n_vertices = 0;
    std::vector<double> digest;
};

std::vector<Golden> Compute(double fault = 0) {
    std::vector<Golden> goldens;
    const auto add = [&](const std::string& name, const auto& shape, Sdc::Split split) {
        auto refiner = Far::TopologyRefiner::Create(Describe(shape), split);
        refiner.RefineUniform({.max_level = 2, .full_topology_in_last_level = true});
        for (const auto& [scheme_name, scheme] : AllSchemes(split)) {
            if (!IsSolid(scheme) && refiner.n_cells(0) > 0) continue;
            auto refined = Apply(Far::StencilTable::Create(refiner, scheme), shape.positions);
            refined[refined.size() / 3] += fault;
            const auto limit = Far::LimitStencilTable::Create(refiner, scheme);
            Golden g{name + "; " + scheme_name, refiner.n_vertices(2), Digest(refined)};
            const auto limits = Digest(Apply(Far::StencilTable::FromRows(g.n_vertices, {limit.rows()}), refined));
            g.digest.insert(g.digest.end(), limits.begin(), limits.end());
            goldens.push_back(g);
        }
    };
    for (const auto& [name, shape] : TestShapes::AllShapes()) add(std::string(name), shape, Sdc::Split::TetOct);
    for (const auto& [name, shape] : TestShapes::PolyhedralShapes()) add(name, shape, Sdc::Split::Polyhedral);
    return goldens;
}

void Write(const std::vector<Golden>& goldens) {
    std::ofstream file(kFile);
    file << "# Level 2 and its limit positions of regression/*_shapes.h under every scheme; written by\n"
            "# SOLIDSUBDIV_WRITE_GOLDENS=1 test_far --gtest_filter='Goldens*' (regression/far/goldens_test.cpp).\n"
            "# shape; scheme and options | vertices | sums of x y z, sums weighted by place; the same of the limits\n";
    for (const Golden& g : goldens) {
        file << g.name << " | " << g.n_vertices << " |";
        for (double d : g.digest) {
            char text[32];
            std::snprintf(text, sizeof text, " %.17g", d);
            file << text;
        }
        file << "\n";
    }
}

std::vector<Golden> Read() {
    std::vector<Golden> goldens;
    std::ifstream file(kFile);
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        const std::size_t bar = line.find(" | ");
        Golden g{line.substr(0, bar), 0, {}};
        std::istringstream rest(line.substr(bar + 3));
        char separator;
        rest >> g.n_vertices >> separator;
        for (double d; rest >> d;) g.digest.push_back(d);
        goldens.push_back(g);
    }
    return goldens;
}

/// Differences to the goldens, one line each. Round-off: 1e-12 of the sums' size, which grows with the number of
/// points.
std::vector<std::string> Differences(const std::vector<Golden>& now, const std::vector<Golden>& golden) {
    std::vector<std::string> differences;
    if (now.size() != golden.size()) differences.push_back("there are other shapes or schemes");
    for (std::size_t i = 0; i < std::min(now.size(), golden.size()); ++i) {
        bool same = now[i].name == golden[i].name && now[i].n_vertices == golden[i].n_vertices &&
                    now[i].digest.size() == golden[i].digest.size();
        for (std::size_t k = 0; same && k < now[i].digest.size(); ++k) {
            same = std::abs(now[i].digest[k] - golden[i].digest[k]) <= 1e-12 * std::max(1, now[i].n_vertices);
        }
        if (!same) differences.push_back(now[i].name + " differs from " + golden[i].name);
    }
    return differences;
}

TEST(Goldens, AreWhatIsComputed) {
    if (std::getenv("SOLIDSUBDIV_WRITE_GOLDENS")) Write(Compute());
    const auto golden = Read();
    ASSERT_FALSE(golden.empty()) << kFile;
    for (const std::string& d : Differences(Compute(), golden)) ADD_FAILURE() << d;
}

TEST(Goldens, CatchAPointThatMovedByAMillionth) {
    const auto golden = Read();
    EXPECT_EQ(Differences(Compute(1e-6), golden).size(), golden.size());
}

}  // namespace

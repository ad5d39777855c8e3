// SPDX-License-Identifier: Apache-2.0
// What the tests of kit/io share: a folder that vanishes, meshes of every kind of element, exact comparison.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/sdc/errors.h>

#include "temporary_folder.h"

namespace SolidSubdiv::Io {

inline void Save(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

inline std::string Load(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline std::filesystem::path Corpus(const std::string& name) {
    return std::filesystem::path(SOLIDSUBDIV_SHAPES) / "io_corpus" / name;
}

/// A file of the data from elsewhere, which may be missing.
inline std::filesystem::path RealData(const std::string& name) {
    const char* const given = std::getenv("SOLIDSUBDIV_DATA");
    return std::filesystem::path(given ? given : SOLIDSUBDIV_DATA) / name;
}

/// The message of the IoError that the call throws; empty if it throws none.
inline std::string ErrorOf(const std::function<void()>& call) {
    try {
        call();
    } catch (const IoError& error) {
        return error.what();
    }
    return {};
}

inline void ExpectSameAttributes(const std::vector<Attribute>& a, const std::vector<Attribute>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].name, b[i].name);
        EXPECT_EQ(a[i].width, b[i].width) << a[i].name;
        EXPECT_EQ(a[i].values, b[i].values) << a[i].name;
    }
}

/// Every index and every number the same, bit for bit as far as == sees it.
inline void ExpectSameMesh(const Mesh& a, const Mesh& b) {
    const Topology &s = a.topology, &t = b.topology;
    EXPECT_EQ(s.n_vertices, t.n_vertices);
    EXPECT_EQ(s.tets, t.tets);
    EXPECT_EQ(s.octs, t.octs);
    EXPECT_EQ(s.hexes, t.hexes);
    EXPECT_EQ(s.wedges, t.wedges);
    EXPECT_EQ(s.pyramids, t.pyramids);
    EXPECT_EQ(s.polyhedron_offsets, t.polyhedron_offsets);
    EXPECT_EQ(s.polyhedron_face_offsets, t.polyhedron_face_offsets);
    EXPECT_EQ(s.polyhedron_vertices, t.polyhedron_vertices);
    EXPECT_EQ(s.triangles, t.triangles);
    EXPECT_EQ(s.quads, t.quads);
    EXPECT_EQ(s.polygon_offsets, t.polygon_offsets);
    EXPECT_EQ(s.polygon_vertices, t.polygon_vertices);
    EXPECT_EQ(s.edges, t.edges);
    EXPECT_EQ(s.vertices, t.vertices);
    EXPECT_EQ(a.positions, b.positions);
    ExpectSameAttributes(a.point_data, b.point_data);
    ExpectSameAttributes(a.cell_data, b.cell_data);
    EXPECT_EQ(a.scheme_options, b.scheme_options);
}

/// Twelve vertices with coordinates that only 17 digits tell apart, tiny, huge and negative ones.
inline std::vector<double> AwkwardPositions() {
    std::vector<double> x = {1.0 / 3, -0.1, 1e-300, 5e-324, 1.7976931348623157e308, 3.141592653589793, 0, -7, 1e16 + 2};
    for (int i = 0; static_cast<int>(x.size()) < 36; ++i) x.push_back((i - 11) / 7.0);
    return x;
}

/// A mesh with the asked kinds of elements ("tohwypTQPEV" for tets, octs, hexes, wedges, pyramids, polyhedra,
/// triangles, quads, polygons, edges, vertices) and with point and cell data.
inline Mesh MeshOf(const std::string& kinds) {
    const auto has = [&](char kind) { return kinds.find(kind) != kinds.npos; };
    Mesh mesh;
    Topology& t = mesh.topology;
    t.n_vertices = 12;
    mesh.positions = AwkwardPositions();
    if (has('t')) t.tets = {0, 1, 2, 3, 4, 5, 6, 7, 11, 10, 9, 8};
    if (has('o')) t.octs = {0, 1, 2, 3, 4, 5, 11, 6, 7, 10, 8, 9};
    if (has('h')) t.hexes = {0, 1, 2, 3, 4, 5, 6, 7};
    if (has('w')) t.wedges = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
    if (has('y')) t.pyramids = {4, 3, 2, 1, 0};
    if (has('p')) {
        t.polyhedron_offsets = {0, 4, 9};
        t.polyhedron_face_offsets = {0, 3, 6, 9, 12, 16, 19, 22, 25, 28};
        t.polyhedron_vertices = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2, 5, 8, 7, 6, 5, 6, 9, 6, 7, 9, 7, 8, 9, 8, 5, 9};
    }
    if (has('T')) t.triangles = {0, 1, 2, 2, 1, 3};
    if (has('Q')) t.quads = {4, 5, 6, 7};
    if (has('P')) {
        t.polygon_offsets = {0, 5, 11};
        t.polygon_vertices = {0, 1, 2, 3, 4, 11, 10, 9, 8, 7, 6};
    }
    if (has('E')) t.edges = {0, 1, 5, 4};
    if (has('V')) t.vertices = {11, 3};
    mesh.point_data = {{"weight", 1, {}}, {"the flow", 3, {}}};
    mesh.cell_data = {{"sharpness", 1, {}}, {"diagonal", 1, {}}, {"pair", 2, {}}};
    for (int i = 0; i < 12; ++i) mesh.point_data[0].values.push_back(i / 3.0);
    for (int i = 0; i < 36; ++i) mesh.point_data[1].values.push_back(-i * 0.1);
    for (int i = 0; i < t.n_elements(); ++i) {
        mesh.cell_data[0].values.push_back(i % 2 ? 10 : 1.0 / (i + 1));
        mesh.cell_data[1].values.push_back(i % 3);
        mesh.cell_data[2].values.insert(mesh.cell_data[2].values.end(), {i + 0.25, -i - 1e-17});
    }
    return mesh;
}

}  // namespace SolidSubdiv::Io

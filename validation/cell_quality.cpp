// SPDX-License-Identifier: Apache-2.0
// Validator cell-quality: scaled Jacobians as VTK's Verdict has them; no sampled determinant below what is proved.
#include "cell_quality.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>

#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/io/formats.h>

#include "python_script.h"
#include "solid_shapes.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

struct NamedMesh {
    std::string name;
    Io::Mesh mesh;
};

/// n^3 cubes with every vertex moved by up to `amount`.
Io::Mesh ShakenHexes(int n, double amount, std::uint32_t seed) {
    Io::Mesh mesh;
    Shaker shaker(seed);
    const int m = n + 1;
    for (int v = 0; v < m * m * m; ++v) {
        for (int c : {v % m, v / m % m, v / m / m}) mesh.positions.push_back(c + amount * shaker.Next());
    }
    mesh.topology.n_vertices = m * m * m;
    for (int z = 0; z < n; ++z) {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                const Index v = x + m * (y + m * z), up = m * m;
                for (Index low : {v, v + up}) {
                    mesh.topology.hexes.insert(mesh.topology.hexes.end(), {low, low + 1, low + m + 1, low + m});
                }
            }
        }
    }
    return mesh;
}

/// The determinant of the derivatives of a hexahedron's trilinear map, by differences of faces' bilinear maps, which
/// are exact: the map is linear along each coordinate.
double DetAt(const Io::Mesh& mesh, std::size_t hex, const std::array<double, 3>& at) {
    static constexpr int kPlace[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                         {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    double d[3][3] = {};  // [coordinate of the cell][axis]
    for (std::size_t i = 0; i < 8; ++i) {
        const auto v = static_cast<std::size_t>(mesh.topology.hexes[8 * hex + i]);
        for (std::size_t k = 0; k < 3; ++k) {
            double weight = kPlace[i][k] == 1 ? 1 : -1;
            for (std::size_t other = 0; other < 3; ++other) {
                if (other != k) weight *= kPlace[i][other] == 1 ? at[other] : 1 - at[other];
            }
            for (std::size_t axis = 0; axis < 3; ++axis) d[k][axis] += weight * mesh.positions[3 * v + axis];
        }
    }
    return d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) - d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
           d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
}

/// The values that the script printed, a list a file.
std::vector<std::vector<double>> ValuesOf(const std::string& text) {
    std::vector<std::vector<double>> files;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("file ")) {
            files.emplace_back();
        } else if (!files.empty()) {
            files.back().push_back(std::strtod(line.c_str(), nullptr));
        }
    }
    return files;
}

}  // namespace

std::vector<Geometry::CellQuality> MeasureMesh(const Io::Mesh& mesh) {
    const auto split = mesh.topology.tets.empty() ? Sdc::Split::Polyhedral : Sdc::Split::TetOct;
    return Geometry::MeasureQuality(Far::TopologyRefiner::Create(mesh.topology, split), 0, mesh.positions);
}

void CompareQuality(const Io::Mesh& mesh, std::span<const Geometry::CellQuality> ours,
                    std::span<const double> by_verdict, Findings& findings) {
    if (ours.size() != by_verdict.size()) return findings.Fault("another number of cells");
    for (std::size_t c = 0; c < ours.size(); ++c) {
        findings.Error(std::abs(ours[c].scaled_jacobian - by_verdict[c]), [&] { return "cell " + std::to_string(c); });
    }
    constexpr int kSamples = 6;
    constexpr double kRounding = 1e-13;  // of determinants of edges of length 2 and less
    for (std::size_t c = 0; c < mesh.topology.hexes.size() / 8; ++c) {
        for (int k = 0; k < kSamples * kSamples * kSamples; ++k) {
            const auto along = [&](int i) { return static_cast<double>(i % kSamples) / (kSamples - 1); };
            const double det = DetAt(mesh, c, {along(k), along(k / kSamples), along(k / kSamples / kSamples)});
            const bool is_wrong_sign = ours[c].sign == Geometry::MinimumSign::Positive && det <= 0;
            if (!is_wrong_sign && det >= ours[c].lower_bound - kRounding) continue;
            findings.Fault("hexahedron " + std::to_string(c) + " has the determinant " + std::to_string(det));
            break;
        }
    }
}

Findings ValidateCellQuality(const Context& context) {
    std::vector<NamedMesh> meshes;
    meshes.push_back({"bunny_lattice", Io::ReadSolid(context.shapes / "demo" / "bunny_lattice.vtu")});
    meshes.push_back({"bunny_lattice shaken", meshes[0].mesh});
    Shaker shaker(1);
    for (double& x : meshes[1].mesh.positions) x += 0.4 * shaker.Next();  // some tets inverted
    meshes.push_back({"hexahedra", ShakenHexes(10, 0.2, 2)});
    meshes.push_back({"hexahedra, some folded", ShakenHexes(10, 0.45, 3)});
    std::vector<std::filesystem::path> paths;
    for (const NamedMesh& m : meshes) {
        paths.push_back(context.scratch / ("quality " + std::to_string(paths.size()) + ".vtu"));
        Io::WriteMesh(paths.back(), m.mesh);
    }
    const auto by_verdict = ValuesOf(RunVtkScript(context.scripts / "vtk_quality.py", paths));
    Findings findings;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        Findings found;
        if (i >= by_verdict.size()) {
            found.Fault("VTK says nothing of it");
        } else {
            CompareQuality(meshes[i].mesh, MeasureMesh(meshes[i].mesh), by_verdict[i], found);
        }
        findings.Merge(found, meshes[i].name);
    }
    return findings;
}

}  // namespace SolidSubdiv::Validation

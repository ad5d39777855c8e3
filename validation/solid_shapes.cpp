// SPDX-License-Identifier: Apache-2.0
// Shapes cut out of blocks of the octet truss, and spindles.
#include "solid_shapes.h"

#include <cmath>
#include <numbers>

#include "octet_truss.h"

namespace SolidSubdiv::Validation {

namespace {

constexpr double kShake = 0.1;  // edges of the lattice are sqrt(3) and 2 long: cells stay positive

/// The part of a block whose cells `keep` wants (asked with the least corner of the cell's box), without unused
/// vertices.
template <class Keep>
SolidShape CutOut(std::string name, std::string feature, const TrussBlock& block, Keep&& keep) {
    SolidShape shape{std::move(name), std::move(feature), {}, {}};
    Shaker shaker(17);
    std::vector<int> number(block.vertices.size(), -1);
    const auto take = [&](auto cell) {
        LatticePoint least = block.vertices[cell[0]];
        for (int v : cell) {
            for (int i = 0; i < 3; ++i) least[i] = std::min(least[i], block.vertices[v][i]);
        }
        if (!keep(least)) return false;
        return true;
    };
    const auto renumber = [&](auto cell) {
        for (int& v : cell) {
            if (number[v] < 0) {
                number[v] = shape.n_vertices();
                const LatticePoint& p = block.vertices[v];
                for (double x : BccPosition({double(p[0]), double(p[1]), double(p[2])})) {
                    shape.positions.push_back(x + kShake * shaker.Next());
                }
            }
            v = number[v];
        }
        return cell;
    };
    for (const auto& tet : block.tets) {
        if (take(tet)) shape.complex.tets.push_back(renumber(tet));
    }
    for (const auto& oct : block.octs) {
        if (take(oct)) shape.complex.octs.push_back(renumber(oct));
    }
    return shape;
}

SolidShape WholeBlock(std::string name, std::string feature, const LatticePoint& size, TrussCells cells, int axis = 2) {
    return CutOut(std::move(name), std::move(feature), MakeTrussBlock(size, cells, axis),
                  [](const LatticePoint&) { return true; });
}

SolidShape OneTet() {
    return {
        "tet", "one tet: valence 3 everywhere", {{{0, 1, 2, 3}}, {}}, {0, 0, 0, 1, 0.1, 0, 0.2, 1.1, 0, 0.1, 0.3, 1}};
}

SolidShape OneOct() {
    return {"oct",
            "one octahedron: valence 4 everywhere",
            {{}, {{0, 1, 2, 3, 4, 5}}},
            {1, 0, 0.1, -1.2, 0, 0, 0, 1, 0.3, 0.1, -1, 0, 0, 0.2, -1, 0, 0, 1.4}};
}

SolidShape OctWithRoofs() {
    SolidShape shape = OneOct();
    shape.name = "oct-and-tets";
    shape.feature = "an octahedron with tets on three of its faces";
    // The faces (v0 v4 v2), (v1 v2 v4), (v1 v3 v5), counterclockwise from outside, and an apex each.
    const std::vector<Triangle> faces = {{0, 4, 2}, {1, 2, 4}, {1, 3, 5}};
    for (const Triangle& f : faces) {
        const int apex = shape.n_vertices();
        for (int i = 0; i < 3; ++i) {
            double sum = 0;
            for (int v : f) sum += shape.positions[3 * v + i];
            shape.positions.push_back(sum);
        }
        shape.complex.tets.push_back({f[0], f[1], f[2], apex});
    }
    return shape;
}

}  // namespace

SolidShape VoxelSolid(std::string name, std::string feature, const std::vector<std::vector<std::string>>& layers) {
    const LatticePoint size = {static_cast<int>(layers[0][0].size()), static_cast<int>(layers[0].size()),
                               static_cast<int>(layers.size())};
    return CutOut(std::move(name), std::move(feature), MakeTrussBlock(size, TrussCells::Tets),
                  [&](const LatticePoint& p) { return layers[p[2]][p[1]][p[0]] == '#'; });
}

SolidShape Spindle(int k) {
    SolidShape shape{"spindle-" + std::to_string(k), "boundary vertices of valence " + std::to_string(k), {}, {}};
    Shaker shaker(static_cast<std::uint32_t>(k));
    const auto add = [&](double x, double y, double z) {
        for (double c : {x, y, z}) shape.positions.push_back(c + 0.05 * shaker.Next());
    };
    add(0, 0, -1);
    add(0, 0, 1);
    for (int i = 0; i < k; ++i) {
        const double angle = 2 * std::numbers::pi * i / k;
        add(std::cos(angle), std::sin(angle), 0);
        shape.complex.tets.push_back({0, 1, 2 + i, 2 + (i + 1) % k});
    }
    return shape;
}

std::vector<SolidShape> ManifoldShapes() {
    std::vector<SolidShape> shapes = {OneTet(), OneOct(), OctWithRoofs()};
    shapes.push_back(WholeBlock("block", "tets only, with inner vertices", {3, 2, 2}, TrussCells::Tets));
    shapes.push_back(WholeBlock("octet-truss", "tets and octahedra with parallel diagonals", {3, 3, 2},
                                TrussCells::ParallelDiagonals, 1));
    shapes.push_back(
        WholeBlock("split-block", "tets and octahedra as one split makes them", {4, 2, 2}, TrussCells::RefinedOnce));
    shapes.push_back(VoxelSolid("ring", "genus 1", {{"###", "#.#", "###"}}));
    shapes.push_back(VoxelSolid("three-rings", "genus 3", {{"#######", "#.#.#.#", "#######"}}));
    shapes.push_back(VoxelSolid("two-blocks", "two components", {{"#.##"}}));
    shapes.push_back(VoxelSolid("hollow", "a cavity: a boundary inside another",
                                {{"###", "###", "###"}, {"###", "#.#", "###"}, {"###", "###", "###"}}));
    for (int k = 3; k <= 12; ++k) shapes.push_back(Spindle(k));
    return shapes;
}

std::vector<SolidShape> NonManifoldShapes() {
    std::vector<SolidShape> shapes;
    shapes.push_back(VoxelSolid("edge-contact", "two blocks that meet in an edge", {{"#.", ".#"}}));
    shapes.push_back(VoxelSolid("vertex-contact", "two blocks that meet in a vertex", {{"#.", ".."}, {"..", ".#"}}));
    shapes.push_back(VoxelSolid("edge-contacts", "four blocks that meet in a line of edges and beyond",
                                {{"#.#", ".#.", "#.."}, {"#..", ".#.", "..#"}}));
    return shapes;
}

SolidShape RandomPiece(std::uint32_t seed) {
    Shaker shaker(seed);
    const LatticePoint size = {2 * (1 + shaker.Below(2)), 2 * (1 + shaker.Below(2)), 2 * (1 + shaker.Below(2))};
    const TrussCells kinds[] = {TrussCells::Tets, TrussCells::ParallelDiagonals, TrussCells::RefinedOnce};
    const TrussBlock block = MakeTrussBlock(size, kinds[shaker.Below(3)], shaker.Below(3));
    return CutOut("random-" + std::to_string(seed), "a random piece of the lattice", block,
                  [&](const LatticePoint&) { return shaker.Below(3) != 0; });
}

}  // namespace SolidSubdiv::Validation

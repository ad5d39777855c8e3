// SPDX-License-Identifier: Apache-2.0
// The API in one page, as a downstream program uses it: a file, refined once, evaluated twice.
#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/osd/evaluator.h>

#include <cmath>
#include <cstdio>
#include <vector>

using namespace SolidSubdiv;

int main() {
    Io::Mesh tetrahedron;
    tetrahedron.topology.n_vertices = 4;
    tetrahedron.topology.tets = {0, 1, 2, 3};
    tetrahedron.positions = {0, 0, 0, 8, 0, 0, 0, 8, 0, 0, 0, 8};
    Io::WriteMesh("part.vtu", tetrahedron);

    Io::Mesh mesh = Io::ReadSolid("part.vtu");
    auto refiner = Far::TopologyRefiner::Create(mesh.topology, Sdc::Split::TetOct);
    refiner.RefineUniform({.max_level = 3});
    auto stencils = Far::StencilTable::Create(refiner, Sdc::BoxSpline{});
    Osd::Evaluator eval(stencils, Osd::Backend::Best());

    std::vector<double> refined(3 * static_cast<std::size_t>(eval.n_refined_vertices()));
    eval.Evaluate(mesh.positions, refined);
    std::vector<double> moved = refined;
    for (double& x : mesh.positions) x += 5;
    eval.Evaluate(mesh.positions, moved);

    // A tetrahedron split three times has the points of a triangular pyramid of 9 layers. Moving the control points
    // moves the refined ones as much; 1e-12 is round-off of sums of numbers of this size.
    bool is_right = refined.size() == 3 * (9 * 10 * 11 / 6);
    for (std::size_t i = 0; i < refined.size(); ++i) is_right = is_right && std::abs(moved[i] - refined[i] - 5) < 1e-12;
    std::printf("%zu points on backend %s: %s\n", refined.size() / 3, std::string(eval.backend().name()).c_str(),
                is_right ? "right" : "WRONG");
    return is_right ? 0 : 1;
}

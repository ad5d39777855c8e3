// SPDX-License-Identifier: Apache-2.0
// Starts of all kinds, and what they are fitted to.
#include "fit_shapes.h"

#include <cmath>
#include <map>

#include <solidsubdiv/apps/fit/start.h>
#include <solidsubdiv/kit/io/formats.h>

#include "solid_shapes.h"

namespace SolidSubdiv::Validation {

std::vector<FitCase> FitCasesAround(const Fit::TargetSurface& target, Index n_control) {
    return {{"hexahedra", MakeSolidStart(target, {.n_control = n_control}), Sdc::CatmullClarkSolid{}},
            {"tets and octahedra", MakeSolidStart(target, {.n_control = n_control, .tets = true}), Sdc::BoxSpline{}},
            {"cage of triangles", MakeCage(target, {.n_control = n_control}), Sdc::Loop{}},
            {"cage of quads", MakeCage(target, {.n_control = n_control, .quads = true}), Sdc::CatmullClark{}}};
}

FitTarget MakeFitBall(int n) {
    FitTarget ball;
    std::map<std::array<int, 3>, Index> numbers;
    const auto number = [&](const std::array<int, 3>& p) {
        const auto found = numbers.try_emplace(p, static_cast<Index>(numbers.size()));
        if (found.second) {
            const double length = std::hypot(p[0], p[1], p[2]);
            const double x = p[0] / length, y = p[1] / length, z = p[2] / length;
            ball.positions.insert(ball.positions.end(), {x * (1 + 0.2 * y), y + 0.1 * x * x, z * (1.1 + 0.1 * x)});
        }
        return found.first->second;
    };
    for (int octant = 0; octant < 8; ++octant) {
        const int x = octant & 1 ? -1 : 1, y = octant & 2 ? -1 : 1, z = octant & 4 ? -1 : 1;
        const bool is_turned = x * y * z < 0;
        const auto add = [&](std::array<int, 2> a, std::array<int, 2> b, std::array<int, 2> c) {
            if (is_turned) std::swap(b, c);
            for (const auto& p : {a, b, c}) {
                ball.triangles.push_back(number({x * p[0], y * p[1], z * (n - p[0] - p[1])}));
            }
        };
        for (int i = 0; i < n; ++i) {
            for (int j = 0; i + j < n; ++j) {
                add({i, j}, {i + 1, j}, {i, j + 1});
                if (i + j + 1 < n) add({i + 1, j}, {i + 1, j + 1}, {i, j + 1});
            }
        }
    }
    return ball;
}

FitTarget ReadFitBunny(const std::filesystem::path& shapes) {
    Io::Mesh mesh = Io::ReadMesh(shapes / "demo" / "bunny.obj");
    return {std::move(mesh.positions), std::move(mesh.topology.triangles)};
}

FitTarget FitSurface(const Fit::Problem& problem) {
    return {problem.surface.Positions(problem.control), problem.surface.triangles};
}

void Shake(std::vector<double>& positions, double amount, std::uint32_t seed) {
    Shaker shaker(seed);
    for (double& x : positions) x += amount * shaker.Next();
}

}  // namespace SolidSubdiv::Validation

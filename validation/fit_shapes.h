// SPDX-License-Identifier: Apache-2.0
// Control meshes for the validators of fitting: one for each kind that a fit moves.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <solidsubdiv/apps/fit/fit.h>

namespace SolidSubdiv::Validation {

struct FitCase {
    std::string name;
    Fit::ControlMesh mesh;
    Sdc::Scheme scheme;
};

/// Triangles that own their arrays.
struct FitTarget {
    std::vector<double> positions;
    std::vector<Index> triangles;

    Fit::TargetSurface View() const { return {.positions = positions, .triangles = triangles}; }
};

/// Starts of about so many control points around a target: hexahedra, tets and octahedra, cages of triangles and quads.
std::vector<FitCase> FitCasesAround(const Fit::TargetSurface& target, Index n_control);

/// A ball, closer at one side than at the other so that nothing is symmetric: triangles of an octahedron cut n by n.
FitTarget MakeFitBall(int n);

/// The scan that the repository carries. @param shapes Context::shapes
FitTarget ReadFitBunny(const std::filesystem::path& shapes);

/// The surface that control points carry.
FitTarget FitSurface(const Fit::Problem& problem);

/// Adds numbers of [-amount, amount], the same everywhere.
void Shake(std::vector<double>& positions, double amount, std::uint32_t seed);

}  // namespace SolidSubdiv::Validation

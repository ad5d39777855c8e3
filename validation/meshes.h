// SPDX-License-Identifier: Apache-2.0
// From the validators' plain shapes to what the framework takes, and from files to plain shapes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <solidsubdiv/far/topology_descriptor.h>
#include <solidsubdiv/far/topology_refiner.h>

#include "solid_shapes.h"

namespace SolidSubdiv::Validation {

/// Flat arrays of a complex; a descriptor of them is valid while this lives.
struct CellArrays {
    std::vector<Index> tets, octs;

    CellArrays() = default;
    explicit CellArrays(const Complex& complex);
    Far::TopologyDescriptor Descriptor(Index n_vertices) const;
};

/// The cells of a level of a refinement.
Complex ComplexOf(const Far::Level& level);

/// Complex of flat arrays, as descriptors and files have them.
Complex ComplexOf(std::span<const Index> tets, std::span<const Index> octs);

/// A solid of tets and octahedra from a file. @throws IoError, InvalidInput if it has other cells
SolidShape ReadSolidShape(const std::filesystem::path& path, std::string feature);

/// Manifold ones, ones that meet themselves, random pieces and a real lattice. @param shapes the project's folder of
/// them
std::vector<SolidShape> SolidsOfEveryKind(const std::filesystem::path& shapes);

}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
// What VTK's own reader finds in VTU files, and what it should find.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <solidsubdiv/kit/io/mesh.h>

#include "findings.h"

namespace SolidSubdiv::Validation {

struct GridArray {
    int width = 0;
    double sum = 0;
};

/// One unstructured grid in figures.
struct GridSummary {
    std::int64_t n_points = 0;
    std::map<int, std::int64_t> n_cells;      ///< by VTK's number of the type
    double least_volume = 0;                  ///< of tets and polyhedra, signed
    double volume = 0;                        ///< their sum
    std::int64_t n_inverted = 0;              ///< how many of them are not positive
    std::map<std::string, GridArray> arrays;  ///< by "point NAME" or "cell NAME"
};

/// What a file of this mesh must hold; a cut octahedron is four tets.
GridSummary Expect(const Io::Mesh& mesh, bool keep_octahedra);

/// Runs vtk_reader.py in Debian's own Python on the files. @throws Unavailable if VTK's Python module is not there,
/// std::runtime_error if VTK can't read a file
std::vector<GridSummary> ReadByVtk(const std::filesystem::path& script,
                                   const std::vector<std::filesystem::path>& files);

/// Errors: volumes and sums of arrays, over their sizes. Faults: counts that differ, those of cells
/// without a positive volume too.
void CompareGrids(const GridSummary& expected, const GridSummary& by_vtk, Findings& findings);

}  // namespace SolidSubdiv::Validation

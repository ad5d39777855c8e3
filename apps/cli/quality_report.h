// SPDX-License-Identifier: Apache-2.0
// The quality of a mesh's cells: measured, as JSON, as text made from the JSON, and as a mesh with cell data.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include <solidsubdiv/kit/geometry/cell_quality.h>
#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Cli {

using Json = nlohmann::ordered_json;

/// One a cell, in the mesh's order. `place.element` is that of a refiner. @throws InvalidInput where there are no
/// cells, or on a fatal defect
std::vector<Geometry::CellQuality> MeasureCells(const Io::Mesh& mesh, const Progress& progress = {});

Json DescribeQuality(const Io::Mesh& mesh, const std::vector<Geometry::CellQuality>& cells);

/// The description in lines for people.
std::string QualityText(const Json& description);

/// The mesh's cells with the cell data `jacobian_minimum` and `scaled_jacobian`, and what data they had.
Io::Mesh QualityMap(const Io::Mesh& mesh, const std::vector<Geometry::CellQuality>& cells);

}  // namespace SolidSubdiv::Cli

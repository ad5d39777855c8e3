// SPDX-License-Identifier: Apache-2.0
// The picture of a refinement: control lattice, first level, last level and a cut through it, side by side.
#pragma once

#include <filesystem>

#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/io/mesh.h>
#include <solidsubdiv/sdc/progress.h>

namespace SolidSubdiv::Cli {

/// Positions of the levels that are shown.
struct PanelInput {
    const Far::TopologyRefiner& refiner;
    std::span<const double> control_positions;
    std::span<const double> first_positions;  ///< level 1; unused if it is the last, or there is none
    const Io::Mesh& last;                     ///< elements and positions of the last level
};

/// Draws the panels, all seen from the same place, and writes a PNG. @throws InvalidInput, IoError, Cancelled
void WriteRefinementPicture(const std::filesystem::path& path, const PanelInput& input, const Progress& progress);

}  // namespace SolidSubdiv::Cli

// SPDX-License-Identifier: Apache-2.0
// Files that say where vertices of a model are dragged to: a line each, `vertex x y z` and perhaps a weight.
#pragma once

#include <string>
#include <vector>

#include <solidsubdiv/apps/deform/direct_manipulation.h>

namespace SolidSubdiv::Cli {

/// Vertices count from 0; what follows a # is a comment; without a weight the target must be reached.
/// @throws IoError naming the line, also where there is no target at all
std::vector<Deform::DragTarget> ReadDragTargets(const std::string& file, Index n_vertices);

}  // namespace SolidSubdiv::Cli

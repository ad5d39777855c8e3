// SPDX-License-Identifier: Apache-2.0
// What `info` says of a mesh's topology: boundary, valences, links, cells that hardly hang together, matched faces.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Cli {

using Json = nlohmann::ordered_json;

/// Adds it. Tets, octs, triangles and edges alone are seen in the tetrahedral view, all others as they are.
/// @pre the mesh has no fatal defects
void AddTopology(const Io::Mesh& mesh, Json& json);

}  // namespace SolidSubdiv::Cli

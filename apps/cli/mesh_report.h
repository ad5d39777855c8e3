// SPDX-License-Identifier: Apache-2.0
// Everything that `info` says about a mesh, as JSON and as text made from the JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Cli {

using Json = nlohmann::ordered_json;

/// Measures a mesh of any kind. Defects are listed, however bad; nothing is thrown for them, but what can't be found
/// with fatal ones is left out, and `analysis` says so.
Json DescribeMesh(const Io::Mesh& mesh);

/// Defects by code: how many, and the first of them with their texts. `at_most` of each code are counted and `listed`
/// given.
Json DescribeDefects(const Far::TopologyDescriptor& topology, Index at_most, Index listed);
/// The same of a list that is there already.
Json DescribeDefects(const std::vector<Far::Defect>& defects, Index at_most, Index listed);

/// The description in lines for people.
std::string MeshReportText(const Json& description);

}  // namespace SolidSubdiv::Cli

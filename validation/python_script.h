// SPDX-License-Identifier: Apache-2.0
// Runs one of the validators' scripts in Debian's own Python, which may have VTK.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace SolidSubdiv::Validation {

/// What the script prints. Not the python3 of the PATH: that may be one without Debian's modules.
/// @throws Unavailable if the script exits with 3 (no VTK) or there is no such Python, std::runtime_error with what it
/// printed if it fails otherwise
std::string RunVtkScript(const std::filesystem::path& script, const std::vector<std::filesystem::path>& arguments);

}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
// The formats that work, for the help, from the list of formats.
#pragma once

#include <string>

namespace SolidSubdiv::Cli {

/// "Files read: .vtu, .vtk, .obj"
std::string ReadableFilesHelp();
/// "Volumes: .nii, .nrrd; points: .xyz, .pcd"
std::string ReadableTargetsHelp();
/// "Files written: solids .vtu, .vtk; surfaces .vtu, .vtk, .obj"
std::string WritableFilesHelp();

}  // namespace SolidSubdiv::Cli

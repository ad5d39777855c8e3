// SPDX-License-Identifier: Apache-2.0
// Pictures of deformations of models from elsewhere; README.md says what is on them, and where the models are from.
#pragma once

#include <filesystem>

namespace SolidSubdiv::Picture {

/// Draws the pictures deformation_*.png whose models are found, at any depth, in the folder `models`; says which are
/// left out.
void DrawDeformations(const std::filesystem::path& models, const std::filesystem::path& out);

}  // namespace SolidSubdiv::Picture

// SPDX-License-Identifier: Apache-2.0
// A solid with its cells coloured by quality: from outside, cut open, and the worst cells by themselves.
#pragma once

#include <optional>
#include <span>
#include <string>

#include <solidsubdiv/kit/io/mesh.h>
#include <solidsubdiv/kit/picture/cut.h>
#include <solidsubdiv/kit/picture/panels.h>

namespace SolidSubdiv::Picture {

struct QualityPictureOptions {
    View view{.azimuth = 20, .elevation = 14};
    RenderOptions render{.width = 640, .height = 600};  ///< of one panel
    std::optional<Plane> plane{};                       ///< otherwise through the middle, facing the viewer
    std::string title = "scaled Jacobian";              ///< of the colours
};

/// `quality`: one number a cell, in the order of cell data, 1 the best. Colours run from 0 to 1; what is not positive
/// is red. The worst cells are those of the least twentieth, with the sides of the solid's boundary around them.
/// @throws InvalidInput if there are no cells, or another number of qualities
Image QualityPicture(const Io::Mesh& mesh, std::span<const double> quality, const QualityPictureOptions& options = {},
                     const Progress& progress = {});

}  // namespace SolidSubdiv::Picture

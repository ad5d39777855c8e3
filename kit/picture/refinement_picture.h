// SPDX-License-Identifier: Apache-2.0
// The picture that tells a refinement: the control lattice around its shape, level 1, and what the refined solid looks
// like inside.
#pragma once

#include <span>
#include <string>

#include <solidsubdiv/kit/io/mesh.h>
#include <solidsubdiv/kit/picture/panels.h>

namespace SolidSubdiv::Picture {

struct RefinementPictureOptions {
    View view{.azimuth = 20, .elevation = 14};
    RenderOptions render{.width = 640, .height = 600};  ///< of one panel
    PanelOptions panels{.columns = 2};
    std::string
        attribute{};  ///< point data (width 1) shown inside the last level; empty: the first that varies, if any
};

/// `levels`: the control mesh and its refinements, coarsest first, all with the same point data. For solids four
/// panels: lattice and shape, level 1, level 2 (or the last) cut open with the kinds of cells told apart, the last
/// level sliced with the attribute inside. For surfaces the first two, the last level (from 2 on) smooth, and the same
/// with reflection lines, which break where it has no tangent plane.
/// @throws InvalidInput if there is no level, nothing to show, or no such attribute
Image RefinementPicture(std::span<const Io::Mesh* const> levels, const RefinementPictureOptions& options = {},
                        const Progress& progress = {});

}  // namespace SolidSubdiv::Picture

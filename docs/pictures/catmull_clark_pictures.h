// SPDX-License-Identifier: Apache-2.0
// Pictures of solids of any cells; README.md says what is on them.
#pragma once

#include <solidsubdiv/kit/picture/image.h>

namespace SolidSubdiv::Picture {

/// Levels 0 to 2 of a lattice of hexahedra, wedges, pyramids and tets, above from outside and below cut open.
Image CatmullClarkSolid();

/// A spike along an inner edge of three hexahedra, sliced, under catmull-clark-solid and mlca.
Image SpikeAlongEdge();

/// An L of hexahedra with sharp and with smooth features.
Image CatmullClarkFeatures();

}  // namespace SolidSubdiv::Picture

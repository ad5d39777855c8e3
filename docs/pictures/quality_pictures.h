// SPDX-License-Identifier: Apache-2.0
// The picture of the quality of cells; README.md says what is on it.
#pragma once

#include <solidsubdiv/kit/picture/image.h>

namespace SolidSubdiv::Picture {

/// A twisted bar of hexahedra whose inner vertices are shaken until some cells are folded.
Image QualityOfATwistedBar();

}  // namespace SolidSubdiv::Picture

// SPDX-License-Identifier: Apache-2.0
// The picture of tessellations; README.md says what is on it.
#pragma once

#include <solidsubdiv/kit/picture/image.h>

namespace SolidSubdiv::Picture {

/// A frame of eight hexahedra: its limit at a rate, by the tolerance that the rate reaches, and its inside in tets.
Image TessellationsOfAFrame();

}  // namespace SolidSubdiv::Picture

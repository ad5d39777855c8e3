// SPDX-License-Identifier: Apache-2.0
// Faces that are holes: they take part in subdivision, so that the surface around them is what it would be without a
// hole, and are left out of what comes of it (OpenSubdiv's setBaseFaceHole).
//
// In a mesh they are the triangles, quadrilaterals and polygons whose cell data `hole` is not 0; in OBJ files
// OpenSubdiv's tag `t hole 1/0/0 <face>`.
#pragma once

#include <string_view>
#include <vector>

#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Io {

/// Name of the cell data, one number an element.
inline constexpr std::string_view kHole = "hole";

/// The mesh's `hole`, if it has cell data of that name and of width 1; else null.
const Attribute* FindHoles(const Mesh& mesh);

/// Rows of cell data of the faces that are holes, ascending. The data of cells, edges and vertices mean nothing.
/// Cost: linear. @throws InvalidInput if `hole` has not one number an element
std::vector<Offset> HolesOf(const Mesh& mesh);

}  // namespace SolidSubdiv::Io

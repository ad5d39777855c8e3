// SPDX-License-Identifier: Apache-2.0
// Points in space that nothing connects: what a scanner gives, and what shapes are fitted to.
#pragma once

#include <string>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Geometry {

/// Points, some clouds with the normal of the scanned surface at each. All numbers are finite.
struct PointCloud {
    std::vector<double> positions;  ///< (n_points, 3), in the file's unit
    /// (n_points, 3), or empty where the points have none; of the lengths that the file gives them (most give 1). The
    /// zero vector says that the normal of this point is unknown.
    std::vector<double> normals;

    std::vector<std::string> notes;  ///< what the reader did that the user should know, a line each

    Offset n_points() const { return static_cast<Offset>(positions.size() / 3); }
    bool has_normals() const { return !normals.empty(); }
};

}  // namespace SolidSubdiv::Geometry

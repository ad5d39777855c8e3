// SPDX-License-Identifier: Apache-2.0
// A target parted along its sharp edges.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include <solidsubdiv/apps/fit/control_mesh.h>
#include <solidsubdiv/apps/fit/internal/vec3.h>
#include <solidsubdiv/kit/geometry/closest_point.h>

namespace SolidSubdiv::Fit::Internal {

/// Numbers of patches.
using PatchSet = std::set<Index>;

/// Triangles that hang together without crossing a sharp edge are a patch.
struct Patches {
    struct Corner {
        Vec3 at;
        PatchSet patches;  ///< three and more
    };
    struct OnCurve {
        Vec3 at;
        double distance = 0;
    };

    Index n_patches = 0;
    std::vector<Index> patch_of;  ///< of each triangle
    std::vector<Corner> corners{};

    /// The target must outlive this.
    Patches(const TargetSurface& target, double degrees);

    /// The patch that is nearest to each of the points.
    std::vector<Index> NearestTo(std::span<const double> points) const;
    /// Of those given, the patch beside a triangle that looks the most as it does.
    Index NearestOf(const PatchSet& which, const std::array<Vec3, 3>& triangle) const;
    /// The point of the sharp edges between two patches that is nearest to an edge; none where there are no such edges.
    std::optional<OnCurve> NearestOnCurve(Index a, Index b, const Vec3& start, const Vec3& end) const;

  private:
    TargetSurface target_;
    Geometry::ClosestPoints surface_;
    std::map<std::pair<Index, Index>, std::vector<std::pair<Vec3, Vec3>>> curves_;
};

}  // namespace SolidSubdiv::Fit::Internal

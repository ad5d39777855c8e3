// SPDX-License-Identifier: Apache-2.0
// Which voxels of a fine grid lie inside a closed surface, and how many of a box.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <solidsubdiv/apps/fit/internal/vec3.h>

namespace SolidSubdiv::Fit::Starting {

using namespace Internal;

/// Voxels are counted as rays along x, y and z through their middles see them, two of three: what is wrong with a
/// surface in one place misleads one of them.
class InsideGrid {
  public:
    /// Positions in [-1/2, 1/2]^3, `n_voxels` a unit. By parity a voxel is inside where a ray has crossed an odd number
    /// of triangles, whatever their orientation; else where they wind around it.
    InsideGrid(std::span<const double> positions, std::span<const Index> triangles, int n_voxels, bool by_parity);

    bool IsEmpty() const { return sums_.back() == 0; }
    /// The part of a box that is inside.
    double Fraction(const Vec3& low, const Vec3& high) const;
    /// The low and the high end of what is inside. @pre not empty
    std::array<Vec3, 2> Bounds() const { return {low_, high_}; }
    /// Middles of about n voxels inside that lie at the surface, evenly strewn, (n, 3).
    std::vector<double> SurfacePoints(std::size_t n) const;
    double Volume() const;

  private:
    struct Crossing;
    void VoteAlong(std::size_t axis, std::span<const double> positions, std::span<const Index> triangles,
                   bool by_parity, std::vector<std::uint8_t>& votes) const;
    std::size_t At(int x, int y, int z) const {
        return static_cast<std::size_t>(x) +
               static_cast<std::size_t>(n_[0]) *
                   (static_cast<std::size_t>(y) + static_cast<std::size_t>(n_[1]) * static_cast<std::size_t>(z));
    }
    /// Voxels inside with numbers below x, y, z.
    std::int32_t Sum(int x, int y, int z) const {
        return sums_[static_cast<std::size_t>(x) +
                     static_cast<std::size_t>(n_[0] + 1) *
                         (static_cast<std::size_t>(y) +
                          static_cast<std::size_t>(n_[1] + 1) * static_cast<std::size_t>(z))];
    }
    Vec3 MiddleOf(int x, int y, int z) const { return origin_ + width_ * Vec3{x + .5, y + .5, z + .5}; }

    double width_;
    Vec3 origin_{}, low_{}, high_{};
    std::array<int, 3> n_{};
    std::vector<std::uint8_t> inside_;
    std::vector<std::int32_t> sums_;
};

}  // namespace SolidSubdiv::Fit::Starting

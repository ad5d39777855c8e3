// SPDX-License-Identifier: Apache-2.0
// Cubes of a regular grid that stand for a solid, and what their boundary is like.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <solidsubdiv/apps/fit/internal/start/inside_grid.h>

namespace SolidSubdiv::Fit::Starting {

/// Where the grid lies and which of its cubes are kept at first.
struct BlockChoice {
    double size = 0;                ///< of a cube's side
    std::array<double, 3> phase{};  ///< [0, 1): the middle of the solid's box, in cubes from a corner of one
    double threshold = .5;          ///< cubes stay of which so much lies inside
    /// And cubes beside them in turn where so much is inside of what is further than half a cube from each of those:
    /// thin parts have no cube that they fill. 1: none.
    double growth = 1;
};

/// What the boundary of a solid has, or should have.
struct SolidTopology {
    Offset n_solids = 1, n_cavities = 0;
    Offset euler = 2;  ///< of the boundary
    friend bool operator==(const SolidTopology&, const SolidTopology&) = default;
};

class Blocks {
  public:
    Blocks(const InsideGrid& grid, const BlockChoice& choice);

    /// Adds and removes cubes until no two faces of the boundary that meet in a corner look against each other:
    /// around a corner, boundary faces then look up or down along each axis, but not both. So the cubes around it are,
    /// but for reflections, with each cube also those nearer to the first in any axis: a stair, whose surface is a disc
    /// (the boundary is a manifold), and that a layer of cells can be laid on. Where several cubes would do, the one
    /// that leaves the fewest such corners, then the one whose part inside is nearest to the threshold.
    /// @returns whether it came to an end
    bool Repair();

    /// Keeps the largest n_solids pieces and n_cavities cavities, fills and removes others. @pre Repair()
    void Trim(Offset n_solids, Offset n_cavities);

    /// @pre Repair()
    SolidTopology Topology() const;

    /// The corners that cubes have, and those of them on the boundary.
    struct Counts {
        Index corners = 0, boundary_corners = 0, cubes = 0;
    };
    Counts Count() const;

    /// Corners by z, y, x, where they are; cubes in VTK's order; both by their places.
    struct Mesh {
        std::vector<double> positions;            ///< (n, 3)
        std::vector<Index> hexes;                 ///< (m, 8)
        std::vector<std::array<Index, 3>> cells;  ///< (m)
        std::vector<std::array<int, 3>> outward;  ///< (n): the signs of where boundary faces at it look, or zeros
        std::vector<Index> quads;                 ///< (k, 4): boundary faces, counterclockwise from outside
    };
    Mesh MakeMesh() const;
    double size() const { return size_; }  ///< of a cube's side

  private:
    void Grow(const InsideGrid& grid, double growth);
    bool IsIn(int x, int y, int z) const { return in_[At(x, y, z)] != 0; }
    std::size_t At(int x, int y, int z) const { return static_cast<std::size_t>(x + n_[0] * (y + n_[1] * z)); }
    /// Where boundary faces at the low corner of a cube look along each axis: 1 up, -1 down, 2 both.
    std::array<int, 3> Outward(int x, int y, int z) const;
    bool IsCritical(int x, int y, int z) const;
    int CountCritical(int x, int y, int z) const;  ///< corners of a cube
    void MendCorner(int x, int y, int z, std::vector<std::uint8_t>& is_final);
    std::vector<std::size_t> Pieces(std::uint8_t kind) const;
    template <class Function>
    void ForEachCorner(Function&& function) const;

    double size_, threshold_;
    Vec3 origin_{};
    std::array<int, 3> n_{};  ///< cubes, with two empty ones at each end
    std::vector<std::uint8_t> in_;
    std::vector<double> parts_;  ///< inside
};

}  // namespace SolidSubdiv::Fit::Starting

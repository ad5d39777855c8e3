// SPDX-License-Identifier: Apache-2.0
// Where points lie in a solid: the cell of a level that holds each, and the coordinates in it (far/place.h).
//
//     const Geometry::Locator locator(refiner, 2, positions);    // once; positions are those of level 2
//     const Geometry::Location found = locator.Locate(points);   // as often as needed
//     const auto rows = Far::MakePlaceRows(refiner, 2, found.places);
//
// Every place has coordinates within their ranges, and its point lies within the tolerance of the point asked for. What
// no cell holds is listed as outside, with the nearest place there is: it may be taken instead, or left out.
//
// A point on a face belongs to the cell of the lowest number among those that hold it, and to the lowest part within
// the cell. So it does where a solid is folded and cells lie over each other: cell_quality.h finds such cells. Inverted
// and flat cells hold points as others do.
//
// Tets, the four tets of an octahedron, and the parts of other cells are linear and solved as such; in hexahedra a
// descent finds a place or bounds prove that there is none (internal/nearest_in_hex.h).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <solidsubdiv/far/place.h>
#include <solidsubdiv/sdc/progress.h>

namespace SolidSubdiv::Geometry {

struct LocateOptions {
    /// In the unit of the positions, [0, 1e75]: points that no cell holds but that lie so near to one are not listed as
    /// outside; their places are the nearest. Points within Locator::round_off() of a cell are held anyway.
    double tolerance = 0;
    /// Find the nearest places of points outside; otherwise their places are without element (kNoIndex) and their
    /// distances infinite.
    bool wants_nearest = true;
    Progress progress{};

    /// @throws InvalidInput
    void Validate() const;
};

struct OutsidePoint {
    Index point = 0;
    double distance = 0;  ///< from the nearest place; in hexahedra it is at most a part in 1e6 larger than the least
};

struct Location {
    std::vector<Far::Place> places;     ///< (n_points): of what lies outside the nearest
    std::vector<OutsidePoint> outside;  ///< ascending by point
};

class Locator {
  public:
    /// The refiner and `positions`, (vertices of the level, 3), must outlive this. Cost: boxes of all cells and a sort,
    /// about 32 bytes a cell.
    /// @throws InvalidInput where there is no such level, no cell in it, or a position is not finite or beyond 1e75
    Locator(const Far::TopologyRefiner& refiner, int level, std::span<const double> positions);

    /// Places of points, (n, 3). Parallel; the same bits for any number of threads and any order of the points.
    /// @throws InvalidInput naming the first point that is not finite or beyond 1e75, Cancelled
    Location Locate(std::span<const double> points, const LocateOptions& options = {}) const;

    /// 64 units of rounding of the largest coordinate: a point that is the sum of weighted vertices is off by a unit a
    /// weight at most, so by 8 in most cells, and the coordinates found by some more.
    double round_off() const;
    /// Bytes kept beside the refiner and the positions.
    Offset Bytes() const;

    ~Locator();
    Locator(Locator&&) noexcept;
    Locator& operator=(Locator&&) noexcept;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace SolidSubdiv::Geometry

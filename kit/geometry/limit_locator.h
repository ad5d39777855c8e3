// SPDX-License-Identifier: Apache-2.0
// Where points lie in the limit of a solid: the cell of a level whose limit holds each, and the coordinates in it.
//
//     const Geometry::LimitLocator locator(refiner, Sdc::BoxSpline{}, 2, positions);  // positions of level 2
//     const auto found = locator.Locate(points);
//     const auto rows = Far::LimitStencilTable::Create(refiner, Sdc::BoxSpline{}, found.places, {.level = 2});
//
// A start is found in the level's cells with their vertices in the limit (locator.h), then Newton's steps within a cell
// where the limit has derivatives and they stay inside, and otherwise the start again for a point moved by what is
// missing. The finer the level, the nearer the start: levels 1 to 3 are usual.
#pragma once

#include <memory>
#include <span>

#include <solidsubdiv/far/limit_stencil_table.h>
#include <solidsubdiv/kit/geometry/locator.h>

namespace SolidSubdiv::Geometry {

struct LimitLocateOptions {
    /// In units of the positions; how far the limit at a place may be from the point. 0: 1e-12 of the diagonal of the
    /// positions' box, which rounding leaves room for.
    double tolerance = 0;
    int max_steps = 40;  ///< [1, 1000]: of each point
    Progress progress{};

    /// @throws InvalidInput
    void Validate() const;
};

class LimitLocator {
  public:
    /// The refiner must outlive this; positions, (vertices of the level, 3), are copied.
    /// @throws InvalidInput as Locator and LimitStencilTableFactory
    LimitLocator(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme, int level,
                 std::span<const double> positions);
    ~LimitLocator();
    LimitLocator(LimitLocator&&) noexcept;
    LimitLocator& operator=(LimitLocator&&) noexcept;

    /// Places of points, (n, 3), whose limits are within the tolerance. What has none is listed as outside, with the
    /// place of the nearest limit that was met on the way and its distance: nearest to within the size of a cell's
    /// bulge, not to round-off. Where cells fold over each other any of the places may be found, and where the limit
    /// turns a cell inside out a point of it may be missed: cell_quality.h finds such cells. The same bits for any
    /// number of threads. @throws InvalidInput as Locator::Locate, Cancelled
    Location Locate(std::span<const double> points, const LimitLocateOptions& options = {});

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace SolidSubdiv::Geometry

// SPDX-License-Identifier: Apache-2.0
// Embree's hierarchy in place of ours under the same tests of cells: cells as user geometry, points as queries of
// radius 0. For the race of location.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <solidsubdiv/far/place.h>

namespace SolidSubdiv::Perf {

class EmbreeLocator {
  public:
    /// Builds the hierarchy on n_threads threads. The refiner and positions must outlive this.
    EmbreeLocator(const Far::TopologyRefiner& refiner, int level, std::span<const double> positions, int n_threads);
    ~EmbreeLocator();

    /// Whether the bench was built with Embree.
    static bool IsThere();

    /// The place in the lowest cell that holds each point, kNoIndex where there is none. Points are taken in the order
    /// of the curve and a few at a time, as by our locator.
    std::vector<Far::Place> Locate(std::span<const double> points) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace SolidSubdiv::Perf

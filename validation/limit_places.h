// SPDX-License-Identifier: Apache-2.0
// Holds limit rows at places, and derivatives, to what the plain walk of limit_walk.h finds there.
#pragma once

#include <string>
#include <vector>

#include <solidsubdiv/far/limit_stencil_table.h>

#include "findings.h"
#include "limit_walk.h"

namespace SolidSubdiv::Validation {

/// A table's rows, which tests may change.
struct LimitRows {
    Far::StencilRows<double> rows;
    std::vector<Far::StencilRows<double>> derivatives;
    std::vector<int> orders;  ///< of each row: derivatives up to which are there; -1: no limit
};

/// By the library.
LimitRows MakeLimitRows(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                        std::span<const Far::Place> places, const Far::LimitPlacesOptions& options);

enum class WhereInElements { Inside, OnSides };  ///< on faces, edges and corners, or inside after all

/// Random ones.
std::vector<Far::Place> RandomLimitPlaces(const Far::TopologyRefiner& refiner, Far::Elements elements, int n,
                                          std::uint32_t seed, WhereInElements where);

/// What was compared with what certainty.
struct LimitTally {
    std::int64_t n_to_tolerance = 0, n_to_bound = 0, n_without_limit = 0, n_slopes = 0, n_curvatures = 0;
    std::array<std::int64_t, 3> n_unsettled{};  ///< points, slopes, second derivatives that walks know nothing sure of
    std::vector<double> bounds, slope_bounds, curvature_bounds;  ///< over the size

    void Merge(const LimitTally& other);
    std::string Text() const;
};

/// Of each place what walks found, for each scheme: [scheme][place].
std::vector<std::vector<std::vector<LimitEstimate>>> WalkToPlaces(const OwnedMesh& mesh, Sdc::Split split,
                                                                  const std::vector<Sdc::Scheme>& schemes,
                                                                  const std::vector<double>& positions,
                                                                  std::span<const Far::Place> places,
                                                                  Far::Elements elements);

/// Where there is no closed form slopes are differences over 2^-26: round-off of tens of weights times 2^26.
inline constexpr double kSlopeRoundOff = 3e-7;

/// Errors over the shape's size, in whole where the walk is certain to kLimitCertainty, otherwise less how far it may
/// be off by what its last levels did; and sums of weights.
inline constexpr double kLimitCertainty = 1e-9;
LimitTally CompareWithWalks(const LimitRows& rows, const std::vector<double>& positions,
                            const std::vector<std::vector<LimitEstimate>>& walks, Findings& findings);

}  // namespace SolidSubdiv::Validation

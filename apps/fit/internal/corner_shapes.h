// SPDX-License-Identifier: Apache-2.0
// An energy that is low where corners of cells are well shaped, and rises steeply where they get flat.
#pragma once

#include <array>
#include <span>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Fit::Internal {

/// The scaled Jacobian of a corner, in [-1, 1]: the determinant of the directions of its three edges.
double CornerQuality(const std::array<Index, 4>& corner, std::span<const double> positions);

/// Sum over corners of (1 / chi(q) - 1 / chi(enough))^2 where q, a corner's scaled
/// Jacobian, is not `enough`, with chi(q) = (q + sqrt(q^2 + 4 softness^2)) / 2. It is 0 for well shaped corners, 1 /
/// softness^2 and more where they are flat, and grows on, smoothly, where they are folded, so that they unfold. Adds
/// `factor` times its slope (n, 3), if asked for. Corners of an edge without length count as flat. Source of chi:
/// garanzha2021foldover.
double CornerEnergy(std::span<const std::array<Index, 4>> corners, std::span<const double> enough,
                    std::span<const double> positions, double softness, double factor, std::span<double> slope);

}  // namespace SolidSubdiv::Fit::Internal

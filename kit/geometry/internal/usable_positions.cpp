// SPDX-License-Identifier: Apache-2.0
// Refuses positions by name.
#include <solidsubdiv/kit/geometry/internal/usable_positions.h>

#include <cmath>
#include <string>

namespace SolidSubdiv::Geometry::Internal {

void RequireUsable(std::span<const double> positions, const char* what) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (std::abs(positions[i]) <= kLargestCoordinate) continue;
        throw InvalidInput(std::string(what) + " " + std::to_string(i / 3) + ": coordinate " + std::to_string(i % 3) +
                           " is " + std::to_string(positions[i]) + ", not finite or beyond 1e75");
    }
}

void RequirePositionsOfLevel(const Far::TopologyRefiner& refiner, int level, std::span<const double> positions) {
    if (level < 0 || level > refiner.max_level()) {
        throw InvalidInput("there is no level " + std::to_string(level) + ": the refiner's last is " +
                           std::to_string(refiner.max_level()));
    }
    if (positions.size() != 3 * static_cast<std::size_t>(refiner.n_vertices(level))) {
        throw InvalidInput(std::to_string(positions.size()) + " numbers for the positions of " +
                           std::to_string(refiner.n_vertices(level)) + " vertices; must be three a vertex");
    }
    RequireUsable(positions, "vertex");
}

}  // namespace SolidSubdiv::Geometry::Internal

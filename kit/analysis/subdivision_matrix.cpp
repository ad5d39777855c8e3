// SPDX-License-Identifier: Apache-2.0
// Matrices from the rows between the last two levels of a refiner.
#include <solidsubdiv/kit/analysis/subdivision_matrix.h>

#include <solidsubdiv/kit/analysis/internal/neighborhood.h>

namespace SolidSubdiv::Analysis {

std::optional<Far::LocalMatrix> MatrixAround(const Far::TopologyRefiner& refiner, int level, Index vertex,
                                             const Sdc::Scheme& scheme) {
    const int last = refiner.max_level();
    if (level < 0 || level >= last || vertex < 0 || vertex >= refiner.n_vertices(level)) {
        throw InvalidInput("vertex " + std::to_string(vertex) + " of level " + std::to_string(level) +
                           " is asked for; the refiner must have that vertex and a level after it");
    }
    const Far::StencilTable table = Far::StencilTable::Create(refiner, scheme);
    const Internal::Neighborhood neighborhood(refiner, level, vertex, last - 1);
    return neighborhood.Close(Internal::RingOf(refiner, last - 1, vertex), table.level(last));
}

}  // namespace SolidSubdiv::Analysis

// SPDX-License-Identifier: Apache-2.0
// Calls OpenSubdiv and copies its answers out.
#include "loop_oracle.h"

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/stencilTable.h>
#include <opensubdiv/far/stencilTableFactory.h>

#include <memory>
#include <stdexcept>

#include "osd_position.h"
#include "osd_topology_oracle.h"

namespace SolidSubdiv::Validation {

namespace {

namespace Theirs = OpenSubdiv::Far;

void CopyRows(const Theirs::TopologyRefiner& refiner, int max_row_level, std::vector<SurfaceLevel>& levels) {
    using Factory = Theirs::StencilTableFactoryReal<double>;
    Factory::Options options;
    options.generateIntermediateLevels = true;
    options.factorizeIntermediateLevels = true;
    options.maxLevel = static_cast<unsigned>(max_row_level);
    const std::unique_ptr<const Theirs::StencilTableReal<double>> table(Factory::Create(refiner, options));
    int next = 0;
    for (int l = 1; l <= max_row_level; ++l) {
        SurfaceLevel& level = levels[l];
        level.row_offsets.push_back(0);
        for (int v = 0; v < level.n_vertices; ++v) {
            const auto row = table->GetStencil(next++);
            level.row_indices.insert(level.row_indices.end(), row.GetVertexIndices(),
                                     row.GetVertexIndices() + row.GetSize());
            level.row_weights.insert(level.row_weights.end(), row.GetWeights(), row.GetWeights() + row.GetSize());
            level.row_offsets.push_back(static_cast<std::int64_t>(level.row_indices.size()));
        }
    }
    if (next != table->GetNumStencils()) throw std::runtime_error("OpenSubdiv's table has an unexpected length");
}

template <class Surface>
std::vector<SurfaceLevel> Refine(const Surface& surface, int max_level, int max_row_level) {
    const auto refiner = MakeOpenSubdivRefiner(surface, max_level);
    std::vector<SurfaceLevel> levels(static_cast<std::size_t>(max_level) + 1);
    std::vector<Position> values(static_cast<std::size_t>(surface.n_vertices)), finer;
    for (std::size_t v = 0; v < values.size(); ++v) {
        for (std::size_t i = 0; i < 3; ++i) values[v].x[i] = surface.positions[3 * v + i];
    }
    const Theirs::PrimvarRefinerReal<double> primvars(*refiner);
    for (int l = 0; l <= max_level; ++l) {
        SurfaceLevel& level = levels[l];
        CopyTopology(refiner->GetLevel(l), l == max_level, level, std::is_same_v<Surface, PolygonSurface>);
        if (l > 0) {
            finer.assign(static_cast<std::size_t>(level.n_vertices), {});
            primvars.Interpolate(l, values, finer);
            std::swap(values, finer);
        }
        for (const Position& p : values) level.positions.insert(level.positions.end(), p.x, p.x + 3);
    }
    if (max_row_level > 0) CopyRows(*refiner, max_row_level, levels);
    return levels;
}

}  // namespace

std::vector<SurfaceLevel> RefineByOpenSubdiv(const ControlSurface& surface, int max_level, int max_row_level) {
    return Refine(surface, max_level, max_row_level);
}

std::vector<SurfaceLevel> RefineByOpenSubdiv(const PolygonSurface& surface, int max_level, int max_row_level) {
    return Refine(surface, max_level, max_row_level);
}

}  // namespace SolidSubdiv::Validation

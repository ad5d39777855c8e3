// SPDX-License-Identifier: Apache-2.0
// Places by arithmetic on the numbering of children.
#include "refined_points.h"

#include "meshes.h"

namespace SolidSubdiv::Validation {

namespace {

LatticePoint Plus(const LatticePoint& a, const LatticePoint& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

}  // namespace

RefinedPoints RefinePoints(const std::vector<LatticePoint>& points, const std::vector<std::array<int, 4>>& tets,
                           const std::vector<std::array<int, 6>>& octs, int max_level) {
    const CellArrays cells(Complex{tets, octs});
    RefinedPoints refined{
        Far::TopologyRefiner::Create(cells.Descriptor(static_cast<Index>(points.size())), Sdc::Split::TetOct),
        {points}};
    Far::UniformRefinementOptions options;
    options.max_level = max_level;
    options.full_topology_in_last_level = true;
    refined.refiner.RefineUniform(options);
    // Children: vertices stay (their coordinates double), then middles of edges, then middles of major diagonals.
    for (int l = 0; l < max_level; ++l) {
        const Far::Level& level = refined.refiner.level(l);
        const std::vector<LatticePoint>& parents = refined.points[l];
        std::vector<LatticePoint> children;
        for (const LatticePoint& p : parents) children.push_back(Plus(p, p));
        for (Index e = 0; e < level.n_edges; ++e) {
            const auto ends = level.EdgeVertices(e);
            children.push_back(Plus(parents[ends[0]], parents[ends[1]]));
        }
        for (Index o = 0; o < level.n_octs; ++o) {
            const auto v = level.OctVertices(o);
            children.push_back(Plus(parents[v[0]], parents[v[1]]));
        }
        refined.points.push_back(std::move(children));
    }
    return refined;
}

}  // namespace SolidSubdiv::Validation

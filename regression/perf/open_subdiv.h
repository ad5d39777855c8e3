// SPDX-License-Identifier: Apache-2.0
// OpenSubdiv at its fastest documented use, behind plain types: a surface refined, its tables, its evaluator.
#pragma once

#if SOLIDSUBDIV_HAS_OPENSUBDIV

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <solidsubdiv/far/topology_descriptor.h>

#include "perf/surface_peers.h"

namespace SolidSubdiv::Perf {

class OpenSubdivSurface {
  public:
    /// Triangles by Loop's scheme, or quadrilaterals by Catmull and Clark's.
    OpenSubdivSurface(const Far::TopologyDescriptor& mesh, std::span<const double> positions, int n_levels);
    ~OpenSubdivSurface();

    void Create();
    void Refine(bool full_topology_in_last_level);
    /// Rows of every level over the one before.
    void MakeCascaded();
    /// Rows of the last level over the control vertices.
    void MakeComposite();
    /// Refines positions level by level.
    void Interpolate();
    /// Frees the table and all levels but the first.
    void Clear();
    /// Holds another's table from now on.
    void TakeTable(OpenSubdivSurface& other);

    /// What its tables hold, for the report.
    std::string Describe();
    /// Of the interpolated points.
    PointSums Sums() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// OpenSubdiv's limit stencils, with derivatives, at places on quadrilaterals; adaptive refinement included.
class OpenSubdivLimits {
  public:
    OpenSubdivLimits(std::span<const Index> quads, Index n_vertices);
    ~OpenSubdivLimits();

    void AddPlace(Index face, double u, double v);
    void Make();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Compressed rows as OpenSubdiv's evaluator takes them.
struct OpenSubdivRows {
    std::vector<int> sizes, offsets;
    const int* indices;
    const float* weights;
};

/// Osd::CpuEvaluator on packed rows of `width`.
void EvaluateByOpenSubdiv(const OpenSubdivRows& rows, const float* source, float* destination, int width);

}  // namespace SolidSubdiv::Perf

#endif

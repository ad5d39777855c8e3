// SPDX-License-Identifier: Apache-2.0
// A round of fitting a Loop cage as users of OpenSubdiv and Ceres write it.
#pragma once

#if SOLIDSUBDIV_HAS_OPENSUBDIV

#include <memory>
#include <span>

#include <solidsubdiv/apps/fit/internal/step.h>

namespace SolidSubdiv::Perf {

/// Weights of limit points are OpenSubdiv's limit stencils, made for the points of the round; each point is a residual
/// block of its own, with these weights as derivatives.
class OpenSubdivFit {
  public:
    /// @param rate of the problem's surface
    OpenSubdivFit(const Fit::ControlMesh& cage, int rate);
    ~OpenSubdivFit();

    /// What Fit::Internal::SolveStep does, by Levenberg-Marquardt.
    void Solve(const Fit::Internal::StepSettings& settings, std::span<const Fit::Internal::Pair> pairs, double fairness,
               std::span<double> control) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace SolidSubdiv::Perf

#endif

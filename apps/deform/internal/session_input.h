// SPDX-License-Identifier: Apache-2.0
// Checks of what an editing session is given.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/apps/deform/editing_session.h>

namespace SolidSubdiv::Deform::Internal {

/// @throws InvalidInput, all of them
void CheckSessionInput(const std::vector<SessionLevel>& levels, std::span<const double> points);
void CheckSessionLevel(int level, int n_levels);
void CheckMove(std::span<const Index> control_points, std::span<const double> positions, Index n_control_points);

}  // namespace SolidSubdiv::Deform::Internal

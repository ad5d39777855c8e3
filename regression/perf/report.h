// SPDX-License-Identifier: Apache-2.0
// Results of races as a table for people (Markdown) and as JSON for programs.
#pragma once

#include <string>
#include <vector>

#include "perf/machine.h"
#include "perf/races.h"

namespace SolidSubdiv::Perf {

std::string TableOf(const Race& race);
std::string TextOf(const MachineInfo& machine);
std::string JsonOf(const MachineInfo& machine, const std::vector<Race>& races, const RaceSettings& settings);

}  // namespace SolidSubdiv::Perf

// SPDX-License-Identifier: Apache-2.0
// The one visible list of races. A new one is a source file with its function, and a line here.
#pragma once

#include "perf/race.h"

namespace SolidSubdiv::Perf {

struct RaceSettings {
    bool is_quick = false;  ///< a tenth of the size, three rounds: to see that it works, not to quote
    int Rounds(int n) const { return is_quick ? 3 : n; }
};

Race RaceTets(const RaceSettings& settings);
Race RaceTriangles(const RaceSettings& settings);
Race RaceEvaluation(const RaceSettings& settings);

struct RaceEntry {
    const char* name;
    Race (*run)(const RaceSettings& settings);
};
inline constexpr RaceEntry kRaces[] = {
    {"tets", &RaceTets},
    {"triangles", &RaceTriangles},
    {"evaluation", &RaceEvaluation},
};

}  // namespace SolidSubdiv::Perf

// SPDX-License-Identifier: Apache-2.0
// The one visible list of races. A new one is a source file with its function, and a line here.
#pragma once

#include "perf/race.h"

namespace SolidSubdiv::Perf {

struct RaceSettings {
    bool is_quick = false;  ///< a tenth of the size, three turns: to see that it works, not to quote
    int max_threads = 2;    ///< races run on one thread and, where this is more, on two
    int Turns(int n) const { return is_quick ? 3 : n; }
    std::vector<int> ThreadCounts() const { return max_threads > 1 ? std::vector{1, 2} : std::vector{1}; }
};

Race RaceTets(const RaceSettings& settings);
Race RaceHexes(const RaceSettings& settings);
Race RaceHexModels(const RaceSettings& settings);
Race RaceHexesCatmarkFresh(const RaceSettings& settings);
Race RaceHexesCatmarkKept(const RaceSettings& settings);
/// Twice: every candidate on fresh memory, and on memory that the process kept.
Race RaceTrianglesFresh(const RaceSettings& settings);
Race RaceTrianglesKept(const RaceSettings& settings);
Race RaceQuadsFresh(const RaceSettings& settings);
Race RaceQuadsKept(const RaceSettings& settings);
Race RacePipelinesFresh(const RaceSettings& settings);
Race RacePipelinesKept(const RaceSettings& settings);
Race RaceInterpolatory(const RaceSettings& settings);
Race RaceEvaluation(const RaceSettings& settings);
Race RaceLocation(const RaceSettings& settings);
Race RaceLimits(const RaceSettings& settings);
/// Of models of so many vertices.
Race RaceDeform(const RaceSettings& settings, int n_vertices);
Race RaceDeformKoala(const RaceSettings& settings);
Race RaceEmbedding(const RaceSettings& settings);
#if defined(SOLIDSUBDIV_HAS_FIT)
Race RaceFit(const RaceSettings& settings);
#endif
#if defined(SOLIDSUBDIV_HAS_VOXEL)
Race RaceVoxels(const RaceSettings& settings);
#endif

struct RaceEntry {
    const char* name;
    Race (*run)(const RaceSettings& settings);
};
inline constexpr RaceEntry kRaces[] = {
    {"tets", &RaceTets},
    {"hexes", &RaceHexes},
    {"hexes-models", &RaceHexModels},
    {"hexes-catmark-fresh", &RaceHexesCatmarkFresh},
    {"hexes-catmark-kept", &RaceHexesCatmarkKept},
    {"triangles-fresh", &RaceTrianglesFresh},
    {"triangles-kept", &RaceTrianglesKept},
    {"quads-fresh", &RaceQuadsFresh},
    {"quads-kept", &RaceQuadsKept},
    {"pipelines-fresh", &RacePipelinesFresh},
    {"pipelines-kept", &RacePipelinesKept},
    {"interpolatory", &RaceInterpolatory},
    {"evaluation", &RaceEvaluation},
    {"location", &RaceLocation},
    {"limits", &RaceLimits},
    {"deform-495", [](const RaceSettings& s) { return RaceDeform(s, 495); }},
    {"deform-22886", [](const RaceSettings& s) { return RaceDeform(s, 22886); }},
    {"deform-53417", [](const RaceSettings& s) { return RaceDeform(s, 53417); }},
    {"deform-1000000", [](const RaceSettings& s) { return RaceDeform(s, 1000000); }},
    {"deform-koala", &RaceDeformKoala},
    {"deform-embedding", &RaceEmbedding},
#if defined(SOLIDSUBDIV_HAS_FIT)
    {"fit", &RaceFit},
#endif
#if defined(SOLIDSUBDIV_HAS_VOXEL)
    {"voxels", &RaceVoxels},
#endif
};

}  // namespace SolidSubdiv::Perf

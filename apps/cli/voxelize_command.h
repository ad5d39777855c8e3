// SPDX-License-Identifier: Apache-2.0
// The steps of `voxelize`: choose a level, refine, fill, write.
#pragma once

#include <string>
#include <vector>

#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/apps/cli/scheme_options.h>

namespace SolidSubdiv::Cli {

struct VoxelizeCommandOptions {
    std::string input, output, picture;
    SchemeOptions scheme;
    int resolution = 128;
    double voxel_size = 0;  ///< 0: by resolution
    std::string kind = "level-set";
    std::vector<std::string> attributes;
    double half_width = 3;
    bool half = false;
    int levels = 2;
    double tolerance = 0;  ///< 0: levels as given
    bool limit = false;
    std::string orient = "repair";
};

/// Does all of it. @throws UsageError, IoError, InvalidInput, Cancelled
void RunVoxelize(const VoxelizeCommandOptions& options, Session& session);

}  // namespace SolidSubdiv::Cli

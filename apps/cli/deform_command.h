// SPDX-License-Identifier: Apache-2.0
// The steps of `deform`: embed or load, move, write.
#pragma once

#include <string>
#include <vector>

#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/apps/cli/scheme_options.h>

namespace SolidSubdiv::Cli {

struct DeformOptions {
    std::string model, lattice, embedding, output, save_embedding, save_lattice, drag, picture;
    std::vector<std::string> to;
    SchemeOptions scheme;
    int levels = 2;
    bool limit = false, keep_octahedra = false, ascii = false;
    std::string outside = "carry";
    double falloff = 0;
    bool preserve_volume = false;
    std::vector<Index> lock;
};

/// Does all of it. @throws UsageError, IoError, InvalidInput, Cancelled
void RunDeform(const DeformOptions& options, Session& session);

}  // namespace SolidSubdiv::Cli

// SPDX-License-Identifier: Apache-2.0
// The one visible list of sub-commands. A new one is a file beside this with its Add function, and a line here.
#pragma once

#include <array>
#include <functional>
#include <string_view>

namespace CLI {
class App;
}

namespace SolidSubdiv::Cli {

class Session;
struct CommonOptions;

/// Does the work of a sub-command whose options have been read.
using Work = std::function<void(Session&)>;

/// Adds the sub-command's own options, and the example at the end of its help.
Work AddInfo(CLI::App& command);
Work AddRefine(CLI::App& command);
Work AddSample(CLI::App& command);
Work AddLattice(CLI::App& command);
Work AddDeform(CLI::App& command);
#if defined(SOLIDSUBDIV_HAS_VOXEL)
Work AddVoxelize(CLI::App& command);
#endif
#if defined(SOLIDSUBDIV_HAS_FIT)
Work AddFit(CLI::App& command);
#endif
#if defined(SOLIDSUBDIV_HAS_ANALYSIS)
Work AddAnalyze(CLI::App& command);
#endif

struct Command {
    std::string_view name;
    std::string_view summary;  ///< one line of the program's help
    Work (*add)(CLI::App& command);
};

inline constexpr std::array kCommands = {
    Command{"info", "what is in a file: counts, shape, boundary, regularity, defects, attributes", AddInfo},
    Command{"refine", "refine a solid, a surface or a curve by a subdivision scheme", AddRefine},
    Command{"sample", "sample the limit: triangles of the boundary, tets of the inside", AddSample},
    Command{"lattice", "control lattices around a model: octree, shrunken, of tets", AddLattice},
    Command{"deform", "free-form deformation: move a model with a control lattice around it", AddDeform},
#if defined(SOLIDSUBDIV_HAS_VOXEL)
    Command{"voxelize", "fill a refined solid with voxels: level sets, fog, attributes, as OpenVDB's grids",
            AddVoxelize},
#endif
#if defined(SOLIDSUBDIV_HAS_FIT)
    Command{"fit", "fit a control lattice or a cage to a shape, so that its limit is that shape", AddFit},
#endif
#if defined(SOLIDSUBDIV_HAS_ANALYSIS)
    Command{"analyze", "eigenvalues of a scheme, and what they say about smoothness", AddAnalyze},
#endif
};

}  // namespace SolidSubdiv::Cli

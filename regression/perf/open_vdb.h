// SPDX-License-Identifier: Apache-2.0
// OpenVDB's own way from a surface to a level set, for the race of voxels.
#pragma once

#include <memory>
#include <span>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Perf {

class OpenVdbPeer {
  public:
    /// A closed surface: positions (n, 3), triangles (n, 3) that name some of them.
    OpenVdbPeer(std::span<const double> positions, std::span<const Index> triangles);
    ~OpenVdbPeer();

    /// openvdb::tools::meshToLevelSet on so many threads. @return active voxels
    Offset MeshToLevelSet(double voxel_size, double half_width, int n_threads);
    void Clear();  ///< frees the grid

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace SolidSubdiv::Perf

// SPDX-License-Identifier: Apache-2.0
// What `fit` is to meet: the surface of a mesh, of a volume, or a cloud of points.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/apps/fit/control_mesh.h>

namespace SolidSubdiv::Cli {

/// Which surface of a volume is meant; of other targets nothing may be given.
struct FitTargetOptions {
    std::optional<double> label;   ///< of a map of labels
    std::optional<double> iso;     ///< level of grey values
    std::optional<double> smooth;  ///< voxels; default 1 for labels, 0 for grey values
};

struct FitTarget {
    std::vector<double> positions;
    std::vector<Index> triangles;  ///< none: points alone
    std::vector<double> normals;   ///< of points alone
    /// Of points alone and of open surfaces that a solid is fitted to: the closed surface that starts are made around;
    /// none where nothing seals them.
    std::vector<double> closing_positions;
    std::vector<Index> closing_triangles;
    double diagonal = 0;
    Offset n_border_edges = 0;
    Json json;  ///< what was read, for the report

    bool is_cloud() const { return triangles.empty(); }
    Fit::TargetSurface Surface() const;  ///< to be met
    Fit::TargetSurface Start() const;    ///< to start from
};

/// Reads a mesh, a volume or points, by the extension and, of PLY files, by whether there are faces. Notes what a user
/// should know. @throws UsageError, IoError, InvalidInput, Cancelled
FitTarget ReadFitTarget(const std::string& file, const FitTargetOptions& options, Session& session);

/// Bridges the holes of an open surface, so that a solid can be started. @throws InvalidInput where nothing seals it
void CloseFitTarget(const std::string& file, FitTarget& target, Session& session);

}  // namespace SolidSubdiv::Cli

// SPDX-License-Identifier: Apache-2.0
// Control lattices that are read for a deformation: the first as it is embedded in, others as that one moved.
#pragma once

#include <memory>
#include <string>

#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/apps/cli/refinement.h>
#include <solidsubdiv/apps/cli/scheme_options.h>

namespace SolidSubdiv::Cli {

class ModelLattice {
  public:
    /// Reads it, turns inverted cells, chooses diagonals. @throws IoError, InvalidInput, UsageError
    ModelLattice(const std::string& file, const SchemeOptions& options, Session& session);

    const std::string& file() const { return file_; }
    const Io::Mesh& mesh() const { return mesh_; }  ///< as it was read
    const Sdc::Scheme& scheme() const { return settings_.choice.scheme; }
    /// The scheme's options, given or by default, and how diagonals were chosen.
    const std::vector<std::pair<std::string, std::string>>& option_values() const { return option_values_; }
    /// Valid while this lives.
    Far::TopologyDescriptor descriptor() const { return refinement_->descriptor(); }

    /// The same lattice with its control points elsewhere. @throws InvalidInput naming the first cell that is another,
    /// or the counts
    Io::Mesh ReadMoved(const std::string& file, Session& session) const;

    /// Cells of the lattice that are folded or inverted where its control points are there, ascending.
    std::vector<Index> FoldedCells(const std::vector<double>& positions) const;

  private:
    std::string file_;
    Io::Mesh mesh_;
    RefinementSettings settings_;
    std::vector<std::pair<std::string, std::string>> option_values_;
    std::unique_ptr<Refinement> refinement_;
};

}  // namespace SolidSubdiv::Cli

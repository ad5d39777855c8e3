// SPDX-License-Identifier: Apache-2.0
// Refines the topology of a complex, once; values are refined later, as often as needed, by tables made from it.
//
//     auto refiner = Far::TopologyRefiner::Create(descriptor, Sdc::Split::TetOct);
//     refiner.RefineUniform({.max_level = 3});
//     refiner.level(3).n_tets;
//
// Sdc::Split::Polyhedral takes cells and faces of every kind; its levels are those of polyhedral_level().
//
// A refiner knows topology and the split, nothing of schemes: one refinement serves many. Children are numbered by the
// parent component they come from (vtr/refinement.h), so relations between levels are arithmetic.
#pragma once

#include <vector>

#include <solidsubdiv/far/topology_descriptor.h>
#include <solidsubdiv/sdc/masks.h>
#include <solidsubdiv/sdc/progress.h>
#include <solidsubdiv/vtr/edge_graph.h>
#include <solidsubdiv/vtr/level.h>
#include <solidsubdiv/vtr/polyhedral_level.h>
#include <solidsubdiv/vtr/polyhedral_refinement.h>
#include <solidsubdiv/vtr/refinement.h>

namespace SolidSubdiv::Far {

using Vtr::Level;

struct UniformRefinementOptions {
    int max_level = 1;  ///< [0, 20]: how many splits
    /// Keep edges, faces and relations of the last level too: needed to refine on, and for limits at its vertices.
    bool full_topology_in_last_level = false;
    /// Refuse what would take more bytes than this; 0: what the machine has.
    Offset max_bytes = 0;
    Progress progress{};

    /// @throws InvalidInput
    void Validate() const;
};

/// Sharpness of a level's edges and vertices; both empty where nothing is sharp. Edges that end a surface anyway
/// (borders, seams) have none of their own.
struct Sharpness {
    Array<float> edges;     ///< (n_edges) or empty
    Array<float> vertices;  ///< (n_vertices) or empty

    bool empty() const { return edges.empty(); }
};

class TopologyRefiner {
  public:
    /// Finds edges, faces and tags of level 0. @throws InvalidInput on the first fatal defect, on elements of kinds
    /// that the split does not take (named), and where counts do not fit. The descriptor's arrays are copied.
    static TopologyRefiner Create(const TopologyDescriptor& descriptor, Sdc::Split split);

    /// Splits every cell, face and edge max_level times, starting anew from level 0.
    /// @throws InvalidInput, before any work, where a level would not fit: says how many bytes it needs.
    void RefineUniform(const UniformRefinementOptions& options);

    Sdc::Split split() const { return split_; }
    bool is_polyhedral() const { return split_ == Sdc::Split::Polyhedral; }
    int max_level() const { return static_cast<int>(levels_.size() + polyhedral_levels_.size()) - 1; }
    /// @pre !is_polyhedral()
    const Level& level(int i) const { return levels_[static_cast<std::size_t>(i)]; }
    /// @pre is_polyhedral(). Cells: the descriptor's hexahedra, then its tets, octs, wedges, pyramids, polyhedra.
    const Vtr::PolyhedralLevel& polyhedral_level(int i) const {
        return polyhedral_levels_[static_cast<std::size_t>(i)];
    }

    // Of either split.
    Index n_vertices(int i) const { return is_polyhedral() ? polyhedral_level(i).n_vertices : level(i).n_vertices; }
    Index n_edges(int i) const { return is_polyhedral() ? polyhedral_level(i).n_edges : level(i).n_edges; }
    Offset n_cells(int i) const { return is_polyhedral() ? polyhedral_level(i).n_cells() : level(i).n_cells(); }
    bool is_full(int i) const { return is_polyhedral() ? polyhedral_level(i).is_full : level(i).is_full; }
    /// Vertices and edges of a full level.
    Vtr::EdgeGraph graph(int i) const {
        return is_polyhedral() ? Vtr::EdgeGraph(polyhedral_level(i)) : Vtr::EdgeGraph(level(i));
    }

    /// Counts that a level has or would have, refined or not. @throws InvalidInput where 64 bits don't hold them
    Vtr::Counts CountsAt(int level) const;
    Vtr::PolyhedralCounts PolyhedralCountsAt(int level) const;

    /// Of level 0. What later levels have is the scheme's business: see Creases (far/creases.h).
    const Sharpness& sharpness() const { return sharpness_; }

    /// What is imperfect in the mesh but followed by rule; see Validate.
    const std::vector<Defect>& defects() const { return defects_; }

    /// Bytes of all levels.
    Offset Bytes() const;

  private:
    TopologyRefiner() = default;

    void CreateTetOct(const TopologyDescriptor& descriptor);
    void CreatePolyhedral(const TopologyDescriptor& descriptor);

    Sdc::Split split_ = Sdc::Split::TetOct;
    std::vector<Level> levels_;                            // of the tet/oct split
    std::vector<Vtr::PolyhedralLevel> polyhedral_levels_;  // of the polyhedral one
    std::vector<Defect> defects_;
    Sharpness sharpness_;
};

/// A size in bytes for people: "3.2 GiB".
std::string BytesText(Offset bytes);

}  // namespace SolidSubdiv::Far

// SPDX-License-Identifier: Apache-2.0
// The steps of `refine` in their order: orient, choose diagonals, refine topology, evaluate, gather elements.
#pragma once

#include <optional>
#include <vector>

#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/apps/cli/left_out.h>
#include <solidsubdiv/apps/cli/scheme_options.h>
#include <solidsubdiv/far/creases.h>
#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/geometry/orientation.h>
#include <solidsubdiv/kit/io/creases.h>
#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Cli {

struct RefinementSettings {
    SchemeChoice choice;
    Sdc::Split split = Sdc::Split::TetOct;
    int levels = 1;
    Geometry::OrientationPolicy orient = Geometry::OrientationPolicy::Repair;
    bool drop_border = false;  ///< leave out the faces at the border of open surfaces
    bool keep_creases = true;  ///< put what is still sharp into the result
    bool limit = false;        ///< push the vertices of the last level to their limits
    bool keep_levels = false;  ///< keep the levels before the last for a picture
};

class Refinement {
  public:
    /// Does all steps. @throws InvalidInput about the mesh, Cancelled
    Refinement(Io::Mesh control, const RefinementSettings& settings, Session& session);

    const Io::Mesh& control() const { return control_; }  ///< oriented
    const Geometry::OrientationReport& orientation() const { return orientation_; }
    const Far::DiagonalChoice& diagonals() const { return diagonals_; }
    const Far::TopologyRefiner& refiner() const { return *refiner_; }
    /// Of the control mesh, oriented, its diagonals chosen, with its creases. Valid while this lives.
    Far::TopologyDescriptor descriptor() const;
    Offset stencil_bytes() const { return stencil_bytes_; }
    /// Elements of the input that lie on parts of higher dimension and are no creases or corners.
    Offset n_tags() const { return n_tags_; }
    const Io::Creases& creases() const { return creases_; }                 ///< of the input
    const Far::Creases& result_creases() const { return result_creases_; }  ///< what is still sharp
    /// Vertices of the last level that the scheme gives no limit: they stay.
    const std::vector<Index>& without_limit() const { return without_limit_; }

    /// Faces of the control mesh whose children the result lacks: holes, and those at a border that is dropped.
    Offset n_faces_left_out() const { return n_faces_left_out_; }
    /// Vertices of the last level that the result has, ascending; empty: all of them.
    const std::vector<Index>& kept_vertices() const { return kept_vertices_; }

    /// Elements, positions and data of the last level.
    const Io::Mesh& result() const { return result_; }
    /// The levels before the last, if they were to be kept.
    const std::vector<Io::Mesh>& earlier() const { return earlier_; }

    /// The boundary of the last level, over its own vertices, with their data.
    Io::Mesh Boundary() const;

  private:
    void Orient();
    void ChooseDiagonals();
    void RefineTopology();
    void Evaluate();
    void KeepLevel(int level);
    template <class Body>
    void WithElements(Body&& body) const;
    void ApplyLimit();
    void GatherElements();
    void LeaveOut();
    void GatherControl();

    RefinementSettings settings_;
    Session& session_;
    Io::Mesh control_, result_;
    Io::Creases creases_;
    Far::Creases result_creases_;
    Geometry::OrientationReport orientation_;
    Far::DiagonalChoice diagonals_;
    std::optional<Far::TopologyRefiner> refiner_;
    FacesLeftOut left_out_;
    std::vector<bool> is_left_out_;  // boundary faces of the last level; empty: none
    Offset n_faces_left_out_ = 0;
    std::vector<Index> kept_vertices_;
    std::vector<Io::Mesh> earlier_;
    Offset stencil_bytes_ = 0;
    Offset n_tags_ = 0;
    std::vector<Index> without_limit_;
};

/// Says how many vertices of the last level stayed for want of a limit, if any did.
void NoteWithoutLimit(Session& session, const std::string& input, const Refinement& refinement);

}  // namespace SolidSubdiv::Cli

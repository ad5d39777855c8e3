// SPDX-License-Identifier: Apache-2.0
// Points of a model bound to a control lattice: found once, in the undeformed lattice; moved as often as it moves.
//
//     const auto embedding = Deform::Embedding::Create(lattice.View(), lattice.positions, model, {.levels = 2});
//     Deform::Deformer deformer(embedding);              // deformer.h
//     deformer.Deform(moved_control_points, moved_model);
//
// The lattice is refined `levels` times by the scheme, and each point keeps the cell of the refined lattice that holds
// it, and where in it (far/place.h). What no point needs of the refinement is dropped. So a moved point is: a cascade
// of small sparse tables (shared by all points), then a sum over the corners of one cell. In the limit instead of at a
// level, it is one row over the vertices of that level.
//
// An embedding is linear in the control points, so affine maps of the lattice are affine maps of the model, and an
// undeformed lattice leaves the model where it was.
//
// Points that no cell holds are listed. They stay, or are carried by the nearest place:
//
//     x' = factor * (row of the nearest place)(control points) + constant
//
// with the constant such that nothing moves where the lattice does not. Continuity over the lattice's border is in
// docs/deformation.md.
//
// Source: ono2002ffd, sections 3 and 4; chang2002boxspline, section 5.1.
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/sdc/progress.h>
#include <solidsubdiv/sdc/schemes.h>

namespace SolidSubdiv::Deform {

/// What becomes of points that no cell holds.
enum class Outside {
    Leave,  ///< they stay
    Clamp,  ///< they move as the nearest place of the lattice does: by the same vector
    /// They move as the nearest cell's map, continued linearly beyond its border, has it; less and less with their
    /// distance from it, and not at all beyond `falloff`.
    Carry
};

/// "leave", "clamp" or "carry". @throws InvalidInput
Outside OutsideOf(std::string_view name);
std::string_view NameOf(Outside outside);

struct EmbedOptions {
    Sdc::Scheme scheme = Sdc::CatmullClarkSolid{};
    int levels = 2;      ///< [0, 20]: of refinement before points are embedded
    bool limit = false;  ///< embed in the limit (found from that level), not in the level
    Outside outside = Outside::Carry;
    /// [0, infinity], in units of the positions: how far cells carry points. 0: the mean length of the control
    /// lattice's edges. With infinity they carry everything alike, so that affine maps stay affine outside as well
    /// (but in the limit where it has no derivative: there the nearest place moves points by its own vector).
    double falloff = 0;
    /// Points so near to a cell, in units of the positions, are held by it: not listed as outside.
    double tolerance = 0;
    /// Words to keep in Embedding::settings() and in its file, as (name, value): options of the scheme, say.
    std::vector<std::pair<std::string, std::string>> notes{};
    Progress progress{};

    /// @throws InvalidInput
    void Validate() const;
};

/// A point that no cell holds: how it is carried.
struct OutsidePoint {
    Index point = 0;
    double distance = 0;  ///< from the nearest place
    double factor = 0;    ///< [0, 1]
    std::array<double, 3> constant{};
};

/// Cells of the refined lattice that hold points, and those points. All cells are of one kind.
template <int kCorners>
struct EmbeddedCells {
    Array<Index> corners;      ///< (n_cells, kCorners): patch points; of hexahedra in VTK's order
    Array<Offset> offsets{0};  ///< (n_cells + 1): of each cell, its points among `points`
    Array<Index> points;       ///< ascending within a cell
    Array<double> at;          ///< (points, 3): coordinates in the cell (far/place.h)

    Index n_cells() const { return static_cast<Index>(offsets.size()) - 1; }
};

/// Everything that a deformation needs. "Patch points" are the columns of what comes last: the rows of the cascade's
/// last table, or, where it is empty, the control points. Every point stands in one of hexes, tets and rows, but for
/// those outside that stay (factor 0), which stand in none.
struct EmbeddingTables {
    Index n_points = 0, n_control_points = 0;
    std::vector<Far::StencilRows<double>>
        cascade;                        ///< columns of the first: the control points; of others: rows before
    EmbeddedCells<8> hexes;             ///< trilinear
    EmbeddedCells<4> tets;              ///< linear: also the parts of octahedra
    Far::StencilRows<double> rows;      ///< of the other points over the patch points
    Array<Index> row_points;            ///< (rows): ascending
    std::vector<OutsidePoint> outside;  ///< ascending by point

    Index n_patch_points() const { return cascade.empty() ? n_control_points : cascade.back().n_rows(); }
    Offset Bytes() const;
};

class Embedding {
  public:
    /// Points, (n, 3), in a lattice. Cost: a refinement of the lattice and a search a point. The same bits every time,
    /// for any number of threads.
    /// @throws InvalidInput on lattices that are none (as TopologyRefiner::Create), without cells, that the scheme
    /// can't refine; on positions that are not finite; Cancelled
    static Embedding Create(const Far::TopologyDescriptor& lattice, std::span<const double> lattice_positions,
                            std::span<const double> points, const EmbedOptions& options);

    /// A file of its own, docs/embedding_file.md byte by byte: an application loads it and deforms at once.
    /// Written beside and renamed. @throws IoError
    void Save(const std::filesystem::path& path) const;
    /// Checks everything: what comes back can't read out of bounds. What is kept of it takes memory as the file does,
    /// whatever number of control points it claims. @throws IoError naming the file and what is wrong
    static Embedding Load(const std::filesystem::path& path);

    const EmbeddingTables& tables() const { return tables_; }
    Index n_points() const { return tables_.n_points; }
    Index n_control_points() const { return tables_.n_control_points; }
    const std::vector<OutsidePoint>& outside() const { return tables_.outside; }
    /// Scheme, its options, level and so on, as (name, value): kept in files.
    const std::vector<std::pair<std::string, std::string>>& settings() const { return settings_; }

    /// The derivative of chosen points by the control points: rows over the control points, indices ascending.
    /// Moved points are these rows times the control points, plus OutsidePoint::constant. @throws InvalidInput
    Far::StencilRows<double> ControlRows(std::span<const Index> points) const;

  private:
    EmbeddingTables tables_;
    std::vector<std::pair<std::string, std::string>> settings_;
};

}  // namespace SolidSubdiv::Deform

// SPDX-License-Identifier: Apache-2.0
// Editing a model through a hierarchy of lattices: coarse and fine by turns, without a jump, and back again.
//
//     Deform::EditingSession session(std::move(levels), model, {.offsets = offsets, .corners = corners});
//     session.Move({7}, {1.5, 0, 0});                        // control point 7 of level 0, and the model with it
//     session.SetLevel(2);                                   // nothing moves; its lattice has followed
//     for (Index v : session.Move({81}, {1, 2, 3}).points)   // a fine edit: the model's points that it touches
//         ...
//     session.Undo();
//
// Let Q_i be the control points of level i, O the octree rule and P_i the embedding of the model in level i. Then
//
//     Q_i = O(Q_{i-1}) + D_i,    model = P_k(Q_k) + correction,    k the current level.
//
// A move at level k changes Q_k, and with it the details D_k; it leaves coarser levels as they are. The details of
// finer levels stay, so finer lattices follow. (They are vectors in space: where a coarse lattice turns, they don't
// turn with it. Octree lattices have none until they are edited, shrunk ones have from the start.) A change of level
// keeps the model and takes what P_j(Q_j) differs from it as the new correction; rounding moves points by a unit in
// their last place.
//
// From local to global: Enclose puts a new coarse lattice around everything, and its moves carry the model and the
// lattices of all levels, by one and the same map. SetLevel returns to the hierarchy: control points are where they
// were carried, details what they then differ from the octree rule.
//
// Embeddings are made from the undeformed lattice and model when a level is first needed; deformed lattices may be
// folded. The model is a function of (level, Q, correction) alone, the same bits whichever way they came about: so Undo
// and Redo restore bits. A session is for one thread.
//
// Source: ono2002ffd, section 4.
#pragma once

#include <initializer_list>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include <solidsubdiv/apps/deform/control_lattice.h>
#include <solidsubdiv/apps/deform/embedding.h>

namespace SolidSubdiv::Deform {

/// One lattice of the hierarchy, coarse to fine.
struct SessionLevel {
    const ControlLattice* lattice = nullptr;  ///< undeformed; must outlive the session
    /// Its control points over those of the level before; ignored at level 0.
    Far::StencilRows<double> octree_rule{};
    /// Of the undeformed model in the undeformed lattice; null: made when first needed.
    std::shared_ptr<const Embedding> embedding{};
};

/// Polygons of the model, for normals: face f has the corners [offsets[f], offsets[f + 1]).
struct ModelFaces {
    std::span<const Offset> offsets{};  ///< (n_faces + 1), or empty: no faces, no normals
    std::span<const Index> corners{};
};

struct SessionOptions {
    EmbedOptions embed{};  ///< of all levels
    /// Older steps are forgotten. A step keeps 56 bytes a control point moved, and 24 bytes a point of the model and a
    /// control point of levels carried where it changes the level or encloses.
    std::size_t max_undo_steps = std::numeric_limits<std::size_t>::max();
};

/// What a change did to the model; valid until the next change.
struct SessionChange {
    std::span<const Index> points{};   ///< touched by it, each once, in no particular order
    std::span<const Index> normals{};  ///< points with new normals: of those, and of the vertices of their faces
};

class EditingSession {
  public:
    /// The model's points, (n, 3), and faces are copied. Starts at level 0, undeformed.
    /// @throws InvalidInput where there is no level or no lattice, an octree rule or an embedding does not fit its
    /// lattice, a face names a point that is not there, a position is not finite; and as Embedding::Create
    EditingSession(std::vector<SessionLevel> levels, std::span<const double> points, const ModelFaces& faces = {},
                   const SessionOptions& options = {});
    ~EditingSession();
    EditingSession(EditingSession&&) noexcept;
    EditingSession& operator=(EditingSession&&) noexcept;

    // What is there.

    int n_levels() const;
    Index n_points() const;
    std::span<const double> points() const;   ///< of the model, (n_points, 3)
    std::span<const double> normals() const;  ///< area-weighted (vertex_normals.h); empty without faces

    int level() const;         ///< the current one; while enclosed, the one before
    bool is_enclosed() const;  ///< the enclosing lattice is the current one
    /// Of the current lattice, (n, 3).
    std::span<const double> control_points() const;
    /// Of any level, as SetLevel would find them. Finer than the current one: carried now, a product of sparse rows a
    /// level. @throws InvalidInput
    std::vector<double> ControlPoints(int level) const;

    /// Of the current lattice. While enclosed it holds the control points of all levels, coarse to fine, after the
    /// model's points.
    const Embedding& embedding() const;
    /// Added to what the embedding makes of the control points, (embedding().n_points(), 3).
    std::span<const double> correction() const;

    // Changes. Bad input changes nothing.

    /// Moves control points of the current lattice to `positions`, (n, 3). Costs what they touch; twice in
    /// `control_points`: the last position counts. @throws InvalidInput naming the one that is out of range or whose
    /// position is not finite
    SessionChange Move(std::span<const Index> control_points, std::span<const double> positions);
    SessionChange Move(std::initializer_list<Index> control_points, std::initializer_list<double> positions) {
        return Move(std::span(control_points.begin(), control_points.size()),
                    std::span(positions.begin(), positions.size()));
    }

    /// Makes this level's lattice the current one. Costs an evaluation of all points, at a level's first time its
    /// embedding. @throws InvalidInput, and as Embedding::Create
    SessionChange SetLevel(int level);

    /// Makes a new lattice, which should hold the model and the lattices of all levels as they are now, the current
    /// one. What lies outside it (embedding().outside()) is carried as the options say; with an infinite falloff all of
    /// it follows. Also while enclosed already. @throws as Embedding::Create
    SessionChange Enclose(const ControlLattice& lattice, const EmbedOptions& options);

    // Undo. A step is one change, or all changes between BeginStep and EndStep, as of a drag; of these it keeps no more
    // than what was there before. Steps without a change don't count.

    /// @throws InvalidInput where one is open (BeginStep, Undo, Redo) or none is (EndStep)
    void BeginStep();
    void EndStep();
    bool CanUndo() const;
    bool CanRedo() const;
    SessionChange Undo();  ///< nothing where CanUndo is false
    SessionChange Redo();  ///< nothing where CanRedo is false; a change forgets what could be redone
    Offset UndoBytes() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace SolidSubdiv::Deform

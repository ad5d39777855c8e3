// SPDX-License-Identifier: Apache-2.0
// A pocket met on the way to a limit, with what is known of it: its closed form, its children, its corners.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include <solidsubdiv/far/internal/pocket.h>
#include <solidsubdiv/far/internal/regular_patch.h>
#include <solidsubdiv/far/internal/root_coordinates.h>

namespace SolidSubdiv::Far::Internal {

/// Rows of points of a pocket's split over its vertices.
struct RowsOfChildren {
    Array<std::uint32_t> offsets{0};
    Array<std::uint16_t> indices;
    Array<double> weights;

    Offset Bytes() const {
        return static_cast<Offset>(offsets.size() * sizeof(std::uint32_t) +
                                   indices.size() * (sizeof(std::uint16_t) + sizeof(double)));
    }
};

struct LimitState;

/// From a pocket's vertices to those of a child of its root, and the other way for coordinates.
struct Transition {
    LimitState* state = nullptr;  ///< of the child
    std::vector<Index> children;  ///< local vertices of the root that the child has as well, by its own; else kNoIndex
    std::vector<Index> rows;      ///< of the child's vertices, among RowsOfChildren; kNoIndex: the pocket does not know
    /// The child's coordinates at a place x of the root: matrix x + shift.
    Matrix3 matrix{};
    Coordinates shift{};
    /// Where there are no such coordinates (polyhedra, polygons): of each vertex of the child's root, the corners of
    /// the root's part in whose middle it is, ascending.
    std::vector<std::vector<Index>> features;
};

enum class LimitOutcome {
    Known,
    None,    ///< there is no limit
    Unknown  ///< the pocket is too small to say
};

/// Limit and derivatives at one vertex of the root.
struct CornerLimit {
    LimitOutcome outcome = LimitOutcome::Unknown;
    bool has_derivatives = false, has_tangents = false;
    LimitBlock block;     ///< of the pocket's vertices, first derivatives included
    LimitBlock tangents;  ///< of faces: the same with tangents in the place of derivatives
};

struct LimitState {
    explicit LimitState(const Pocket& p);

    /// A cell other than a tet, an octahedron or a hexahedron, or a face of other than four vertices among polyhedra.
    bool has_parts() const { return root_faces.size() > 0; }

    const RootKind root;
    const Index n_root_vertices, n_vertices;
    VertexLists root_faces;  ///< of a root with parts
    Pocket pocket;           ///< until it is expanded
    std::optional<RegularPatch> patch;
    std::once_flag expansion;
    std::unique_ptr<std::once_flag[]> corner_flags;  ///< of each corner of the root
    std::vector<Transition> children;
    RowsOfChildren rows;
    std::vector<CornerLimit> corners;
};

/// Rows of a child's vertices made rows of its parent's. False where a row that counts is not known.
bool Pull(const LimitState& state, const Transition& t, const LimitBlock& child, LimitBlock& parent);

/// Derivatives by old coordinates turned into those by new ones; by[i][a]: of old coordinate i by new coordinate a.
void ChangeRows(const Matrix3& by, int dimension, int order, LimitBlock& block);

}  // namespace SolidSubdiv::Far::Internal

// SPDX-License-Identifier: Apache-2.0
// Drag points of the model, and the control points follow: by the least change that brings the points there.
//
//     const std::vector<Deform::DragTarget> targets{{.point = 12, .position = {0, 0, 1}},
//                                                   {.point = 99, .position = {1, 0, 0}, .weight = 4}};
//     const auto result = Deform::Drag(embedding, control_points, targets, {.locked = locked});
//     if (!result.is_consistent) ...                         // some can't be reached, or contradict each other
//     deformer.Update(result.moved, result.control_points, model);
//
// Of all changes d of the control points that bring the points of hard targets (weight infinity) where they should be,
// it is that of the least
//
//     |d|^2 + sum over soft targets of weight * |distance from the target|^2.
//
// A soft target of weight 1 counts a distance as much as a change of one control point by it. Where hard targets
// contradict each other, or can't be reached, their distances are the least in the sense of squares, and is_consistent
// is false.
//
// Solved by conjugate gradients on the rows of the dragged points: about as many iterations as there are targets, each
// as long as their rows and the control points together. With preserve_volume, also some evaluations of the model.
//
// Source: hsu1992direct; with the volume as in hirota1999volume: one more row, the volume's derivative, in Newton
// steps.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include <solidsubdiv/apps/deform/embedding.h>

namespace SolidSubdiv::Deform {

struct DragTarget {
    Index point = 0;                                          ///< of the embedding
    std::array<double, 3> position{};                         ///< where it should be
    double weight = std::numeric_limits<double>::infinity();  ///< (0, infinity]; finite: a wish, not a demand
};

struct DragOptions {
    std::span<const Index> locked{};  ///< control points that stay, to the bit
    /// Keep the volume that these triangles of embedded points enclose: (n, 3), a closed surface, counterclockwise from
    /// outside. (Of another surface: the sum of the cones over it from the middle of the control points' box.)
    bool preserve_volume = false;
    std::span<const Index> triangles{};
    /// (n_points, 3), added to every deformed point, or empty: EditingSession::correction().
    std::span<const double> correction{};
    /// (0, 1): of hard targets' distances, relative to the diagonal of the control points' box, and of the volume,
    /// relative to itself.
    double tolerance = 1e-10;
    int max_iterations = 10000;  ///< [1, ...]: of conjugate gradients, all together

    /// @throws InvalidInput
    void Validate() const;
};

struct DragResult {
    std::vector<double> control_points;          ///< (n_control_points, 3)
    std::vector<Index> moved;                    ///< those that have, ascending
    double largest_residual = 0;                 ///< distance of the worst hard target, in units of the positions
    double volume_before = 0, volume_after = 0;  ///< with preserve_volume
    int iterations = 0;                          ///< of conjugate gradients
    /// Dragged points that no control point moves, or only locked ones; ascending.
    std::vector<Index> immovable;
    /// Hard targets are reached, and the volume is kept, within the tolerance.
    bool is_consistent = true;
};

/// The change that drags points, starting from these control points, (n_control_points, 3). The same bits every time.
/// @throws InvalidInput naming the target, lock or triangle whose index is out of range, a position that is not finite,
/// a weight that is not positive
DragResult Drag(const Embedding& embedding, std::span<const double> control_points, std::span<const DragTarget> targets,
                const DragOptions& options = {});

}  // namespace SolidSubdiv::Deform

// SPDX-License-Identifier: Apache-2.0
// Moves embedded points with their control lattice, as often as it moves: all of them, or what a move touches.
//
//     Deform::Deformer deformer(embedding);                        // double; DeformerReal<float> in half the memory
//     deformer.Deform(control_points, model);                      // all control points have moved
//     const Index moved[] = {7};
//     control_points[3 * 7] += .1;
//     for (Index v : deformer.Update(moved, control_points, model))  // one has: what it touches, and nothing else
//         ...
//
// Updates give the bits that Deform would. A deformer owns its scratch: one a thread.
#pragma once

#include <memory>
#include <span>

#include <solidsubdiv/apps/deform/embedding.h>

namespace SolidSubdiv::Deform {

template <class Real>
class DeformerReal {
  public:
    /// Copies what it needs, in its own precision and order.
    explicit DeformerReal(const Embedding& embedding);
    ~DeformerReal();
    DeformerReal(DeformerReal&&) noexcept;
    DeformerReal& operator=(DeformerReal&&) noexcept;

    Index n_points() const;
    Index n_control_points() const;

    /// Positions of all points, (n_points, 3), from those of all control points, (n_control_points, 3). Parallel; the
    /// same bits for any number of threads. @throws InvalidInput where a span's length does not fit
    void Deform(std::span<const Real> control_points, std::span<Real> points);

    /// The same where only the control points `moved` differ from those of the last Deform or Update: writes the points
    /// that they touch, and returns their numbers (valid until the next call), ascending within cells but in no order
    /// of the whole. The first call finds out who touches whom, which takes as long as some Deforms.
    /// @throws InvalidInput as Deform, before any Deform, and where an index is out of range
    std::span<const Index> Update(std::span<const Index> moved, std::span<const Real> control_points,
                                  std::span<Real> points);

    /// The points that a move of these control points touches: those with one of them in their rows; ascending.
    std::vector<Index> Affected(std::span<const Index> control_points);

    /// What is kept, all together; without what Update needs until its first call.
    Offset Bytes() const;
    /// Of these, what the points are kept by: their coordinates and numbers, and the cells or rows that they are in.
    /// The rest is the refined lattice, which would be the same for more points in these cells.
    Offset PointBytes() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

using Deformer = DeformerReal<double>;
extern template class DeformerReal<double>;
extern template class DeformerReal<float>;

}  // namespace SolidSubdiv::Deform

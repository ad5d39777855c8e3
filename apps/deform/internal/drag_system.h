// SPDX-License-Identifier: Apache-2.0
// What a drag demands of the change of the control points: linear equations, and their solution of least norm.
#pragma once

#include <vector>

#include <solidsubdiv/far/stencil_table.h>

namespace SolidSubdiv::Deform::Internal {

/// Unknowns z: the change d of the control points, (n, 3), then a slack e for each target, (n_targets, 3). Equations:
///
///     row of target t times d + softness of t * e_t = right_t    (three: x, y, z)
///     volume row times d = right                                 (one, if there is one)
///
/// A slack counts in the norm of z as weight * distance^2 where softness is 1 / sqrt(weight): so the least norm is the
/// best trade between control points and soft targets, and hard targets have softness 0.
class DragSystem {
  public:
    /// Control points with is_locked are left where they are.
    DragSystem(Far::StencilRows<double> rows, std::vector<double> softness, std::vector<char> is_locked);

    /// (n, 3); empty: none. Of any length, so scaled to 1.
    void SetVolumeRow(std::vector<double> gradient);
    double volume_row_length() const { return volume_row_length_; }

    Index n_targets() const { return rows_.n_rows(); }
    std::size_t n_equations() const {
        return 3 * static_cast<std::size_t>(n_targets()) + (volume_row_.empty() ? 0 : 1);
    }
    std::size_t n_unknowns() const { return 3 * (is_locked_.size() + static_cast<std::size_t>(n_targets())); }
    const Far::StencilRows<double>& rows() const { return rows_; }
    /// No control point can move it.
    bool IsImmovable(Index target) const;

    std::vector<double> Apply(const std::vector<double>& unknowns) const;
    std::vector<double> ApplyTransposed(const std::vector<double>& equations) const;

    /// The unknowns of least norm among those that solve the equations, or come nearest in the sense of squares.
    /// Conjugate gradients on the normal equations, from 0: their steps stay in the span of the rows, where the least
    /// norm is. Adds to n_iterations, up to max_iterations.
    std::vector<double> LeastNorm(const std::vector<double>& right, int max_iterations, int& n_iterations) const;

  private:
    Far::StencilRows<double> rows_;
    std::vector<double> softness_;
    std::vector<char> is_locked_;
    std::vector<double> volume_row_;
    double volume_row_length_ = 1;
};

}  // namespace SolidSubdiv::Deform::Internal

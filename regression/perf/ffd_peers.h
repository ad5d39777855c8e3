// SPDX-License-Identifier: Apache-2.0
// Classic free-form deformations in tight loops, in float: what users of fixed lattices have. Bernstein polynomials of
// degree 3 over 4^3 control points, and a uniform tricubic B-spline over a full block of control points.
#pragma once

#include <array>
#include <span>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Perf {

/// A box of the points.
struct FfdBox {
    std::array<float, 3> low{}, size{};
    explicit FfdBox(std::span<const float> points);
};

/// Keeps three coordinates in the box a point, 12 bytes: weights are cheaper to compute than to read. Its control
/// points: (4, 4, 4, 3), those along x next to each other.
class BernsteinFfd {
  public:
    explicit BernsteinFfd(std::span<const float> points);
    /// At rest.
    Array<float> ControlPoints() const;
    void Deform(std::span<const float> control, std::span<float> points) const;
    double Bytes() const { return static_cast<double>(u_.size() * sizeof(float)); }

  private:
    FfdBox box_;
    std::size_t n_;
    Array<float> u_;  ///< blocks of kLanes points: their u, their v, their w
};

/// Keeps of each point where its 4^3 control points begin and 12 weights, four along each axis: 52 bytes. Its control
/// points: n_cells + 3 along each axis, as four floats each, the last unused.
class SplineFfd {
  public:
    SplineFfd(std::span<const float> points, int n_cells);
    Array<float> ControlPoints() const;
    void Deform(std::span<const float> control, std::span<float> points) const;
    double Bytes() const {
        return static_cast<double>(weights_.size() * sizeof(float) + begins_.size() * sizeof(Index));
    }

  private:
    FfdBox box_;
    int n_cells_;
    Array<Index> begins_;
    Array<float> weights_;
};

}  // namespace SolidSubdiv::Perf

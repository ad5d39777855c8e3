// SPDX-License-Identifier: Apache-2.0
// A search for the frame of a box of little volume around points.
//
// A box that can't be made smaller by a turn about any of its axes is a local minimum; many starts find many of those.
// Turns are searched among few points that reach far in many directions; the frame found says which points reach
// farther, they join in, and the search goes on. Where none does, the few are as good as all.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/kit/geometry/internal/extremes.h>
#include <solidsubdiv/kit/geometry/internal/principal_axes.h>

namespace SolidSubdiv::Geometry::Internal {

class LeastBox {
  public:
    /// Of points (n, 3), which must outlive this. @pre there are points
    LeastBox(std::span<const double> points, const PrincipalAxes& principal, const Box& box);

    /// The frame of the least box found.
    Frame Find();
    /// Turns a frame about those of its axes that are allowed, until no turn makes its box smaller.
    Frame Turn(Frame frame, std::array<bool, 3> axes);

  private:
    struct Candidate {
        Frame frame = kCoordinateAxes;
        double volume = std::numeric_limits<double>::infinity();
    };

    /// Takes the place of the least if its box around all points is smaller.
    void Try(const Frame& frame, Candidate& least) const;
    /// The same with frames that turns make of these.
    void TryTurns(std::vector<Frame> frames, Candidate& least);
    double VolumeOf(std::span<const Extremes> reach) const;
    double VolumeAmongFew(const Frame& frame) const;
    Frame TurnAmongFew(Frame frame, std::array<bool, 3> axes) const;
    void Join(std::span<const Extremes> extremes);

    std::span<const double> points_;
    Frame principal_;
    Vec3 origin_;
    double least_length_ = 0;  // sides below count as that: products of rounding say nothing
    std::vector<double> few_;  // (n, 3), each once, ascending by x, y, z
};

}  // namespace SolidSubdiv::Geometry::Internal

// SPDX-License-Identifier: Apache-2.0
// Normals at the vertices of a polygonal surface, kept up to date while some of its vertices move.
//
//     Deform::VertexNormals normals(n_points, offsets, corners);
//     normals.Compute(points);                             // all
//     for (Index v : normals.Update(moved, points)) ...    // those of `moved`, and of the vertices of their faces
//
// A vertex's normal is the direction of the sum of its faces' area vectors, so faces count by their area; polygons need
// be neither flat nor convex, surfaces neither closed nor manifold. Where the sum is 0, as at vertices without faces,
// it is 0. Updates give the bits that Compute would.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Deform {

class VertexNormals {
  public:
    /// No faces.
    VertexNormals() = default;
    /// Face f has the corners [offsets[f], offsets[f + 1]) of `corners`, which are points; both are copied. Keeps twice
    /// as much beside them, and 24 bytes a face and a point.
    /// @throws InvalidInput where offsets do not fit or a corner is out of range, naming the face
    VertexNormals(Index n_points, std::span<const Offset> offsets, std::span<const Index> corners);

    /// From the positions of all points, (n_points, 3). Parallel; the same bits for any number of threads.
    void Compute(std::span<const double> points);

    /// The same where only the points `moved` differ from those of the last Compute or Update: the points whose normals
    /// it computes, each once, valid until the next call.
    std::span<const Index> Update(std::span<const Index> moved, std::span<const double> points);

    /// (n_points, 3), or empty where there are no faces.
    std::span<const double> normals() const { return normals_; }

  private:
    Index n_faces() const { return static_cast<Index>(offsets_.size()) - 1; }
    void ComputeAreaVector(Index face, std::span<const double> points);
    void ComputeNormal(Index point);

    std::vector<Offset> offsets_{0};        ///< of faces among corners_
    std::vector<Index> corners_;            ///< points
    std::vector<Offset> point_offsets_{0};  ///< of points among faces_
    std::vector<Index> faces_;              ///< of each point, ascending; twice where it is twice a corner
    std::vector<double> area_vectors_;      ///< (faces, 3): twice the area, along the normal
    std::vector<double> normals_;           ///< (points, 3)
    std::vector<char> is_listed_;           ///< of faces, then of points; all 0 between calls
    std::vector<Index> listed_, updated_;   ///< faces and points of the last Update
};

}  // namespace SolidSubdiv::Deform

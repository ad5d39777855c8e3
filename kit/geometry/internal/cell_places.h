// SPDX-License-Identifier: Apache-2.0
// Places of points in single cells of a level, whatever the cell.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/far/place.h>
#include <solidsubdiv/kit/geometry/internal/nearest_in_tet.h>

namespace SolidSubdiv::Geometry::Internal {

/// The four tets of an octahedron around its major diagonal: corners for part `quadrant`, bit 0 set where v is
/// negative, bit 1 where w is.
TetCorners OctPart(const std::array<Vec3, 6>& corners, int quadrant);

/// The tets of a cell that has parts (far/place.h), its centroids computed once. Points are relative to `origin`: near
/// the cell, they are known better so.
class PolyhedronParts {
  public:
    /// @pre cell < cells.size()
    PolyhedronParts(const Vtr::Polyhedra& cells, Index cell, std::span<const double> positions, const Vec3& origin);
    Index n_parts() const { return static_cast<Index>(corners_.size()); }
    /// Centroid of the cell, of the face, the corner and the next.
    TetCorners Part(Index part) const {
        const auto& [face, corner, next] = corners_[static_cast<std::size_t>(part)];
        return {centroid_, face, corner, next};
    }

  private:
    Vec3 centroid_{};
    std::vector<std::array<Vec3, 3>> corners_;
};

/// A place in a cell and how far the point is from it, over the scale.
struct CellPlace {
    Far::Place place{};
    double distance = std::numeric_limits<double>::infinity();
};

/// Cells of a level with positions; both must outlive this.
class CellPlaces {
  public:
    CellPlaces(const Far::TopologyRefiner& refiner, int level, std::span<const double> positions);

    Offset n_cells() const { return refiner_.n_cells(level_); }
    /// All vertices of a cell, some repeatedly.
    std::span<const Index> Vertices(Index cell) const;

    /// Has what Vertices reads, and then what the vertices' positions are, brought to the caches.
    void FetchIndices(Index cell) const { Fetch(Vertices(cell)); }
    void FetchPositions(Index cell) const {
        for (Index v : Vertices(cell)) Fetch(positions_.subspan(3 * static_cast<std::size_t>(v), 3));
    }

    /// The place in the cell nearest to the point; perhaps none where that is further than `limit`. Lengths are
    /// multiplied by `scale` before they are squared; distances, reach and limits are in that unit.
    CellPlace FindNearest(Index cell, const Vec3& point, double scale, double round_off, double limit) const;
    /// The same where the point lies within `reach` of the cell; otherwise a distance larger than reach.
    CellPlace Hold(Index cell, const Vec3& point, double scale, double reach) const;

  private:
    template <class T>
    static void Fetch(std::span<const T> values) {
        __builtin_prefetch(values.data());
        __builtin_prefetch(values.data() + values.size() - 1);
    }
    template <class InTet, class InHex>
    CellPlace Find(Index cell, const Vec3& point, double scale, InTet&& in_tet, InHex&& in_hex, double enough) const;

    const Far::TopologyRefiner& refiner_;
    int level_;
    std::span<const double> positions_;
};

}  // namespace SolidSubdiv::Geometry::Internal

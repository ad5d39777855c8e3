// SPDX-License-Identifier: Apache-2.0
// Places in a regular lattice for the vertices of a pocket.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Far::Internal {

using Point = std::array<int, 3>;

/// Where vertices lie in the lattice; refuses what contradicts itself.
class Unfolding {
  public:
    explicit Unfolding(Index n_vertices) : points_(static_cast<std::size_t>(n_vertices)) {}

    bool Has(Index v) const { return points_[static_cast<std::size_t>(v)].has_value(); }
    const Point& operator[](Index v) const { return *points_[static_cast<std::size_t>(v)]; }
    /// False if the vertex is elsewhere, or the place taken.
    bool Put(Index v, const Point& p) {
        auto& point = points_[static_cast<std::size_t>(v)];
        if (point) return *point == p;
        point = p;
        return vertices_.emplace(p, v).second;
    }
    Index VertexAt(const Point& p) const {
        const auto found = vertices_.find(p);
        return found == vertices_.end() ? kNoIndex : found->second;
    }

  private:
    std::vector<std::optional<Point>> points_;
    std::map<Point, Index> vertices_;
};

inline Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline int Dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point Cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace SolidSubdiv::Far::Internal

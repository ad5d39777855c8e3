// SPDX-License-Identifier: Apache-2.0
// Signed volumes of cells, from their vertices or as the sum of the cones over their faces.
#include <solidsubdiv/kit/geometry/cell_volume.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <solidsubdiv/sdc/cells.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Geometry {

namespace {

constexpr Offset kGrain = 4096;

using Point = std::array<double, 3>;

Point At(std::span<const double> positions, Index v) {
    const double* p = positions.data() + 3 * static_cast<std::size_t>(v);
    return {p[0], p[1], p[2]};
}

Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double Determinant(const Point& a, const Point& b, const Point& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Six times the volume of the cone from `apex` over a polygon seen counterclockwise from outside.
double SixfoldCone(std::span<const double> positions, const Point& apex, std::span<const Index> face) {
    if (face.size() == 3) {
        return Determinant(At(positions, face[0]) - apex, At(positions, face[1]) - apex, At(positions, face[2]) - apex);
    }
    Point mean{};
    for (Index v : face) {
        const Point p = At(positions, v) - apex;
        for (int axis = 0; axis < 3; ++axis) mean[axis] += p[axis] / static_cast<double>(face.size());
    }
    double sum = 0;
    for (std::size_t k = 0; k < face.size(); ++k) {
        const Index next = face[k + 1 == face.size() ? 0 : k + 1];
        sum += Determinant(mean, At(positions, face[k]) - apex, At(positions, next) - apex);
    }
    return sum;
}

template <class Cell>
double VolumeByFaces(std::span<const double> positions, std::span<const Index> cell) {
    const Point apex = At(positions, cell[0]);
    double sum = 0;
    for (const auto& face : Cell::faces) {
        const std::size_t n = face[3] == Sdc::kNoLocal ? 3 : 4;
        std::array<Index, 4> vertices{};
        for (std::size_t k = 0; k < n; ++k) vertices[k] = cell[face[k]];
        sum += SixfoldCone(positions, apex, std::span(vertices).first(n));
    }
    return sum / 6.0;
}

double PolyhedronVolume(const Far::TopologyDescriptor& d, std::span<const double> positions, Offset cell) {
    const Offset first = d.polyhedron_offsets[cell], last = d.polyhedron_offsets[cell + 1];
    if (first == last) return 0;
    const Point apex = At(positions, d.polyhedron_vertices[d.polyhedron_face_offsets[first]]);
    double sum = 0;
    for (Offset f = first; f < last; ++f) {
        const Offset begin = d.polyhedron_face_offsets[f], end = d.polyhedron_face_offsets[f + 1];
        sum += SixfoldCone(positions, apex, d.polyhedron_vertices.subspan(begin, end - begin));
    }
    return sum / 6.0;
}

}  // namespace

double TetVolume(std::span<const double> positions, std::span<const Index, 4> tet) {
    const Point p = At(positions, tet[0]);
    return Determinant(At(positions, tet[1]) - p, At(positions, tet[2]) - p, At(positions, tet[3]) - p) / 6.0;
}

double OctVolume(std::span<const double> positions, std::span<const Index, 6> oct) {
    double sum = 0;
    for (const auto& t : Sdc::Oct::tets) {
        sum += TetVolume(positions, std::array{oct[t[0]], oct[t[1]], oct[t[2]], oct[t[3]]});
    }
    return sum;
}

std::vector<double> CellVolumes(const Far::TopologyDescriptor& d, std::span<const double> positions) {
    std::vector<double> volumes;
    // Appends the volumes of n cells.
    const auto append = [&](std::size_t n, auto&& volume) {
        const std::size_t first = volumes.size();
        volumes.resize(first + n);
        Sdc::ParallelFor(static_cast<Offset>(n), kGrain, [&](Offset begin, Offset end) {
            for (Offset c = begin; c < end; ++c) volumes[first + static_cast<std::size_t>(c)] = volume(c);
        });
    };
    append(d.tets.size() / 4, [&](Offset c) { return TetVolume(positions, d.tets.subspan(4 * c).first<4>()); });
    append(d.octs.size() / 6, [&](Offset c) { return OctVolume(positions, d.octs.subspan(6 * c).first<6>()); });
    append(d.hexes.size() / 8, [&](Offset c) { return VolumeByFaces<Sdc::Hex>(positions, d.hexes.subspan(8 * c, 8)); });
    append(d.wedges.size() / 6,
           [&](Offset c) { return VolumeByFaces<Sdc::Wedge>(positions, d.wedges.subspan(6 * c, 6)); });
    append(d.pyramids.size() / 5,
           [&](Offset c) { return VolumeByFaces<Sdc::Pyramid>(positions, d.pyramids.subspan(5 * c, 5)); });
    append(d.polyhedron_offsets.empty() ? 0 : d.polyhedron_offsets.size() - 1,
           [&](Offset c) { return PolyhedronVolume(d, positions, c); });
    return volumes;
}

double VolumeRoundoff(std::span<const double> positions, std::span<const Index> cell) {
    const Point first = At(positions, cell[0]);
    double reach = 0, size = 0;  // largest coordinate and largest edge, in the maximum norm
    for (Index v : cell) {
        const Point p = At(positions, v);
        for (int axis = 0; axis < 3; ++axis) {
            reach = std::max(reach, std::abs(p[axis]));
            size = std::max(size, std::abs(p[axis] - first[axis]));
        }
    }
    // A coordinate is known to half an epsilon of its size; a determinant of differences then to a few times this.
    return 4 * std::numeric_limits<double>::epsilon() * reach * size * size;
}

}  // namespace SolidSubdiv::Geometry

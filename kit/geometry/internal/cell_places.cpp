// SPDX-License-Identifier: Apache-2.0
// From the coordinates of tets and hexahedra to those of places (far/place.h).
#include <solidsubdiv/kit/geometry/internal/cell_places.h>

#include <solidsubdiv/kit/geometry/internal/nearest_in_hex.h>

namespace SolidSubdiv::Geometry::Internal {

TetCorners OctPart(const std::array<Vec3, 6>& corners, int quadrant) {
    return {corners[0], corners[1], corners[quadrant & 1 ? 3 : 2], corners[quadrant & 2 ? 5 : 4]};
}

PolyhedronParts::PolyhedronParts(const Vtr::Polyhedra& cells, Index cell, std::span<const double> positions,
                                 const Vec3& origin) {
    const auto point = [&](Index v) { return PointAt(positions, v) - origin; };
    const Offset first = cells.offsets[cell], last = cells.offsets[cell + 1];
    std::vector<Index> vertices(cells.face_vertices.begin() + cells.face_vertex_offsets[first],
                                cells.face_vertices.begin() + cells.face_vertex_offsets[last]);
    corners_.reserve(vertices.size());
    for (Offset f = first; f < last; ++f) {
        const Offset begin = cells.face_vertex_offsets[f], n = cells.face_vertex_offsets[f + 1] - begin;
        const auto corner = [&](Offset k) { return point(cells.face_vertices[begin + k % n]); };
        Vec3 face{};
        for (Offset k = 0; k < n; ++k) face = face + (1.0 / static_cast<double>(n)) * corner(k);
        for (Offset k = 0; k < n; ++k) corners_.push_back({face, corner(k), corner(k + 1)});
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    for (Index v : vertices) {
        centroid_ = centroid_ + (1 / static_cast<double>(vertices.size())) * point(v);
    }
}

CellPlaces::CellPlaces(const Far::TopologyRefiner& refiner, int level, std::span<const double> positions)
    : refiner_(refiner), level_(level), positions_(positions) {}

std::span<const Index> CellPlaces::Vertices(Index cell) const {
    if (!refiner_.is_polyhedral()) {
        const Far::Level& l = refiner_.level(level_);
        if (cell < l.n_tets) return l.TetVertices(cell);
        return l.OctVertices(cell - l.n_tets);
    }
    const Vtr::PolyhedralLevel& l = refiner_.polyhedral_level(level_);
    if (l.IsHex(cell)) return {l.hex_vertices.data() + 8 * static_cast<std::size_t>(cell), 8};
    const Vtr::Polyhedra& p = l.polyhedra;
    const Offset begin = p.face_vertex_offsets[p.offsets[cell - l.n_hexes]],
                 end = p.face_vertex_offsets[p.offsets[cell - l.n_hexes + 1]];
    return {p.face_vertices.data() + begin, static_cast<std::size_t>(end - begin)};
}

template <class InTet, class InHex>
CellPlace CellPlaces::Find(Index cell, const Vec3& point, double scale, InTet&& in_tet, InHex&& in_hex,
                           double enough) const {
    const auto relative = [&](const Vec3& p) { return scale * (p - point); };
    const auto corner = [&](std::span<const Index> v, std::size_t i) { return relative(PointAt(positions_, v[i])); };
    CellPlace best{.place = {.element = cell}};
    const auto take = [&](const Nearest& found, Index part, const std::array<double, 3>& at) {
        if (!(found.distance < best.distance)) return best.distance <= enough;
        best = {{cell, part, at}, found.distance};
        return best.distance <= enough;
    };

    if (!refiner_.is_polyhedral()) {
        const Far::Level& l = refiner_.level(level_);
        if (cell < l.n_tets) {
            const auto v = l.TetVertices(cell);
            const Nearest found = in_tet({corner(v, 0), corner(v, 1), corner(v, 2), corner(v, 3)});
            take(found, 0, {found.at.x, found.at.y, found.at.z});
            return best;
        }
        const auto v = l.OctVertices(cell - l.n_tets);
        std::array<Vec3, 6> corners;
        for (std::size_t i = 0; i < 6; ++i) corners[i] = corner(v, i);
        for (int quadrant = 0; quadrant < 4; ++quadrant) {
            const Nearest found = in_tet(OctPart(corners, quadrant));
            const double b = found.at.y, c = found.at.z, rest = 1 - b - c;
            // The second corner of the part weighs at.x, the first what is left of `rest`.
            const double u = std::clamp(rest - 2 * found.at.x, -rest, rest);
            if (take(found, 0, {u, quadrant & 1 ? -b : b, quadrant & 2 ? -c : c})) break;
        }
        return best;
    }
    const Vtr::PolyhedralLevel& l = refiner_.polyhedral_level(level_);
    if (l.IsHex(cell)) {
        const auto v = Vertices(cell);
        Trilinear hex;
        for (std::size_t i = 0; i < 8; ++i) hex.corners[i] = corner(v, kHexVertexOfCorner[i]);
        const Nearest found = in_hex(hex);
        take(found, 0, {found.at.x, found.at.y, found.at.z});
        return best;
    }
    const PolyhedronParts parts(l.polyhedra, cell - l.n_hexes, positions_, point);
    for (Index part = 0; part < parts.n_parts(); ++part) {
        TetCorners corners = parts.Part(part);
        for (Vec3& c : corners) c = scale * c;
        const Nearest found = in_tet(corners);
        if (take(found, part, {found.at.x, found.at.y, found.at.z})) break;
    }
    return best;
}

CellPlace CellPlaces::FindNearest(Index cell, const Vec3& point, double scale, double round_off, double limit) const {
    return Find(
        cell, point, scale, [](const TetCorners& corners) { return NearestInTet(corners); },
        [&](const Trilinear& hex) { return NearestInHex(hex, round_off, limit); }, 0);
}

CellPlace CellPlaces::Hold(Index cell, const Vec3& point, double scale, double reach) const {
    return Find(
        cell, point, scale, [&](const TetCorners& corners) { return HoldInTet(corners, reach); },
        [&](const Trilinear& hex) { return HoldInHex(hex, reach); }, reach);
}

}  // namespace SolidSubdiv::Geometry::Internal

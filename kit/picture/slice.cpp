// SPDX-License-Identifier: Apache-2.0
// Cells as tets, and what a plane leaves of triangles and tets; see slice.h.
#include <solidsubdiv/kit/picture/internal/cell_shapes.h>
#include <solidsubdiv/kit/picture/internal/vec3.h>
#include <solidsubdiv/kit/picture/slice.h>
#include <solidsubdiv/sdc/errors.h>

#include <algorithm>
#include <string>
#include <unordered_map>

namespace SolidSubdiv::Picture {
namespace {

using Internal::Vec3d;

class Slicer {
  public:
    Slicer(const Io::Mesh& mesh, const Plane& plane, std::span<const double> values)
        : mesh_(mesh), values_(values), normal_{plane.normal[0], plane.normal[1], plane.normal[2]} {
        const Vec3d point{plane.point[0], plane.point[1], plane.point[2]};
        const auto n = static_cast<std::size_t>(mesh.topology.n_vertices);
        points_.resize(n);
        heights_.resize(n);
        for (std::size_t v = 0; v < n; ++v) {
            points_[v] = {mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]};
            heights_[v] = Dot(normal_, points_[v] - point);
        }
        point_values_.assign(values.begin(), values.end());
    }

    SolidSlice Run() {
        const SolidFaces boundary = SolidBoundary(mesh_);
        for (std::size_t t = 0; t < boundary.triangles.size(); t += 3) ClipSkin(&boundary.triangles[t]);
        Internal::ForEachCell(mesh_.topology, [&](const Internal::CellFaces& cell) {
            const auto vertices = cell.vertices();
            const auto n_above = std::count_if(vertices.begin(), vertices.end(), [&](Index v) { return Above(v); });
            if (n_above > 0 && static_cast<std::size_t>(n_above) < vertices.size()) CutCell(cell);
        });
        out_.cap_edges = Internal::UniqueEdges(std::move(edges_));
        return std::move(out_);
    }

  private:
    bool Above(Index v) const { return heights_[static_cast<std::size_t>(v)] > 0; }

    Index Emit(Vec3d p, double value) {
        out_.positions.insert(out_.positions.end(), {p.x, p.y, p.z});
        if (!values_.empty()) out_.values.push_back(value);
        return static_cast<Index>(out_.positions.size() / 3 - 1);
    }
    double ValueAt(Index v) const { return values_.empty() ? 0 : point_values_[static_cast<std::size_t>(v)]; }

    /// The slice's point for a vertex that stays (a == b) or for the place where an edge meets the plane.
    Index PointOn(Index a, Index b) {
        if (a > b) std::swap(a, b);  // the same bits from both sides
        // An edge that ends on the plane meets it in its end, which stays.
        if (heights_[static_cast<std::size_t>(a)] == 0) b = a;
        if (heights_[static_cast<std::size_t>(b)] == 0) a = b;
        const auto key = (static_cast<std::uint64_t>(a) << 32) | static_cast<std::uint32_t>(b);
        const auto [place, is_new] = made_.try_emplace(key, kNoIndex);
        if (is_new) {
            const double ha = heights_[static_cast<std::size_t>(a)], hb = heights_[static_cast<std::size_t>(b)];
            const double t = a == b ? 0 : ha / (ha - hb);
            const Vec3d pa = points_[static_cast<std::size_t>(a)], pb = points_[static_cast<std::size_t>(b)];
            place->second = Emit(pa + t * (pb - pa), (1 - t) * ValueAt(a) + t * ValueAt(b));
        }
        return place->second;
    }

    void ClipSkin(const Index* triangle) {
        std::vector<Index> polygon;
        for (int i = 0; i < 3; ++i) {
            const Index a = triangle[i], b = triangle[(i + 1) % 3];
            if (!Above(a)) polygon.push_back(PointOn(a, a));
            if (Above(a) != Above(b)) polygon.push_back(PointOn(a, b));
        }
        for (std::size_t i = 2; i < polygon.size(); ++i) {
            const std::array<Index, 3> t{polygon[0], polygon[i - 1], polygon[i]};
            if (HasArea(t)) out_.skin.insert(out_.skin.end(), t.begin(), t.end());
        }
    }

    static bool HasArea(const std::array<Index, 3>& t) { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; }

    void CutCell(const Internal::CellFaces& cell) {
        const bool is_tet = cell.kind() == CellKind::Tet;
        const auto v = cell.vertices();
        if (is_tet) CutTet({v[0], v[1], v[2], v[3]}, cell.kind());
        // Other cells are tets from the centre to the triangles of the faces; a face's diagonals start at its lowest
        // vertex, so that both its cells take the same ones.
        const Index centre = is_tet ? kNoIndex : AddCentre(v);
        for (std::size_t f = 0; f < cell.n_faces(); ++f) {
            std::vector<Index> face(cell.face(f).begin(), cell.face(f).end());
            std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
            for (std::size_t i = 2; i < face.size(); ++i) {
                const std::array<Index, 3> triangle{face[0], face[i - 1], face[i]};
                AddOutline(triangle);
                if (!is_tet) CutTet({triangle[0], triangle[1], triangle[2], centre}, cell.kind());
            }
        }
    }

    Index AddCentre(std::span<const Index> cell) {
        const double share = 1 / static_cast<double>(cell.size());
        Vec3d point{};
        double height = 0, value = 0;
        for (Index v : cell) {
            point += share * points_[static_cast<std::size_t>(v)];
            height += share * heights_[static_cast<std::size_t>(v)];
            value += share * ValueAt(v);
        }
        points_.push_back(point);
        heights_.push_back(height);
        if (!values_.empty()) point_values_.push_back(value);
        return static_cast<Index>(points_.size() - 1);
    }

    void CutTet(const std::array<Index, 4>& tet, CellKind kind) {
        std::vector<Index> above, below;
        for (Index v : tet) (Above(v) ? above : below).push_back(v);
        if (above.empty() || below.empty()) return;
        std::vector<Index> polygon;  // around: neighbours share a vertex of the tet
        if (above.size() == 2) {
            polygon = {PointOn(above[0], below[0]), PointOn(above[0], below[1]), PointOn(above[1], below[1]),
                       PointOn(above[1], below[0])};
        } else {
            for (Index a : above) {
                for (Index b : below) polygon.push_back(PointOn(a, b));
            }
        }
        for (std::size_t i = 2; i < polygon.size(); ++i) {
            std::array<Index, 3> t{polygon[0], polygon[i - 1], polygon[i]};
            if (!HasArea(t)) continue;
            const auto at = [&](Index p) {
                const double* x = &out_.positions[3 * static_cast<std::size_t>(p)];
                return Vec3d{x[0], x[1], x[2]};
            };
            if (Dot(Cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])), normal_) < 0) std::swap(t[1], t[2]);
            out_.cap.insert(out_.cap.end(), t.begin(), t.end());
            out_.cap_kinds.push_back(kind);
        }
    }

    void AddOutline(const std::array<Index, 3>& triangle) {
        std::vector<Index> ends;
        for (std::size_t i = 0; i < 3; ++i) {
            const Index a = triangle[i], b = triangle[(i + 1) % 3];
            if (Above(a) != Above(b)) ends.push_back(PointOn(a, b));
        }
        if (ends.size() == 2 && ends[0] != ends[1])
            edges_.push_back({std::min(ends[0], ends[1]), std::max(ends[0], ends[1])});
    }

    const Io::Mesh& mesh_;
    std::span<const double> values_;
    Vec3d normal_;
    std::vector<Vec3d> points_;         // vertices, then centres of cells that are cut
    std::vector<double> heights_;       // above the plane
    std::vector<double> point_values_;  // or empty
    std::unordered_map<std::uint64_t, Index> made_;
    std::vector<std::array<Index, 2>> edges_;
    SolidSlice out_;
};

}  // namespace

std::vector<Color> SolidSlice::CapColorsByKind() const {
    std::vector<Color> colors;
    for (CellKind kind : cap_kinds) colors.push_back(ColorOf(kind));
    return colors;
}

SolidSlice SliceSolid(const Io::Mesh& mesh, const Plane& plane, std::span<const double> values) {
    Internal::CheckPlane(plane);
    if (!values.empty() && values.size() != static_cast<std::size_t>(mesh.topology.n_vertices)) {
        throw InvalidInput("picture: " + std::to_string(values.size()) + " values for " +
                           std::to_string(mesh.topology.n_vertices) + " vertices");
    }
    return Slicer(mesh, plane, values).Run();
}

}  // namespace SolidSubdiv::Picture

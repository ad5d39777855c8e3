// SPDX-License-Identifier: Apache-2.0
// The elements of a refined level as a mesh for files.
#include <solidsubdiv/apps/cli/refined_mesh.h>

#include <algorithm>
#include <array>

#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Cli {

namespace {

using Corners = std::array<Index, 3>;

Corners Ascending(std::span<const Index, 3> v) {
    Corners corners = {v[0], v[1], v[2]};
    std::sort(corners.begin(), corners.end());
    return corners;
}

template <class T>
void Repeat(std::vector<Offset>& rows, T row, Offset times) {
    rows.insert(rows.end(), static_cast<std::size_t>(times), static_cast<Offset>(row));
}

}  // namespace

RefinedElements::RefinedElements(const Io::Topology& control, const Far::TopologyRefiner& refiner,
                                 const FacesLeftOut& left_out)
    : control_(control), refiner_(refiner), edges_(control, refiner) {
    FindTriangles();
    n_tags_ = control.n_triangles() - static_cast<Offset>(triangles_.size()) + control.n_edges() - edges_.n_parts();
    left_out_ = TakeLeftOut(triangles_, left_out, refiner);
}

void RefinedElements::FindTriangles() {
    // Level 0 numbers faces in the order of their ascending vertices, and boundary faces in that of the faces: so both
    // lists are walked together.
    const Vtr::Level& level = refiner_.level(0);
    const auto corners = [&](Index t) {
        return Ascending(std::span(control_.triangles).subspan(3 * static_cast<std::size_t>(t)).first<3>());
    };
    std::vector<Index> order(static_cast<std::size_t>(control_.n_triangles()));
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Index>(i);
    std::sort(order.begin(), order.end(), [&](Index a, Index b) { return corners(a) < corners(b); });
    Index b = 0;
    for (Index t : order) {
        const Corners wanted = corners(t);
        while (b < level.n_boundary_faces && Ascending(level.BoundaryVertices(b)) < wanted) ++b;
        if (b == level.n_boundary_faces || Ascending(level.BoundaryVertices(b)) != wanted) continue;
        if (level.face_tags[level.boundary_faces[b]].n_cells() == 0) triangles_.push_back({control_.n_cells() + t, b});
    }
    std::sort(triangles_.begin(), triangles_.end(), [](FacePart p, FacePart q) { return p.row < q.row; });
}

Io::Topology RefinedElements::At(int level) const {
    const Vtr::Level& from = refiner_.level(level);
    Io::Topology topology;
    topology.n_vertices = from.n_vertices;
    topology.tets.assign(from.tet_vertices.begin(), from.tet_vertices.end());
    topology.octs.assign(from.oct_vertices.begin(), from.oct_vertices.end());
    const std::size_t n_children = std::size_t{1} << (2 * level);
    topology.triangles.reserve(3 * n_children * triangles_.size());
    for (const FacePart& part : triangles_) {
        const Index* first = from.boundary_vertices.data() + 3 * n_children * static_cast<std::size_t>(part.place);
        topology.triangles.insert(topology.triangles.end(), first, first + 3 * n_children);
    }
    topology.edges = edges_.At(level);
    return topology;
}

std::vector<Offset> RefinedElements::ControlRows(int level) const {
    const Vtr::Level& base = refiner_.level(0);
    std::vector<Offset> tets(static_cast<std::size_t>(base.n_tets)), octs(static_cast<std::size_t>(base.n_octs));
    for (std::size_t t = 0; t < tets.size(); ++t) tets[t] = static_cast<Offset>(t);
    for (std::size_t o = 0; o < octs.size(); ++o) octs[o] = static_cast<Offset>(tets.size() + o);
    for (int i = 0; i < level; ++i) {
        std::vector<Offset> child_tets, child_octs;
        child_tets.reserve(4 * tets.size() + 8 * octs.size());
        child_octs.reserve(tets.size() + 6 * octs.size());
        for (Offset row : tets) Repeat(child_tets, row, 4);
        for (Offset row : octs) Repeat(child_tets, row, 8);
        child_octs = tets;
        for (Offset row : octs) Repeat(child_octs, row, 6);
        tets = std::move(child_tets);
        octs = std::move(child_octs);
    }
    std::vector<Offset> rows = std::move(tets);
    rows.insert(rows.end(), octs.begin(), octs.end());
    for (const FacePart& part : triangles_) Repeat(rows, part.row, Offset{1} << (2 * level));
    const Offset first_edge = control_.n_cells() + control_.n_triangles();
    for (Index edge : edges_.Origins(level)) rows.push_back(first_edge + edge);
    return rows;
}

std::vector<bool> RefinedElements::LeftOut(int level) const {
    std::vector<bool> is_left_out;
    if (left_out_.empty()) return is_left_out;
    is_left_out.assign(static_cast<std::size_t>(refiner_.level(level).n_boundary_faces), false);
    const std::ptrdiff_t n_children = std::ptrdiff_t{1} << (2 * level);
    for (Index place : left_out_) std::fill_n(is_left_out.begin() + n_children * place, n_children, true);
    return is_left_out;
}

Io::Attribute InheritedRows(const Io::Attribute& control, const std::vector<Offset>& control_rows) {
    Io::Attribute result{control.name, control.width, {}};
    const auto width = static_cast<std::size_t>(control.width);
    result.values.resize(control_rows.size() * width);
    Sdc::ParallelFor(static_cast<Offset>(control_rows.size()), 1 << 16, [&](Offset begin, Offset end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            std::copy_n(control.values.begin() + control_rows[i] * control.width, width,
                        result.values.begin() + static_cast<std::ptrdiff_t>(i * width));
        }
    });
    return result;
}

}  // namespace SolidSubdiv::Cli

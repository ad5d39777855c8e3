// SPDX-License-Identifier: Apache-2.0
// All cells are looked through for each cut: a few hundred cuts of a few thousand cells.
#include <solidsubdiv/apps/fit/internal/tet_cutter.h>

#include <algorithm>

#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/sdc/cells.h>

namespace SolidSubdiv::Fit::Internal {

namespace {

/// Of a tet: its volume over that of the regular one with its longest edge.
double QualityOf(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    double longest = 0;
    for (const Vec3& e : {b - a, c - a, d - a, c - b, d - b, d - c}) longest = std::max(longest, Dot(e, e));
    return longest > 0 ? std::sqrt(2.0) * Dot(Cross(b - a, c - a), d - a) / (longest * std::sqrt(longest)) : 0;
}

bool Has(std::span<const Index> cell, Index v) { return std::find(cell.begin(), cell.end(), v) != cell.end(); }
bool HasAll(std::span<const Index> cell, std::span<const Index> vertices) {
    return std::all_of(vertices.begin(), vertices.end(), [&](Index v) { return Has(cell, v); });
}

/// With c in place of v.
template <std::size_t n>
std::array<Index, n> Replaced(std::array<Index, n> cell, Index v, Index c) {
    std::replace(cell.begin(), cell.end(), v, c);
    return cell;
}

}  // namespace

TetCutter::TetCutter(ControlMesh& mesh) : mesh_(mesh) {
    const auto refiner = Far::TopologyRefiner::Create(mesh.View(), Sdc::Split::TetOct);
    for (Index b = 0; b < refiner.level(0).n_boundary_faces; ++b) {
        const auto v = refiner.level(0).BoundaryVertices(b);
        faces_.push_back({{v[0], v[1], v[2]}, 0});
    }
}

std::array<Index, 4> TetCutter::Tet(std::size_t t) const {
    const Index* const v = &mesh_.tets[4 * t];
    return {v[0], v[1], v[2], v[3]};
}

std::set<Edge> TetCutter::BoundaryEdges() const {
    std::set<Edge> edges;
    for (const Face& f : faces_) {
        for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax({f.vertices[k], f.vertices[(k + 1) % 3]}));
    }
    return edges;
}

std::set<Index> TetCutter::BoundaryVertices() const {
    std::set<Index> vertices;
    for (const Face& f : faces_) vertices.insert(f.vertices.begin(), f.vertices.end());
    return vertices;
}

double TetCutter::MeanEdge(Index v) const {
    double sum = 0;
    int n = 0;
    for (const Face& f : faces_) {
        if (!Has(f.vertices, v)) continue;
        for (Index w : f.vertices) sum += Length(At(w) - At(v));
        n += 2;
    }
    return n > 0 ? sum / n : 0;
}

double TetCutter::LeastQuality(Index v) const {
    double least = 1;
    for (std::size_t t = 0; t < n_tets(); ++t) {
        const auto tet = Tet(t);
        if (Has(tet, v)) least = std::min(least, QualityOf(At(tet[0]), At(tet[1]), At(tet[2]), At(tet[3])));
    }
    for (std::size_t i = 0; i < mesh_.octs.size(); i += 6) {
        const std::span<const Index> o(&mesh_.octs[i], 6);
        if (!Has(o, v)) continue;
        for (const auto& t : Sdc::Oct::tets) {
            least = std::min(least, QualityOf(At(o[t[0]]), At(o[t[1]]), At(o[t[2]]), At(o[t[3]])));
        }
    }
    return least;
}

bool TetCutter::MoveIfWell(Index v, const Vec3& to) {
    constexpr double kWell = 0.08;
    const Vec3 from = At(v);
    const double before = LeastQuality(v);
    SetPoint(mesh_.positions, v, to);
    if (LeastQuality(v) >= std::min(kWell, 0.5 * before)) return true;
    SetPoint(mesh_.positions, v, from);
    return false;
}

void TetCutter::MoveTowards(Index v, const Vec3& to) {
    const Vec3 from = At(v);
    for (double part : {1.0, 0.75, 0.5, 0.25, 0.125}) {
        if (MoveIfWell(v, from + part * (to - from))) return;
    }
}

Index TetCutter::AddVertex(const Vec3& at) {
    mesh_.positions.insert(mesh_.positions.end(), {at.x, at.y, at.z});
    return mesh_.n_vertices() - 1;
}

void TetCutter::CutOct(std::size_t o) {
    const auto at = mesh_.octs.begin() + static_cast<std::ptrdiff_t>(6 * o);
    for (const auto& t : Sdc::Oct::tets) {
        for (auto corner : t) mesh_.tets.push_back(at[corner]);
    }
    mesh_.octs.erase(at, at + 6);
}

void TetCutter::CutOctsAt(std::span<const Index> vertices) {
    for (std::size_t o = 0; 6 * o < mesh_.octs.size();) {
        if (HasAll({&mesh_.octs[6 * o], 6}, vertices)) {
            CutOct(o);
        } else {
            ++o;
        }
    }
}

void TetCutter::ReplaceTet(std::size_t t, std::span<const Index> vertices, Index c) {
    const std::array<Index, 4> tet = Tet(t);
    const auto first = Replaced(tet, vertices.front(), c);
    std::copy(first.begin(), first.end(), mesh_.tets.begin() + static_cast<std::ptrdiff_t>(4 * t));
    for (Index v : vertices.subspan(1)) {
        const auto part = Replaced(tet, v, c);
        mesh_.tets.insert(mesh_.tets.end(), part.begin(), part.end());
    }
}

Index TetCutter::CutEdge(Index u, Index v, const Vec3& at) {
    const std::array<Index, 2> ends{u, v};
    CutOctsAt(ends);
    constexpr double kLeast = 0.15;  // of the edge, from its ends
    const Vec3 start = At(u), along = At(v) - start;
    const double t = Dot(along, along) > 0 ? Dot(at - start, along) / Dot(along, along) : 0.5;
    const Index c = AddVertex(start + std::clamp(t, kLeast, 1 - kLeast) * along);
    for (std::size_t i = 0, n = n_tets(); i < n; ++i) {
        if (HasAll(Tet(i), ends)) ReplaceTet(i, ends, c);
    }
    for (std::size_t i = 0, n = faces_.size(); i < n; ++i) {
        const Face face = faces_[i];
        if (!HasAll(face.vertices, ends)) continue;
        faces_[i].vertices = Replaced(face.vertices, u, c);
        faces_.push_back({Replaced(face.vertices, v, c), face.patch});
    }
    MoveTowards(c, at);
    return c;
}

Index TetCutter::CutFace(const std::array<Index, 3>& face, const Vec3& at) {
    CutOctsAt(face);
    const Index c = AddVertex(1.0 / 3 * (At(face[0]) + At(face[1]) + At(face[2])));
    for (std::size_t i = 0, n = n_tets(); i < n; ++i) {
        if (HasAll(Tet(i), face)) ReplaceTet(i, face, c);
    }
    for (std::size_t i = 0, n = faces_.size(); i < n; ++i) {
        const Face whole = faces_[i];
        if (whole.vertices != face) continue;
        faces_[i].vertices = Replaced(face, face[0], c);
        for (std::size_t k = 1; k < 3; ++k) faces_.push_back({Replaced(face, face[k], c), whole.patch});
    }
    MoveTowards(c, at);
    return c;
}

Index TetCutter::CutTet(const std::array<Index, 4>& tet) {
    const Index c = AddVertex(0.25 * (At(tet[0]) + At(tet[1]) + At(tet[2]) + At(tet[3])));
    for (std::size_t i = 0, n = n_tets(); i < n; ++i) {
        if (Tet(i) == tet) ReplaceTet(i, tet, c);
    }
    return c;
}

}  // namespace SolidSubdiv::Fit::Internal

// SPDX-License-Identifier: Apache-2.0
// Patches of the target, patches of the boundary's vertices, and cuts where an edge leads from one to another.
#include <solidsubdiv/apps/fit/cut_creases.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>

#include <solidsubdiv/apps/fit/internal/flat_cells.h>
#include <solidsubdiv/apps/fit/internal/patches.h>
#include <solidsubdiv/apps/fit/internal/tet_cutter.h>
#include <solidsubdiv/apps/fit/internal/vec3.h>
#include <solidsubdiv/sdc/creases.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Fit {

using namespace Internal;

namespace {

bool HaveCommon(const PatchSet& a, const PatchSet& b) {
    return std::any_of(a.begin(), a.end(), [&](Index p) { return b.count(p) > 0; });
}

/// Edges between faces of two patches.
std::vector<Edge> CreasesBetween(const std::vector<TetCutter::Face>& faces) {
    std::map<Edge, PatchSet> patches_at;
    for (const auto& f : faces) {
        for (std::size_t k = 0; k < 3; ++k) {
            patches_at[std::minmax({f.vertices[k], f.vertices[(k + 1) % 3]})].insert(f.patch);
        }
    }
    std::vector<Edge> creases;
    for (const auto& [edge, patches] : patches_at) {
        if (patches.size() > 1) creases.push_back(edge);
    }
    return creases;
}

/// Vertices of the boundary know the patches that they are on: one, two on a sharp edge, more in a corner.
class CreaseCutter {
  public:
    CreaseCutter(TetCutter& cutter, const Patches& patches) : cutter_(cutter), patches_(patches) {
        std::vector<double> points;
        const std::set<Index> vertices = cutter.BoundaryVertices();
        for (Index v : vertices) {
            const Vec3 p = cutter_.At(v);
            points.insert(points.end(), {p.x, p.y, p.z});
        }
        const std::vector<Index> nearest = patches.NearestTo(points);
        std::size_t i = 0;
        for (Index v : vertices) sets_[v] = {nearest[i++]};
    }

    /// Faces of the boundary get their patches. @returns vertices where three and more meet
    Index Run() {
        MoveToCorners();
        MoveToCurves();
        CutEdges();
        CutFaces();
        SetPatches();
        Settle();
        SetPatches();
        return static_cast<Index>(
            std::count_if(sets_.begin(), sets_.end(), [](const auto& entry) { return entry.second.size() > 2; }));
    }

  private:
    /// Each corner takes the nearest vertex that is near.
    void MoveToCorners() {
        constexpr double kNear = 0.35;  // of the mean edge at the vertex
        std::vector<std::tuple<double, std::size_t, Index>> pairs;
        for (Index v : cutter_.BoundaryVertices()) {
            const double near = kNear * cutter_.MeanEdge(v);
            for (std::size_t c = 0; c < patches_.corners.size(); ++c) {
                const double d = Length(cutter_.At(v) - patches_.corners[c].at);
                if (d < near) pairs.emplace_back(d, c, v);
            }
        }
        std::sort(pairs.begin(), pairs.end());
        for (const auto& [d, c, v] : pairs) {
            PatchSet& set = sets_.at(v);
            if (taken_.count(c) > 0 || set.size() > 1 || !cutter_.MoveIfWell(v, patches_.corners[c].at)) continue;
            set = patches_.corners[c].patches;
            taken_.insert(c);
        }
    }

    struct Crossing {
        Vec3 at;
        PatchSet patches;
        std::optional<std::size_t> corner{};  ///< that it is
    };
    /// The corner of all of these patches that is nearest to a point, not taken yet, and nearer than `least`.
    std::optional<std::size_t> CornerNear(const Vec3& at, const PatchSet& patches, double least) const {
        std::optional<std::size_t> nearest;
        for (std::size_t c = 0; c < patches_.corners.size(); ++c) {
            const PatchSet& of = patches_.corners[c].patches;
            const double d = Length(patches_.corners[c].at - at);
            if (taken_.count(c) > 0 || d >= least ||
                !std::includes(of.begin(), of.end(), patches.begin(), patches.end()))
                continue;
            least = d;
            nearest = c;
        }
        return nearest;
    }
    /// Of an edge that leads from one patch to another: the point of the curves between them that is nearest to it.
    std::optional<Crossing> CrossingOf(Index u, Index v) const {
        std::optional<Crossing> crossing;
        double least = 0;
        for (Index a : sets_.at(u)) {
            for (Index b : sets_.at(v)) {
                const auto found = patches_.NearestOnCurve(a, b, cutter_.At(u), cutter_.At(v));
                if (!found || (crossing && found->distance >= least)) continue;
                least = found->distance;
                crossing = Crossing{found->at, {a, b}};
            }
        }
        constexpr double kNear = 0.25;  // of the edge: what would be beside a corner is the corner
        if (!crossing) return crossing;
        crossing->corner = CornerNear(crossing->at, crossing->patches, kNear * Length(cutter_.At(u) - cutter_.At(v)));
        if (crossing->corner) {
            const Patches::Corner& corner = patches_.corners[*crossing->corner];
            crossing->at = corner.at;
            crossing->patches = corner.patches;
        }
        return crossing;
    }

    /// Ends of such edges that are near, the nearest first.
    void MoveToCurves() {
        constexpr double kNear = 0.3;  // of the edge
        struct Move {
            double distance = 0;
            Index vertex = kNoIndex;
            Crossing to;
        };
        std::vector<Move> moves;
        for (const auto& [u, v] : cutter_.BoundaryEdges()) {
            if (HaveCommon(sets_.at(u), sets_.at(v))) continue;
            const auto crossing = CrossingOf(u, v);
            if (!crossing) continue;
            const double near = kNear * Length(cutter_.At(u) - cutter_.At(v));
            for (Index end : {u, v}) {
                Crossing to = *crossing;
                if (!to.corner) {  // straight to the sharp edge, not along it
                    to.at =
                        patches_
                            .NearestOnCurve(*to.patches.begin(), *to.patches.rbegin(), cutter_.At(end), cutter_.At(end))
                            ->at;
                }
                const double d = Length(cutter_.At(end) - to.at);
                if (d < near) moves.push_back({d, end, to});
            }
        }
        std::stable_sort(moves.begin(), moves.end(),
                         [](const Move& a, const Move& b) { return a.distance < b.distance; });
        for (const Move& m : moves) {
            PatchSet& set = sets_.at(m.vertex);
            if (m.to.corner && taken_.count(*m.to.corner) > 0) continue;
            if (set.size() > 1 || !cutter_.MoveIfWell(m.vertex, m.to.at)) continue;
            set = m.to.patches;
            if (m.to.corner) taken_.insert(*m.to.corner);
        }
    }

    void CutEdges() {
        constexpr int kMostDeep = 2;  // cuts of what was cut
        std::map<Index, int> depth;   // of vertices that were put in
        for (bool is_done = false; !is_done;) {
            is_done = true;
            for (const auto& [u, v] : cutter_.BoundaryEdges()) {
                PatchSet both = sets_.at(u);
                if (HaveCommon(both, sets_.at(v))) continue;
                is_done = false;
                both.insert(sets_.at(v).begin(), sets_.at(v).end());
                const int deep = std::max(depth[u], depth[v]);
                if (deep >= kMostDeep) {  // more patches than edges here: what is added last is on all of them
                    sets_.at(depth[u] > depth[v] ? u : v) = both;
                    continue;
                }
                // No sharp edge between the patches: what lies between them is narrower than this edge.
                const Crossing middle{0.5 * (cutter_.At(u) + cutter_.At(v)), both};
                const Crossing crossing = CrossingOf(u, v).value_or(middle);
                const Index c = cutter_.CutEdge(u, v, crossing.at);
                sets_[c] = crossing.patches;
                if (crossing.corner) taken_.insert(*crossing.corner);
                depth[c] = deep + 1;
            }
        }
    }

    PatchSet CommonOf(const std::array<Index, 3>& face) const {
        PatchSet common;
        for (Index p : sets_.at(face[0])) {
            if (sets_.at(face[1]).count(p) > 0 && sets_.at(face[2]).count(p) > 0) common.insert(p);
        }
        return common;
    }

    /// Faces between three sharp edges get the corner where these meet.
    void CutFaces() {
        const std::vector<TetCutter::Face> faces = cutter_.Faces();
        for (const auto& [face, patch] : faces) {
            if (!CommonOf(face).empty()) continue;
            PatchSet all;
            for (Index v : face) all.insert(sets_.at(v).begin(), sets_.at(v).end());
            const Vec3 middle = 1.0 / 3 * (cutter_.At(face[0]) + cutter_.At(face[1]) + cutter_.At(face[2]));
            const auto corner = CornerNear(middle, all, 0.5 * Length(cutter_.At(face[1]) - cutter_.At(face[0])));
            sets_[cutter_.CutFace(face, corner ? patches_.corners[*corner].at : middle)] = all;
            if (corner) taken_.insert(*corner);
        }
    }

    /// The rest of the way to the sharp edges, for those whose neighbours were in it, and evenly along them: places
    /// that were nearest to edges across may lie in another order than the edges do.
    void Settle() {
        std::map<Index, std::vector<Index>> along;  // neighbours by creases
        for (const Edge& e : CreasesBetween(cutter_.Faces())) {
            along[e.first].push_back(e.second);
            along[e.second].push_back(e.first);
        }
        constexpr int kSweeps = 10;
        for (int sweep = 0; sweep < kSweeps; ++sweep) {
            for (const auto& [v, patches] : sets_) {
                const PatchSet& set = patches;
                if (set.size() == 2) {
                    Vec3 at = cutter_.At(v);
                    if (const auto& beside = along[v]; beside.size() == 2) {
                        at = 0.5 * at + 0.25 * (cutter_.At(beside[0]) + cutter_.At(beside[1]));
                    }
                    const auto to = patches_.NearestOnCurve(*set.begin(), *set.rbegin(), at, at);
                    if (to) cutter_.MoveTowards(v, to->at);
                } else if (set.size() > 2) {
                    const auto corner = std::find_if(patches_.corners.begin(), patches_.corners.end(),
                                                     [&](const Patches::Corner& c) { return c.patches == set; });
                    if (corner != patches_.corners.end()) cutter_.MoveTowards(v, corner->at);
                }
            }
        }
    }

    /// That which all corners of a face have; of several the one beside which it looks the same way.
    void SetPatches() {
        const auto& faces = cutter_.Faces();
        std::map<std::size_t, PatchSet> several;
        std::map<Edge, std::vector<std::size_t>> faces_at;
        for (std::size_t i = 0; i < faces.size(); ++i) {
            const auto& v = faces[i].vertices;
            const PatchSet common = CommonOf(v);
            if (common.size() > 1) {
                several[i] = common;
                cutter_.SetPatch(i, patches_.NearestOf(common, {cutter_.At(v[0]), cutter_.At(v[1]), cutter_.At(v[2])}));
            } else {
                cutter_.SetPatch(i, *common.begin());
            }
            for (std::size_t k = 0; k < 3; ++k) faces_at[std::minmax({v[k], v[(k + 1) % 3]})].push_back(i);
        }
        // Two creases along a face: the third edge is the shorter way.
        constexpr int kPasses = 4;
        for (int pass = 0; pass < kPasses; ++pass) {
            for (const auto& [i, common] : several) {
                std::map<Index, int> n_beside;
                const auto& v = faces[i].vertices;
                for (std::size_t k = 0; k < 3; ++k) {
                    for (std::size_t j : faces_at[std::minmax({v[k], v[(k + 1) % 3]})]) {
                        if (j != i) ++n_beside[faces[j].patch];
                    }
                }
                for (const auto& [patch, n] : n_beside) {
                    if (n >= 2 && common.count(patch) > 0) cutter_.SetPatch(i, patch);
                }
            }
        }
    }

    TetCutter& cutter_;
    const Patches& patches_;
    std::map<Index, PatchSet> sets_;  // of vertices of the boundary
    std::set<std::size_t> taken_{};   // corners that are vertices
};

}  // namespace

CutReport CutCreases(ControlMesh& mesh, const TargetSurface& target, double degrees) {
    if (!mesh.hexes.empty() || (mesh.tets.empty() && mesh.octs.empty())) {
        throw InvalidInput("fit: sharp edges can be cut into tets and octahedra, not into other cells");
    }
    if (!(degrees >= 0 && degrees < 180)) {
        throw InvalidInput("fit: degrees is " + std::to_string(degrees) + "; it must be from 0 to below 180");
    }
    CutReport report{.n_added = -mesh.n_vertices()};
    TetCutter cutter(mesh);
    if (degrees > 0) {
        const Patches patches(target, degrees);
        if (patches.n_patches > 1) report.n_corners = CreaseCutter(cutter, patches).Run();
    }
    CutFlatCells(cutter);
    for (const Edge& e : CreasesBetween(cutter.Faces())) {
        mesh.crease_edges.insert(mesh.crease_edges.end(), {e.first, e.second});
        mesh.crease_sharpness.push_back(Sdc::kInfinitelySharp);
        ++report.n_creases;
    }
    report.n_added += mesh.n_vertices();
    return report;
}

}  // namespace SolidSubdiv::Fit

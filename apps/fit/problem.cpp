// SPDX-License-Identifier: Apache-2.0
// Problems of control meshes: the limit of the boundary as rows, neighbours and corners from the elements.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string>

#include <solidsubdiv/apps/deform/embedding.h>
#include <solidsubdiv/apps/fit/fit.h>
#include <solidsubdiv/apps/fit/internal/cell_volumes.h>
#include <solidsubdiv/kit/geometry/tessellation.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Fit {

namespace {

/// Calls visit(vertices) for each element.
template <class Visit>
void ForElements(std::span<const Index> vertices, std::size_t width, Visit&& visit) {
    for (std::size_t i = 0; i + width <= vertices.size(); i += width) visit(vertices.subspan(i, width));
}

/// All that share an element with a point; where these are too few or lie too flat for affine weights, those around
/// them as well.
std::vector<std::vector<Index>> NeighborsOf(const ControlMesh& mesh) {
    std::vector<std::set<Index>> near(static_cast<std::size_t>(mesh.n_vertices()));
    const auto join = [&](std::span<const Index> element) {
        for (Index a : element) {
            for (Index b : element) {
                if (a != b) near[static_cast<std::size_t>(a)].insert(b);
            }
        }
    };
    ForElements(mesh.tets, 4, join);
    ForElements(mesh.octs, 6, join);
    ForElements(mesh.hexes, 8, join);
    ForElements(mesh.triangles, 3, join);
    ForElements(mesh.quads, 4, join);
    std::vector<std::vector<Index>> neighbors;
    for (std::size_t v = 0; v < near.size(); ++v) {
        std::set<Index> all = near[v];
        if (!mesh.is_solid()) {  // rings of a surface are flat
            for (Index a : near[v])
                all.insert(near[static_cast<std::size_t>(a)].begin(), near[static_cast<std::size_t>(a)].end());
            all.erase(static_cast<Index>(v));
        }
        neighbors.emplace_back(all.begin(), all.end());
    }
    return neighbors;
}

}  // namespace

std::vector<double> MovingSurface::Positions(std::span<const double> control) const {
    std::vector<double> positions(3 * static_cast<std::size_t>(rows.n_rows()));
    for (Index v = 0; v < rows.n_rows(); ++v) {
        const auto indices = rows.Indices(v);
        const auto weights = rows.Weights(v);
        for (std::size_t k = 0; k < indices.size(); ++k) {
            for (std::size_t c = 0; c < 3; ++c) {
                positions[3 * static_cast<std::size_t>(v) + c] +=
                    weights[k] * control[3 * static_cast<std::size_t>(indices[k]) + c];
            }
        }
    }
    return positions;
}

Problem MakeProblem(const ControlMesh& mesh, const Sdc::Scheme& scheme, const TargetSurface& target, int rate,
                    int fine_rate, bool with_tangents) {
    const Far::TopologyDescriptor topology = mesh.View();
    const bool is_polyhedral = !mesh.hexes.empty() || !mesh.quads.empty() || !Sdc::Takes(scheme, Sdc::Split::TetOct);
    const auto refiner =
        Far::TopologyRefiner::Create(topology, is_polyhedral ? Sdc::Split::Polyhedral : Sdc::Split::TetOct);
    const auto surface_at = [&](int facets, bool has_tangents) {
        Geometry::Tessellation t =
            Geometry::TessellateBoundary(refiner, scheme, {.rate = facets, .normals = has_tangents});
        return MovingSurface{std::move(t.rows), std::move(t.triangles), std::move(t.tangents),
                             std::move(t.tangent_vertices)};
    };
    Problem problem{.surface = surface_at(rate, with_tangents),
                    .target = target,
                    .control = mesh.positions,
                    .neighbors = NeighborsOf(mesh),
                    .corners = Internal::CellCornersOf(mesh)};
    if (fine_rate > 0 && fine_rate != rate) problem.fine = surface_at(fine_rate, false);
    return problem;
}

Problem MakeLatticeProblem(const ControlMesh& lattice, const Sdc::Scheme& scheme, const TargetSurface& model,
                           const TargetSurface& target, int levels) {
    const auto embedding = Deform::Embedding::Create(lattice.View(), lattice.positions, model.positions,
                                                     {.scheme = scheme, .levels = levels});
    if (!embedding.outside().empty()) {
        throw InvalidInput("fit: " + std::to_string(embedding.outside().size()) +
                           " points of the model lie outside the lattice, the first is point " +
                           std::to_string(embedding.outside().front().point) + "; make the lattice larger");
    }
    std::vector<Index> all(static_cast<std::size_t>(embedding.n_points()));
    std::iota(all.begin(), all.end(), 0);
    return {.surface = {embedding.ControlRows(all), {model.triangles.begin(), model.triangles.end()}},
            .target = target,
            .control = lattice.positions,
            .neighbors = NeighborsOf(lattice),
            .corners = Internal::CellCornersOf(lattice)};
}

void Problem::Validate() const {
    const std::size_t n = control.size() / 3;
    const auto fail = [](const std::string& text) { throw InvalidInput("fit: " + text); };
    if (control.empty() || control.size() % 3 != 0) fail("there are no control points");
    if (surface.rows.n_rows() == 0 || surface.triangles.empty()) fail("control points carry no surface");
    if (static_cast<std::size_t>(surface.rows.n_sources) != n) {
        fail("the surface is of " + std::to_string(surface.rows.n_sources) + " control points; there are " +
             std::to_string(n));
    }
    for (const auto& rows : surface.tangents) {
        if (static_cast<std::size_t>(rows.n_rows()) != surface.tangent_vertices.size()) {
            fail(std::to_string(rows.n_rows()) + " tangents for " + std::to_string(surface.tangent_vertices.size()) +
                 " vertices");
        }
    }
    for (double x : control) {
        if (!std::isfinite(x)) fail("a control point is not finite");
    }
    if (neighbors.size() != n)
        fail("neighbors has " + std::to_string(neighbors.size()) + " rows; it must have one a control point");
    const auto require_point = [&](Index p, const char* what) {
        if (p < 0 || static_cast<std::size_t>(p) >= n) {
            fail(std::string(what) + " names control point " + std::to_string(p) + "; there are " + std::to_string(n));
        }
    };
    for (const auto& around : neighbors) {
        for (Index p : around) require_point(p, "neighbors");
    }
    for (const auto& corner : corners) {
        for (Index p : corner) require_point(p, "a corner");
    }
    if (fine_places.n_rows() > 0 && static_cast<std::size_t>(fine_places.n_sources) != n) {
        fail("fine places are of " + std::to_string(fine_places.n_sources) + " control points; there are " +
             std::to_string(n));
    }
    for (const auto& corner : fine_corners) {
        for (Index p : corner) {
            if (p < 0 || p >= fine_places.n_rows()) {
                fail("a fine corner names place " + std::to_string(p) + "; there are " +
                     std::to_string(fine_places.n_rows()));
            }
        }
    }
    for (Index p : locked) require_point(p, "locked");
    for (const auto& pair : mirrored) {
        for (Index p : pair) require_point(p, "mirrored");
    }
    if (mirror_axis < 0 || mirror_axis > 2)
        fail("mirror_axis is " + std::to_string(mirror_axis) + "; it must be 0, 1 or 2");
    if (!partners.empty() && partners.size() != 3 * static_cast<std::size_t>(surface.rows.n_rows())) {
        fail(std::to_string(partners.size() / 3) + " partners for " + std::to_string(surface.rows.n_rows()) +
             " vertices of the surface");
    }
    if (partners.empty() || !target.positions.empty()) target.Validate();
}

}  // namespace SolidSubdiv::Fit

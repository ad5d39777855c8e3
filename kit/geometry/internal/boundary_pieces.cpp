// SPDX-License-Identifier: Apache-2.0
// Pieces of boundary faces, and limits in them.
#include <solidsubdiv/kit/geometry/internal/boundary_pieces.h>

#include <algorithm>
#include <string>

#include <solidsubdiv/far/limit_stencil_table.h>
#include <solidsubdiv/kit/geometry/internal/nearest_in_triangle.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Geometry::Internal {

namespace {

constexpr std::array<At, 4> kTriangle{{{0, 0}, {1, 0}, {0, 1}, {0, 0}}};
constexpr std::array<At, 4> kQuad{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

}  // namespace

BoundaryPieces FindPieces(const Far::TopologyRefiner& refiner, const std::vector<bool>& is_left_out, bool cuts_quads) {
    const bool is_polyhedral = refiner.is_polyhedral();
    const Index n_faces =
        is_polyhedral ? refiner.polyhedral_level(0).n_boundary_faces : refiner.level(0).n_boundary_faces;
    if (!is_left_out.empty() && static_cast<Index>(is_left_out.size()) != n_faces) {
        throw InvalidInput("is_left_out speaks of " + std::to_string(is_left_out.size()) + " faces; there are " +
                           std::to_string(n_faces) + " boundary faces");
    }
    BoundaryPieces found{.n_nodes = refiner.n_vertices(0)};
    for (Index f = 0; f < n_faces; ++f) {
        if (!is_left_out.empty() && is_left_out[static_cast<std::size_t>(f)]) continue;
        if (!is_polyhedral) {
            const auto v = refiner.level(0).BoundaryVertices(f);
            found.pieces.push_back({{f, 0, kTriangle}, 3, {v[0], v[1], v[2], kNoIndex}});
            continue;
        }
        const auto v = refiner.polyhedral_level(0).BoundaryVertices(f);
        if (v.size() == 4 && !cuts_quads) {
            found.pieces.push_back({{f, 0, kQuad}, 4, {v[0], v[1], v[2], v[3]}});
            continue;
        }
        const Index centre = found.n_nodes++;
        for (std::size_t k = 0; k < v.size(); ++k) {
            const std::size_t next = (k + 1) % v.size();
            FacetDomain domain{f, static_cast<Index>(k), kTriangle};
            if (v.size() == 4) domain = {f, 0, {{{.5, .5}, kQuad[k], kQuad[next], {}}}};
            found.pieces.push_back({domain, 3, {centre, v[k], v[next], kNoIndex}});
        }
    }
    return found;
}

namespace {

Far::LimitPlacesOptions OptionsOf(bool tangents, const Progress& progress) {
    return {.level = 0,
            .elements = Far::Elements::BoundaryFaces,
            .order = tangents ? 1 : 0,
            .tangents = tangents,
            .progress = progress};
}

void RequireLimits(const Far::LimitStencilTable& table, std::span<const Far::Place> places, const Sdc::Scheme& scheme) {
    if (table.without_limit().empty()) return;
    const Far::Place& place = places[static_cast<std::size_t>(table.without_limit().front())];
    throw InvalidInput("boundary face " + std::to_string(place.element) + " has no limit at (" +
                       std::to_string(place.at[0]) + ", " + std::to_string(place.at[1]) +
                       "): " + std::string(Sdc::NameOf(scheme)) +
                       " does not converge there; choose other options or another scheme");
}

}  // namespace

LimitRows MakeLimitRows(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                        std::span<const Far::Place> places, bool tangents, const Progress& progress) {
    const auto table = Far::LimitStencilTable::Create(refiner, scheme, places, OptionsOf(tangents, progress));
    RequireLimits(table, places, scheme);
    LimitRows made{table.rows(), {}};
    if (tangents) made.tangents = {table.DerivativeRows(0), table.DerivativeRows(1)};
    return made;
}

LimitPoints::LimitPoints(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme, const Progress& progress)
    : scheme_(scheme), factory_(refiner, scheme, OptionsOf(false, progress)) {}

std::vector<Vec3> LimitPoints::At(std::span<const Far::Place> places, std::span<const double> positions) {
    constexpr std::size_t kAtATime = std::size_t{1} << 18;  // some 100 MB of rows
    std::vector<Vec3> points;
    points.reserve(places.size());
    for (std::size_t first = 0; first < places.size(); first += kAtATime) {
        const auto some = places.subspan(first, std::min(kAtATime, places.size() - first));
        const Far::LimitStencilTable table = factory_.Create(some);
        RequireLimits(table, some, scheme_);
        const std::vector<double> values = Apply(table.rows(), positions, 3);
        for (std::size_t i = 0; i < values.size(); i += 3) points.push_back({values[i], values[i + 1], values[i + 2]});
    }
    return points;
}

std::vector<double> Apply(const Far::StencilRows<double>& rows, std::span<const double> values, int width) {
    const std::size_t w = static_cast<std::size_t>(std::max(0, width));
    if (width < 1 || values.size() != static_cast<std::size_t>(rows.n_sources) * w) {
        throw InvalidInput(std::to_string(values.size()) + " values do not fit " + std::to_string(rows.n_sources) +
                           " control vertices with " + std::to_string(width) + " each");
    }
    std::vector<double> result(static_cast<std::size_t>(rows.n_rows()) * w, 0.0);
    Sdc::ParallelFor(rows.n_rows(), 1024, [&](Offset begin, Offset end) {
        for (Offset i = begin; i < end; ++i) {
            double* to = result.data() + static_cast<std::size_t>(i) * w;
            const auto indices = rows.Indices(static_cast<Index>(i));
            const auto weights = rows.Weights(static_cast<Index>(i));
            for (std::size_t k = 0; k < indices.size(); ++k) {
                const double* from = values.data() + static_cast<std::size_t>(indices[k]) * w;
                for (std::size_t c = 0; c < w; ++c) to[c] += weights[k] * from[c];
            }
        }
    });
    return result;
}

double DistanceTo(const Vec3& p, const Vec3& a, const Vec3& b) { return DistanceTo(p, a, b, b); }

double DistanceTo(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto [v, w] = NearestInTriangle(a - p, b - p, c - p);
    return Length((a - p) + v * (b - a) + w * (c - a));
}

}  // namespace SolidSubdiv::Geometry::Internal

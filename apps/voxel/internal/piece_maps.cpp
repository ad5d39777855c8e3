// SPDX-License-Identifier: Apache-2.0
// Newton's method for four voxels of a hexahedron at a time; in tets its first step is the answer.
#include <solidsubdiv/apps/voxel/internal/piece_maps.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace SolidSubdiv::Voxel::Internal {

namespace {

using Vec = std::array<double, 3>;
typedef double Four __attribute__((vector_size(4 * sizeof(double))));

Vec Minus(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double Det(const Vec& a, const Vec& b, const Vec& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

using FourVecs = std::array<Four, 3>;

// Results go where they belong: vectors returned would depend on the processor.
void Cross(const FourVecs& a, const FourVecs& b, FourVecs& result) {
    result = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
void Dot(const FourVecs& a, const FourVecs& b, Four& result) { result = a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Coordinates of four voxels.
struct Coordinates {
    FourVecs at;
    Four jacobian;
    Four is_found;  ///< 0 or 1
};

/// Moves coordinates towards points where the map has them, until all are found.
#if defined(__x86_64__)
__attribute__((target_clones("avx2", "default")))
#endif
void SolveFour(const std::array<Polynomial, 3>& map, const FourVecs& points, bool is_linear, Coordinates& c) {
    const Four zero{}, low = zero - 0.5, high = zero + 1.5, one = zero + 1;
    for (int step = 0; step < 12; ++step) {
        const Four u = c.at[0], v = c.at[1], w = c.at[2];
        FourVecs missing, du, dv, dw;
        for (std::size_t k = 0; k < 3; ++k) {
            const Polynomial& f = map[k];
            du[k] = f[1] + v * f[4] + w * (f[5] + v * f[7]);
            dv[k] = f[2] + u * f[4] + w * (f[6] + u * f[7]);
            dw[k] = f[3] + u * f[5] + v * (f[6] + u * f[7]);
            missing[k] = (points[k] - f[0]) - (u * (f[1] + v * f[4]) + v * f[2] + w * dw[k]);
        }
        FourVecs rows[3], move;  // of the matrix's adjugate
        Cross(dv, dw, rows[0]);
        Cross(dw, du, rows[1]);
        Cross(du, dv, rows[2]);
        Dot(du, rows[0], c.jacobian);
        for (std::size_t k = 0; k < 3; ++k) {
            Dot(missing, rows[k], move[k]);
            move[k] /= c.jacobian;
        }
        Four length = zero;
        for (std::size_t k = 0; k < 3; ++k) {
            length += move[k] < zero ? -move[k] : move[k];
            if (is_linear) {
                c.at[k] += move[k];
                continue;
            }
            const Four next = c.at[k] + move[k];
            c.at[k] = next > low ? (next < high ? next : high) : low;
        }
        // Steps square what is missing: after one this short only rounding is.
        const auto is_short = length < 1e-7;
        c.is_found = is_short ? one : zero;
        if (is_linear || (is_short[0] & is_short[1] & is_short[2] & is_short[3])) break;
    }
}

/// Coordinates of the corners of a hexahedron.
constexpr std::array<Vec, 8> kHexCorners = {
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

#if defined(__x86_64__)
__attribute__((target_clones("avx2", "default")))
#endif
void EvaluateAt(const Polynomial& f, const double* u, const double* v, const double* w, std::span<float> values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double a = u[i], b = v[i], c = w[i];
        values[i] =
            static_cast<float>(f[0] + a * (f[1] + b * f[4]) + b * f[2] + c * (f[3] + a * f[5] + b * (f[6] + a * f[7])));
    }
}

}  // namespace

void PlacesInPiece::Evaluate(const Polynomial& f, std::span<float> values) const {
    EvaluateAt(f, u.data(), v.data(), w.data(), values);
}

PieceMaps::PieceMaps(const Far::TopologyRefiner& refiner, int level, const VoxelSolid& solid)
    : refiner_(refiner), level_(level), solid_(solid) {
    if (!refiner.is_polyhedral()) {
        n_tets_ = refiner.level(level).n_tets;
        return;
    }
    const Vtr::PolyhedralLevel& l = refiner.polyhedral_level(level);
    // Tets of one polyhedron share their first vertex and are a face's corners less two: counted as they were cut.
    Index next = solid.n_hexes;
    for (Index p = 0; p < l.n_polyhedra(); ++p) {
        polyhedron_pieces_.push_back(next);
        const Index apex = solid.TetsOf(next)[0];
        for (Offset f = l.polyhedra.offsets[p]; f < l.polyhedra.offsets[p + 1]; ++f) {
            const Offset begin = l.polyhedra.face_vertex_offsets[f], end = l.polyhedra.face_vertex_offsets[f + 1];
            const auto first = l.polyhedra.face_vertices.begin();
            if (std::find(first + begin, first + end, apex) == first + end) next += static_cast<Index>(end - begin) - 2;
        }
    }
    polyhedron_pieces_.push_back(next);
}

Index PieceMaps::CellOf(Index piece) const {
    if (!refiner_.is_polyhedral()) return piece < n_tets_ ? piece : n_tets_ + (piece - n_tets_) / 4;
    if (piece < solid_.n_hexes) return piece;
    const auto after = std::upper_bound(polyhedron_pieces_.begin(), polyhedron_pieces_.end(), piece);
    return solid_.n_hexes + static_cast<Index>(after - polyhedron_pieces_.begin()) - 1;
}

/// Coordinates that the tets of a hexahedron give to a point in it: near its own, however bent the hexahedron is.
Vec PieceMaps::CoordinatesByTets(const PlacesInPiece& hex, Index piece, const Vec& point) const {
    const auto tets = solid_.TetsOf(piece);
    Vec best{};
    double greatest_least = -HUGE_VAL;
    for (std::size_t t = 0; t < tets.size(); t += 4) {
        std::array<Vec, 4> x;
        for (std::size_t k = 0; k < 4; ++k) {
            const double* const p = &solid_.points[3 * static_cast<std::size_t>(tets[t + k])];
            x[k] = Minus({p[0], p[1], p[2]}, point);
        }
        const double det = Det(Minus(x[1], x[0]), Minus(x[2], x[0]), Minus(x[3], x[0]));
        std::array<double, 4> weights{0, Det(x[2], x[0], x[3]) / det, Det(x[1], x[3], x[0]) / det,
                                      Det(x[1], x[0], x[2]) / det};
        weights[0] = 1 - weights[1] - weights[2] - weights[3];
        const double least = *std::min_element(weights.begin(), weights.end());
        if (!(least > greatest_least)) continue;
        greatest_least = least;
        best = {};
        for (std::size_t k = 0; k < 4; ++k) {
            const auto corner = std::find(hex.vertices.begin(), hex.vertices.end(), tets[t + k]) - hex.vertices.begin();
            for (std::size_t c = 0; c < 3; ++c)
                best[c] += weights[k] * kHexCorners[static_cast<std::size_t>(corner)][c];
        }
    }
    return best;
}

void PieceMaps::Locate(const OwnedVoxels& owned, const Place& origin, PlacesInPiece& places) const {
    places.cell = CellOf(owned.piece);
    const bool is_hex = owned.piece < solid_.n_hexes;
    places.n_vertices = is_hex ? 8 : 4;
    const std::span<const Index> vertices = is_hex
                                                ? std::span<const Index>(refiner_.polyhedral_level(level_).hex_vertices)
                                                      .subspan(8 * static_cast<std::size_t>(owned.piece), 8)
                                                : solid_.TetsOf(owned.piece);
    std::copy(vertices.begin(), vertices.end(), places.vertices.begin());
    places.voxels.clear();
    for (int x = 0; x < kTileSide; ++x) {
        for (std::uint64_t bits = owned.voxels[static_cast<std::size_t>(x)]; bits != 0; bits &= bits - 1) {
            places.voxels.push_back(64 * x + std::countr_zero(bits));
        }
    }
    std::array<Polynomial, 3> map;
    for (std::size_t c = 0; c < 3; ++c) {
        map[c] =
            places.Between([&](Index v) { return solid_.points[3 * static_cast<std::size_t>(v) + c] - origin[c]; });
    }
    const std::size_t n = places.voxels.size();
    for (auto* x : {&places.u, &places.v, &places.w, &places.jacobian}) x->resize(n);
    const double start = is_hex ? 0.5 : 0;
    for (std::size_t i = 0; i < n; i += 4) {
        FourVecs points;
        for (std::size_t k = 0; k < 4; ++k) {
            const int voxel = places.voxels[std::min(i + k, n - 1)];
            points[0][k] = voxel / 64;
            points[1][k] = voxel / 8 % 8;
            points[2][k] = voxel % 8;
        }
        const Four middle = Four{} + start;
        Coordinates c{.at = {middle, middle, middle}, .jacobian = {}, .is_found = {}};
        SolveFour(map, points, !is_hex, c);
        const auto is_lost = [&](std::size_t k) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                if (!(std::abs(c.at[axis][k] - 0.5) < 0.75)) return true;
            }
            return c.is_found[k] == 0;
        };
        if (is_hex && (is_lost(0) || is_lost(1) || is_lost(2) || is_lost(3))) {
            for (std::size_t k = 0; k < 4; ++k) {
                const Vec at =
                    CoordinatesByTets(places, owned.piece,
                                      {points[0][k] + origin[0], points[1][k] + origin[1], points[2][k] + origin[2]});
                for (std::size_t axis = 0; axis < 3; ++axis) c.at[axis][k] = at[axis];
            }
            SolveFour(map, points, false, c);
        }
        for (std::size_t k = 0; k < std::min<std::size_t>(4, n - i); ++k) {
            places.u[i + k] = c.at[0][k];
            places.v[i + k] = c.at[1][k];
            places.w[i + k] = c.at[2][k];
            places.jacobian[i + k] = c.jacobian[k];
        }
    }
}

}  // namespace SolidSubdiv::Voxel::Internal

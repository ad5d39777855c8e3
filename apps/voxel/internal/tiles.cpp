// SPDX-License-Identifier: Apache-2.0
// Tiles are found by boxes; in a tile tets are intersected with rows of voxels.
#include <solidsubdiv/apps/voxel/internal/tiles.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <solidsubdiv/apps/voxel/internal/triangle_distance.h>
#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/vtr/grouping.h>

namespace SolidSubdiv::Voxel::Internal {

namespace {

using Vec = std::array<double, 3>;

struct Box {
    Vec low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

    void Include(const double* p) {
        for (std::size_t c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], p[c]);
            high[c] = std::max(high[c], p[c]);
        }
    }
    /// The tiles with voxels within `reach` of it: first and last.
    std::array<Place, 2> TilesWithin(double reach) const {
        std::array<Place, 2> tiles;
        for (std::size_t c = 0; c < 3; ++c) {
            tiles[0][c] = static_cast<int>(std::floor(std::ceil(low[c] - reach) / kTileSide));
            tiles[1][c] = static_cast<int>(std::floor(std::floor(high[c] + reach) / kTileSide));
        }
        return tiles;
    }
};

Box BoxOf(const VoxelSolid& solid) {
    Box box;
    for (std::size_t i = 0; i < solid.points.size(); i += 3) box.Include(&solid.points[i]);
    return box;
}

Vec Minus(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double Dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec Cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A tet as the points on the inner side of four planes; one that is inverted counts as it would the other way round,
/// a flat one holds nothing.
struct TetPlanes {
    std::array<Vec, 4> normal;
    std::array<double, 4> offset;
    Box box;

    /// Points so far outside, in voxels, are held: what lies on a face is in both cells, whatever rounding does. Of a
    /// tet that is all but flat no farther than a thousandth of its height.
    static constexpr double kSlack = 1e-9, kSlackOfHeight = 1e-3;

    bool Make(const std::array<Vec, 4>& v) {
        static constexpr std::size_t faces[4][3] = {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}};
        const double det = Dot(Minus(v[1], v[0]), Cross(Minus(v[2], v[0]), Minus(v[3], v[0])));
        if (det == 0) return false;
        for (std::size_t f = 0; f < 4; ++f) {
            const Vec& a = v[faces[f][0]];
            Vec n = Cross(Minus(v[faces[f][1]], a), Minus(v[faces[f][2]], a));
            if (Dot(n, Minus(v[f], a)) < 0) {
                for (double& x : n) x = -x;
            }
            normal[f] = n;
            offset[f] = std::min(kSlack * std::sqrt(Dot(n, n)), kSlackOfHeight * std::abs(det)) - Dot(n, a);
        }
        for (const Vec& p : v) box.Include(p.data());
        return true;
    }

    /// The z in [start, last] at which a row of points (x, y, z) is in the tet: [first, second], empty if first >
    /// second.
    std::array<double, 2> Row(double x, double y, double start, double last) const {
        double low = std::max(start, box.low[2] - kSlack), high = std::min(last, box.high[2] + kSlack);
        for (std::size_t f = 0; f < 4; ++f) {
            const double c = normal[f][2], rest = normal[f][0] * x + normal[f][1] * y + offset[f];
            if (c > 0) {
                low = std::max(low, -rest / c);
            } else if (c < 0) {
                high = std::min(high, -rest / c);
            } else if (rest < 0) {
                return {1, 0};
            }
        }
        return {low, high};
    }
};

/// Calls row(x, y, first z, last z) for the rows of a grid of n^3 points, `step` apart from `start` on, that a tet
/// holds a part of. Coordinates are relative to the tile.
template <class RowOf>
void ForRows(const TetPlanes& tet, int n, double start, double step, RowOf&& row) {
    const auto range = [&](std::size_t c) {
        const double low = (tet.box.low[c] - start) / step, high = (tet.box.high[c] - start) / step;
        return std::array<int, 2>{static_cast<int>(std::ceil(std::clamp(low - 1e-6, 0.0, n + 0.0))),
                                  static_cast<int>(std::floor(std::clamp(high + 1e-6, -1.0, n - 1.0)))};
    };
    const auto xs = range(0), ys = range(1);
    for (int x = xs[0]; x <= xs[1]; ++x) {
        for (int y = ys[0]; y <= ys[1]; ++y) {
            const auto z = tet.Row(start + step * x, start + step * y, start, start + step * (n - 1));
            if (!(z[0] <= z[1])) continue;  // planes of nearly flat tets are met at heights that no int holds
            const int first = static_cast<int>(std::ceil((z[0] - start) / step));
            const int last = static_cast<int>(std::floor((z[1] - start) / step));
            if (first <= last && last >= 0 && first < n) row(x, y, std::max(first, 0), std::min(last, n - 1));
        }
    }
}

/// Tets of a negative determinant. Where they meet others the solid is folded and may end where no boundary is.
std::vector<char> FindInverted(const VoxelSolid& solid) {
    std::vector<char> is_inverted(solid.tets.size() / 4);
    Sdc::ParallelFor(static_cast<Offset>(is_inverted.size()), 4096, [&](Offset begin, Offset end) {
        for (auto t = static_cast<std::size_t>(begin); t < static_cast<std::size_t>(end); ++t) {
            std::array<Vec, 4> v;
            for (std::size_t k = 0; k < 4; ++k) {
                const double* const p = &solid.points[3 * static_cast<std::size_t>(solid.tets[4 * t + k])];
                v[k] = {p[0], p[1], p[2]};
            }
            is_inverted[t] = Dot(Minus(v[1], v[0]), Cross(Minus(v[2], v[0]), Minus(v[3], v[0]))) < 0;
        }
    });
    return is_inverted;
}

}  // namespace

double Tiles::CountTiles(const VoxelSolid& solid, double reach) {
    const Box box = BoxOf(solid);
    double n = 1;
    for (std::size_t c = 0; c < 3; ++c) n *= std::floor((box.high[c] - box.low[c] + 2 * reach) / kTileSide) + 2;
    return n;
}

Tiles::Tiles(const VoxelSolid& solid, double reach, bool wants_others) : solid_(solid), reach_(reach) {
    const auto tiles = BoxOf(solid).TilesWithin(reach);
    low_ = tiles[0];
    for (std::size_t c = 0; c < 3; ++c) n_[c] = tiles[1][c] - tiles[0][c] + 1;
    triangles_ = FindNear<3>(solid.triangles, reach, true);
    const std::vector<char> is_inverted = FindInverted(solid);
    const auto n_inverted = static_cast<std::size_t>(std::count(is_inverted.begin(), is_inverted.end(), true));
    const bool is_folded = n_inverted > 0 && n_inverted < is_inverted.size();
    tets_ = FindNear<4>(solid.tets, 0.5, wants_others || is_folded);  // parts of voxels are asked for too
    const auto differ = [&](Index tile) {
        const auto tets = tets_[tile];
        return std::any_of(tets.begin(), tets.end(), [&](Index t) {
            return is_inverted[static_cast<std::size_t>(t)] != is_inverted[static_cast<std::size_t>(tets[0])];
        });
    };
    for (Index tile = 0; tile < CountAll(); ++tile) {
        if (!triangles_[tile].empty() || (is_folded && differ(tile))) {
            near_boundary_.push_back(tile);
        } else if (!tets_[tile].empty()) {
            others_.push_back(tile);
        }
    }
}

template <int kCorners>
Tiles::Near Tiles::FindNear(std::span<const Index> elements, double reach, bool wants_others) const {
    const auto visit = [&](auto&& add) {
        const auto n = static_cast<Index>(elements.size() / kCorners);
        for (Index i = 0; i < n; ++i) {
            Box box;
            for (int k = 0; k < kCorners; ++k) {
                box.Include(&solid_.points[3 * static_cast<std::size_t>(elements[kCorners * i + k])]);
            }
            const auto tiles = box.TilesWithin(reach);
            for (int x = tiles[0][0] - low_[0]; x <= tiles[1][0] - low_[0]; ++x) {
                for (int y = tiles[0][1] - low_[1]; y <= tiles[1][1] - low_[1]; ++y) {
                    for (int z = tiles[0][2] - low_[2]; z <= tiles[1][2] - low_[2]; ++z) {
                        const Index tile = (x * n_[1] + y) * n_[2] + z;
                        if (wants_others || !triangles_[tile].empty()) add(tile, i);
                    }
                }
            }
        }
    };
    Near near;
    near.offsets = Vtr::CountRows(CountAll(), visit);
    near.items.resize(static_cast<std::size_t>(near.offsets.back()));
    Vtr::FillRows(near.offsets, visit, [&](Offset place, Index item) { near.items[place] = item; });
    return near;
}

Place Tiles::Origin(Index tile) const {
    return {kTileSide * (low_[0] + tile / (n_[1] * n_[2])), kTileSide * (low_[1] + tile / n_[2] % n_[1]),
            kTileSide * (low_[2] + tile % n_[2])};
}

void Tiles::SquaredDistances(Index tile, std::span<float, kTileVoxels> squares) const {
    const Place origin = Origin(tile);
    const auto reach = static_cast<float>(reach_);
    std::fill(squares.begin(), squares.end(), std::numeric_limits<float>::max());
    for (Index t : triangles_[tile]) {
        std::array<Vec, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const double* const p = &solid_.points[3 * static_cast<std::size_t>(solid_.triangles[3 * t + k])];
            for (std::size_t c = 0; c < 3; ++c) corners[k][c] = p[c] - origin[c];
        }
        LowerDistances(corners, reach, squares);
    }
}

std::array<Vec, 4> Tiles::Tet(Index tet, const Place& origin) const {
    std::array<Vec, 4> v;
    for (std::size_t k = 0; k < 4; ++k) {
        const double* const p = &solid_.points[3 * static_cast<std::size_t>(solid_.tets[4 * tet + k])];
        for (std::size_t c = 0; c < 3; ++c) v[k][c] = p[c] - origin[c];
    }
    return v;
}

std::uint8_t SidesInside(const VoxelSet& inside) {
    constexpr int kMiddle = 4, kStride[3] = {64, 8, 1};
    unsigned sides = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const int middle = (64 + 8 + 1 - kStride[axis]) * kMiddle;
        for (int upper = 0; upper < 2; ++upper) {
            const bool is_inside = Holds(inside, middle + (upper ? (kTileSide - 1) * kStride[axis] : 0));
            sides |= static_cast<unsigned>(is_inside) << (2 * axis + upper);
        }
    }
    return static_cast<std::uint8_t>(sides);
}

std::vector<Index> Tiles::OthersInside(std::span<const std::uint8_t> beside) const {
    enum : char { kUnknown, kNear, kFound };
    std::vector<char> states(static_cast<std::size_t>(CountAll()), kUnknown);
    for (Index tile : near_boundary_) states[static_cast<std::size_t>(tile)] = kNear;
    const Index strides[3] = {n_[1] * n_[2], n_[2], 1};
    std::vector<Index> inside;
    const auto visit = [&](Index tile) {
        char& state = states[static_cast<std::size_t>(tile)];
        if (state == kUnknown) {
            state = kFound;
            inside.push_back(tile);
        }
    };
    const auto for_neighbours = [&](Index tile, auto&& use) {
        const Index places[3] = {tile / strides[0], tile / n_[2] % n_[1], tile % n_[2]};
        for (int axis = 0; axis < 3; ++axis) {
            if (places[axis] > 0) use(2 * axis, tile - strides[axis]);
            if (places[axis] + 1 < n_[static_cast<std::size_t>(axis)]) use(2 * axis + 1, tile + strides[axis]);
        }
    };
    for (std::size_t i = 0; i < near_boundary_.size(); ++i) {
        for_neighbours(near_boundary_[i], [&](int side, Index neighbour) {
            if (beside[i] >> side & 1) visit(neighbour);
        });
    }
    for (std::size_t i = 0; i < inside.size(); ++i) {
        for_neighbours(inside[i], [&](int, Index neighbour) { visit(neighbour); });
    }
    std::sort(inside.begin(), inside.end());
    return inside;
}

VoxelSet Tiles::Inside(Index tile) const {
    const Place origin = Origin(tile);
    VoxelSet inside{};
    for (Index t : tets_[tile]) {
        TetPlanes tet;
        if (!tet.Make(Tet(t, origin))) continue;
        ForRows(tet, kTileSide, 0, 1, [&](int x, int y, int first, int last) {
            inside[static_cast<std::size_t>(x)] |= ((std::uint64_t{2} << last) - (std::uint64_t{1} << first))
                                                   << (8 * y);
        });
    }
    return inside;
}

void Tiles::FindOwners(Index tile, std::span<Index, kTileVoxels> tets) const {
    const Place origin = Origin(tile);
    std::fill(tets.begin(), tets.end(), kNoIndex);
    for (Index t : tets_[tile]) {  // ascending
        TetPlanes tet;
        if (!tet.Make(Tet(t, origin))) continue;
        ForRows(tet, kTileSide, 0, 1, [&](int x, int y, int first, int last) {
            for (int z = first; z <= last; ++z) {
                Index& owner = tets[static_cast<std::size_t>(64 * x + 8 * y + z)];
                if (owner == kNoIndex) owner = t;
            }
        });
    }
}

void Tiles::CountInside(Index tile, int fineness, std::span<std::uint16_t, kTileVoxels> counts) const {
    const Place origin = Origin(tile);
    const int n = kTileSide * fineness;
    std::vector<bool> is_inside(static_cast<std::size_t>(n) * static_cast<std::size_t>(n) *
                                static_cast<std::size_t>(n));
    const double step = 1.0 / fineness, start = step / 2 - 0.5;
    for (Index t : tets_[tile]) {
        TetPlanes tet;
        if (!tet.Make(Tet(t, origin))) continue;
        ForRows(tet, n, start, step, [&](int x, int y, int first, int last) {
            const auto row = is_inside.begin() + (x * n + y) * n;
            std::fill(row + first, row + last + 1, true);
        });
    }
    std::fill(counts.begin(), counts.end(), std::uint16_t{0});
    std::size_t i = 0;
    for (int x = 0; x < n; ++x) {
        for (int y = 0; y < n; ++y) {
            for (int z = 0; z < n; ++z, ++i) {
                const auto voxel = static_cast<std::size_t>(64 * (x / fineness) + 8 * (y / fineness) + z / fineness);
                counts[voxel] = static_cast<std::uint16_t>(counts[voxel] + is_inside[i]);
            }
        }
    }
}

}  // namespace SolidSubdiv::Voxel::Internal

// SPDX-License-Identifier: Apache-2.0
// Tiles are found by boxes.
#include <solidsubdiv/apps/voxel/internal/tiles.h>

#include <algorithm>
#include <bit>
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

/// For each element the tiles with voxels within reach of its box.
template <class CornersOf>
std::vector<std::array<Place, 2>> FindBoxes(Index n, double reach, const std::vector<double>& points,
                                            CornersOf&& corners_of) {
    std::vector<std::array<Place, 2>> boxes(static_cast<std::size_t>(n));
    Sdc::ParallelFor(n, 4096, [&](Offset begin, Offset end) {
        for (Offset i = begin; i < end; ++i) {
            Box box;
            for (Index v : corners_of(static_cast<Index>(i))) box.Include(&points[3 * static_cast<std::size_t>(v)]);
            boxes[static_cast<std::size_t>(i)] = box.TilesWithin(reach);
        }
    });
    return boxes;
}

/// Which way round the tets of a piece are.
enum Side : char { kRight, kInverted, kBoth };

Side SideOf(const VoxelSolid& solid, Index piece) {
    bool has[2] = {false, false};
    const auto tets = solid.TetsOf(piece);
    for (std::size_t t = 0; t < tets.size(); t += 4) {
        std::array<Vec, 4> v;
        for (std::size_t k = 0; k < 4; ++k) {
            const double* const p = &solid.points[3 * static_cast<std::size_t>(tets[t + k])];
            v[k] = {p[0], p[1], p[2]};
        }
        has[Dot(Minus(v[1], v[0]), Cross(Minus(v[2], v[0]), Minus(v[3], v[0]))) < 0] = true;
    }
    return has[0] && has[1] ? kBoth : has[1] ? kInverted : kRight;
}

/// Where pieces of both sides meet the solid is folded and may end where no boundary is.
std::vector<Side> FindSides(const VoxelSolid& solid) {
    std::vector<Side> sides(static_cast<std::size_t>(solid.n_pieces()));
    Sdc::ParallelFor(solid.n_pieces(), 1024, [&](Offset begin, Offset end) {
        for (Offset i = begin; i < end; ++i) {
            sides[static_cast<std::size_t>(i)] = SideOf(solid, static_cast<Index>(i));
        }
    });
    return sides;
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
    triangles_ = FindNear(
        FindBoxes(
            static_cast<Index>(solid.triangles.size() / 3), reach, solid.points,
            [&](Index t) { return std::span<const Index, 3>(&solid.triangles[3 * static_cast<std::size_t>(t)], 3); }),
        true);
    const std::vector<Side> sides = FindSides(solid);
    const bool is_folded = std::any_of(sides.begin(), sides.end(), [&](Side s) { return s == kBoth || s != sides[0]; });
    // Parts of voxels are asked for too.
    pieces_ = FindNear(FindBoxes(solid.n_pieces(), 0.5, solid.points, [&](Index p) { return solid.TetsOf(p); }),
                       wants_others || is_folded);
    const auto differ = [&](Index tile) {
        const auto pieces = pieces_[tile];
        return std::any_of(pieces.begin(), pieces.end(), [&](Index p) {
            const Side side = sides[static_cast<std::size_t>(p)];
            return side == kBoth || side != sides[static_cast<std::size_t>(pieces[0])];
        });
    };
    for (Index tile = 0; tile < CountAll(); ++tile) {
        if (!triangles_[tile].empty() || (is_folded && differ(tile))) {
            near_boundary_.push_back(tile);
        } else if (!pieces_[tile].empty()) {
            others_.push_back(tile);
        }
    }
}

Tiles::Near Tiles::FindNear(std::span<const std::array<Place, 2>> boxes, bool wants_all) const {
    const auto visit = [&](auto&& add) {
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const auto& [first, last] = boxes[i];
            for (int x = first[0] - low_[0]; x <= last[0] - low_[0]; ++x) {
                for (int y = first[1] - low_[1]; y <= last[1] - low_[1]; ++y) {
                    for (int z = first[2] - low_[2]; z <= last[2] - low_[2]; ++z) {
                        const Index tile = (x * n_[1] + y) * n_[2] + z;
                        if (wants_all || !triangles_[tile].empty()) add(tile, static_cast<Index>(i));
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

template <class Use>
void Tiles::ForRows(Index tile, const PointGrid& grid, Use&& use) const {
    const Place origin = Origin(tile);
    std::vector<Row> rows(static_cast<std::size_t>(grid.n) * static_cast<std::size_t>(grid.n));
    for (Index piece : pieces_[tile]) {
        const auto tets = solid_.TetsOf(piece);
        for (std::size_t t = 0; t < tets.size(); t += 4) {
            Tet v;
            for (std::size_t k = 0; k < 4; ++k) {
                const double* const p = &solid_.points[3 * static_cast<std::size_t>(tets[t + k])];
                for (std::size_t c = 0; c < 3; ++c) v[k][c] = p[c] - origin[c];
            }
            for (const Row& row : std::span(rows).first(FindRows(v, grid, rows))) use(piece, row);
        }
    }
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

namespace {

/// Of a tile's voxels.
constexpr PointGrid kCentres{.n = kTileSide, .start = 0, .step = 1};

std::uint64_t BitsOf(const Row& row) { return (std::uint64_t{2} << row.last) - (std::uint64_t{1} << row.first); }
/// Among those of its slice.
std::uint64_t BitsInSlice(const Row& row) { return BitsOf(row) << (kTileSide * row.y); }

}  // namespace

VoxelSet Tiles::Inside(Index tile) const {
    VoxelSet inside{};
    ForRows(tile, kCentres,
            [&](Index, const Row& row) { inside[static_cast<std::size_t>(row.x)] |= BitsInSlice(row); });
    return inside;
}

std::vector<OwnedVoxels> Tiles::FindOwners(Index tile) const {
    std::vector<OwnedVoxels> owners;
    VoxelSet taken{};
    ForRows(tile, kCentres, [&](Index piece, const Row& row) {
        const auto x = static_cast<std::size_t>(row.x);
        const std::uint64_t mine = BitsInSlice(row) & ~taken[x];
        if (mine == 0) return;
        taken[x] |= mine;
        if (owners.empty() || owners.back().piece != piece) owners.push_back({piece, {}});
        owners.back().voxels[x] |= mine;
    });
    return owners;
}

void Tiles::CountInside(Index tile, int fineness, std::span<std::uint16_t, kTileVoxels> counts) const {
    const auto f = static_cast<std::size_t>(fineness), n = kTileSide * f;
    std::vector<std::uint64_t> lines(n * n);  // of points along z
    const double step = 1.0 / fineness;
    const PointGrid parts{.n = kTileSide * fineness, .start = step / 2 - 0.5, .step = step};
    ForRows(tile, parts, [&](Index, const Row& row) {
        lines[static_cast<std::size_t>(row.x) * n + static_cast<std::size_t>(row.y)] |= BitsOf(row);
    });
    std::fill(counts.begin(), counts.end(), std::uint16_t{0});
    for (std::size_t x = 0; x < n; ++x) {
        for (std::size_t y = 0; y < n; ++y) {
            std::uint64_t line = lines[x * n + y];
            for (std::size_t z = 0; line != 0; ++z, line >>= f) {
                std::uint16_t& count = counts[64 * (x / f) + 8 * (y / f) + z];
                count = static_cast<std::uint16_t>(count + std::popcount(line & ((std::uint64_t{1} << f) - 1)));
            }
        }
    }
}

}  // namespace SolidSubdiv::Voxel::Internal

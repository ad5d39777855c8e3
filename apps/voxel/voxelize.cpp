// SPDX-License-Identifier: Apache-2.0
// Tiles become leaves of OpenVDB's trees: made in parallel, put in one after another.
#include <solidsubdiv/apps/voxel/voxelize.h>

#include <solidsubdiv/apps/voxel/internal/attribute_grids.h>
#include <solidsubdiv/apps/voxel/internal/tiles.h>
#include <solidsubdiv/apps/voxel/internal/vdb.h>
#include <solidsubdiv/apps/voxel/internal/voxel_solid.h>
#include <solidsubdiv/sdc/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>
#include <string>

namespace SolidSubdiv::Voxel {

using namespace Internal;

namespace {

bool HasLevelSet(Kind kind) { return kind == Kind::LevelSet || kind == Kind::Both; }
bool HasFog(Kind kind) { return kind == Kind::Fog || kind == Kind::Both; }

using Leaf = openvdb::FloatTree::LeafNodeType;
static_assert(Leaf::DIM == kTileSide);

openvdb::Coord CoordOf(const Place& p) { return {p[0], p[1], p[2]}; }

openvdb::FloatGrid::Ptr MakeGrid(const char* name, float background, openvdb::GridClass kind, double voxel_size) {
    auto grid = openvdb::FloatGrid::create(background);
    grid->setName(name);
    grid->setGridClass(kind);
    grid->setTransform(openvdb::math::Transform::createLinearTransform(voxel_size));
    return grid;
}

/// Makes leaves of tiles, fill(i, tile, leaf) of each, and puts them into the tree.
template <class Fill>
void AddLeaves(std::span<const Index> tiles_near, const Tiles& tiles, openvdb::FloatTree& tree,
               const Progress& progress, Fill&& fill) {
    constexpr Offset kBatch = 1 << 14;  // 32 MB of leaves that are not in the tree yet
    std::vector<std::unique_ptr<Leaf>> leaves;
    const auto n = static_cast<Offset>(tiles_near.size());
    for (Offset first = 0; first < n; first += kBatch) {
        Report(progress, "voxelize", static_cast<double>(first) / static_cast<double>(n));
        const Offset n_now = std::min(kBatch, n - first);
        leaves.clear();
        leaves.resize(static_cast<std::size_t>(n_now));
        Sdc::ParallelFor(n_now, 4, [&](Offset begin, Offset end) {
            for (Offset i = begin; i < end; ++i) {
                const Index tile = tiles_near[static_cast<std::size_t>(first + i)];
                auto leaf = std::make_unique<Leaf>(CoordOf(tiles.Origin(tile)), tree.background());
                leaf->allocate();
                if (fill(static_cast<std::size_t>(first + i), tile, *leaf))
                    leaves[static_cast<std::size_t>(i)] = std::move(leaf);
            }
        });
        for (auto& leaf : leaves) {
            if (leaf) tree.addLeaf(leaf.release());
        }
    }
}

/// Puts what is inside and away from the boundary into the tree.
void AddTilesInside(const Tiles& tiles, std::span<const std::uint8_t> beside, float value, bool is_active,
                    openvdb::FloatTree& tree) {
    for (Index tile : tiles.OthersInside(beside)) tree.addTile(1, CoordOf(tiles.Origin(tile)), value, is_active);
    tree.prune();
}

openvdb::FloatGrid::Ptr MakeLevelSet(const Tiles& tiles, const VoxelizeOptions& options) {
    const auto background = static_cast<float>(options.half_width * options.voxel_size);
    const auto size = static_cast<float>(options.voxel_size);
    auto grid = MakeGrid("surface", background, openvdb::GRID_LEVEL_SET, options.voxel_size);
    const auto reach_squared = static_cast<float>(options.half_width * options.half_width);
    std::vector<std::uint8_t> beside(tiles.near_boundary().size());
    AddLeaves(tiles.near_boundary(), tiles, grid->tree(), options.progress, [&](std::size_t i, Index tile, Leaf& leaf) {
        std::array<float, kTileVoxels> squares;
        tiles.SquaredDistances(tile, squares);
        const VoxelSet inside = tiles.Inside(tile);
        beside[i] = SidesInside(inside);
        bool differs = false;
        for (int v = 0; v < kTileVoxels; ++v) {
            const float square = squares[static_cast<std::size_t>(v)];
            const bool is_near = square < reach_squared, is_inside = Holds(inside, v);
            const float distance = is_near ? std::sqrt(square) * size : background;
            leaf.setValueOnly(static_cast<openvdb::Index>(v), is_inside ? -distance : distance);
            leaf.setActiveState(static_cast<openvdb::Index>(v), is_near);
            differs = differs || is_near || is_inside;
        }
        return differs;
    });
    AddTilesInside(tiles, beside, -background, false, grid->tree());
    return grid;
}

openvdb::FloatGrid::Ptr MakeFog(const Tiles& tiles, const VoxelizeOptions& options) {
    constexpr int kFineness = 4;
    auto grid = MakeGrid("density", 0, openvdb::GRID_FOG_VOLUME, options.voxel_size);
    std::vector<std::uint8_t> beside(tiles.near_boundary().size());
    AddLeaves(tiles.near_boundary(), tiles, grid->tree(), options.progress, [&](std::size_t i, Index tile, Leaf& leaf) {
        beside[i] = SidesInside(tiles.Inside(tile));
        std::array<std::uint16_t, kTileVoxels> counts;
        tiles.CountInside(tile, kFineness, counts);
        bool is_filled = false;
        for (int v = 0; v < kTileVoxels; ++v) {
            const int count = counts[static_cast<std::size_t>(v)];
            leaf.setValueOnly(static_cast<openvdb::Index>(v),
                              static_cast<float>(count) / (kFineness * kFineness * kFineness));
            leaf.setActiveState(static_cast<openvdb::Index>(v), count > 0);
            is_filled = is_filled || count > 0;
        }
        return is_filled;
    });
    AddTilesInside(tiles, beside, 1, true, grid->tree());
    return grid;
}

/// About how many bytes the tiles and the grids will take.
double EstimateBytes(const VoxelSolid& solid, const VoxelizeOptions& options) {
    const auto point = [&](Index v) {
        const double* p = &solid.points[3 * static_cast<std::size_t>(v)];
        return openvdb::Vec3d(p[0], p[1], p[2]);
    };
    double volume = 0, area = 0;  // in voxels
    const openvdb::Vec3d origin = point(solid.triangles.empty() ? 0 : solid.triangles[0]);
    for (std::size_t t = 0; t < solid.triangles.size(); t += 3) {
        const openvdb::Vec3d a = point(solid.triangles[t]) - origin;
        const openvdb::Vec3d n =
            (point(solid.triangles[t + 1]) - origin - a).cross(point(solid.triangles[t + 2]) - origin - a);
        area += n.length() / 2;
        volume += n.dot(a) / 6;
    }
    // Whole tiles: beside what is within reach of the boundary half a tile on either side.
    const auto near = [&](double reach) { return area * (2 * reach + kTileSide); };
    double numbers = HasLevelSet(options.kind) ? near(options.half_width) : 0;
    if (HasFog(options.kind)) numbers += near(1);
    int width = options.jacobian + options.cell_id + options.level_id;
    for (const Attribute& a : options.attributes) width += a.width;
    numbers += width * (std::abs(volume) + area * kTileSide / 2);
    return 8 * Tiles::CountTiles(solid, options.half_width) + sizeof(float) * numbers;
}

/// Refuses, before any work, boxes of more voxels than coordinates or memory hold.
void RequireRoom(const VoxelSolid& solid, const VoxelizeOptions& options) {
    std::array<double, 3> n{};
    double voxels = 1, largest = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (std::size_t i = c; i < solid.points.size(); i += 3) {
            low = std::min(low, solid.points[i]);
            high = std::max(high, solid.points[i]);
        }
        n[c] = std::ceil(high - low) + 1;
        voxels *= n[c];
        largest = std::max({largest, std::abs(low), std::abs(high)});
    }
    const double bytes = EstimateBytes(solid, options);
    const bool fits = largest < 1e9 && bytes < static_cast<double>(options.max_bytes) &&
                      Tiles::CountTiles(solid, options.half_width) < std::numeric_limits<Index>::max();
    if (fits) return;
    char text[250];
    std::snprintf(text, sizeof text,
                  "voxels of size %g make a box of %.4g x %.4g x %.4g = %.4g of them, too many "
                  "(about %.3g GB); choose larger ones",
                  options.voxel_size, n[0], n[1], n[2], voxels, 1e-9 * bytes);
    throw InvalidInput(text);
}

}  // namespace

Kind KindOf(std::string_view name) {
    if (name == "level-set") return Kind::LevelSet;
    if (name == "fog") return Kind::Fog;
    if (name == "both") return Kind::Both;
    if (name == "none") return Kind::None;
    throw InvalidInput("there is no kind '" + std::string(name) + "' of grids; there are level-set, fog, both, none");
}

void VoxelizeOptions::Validate() const {
    if (!(voxel_size > 0) || !std::isfinite(voxel_size)) {
        char text[100];
        std::snprintf(text, sizeof text, "voxel_size is %g; it must be above 0, and finite", voxel_size);
        throw InvalidInput(text);
    }
    if (!(half_width >= 1 && half_width <= 100)) {
        throw InvalidInput("half_width is " + std::to_string(half_width) + "; it must be 1 to 100 voxels");
    }
    std::set<std::string> names;
    if (HasLevelSet(kind)) names.insert("surface");
    if (HasFog(kind)) names.insert("density");
    if (jacobian) names.insert("jacobian");
    if (cell_id) names.insert("cell_id");
    if (level_id) names.insert("level");
    for (const Attribute& a : attributes) {
        if (a.name.empty()) throw InvalidInput("an attribute has no name");
        if (!names.insert(a.name).second) throw InvalidInput("a second grid would have the name '" + a.name + "'");
    }
    if (names.empty()) throw InvalidInput("kind is none and no attribute is asked for; there would be no grid");
}

Grids Voxelize(const Far::TopologyRefiner& refiner, int level, std::span<const double> positions,
               const VoxelizeOptions& options) {
    options.Validate();
    for (const Attribute& a : options.attributes) {
        if (level < 0 || level > refiner.max_level()) break;  // told below
        const auto n = static_cast<std::size_t>(refiner.n_vertices(level)) * static_cast<std::size_t>(a.width);
        if ((a.width != 1 && a.width != 3) || a.values.size() != n) {
            throw InvalidInput("attribute '" + a.name + "' has " + std::to_string(a.values.size()) + " numbers, " +
                               std::to_string(a.width) + " a vertex; it must have 1 or 3 for each of the " +
                               std::to_string(refiner.n_vertices(level)) + " vertices");
        }
    }
    InitializeVdb();
    const VoxelSolid solid = MakeVoxelSolid(refiner, level, positions, options.voxel_size);
    RequireRoom(solid, options);
    Grids result;
    openvdb::GridPtrVec& grids = result.state().grids;
    const bool wants_inside = !options.attributes.empty() || options.jacobian || options.cell_id || options.level_id;
    const auto add_inside = [&](const Tiles& tiles) {
        for (auto& grid : MakeAttributeGrids(tiles, refiner, level, options)) grids.push_back(std::move(grid));
    };
    if (HasLevelSet(options.kind)) {
        const bool is_last = options.kind == Kind::LevelSet;
        const Tiles tiles(solid, options.half_width, wants_inside && is_last);
        grids.push_back(MakeLevelSet(tiles, options));
        if (wants_inside && is_last) add_inside(tiles);
        if (is_last) return result;
    }
    const Tiles tiles(solid, 1, wants_inside);  // parts of voxels are less than 0.87 from its centre
    if (HasFog(options.kind)) grids.push_back(MakeFog(tiles, options));
    if (wants_inside) add_inside(tiles);
    return result;
}

}  // namespace SolidSubdiv::Voxel

// SPDX-License-Identifier: Apache-2.0
// The piece of each voxel is found once and gives all values there.
#include <solidsubdiv/apps/voxel/internal/attribute_grids.h>

#include <solidsubdiv/apps/voxel/internal/piece_maps.h>
#include <solidsubdiv/sdc/parallel.h>

#include <algorithm>
#include <memory>

namespace SolidSubdiv::Voxel::Internal {

namespace {

/// A grid that is made of leaves, a batch at a time.
class Sink {
  public:
    virtual ~Sink() = default;
    virtual void Begin(std::size_t n_tiles) = 0;
    virtual void Start(std::size_t i, const Place& origin, const VoxelSet& active) = 0;
    /// Values in a piece, for tile i of the batch.
    virtual void Put(std::size_t i, const PlacesInPiece& places) = 0;
    virtual void End() = 0;  ///< puts the batch into the grid
    virtual openvdb::GridBase::Ptr grid() = 0;
};

/// fill(places, values) writes the values at places.voxels.
template <class Grid, class Fill>
class GridSink : public Sink {
  public:
    using Leaf = typename Grid::TreeType::LeafNodeType;
    static_assert(Leaf::DIM == kTileSide);

    GridSink(const std::string& name, const typename Grid::ValueType& background, double voxel_size, Fill fill)
        : grid_(Grid::create(background)), fill_(fill) {
        grid_->setName(name);
        grid_->setTransform(openvdb::math::Transform::createLinearTransform(voxel_size));
    }
    void Begin(std::size_t n_tiles) override {
        leaves_.clear();
        leaves_.resize(n_tiles);
    }
    void Start(std::size_t i, const Place& origin, const VoxelSet& active) override {
        leaves_[i] = std::make_unique<Leaf>(openvdb::Coord(origin[0], origin[1], origin[2]), grid_->background());
        leaves_[i]->allocate();
        openvdb::util::NodeMask<3> mask;
        for (openvdb::Index x = 0; x < kTileSide; ++x) mask.getWord<std::uint64_t>(x) = active[x];
        leaves_[i]->setValueMask(mask);
    }
    void Put(std::size_t i, const PlacesInPiece& places) override { fill_(places, leaves_[i]->buffer().data()); }
    void End() override {
        for (auto& leaf : leaves_) {
            if (leaf) grid_->tree().addLeaf(leaf.release());
        }
    }
    openvdb::GridBase::Ptr grid() override { return grid_; }

  private:
    typename Grid::Ptr grid_;
    Fill fill_;
    std::vector<std::unique_ptr<Leaf>> leaves_;
};

template <class Grid, class Fill>
std::unique_ptr<Sink> MakeSink(const std::string& name, const typename Grid::ValueType& background, double voxel_size,
                               Fill fill) {
    return std::make_unique<GridSink<Grid, Fill>>(name, background, voxel_size, fill);
}

/// Calls put(voxel, number) with a component of an attribute.
template <class Put>
void ForComponent(const PlacesInPiece& places, const Attribute& a, std::size_t component, Put&& put) {
    const auto width = static_cast<std::size_t>(a.width);
    std::array<float, kTileVoxels> values;
    const std::size_t n = places.voxels.size();
    places.Evaluate(places.Between([&](Index v) { return a.values[static_cast<std::size_t>(v) * width + component]; }),
                    std::span(values).first(n));
    for (std::size_t i = 0; i < n; ++i) put(places.voxels[i], values[i]);
}

template <class Value, class ValueOf>
void PutEach(const PlacesInPiece& places, Value* out, ValueOf&& value_of) {
    for (std::size_t i = 0; i < places.voxels.size(); ++i) out[places.voxels[i]] = value_of(i);
}

std::vector<std::unique_ptr<Sink>> MakeSinks(int level, const VoxelizeOptions& o) {
    using openvdb::FloatGrid, openvdb::Vec3SGrid, openvdb::Int32Grid, openvdb::Vec3s;
    std::vector<std::unique_ptr<Sink>> sinks;
    for (const Attribute& a : o.attributes) {
        if (a.width == 1) {
            sinks.push_back(MakeSink<FloatGrid>(a.name, 0.0f, o.voxel_size, [&a](const PlacesInPiece& at, float* out) {
                ForComponent(at, a, 0, [&](int voxel, float x) { out[voxel] = x; });
            }));
        } else {
            sinks.push_back(
                MakeSink<Vec3SGrid>(a.name, Vec3s(0, 0, 0), o.voxel_size, [&a](const PlacesInPiece& at, Vec3s* out) {
                    for (int c = 0; c < 3; ++c) {
                        ForComponent(at, a, static_cast<std::size_t>(c),
                                     [&](int voxel, float x) { out[voxel][c] = x; });
                    }
                }));
        }
    }
    if (o.jacobian) {
        const double cube = o.voxel_size * o.voxel_size * o.voxel_size;
        sinks.push_back(
            MakeSink<FloatGrid>("jacobian", 0.0f, o.voxel_size, [cube](const PlacesInPiece& at, float* out) {
                PutEach(at, out, [&](std::size_t i) { return static_cast<float>(at.jacobian[i] * cube); });
            }));
    }
    if (o.cell_id) {
        sinks.push_back(
            MakeSink<Int32Grid>("cell_id", -1, o.voxel_size, [](const PlacesInPiece& at, std::int32_t* out) {
                PutEach(at, out, [&](std::size_t) { return at.cell; });
            }));
    }
    if (o.level_id) {
        sinks.push_back(
            MakeSink<Int32Grid>("level", -1, o.voxel_size, [level](const PlacesInPiece& at, std::int32_t* out) {
                PutEach(at, out, [&](std::size_t) { return level; });
            }));
    }
    return sinks;
}

}  // namespace

openvdb::GridPtrVec MakeAttributeGrids(const Tiles& tiles, const Far::TopologyRefiner& refiner, int level,
                                       const VoxelizeOptions& options) {
    const PieceMaps maps(refiner, level, tiles.solid());
    std::vector<Index> all(tiles.near_boundary().begin(), tiles.near_boundary().end());
    all.insert(all.end(), tiles.others().begin(), tiles.others().end());
    const auto sinks = MakeSinks(level, options);
    constexpr std::size_t kBatch = 1 << 13;
    for (std::size_t first = 0; first < all.size(); first += kBatch) {
        Report(options.progress, "attributes", static_cast<double>(first) / static_cast<double>(all.size()));
        const std::size_t n_now = std::min(kBatch, all.size() - first);
        for (const auto& sink : sinks) sink->Begin(n_now);
        Sdc::ParallelFor(static_cast<Offset>(n_now), 4, [&](Offset begin, Offset end) {
            PlacesInPiece places;
            for (Offset i = begin; i < end; ++i) {
                const auto place = static_cast<std::size_t>(i);
                const Index tile = all[first + place];
                const std::vector<OwnedVoxels> owners = tiles.FindOwners(tile);
                if (owners.empty()) continue;
                VoxelSet active{};
                for (const OwnedVoxels& owned : owners) {
                    for (std::size_t x = 0; x < active.size(); ++x) active[x] |= owned.voxels[x];
                }
                const Place origin = tiles.Origin(tile);
                for (const auto& sink : sinks) sink->Start(place, origin, active);
                for (const OwnedVoxels& owned : owners) {
                    maps.Locate(owned, origin, places);
                    for (const auto& sink : sinks) sink->Put(place, places);
                }
            }
        });
        for (const auto& sink : sinks) sink->End();
    }
    openvdb::GridPtrVec grids;
    for (const auto& sink : sinks) grids.push_back(sink->grid());
    return grids;
}

}  // namespace SolidSubdiv::Voxel::Internal

// SPDX-License-Identifier: Apache-2.0
// The cell of each voxel is found once and gives all values there.
#include <solidsubdiv/apps/voxel/internal/attribute_grids.h>

#include <solidsubdiv/apps/voxel/internal/voxel_solid.h>
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
    virtual void Start(std::size_t i, const Place& origin) = 0;
    /// The value of a voxel of tile i of the batch.
    virtual void Put(std::size_t i, int voxel, const CellWeights& at) = 0;
    virtual void End() = 0;  ///< puts the batch into the grid
    virtual openvdb::GridBase::Ptr grid() = 0;
};

template <class Grid, class ValueOf>
class GridSink : public Sink {
  public:
    using Leaf = typename Grid::TreeType::LeafNodeType;

    GridSink(const std::string& name, const typename Grid::ValueType& background, double voxel_size, ValueOf value_of)
        : grid_(Grid::create(background)), value_of_(value_of) {
        grid_->setName(name);
        grid_->setTransform(openvdb::math::Transform::createLinearTransform(voxel_size));
    }
    void Begin(std::size_t n_tiles) override {
        leaves_.clear();
        leaves_.resize(n_tiles);
    }
    void Start(std::size_t i, const Place& origin) override {
        leaves_[i] = std::make_unique<Leaf>(openvdb::Coord(origin[0], origin[1], origin[2]), grid_->background());
        leaves_[i]->allocate();
    }
    void Put(std::size_t i, int voxel, const CellWeights& at) override {
        leaves_[i]->setValueOn(static_cast<openvdb::Index>(voxel), value_of_(at));
    }
    void End() override {
        for (auto& leaf : leaves_) {
            if (leaf) grid_->tree().addLeaf(leaf.release());
        }
    }
    openvdb::GridBase::Ptr grid() override { return grid_; }

  private:
    typename Grid::Ptr grid_;
    ValueOf value_of_;
    std::vector<std::unique_ptr<Leaf>> leaves_;
};

template <class Grid, class ValueOf>
std::unique_ptr<Sink> MakeSink(const std::string& name, const typename Grid::ValueType& background, double voxel_size,
                               ValueOf value_of) {
    return std::make_unique<GridSink<Grid, ValueOf>>(name, background, voxel_size, value_of);
}

double SumOf(const CellWeights& at, const Attribute& a, int component) {
    double sum = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(at.n); ++k) {
        const auto row = static_cast<std::size_t>(at.vertices[k]) * static_cast<std::size_t>(a.width);
        sum += at.weights[k] * a.values[row + static_cast<std::size_t>(component)];
    }
    return sum;
}

std::vector<std::unique_ptr<Sink>> MakeSinks(int level, const VoxelizeOptions& o) {
    std::vector<std::unique_ptr<Sink>> sinks;
    for (const Attribute& a : o.attributes) {
        if (a.width == 1) {
            sinks.push_back(MakeSink<openvdb::FloatGrid>(a.name, 0.0f, o.voxel_size, [&a](const CellWeights& at) {
                return static_cast<float>(SumOf(at, a, 0));
            }));
        } else {
            sinks.push_back(MakeSink<openvdb::Vec3SGrid>(
                a.name, openvdb::Vec3s(0, 0, 0), o.voxel_size, [&a](const CellWeights& at) {
                    return openvdb::Vec3s(static_cast<float>(SumOf(at, a, 0)), static_cast<float>(SumOf(at, a, 1)),
                                          static_cast<float>(SumOf(at, a, 2)));
                }));
        }
    }
    if (o.jacobian) {
        const double cube = o.voxel_size * o.voxel_size * o.voxel_size;
        sinks.push_back(MakeSink<openvdb::FloatGrid>("jacobian", 0.0f, o.voxel_size, [cube](const CellWeights& at) {
            return static_cast<float>(at.jacobian * cube);
        }));
    }
    if (o.cell_id) {
        sinks.push_back(
            MakeSink<openvdb::Int32Grid>("cell_id", -1, o.voxel_size, [](const CellWeights& at) { return at.cell; }));
    }
    if (o.level_id) {
        sinks.push_back(
            MakeSink<openvdb::Int32Grid>("level", -1, o.voxel_size, [level](const CellWeights&) { return level; }));
    }
    return sinks;
}

}  // namespace

openvdb::GridPtrVec MakeAttributeGrids(const Tiles& tiles, const Far::TopologyRefiner& refiner, int level,
                                       const VoxelizeOptions& options) {
    const TetCells cells(refiner, level, tiles.solid());
    std::vector<Index> all(tiles.near_boundary().begin(), tiles.near_boundary().end());
    all.insert(all.end(), tiles.others().begin(), tiles.others().end());
    const auto sinks = MakeSinks(level, options);
    constexpr std::size_t kBatch = 1 << 13;
    for (std::size_t first = 0; first < all.size(); first += kBatch) {
        Report(options.progress, "attributes", static_cast<double>(first) / static_cast<double>(all.size()));
        const std::size_t n_now = std::min(kBatch, all.size() - first);
        for (const auto& sink : sinks) sink->Begin(n_now);
        Sdc::ParallelFor(static_cast<Offset>(n_now), 4, [&](Offset begin, Offset end) {
            for (Offset i = begin; i < end; ++i) {
                const auto place = static_cast<std::size_t>(i);
                const Index tile = all[first + place];
                std::array<Index, kTileVoxels> owners;
                tiles.FindOwners(tile, owners);
                if (std::all_of(owners.begin(), owners.end(), [](Index t) { return t == kNoIndex; })) continue;
                const Place origin = tiles.Origin(tile);
                HexMap hex;  // of this tile alone: the same bits whatever tiles a thread has
                for (const auto& sink : sinks) sink->Start(place, origin);
                for (int v = 0; v < kTileVoxels; ++v) {
                    const Index tet = owners[static_cast<std::size_t>(v)];
                    if (tet == kNoIndex) continue;
                    const CellWeights at = cells.At(
                        tet, {origin[0] + v / 64 + 0.0, origin[1] + v / 8 % 8 + 0.0, origin[2] + v % 8 + 0.0}, hex);
                    for (const auto& sink : sinks) sink->Put(place, v, at);
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

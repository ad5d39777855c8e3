// SPDX-License-Identifier: Apache-2.0
// Grids in files, and what is in them.
#include <solidsubdiv/apps/voxel/grids.h>

#include <solidsubdiv/apps/voxel/internal/vdb.h>
#include <solidsubdiv/apps/voxel/internal/vdb_file.h>
#include <solidsubdiv/sdc/errors.h>

#include <openvdb/io/Stream.h>
#include <openvdb/tools/Count.h>
#include <openvdb/tools/VolumeToMesh.h>

#include <fstream>
#include <memory>
#include <mutex>
#include <optional>
#include <type_traits>

namespace SolidSubdiv::Voxel {

namespace Internal {

void InitializeVdb() {
    static std::once_flag once;
    std::call_once(once, [] { openvdb::initialize(); });
}

}  // namespace Internal

namespace {

template <class Grid>
void Measure(const Grid& grid, GridInfo& info) {
    info.background = static_cast<double>(grid.background());
    const auto range = openvdb::tools::minMax(grid.tree());
    info.least = static_cast<double>(range.min());
    info.greatest = static_cast<double>(range.max());
}

/// Calls use(grid) with the grid of that name and a type of numbers. @throws InvalidInput
template <class... Types, class Use>
auto WithGrid(const openvdb::GridPtrVec& grids, const std::string& name, const char* kind, Use&& use) {
    using Result = std::common_type_t<decltype(use(std::declval<const Types&>()))...>;
    const auto grid = openvdb::findGridByName(grids, name);
    if (!grid) throw InvalidInput("there is no grid '" + name + "'");
    std::optional<Result> result;
    const auto try_type = [&](auto* type) {
        using Type = std::remove_pointer_t<decltype(type)>;
        if (!result && grid->isType<Type>()) result = use(static_cast<const Type&>(*grid));
    };
    (try_type(static_cast<Types*>(nullptr)), ...);
    if (!result) throw InvalidInput("grid '" + name + "' is one of " + grid->valueType() + ", not of " + kind);
    return *result;
}

/// The same of numbers or vectors.
template <class Use>
auto WithAnyGrid(const openvdb::GridPtrVec& grids, const std::string& name, Use&& use) {
    return WithGrid<openvdb::FloatGrid, openvdb::DoubleGrid, openvdb::Int32Grid, openvdb::Vec3SGrid,
                    openvdb::Vec3DGrid>(grids, name, "numbers or vectors", use);
}

template <class Grid>
GridSurface SurfaceOf(const Grid& grid, double value) {
    std::vector<openvdb::Vec3s> points;
    std::vector<openvdb::Vec3I> triangles;
    std::vector<openvdb::Vec4I> quads;
    openvdb::tools::volumeToMesh(grid, points, triangles, quads, value);
    GridSurface surface;
    for (const openvdb::Vec3s& p : points) surface.positions.insert(surface.positions.end(), {p[0], p[1], p[2]});
    // OpenVDB lists corners clockwise as seen from outside.
    const auto add = [](const auto& face, int n, std::vector<Index>& faces) {
        for (int i = n - 1; i >= 0; --i) faces.push_back(static_cast<Index>(face[i]));
    };
    for (const openvdb::Vec3I& face : triangles) add(face, 3, surface.triangles);
    for (const openvdb::Vec4I& face : quads) add(face, 4, surface.quads);
    return surface;
}

/// Calls visit(voxel) for a box of voxels, z fastest. @throws InvalidInput where it is empty or too large
template <class Visit>
void ForBox(const std::array<int, 3>& low, const std::array<int, 3>& high, Visit&& visit) {
    double n = 1;
    for (std::size_t c = 0; c < 3; ++c) n *= std::max(0.0, static_cast<double>(high[c]) - low[c] + 1);
    if (!(n >= 1 && n < 2147483648.0)) {
        throw InvalidInput("a box of " + std::to_string(n) + " voxels is asked for; it must hold 1 to 2^31");
    }
    for (int x = low[0]; x <= high[0]; ++x) {
        for (int y = low[1]; y <= high[1]; ++y) {
            for (int z = low[2]; z <= high[2]; ++z) visit(openvdb::Coord(x, y, z));
        }
    }
}

}  // namespace

Grids::Grids() : state_(std::make_unique<State>()) {}
Grids::~Grids() = default;
Grids::Grids(Grids&&) noexcept = default;
Grids& Grids::operator=(Grids&&) noexcept = default;

Grids Grids::Read(const std::filesystem::path& path) {
    Internal::InitializeVdb();
    Grids grids;
    try {
        // Not by io::File: it takes what lies beyond the end of a file for zeros.
        std::ifstream file(path, std::ios::binary);
        if (!file) throw IoError("there is no such file, or no right to read it");
        file.exceptions(std::ios::failbit | std::ios::badbit);
        Internal::CheckVdbFile(file);
        openvdb::io::Stream stream(file, false);
        grids.state_->grids = *stream.getGrids();
    } catch (const std::ios::failure&) {
        throw IoError(path.string() + ": can't be read as OpenVDB: it ends too early");
    } catch (const std::exception& error) {
        throw IoError(path.string() + ": can't be read as OpenVDB: " + error.what());
    }
    return grids;
}

void Grids::SetMetadata(const std::string& name, const std::string& value) {
    for (const auto& grid : state_->grids) {
        grid->removeMeta(name);
        grid->insertMeta(name, openvdb::StringMetadata(value));
    }
}

std::vector<GridInfo> Grids::Describe() const {
    std::vector<GridInfo> infos;
    for (const auto& grid : state_->grids) {
        GridInfo info;
        info.name = grid->getName();
        info.type = grid->valueType();
        info.grid_class = openvdb::GridBase::gridClassToString(grid->getGridClass());
        info.active_voxels = static_cast<Offset>(grid->activeVoxelCount());
        const openvdb::CoordBBox box = grid->evalActiveVoxelBoundingBox();
        const openvdb::Vec3d size = grid->voxelSize(), origin = grid->indexToWorld(openvdb::Vec3d(0, 0, 0));
        for (int c = 0; c < 3; ++c) {
            info.low[static_cast<std::size_t>(c)] = box.empty() ? 0 : box.min()[c];
            info.high[static_cast<std::size_t>(c)] = box.empty() ? -1 : box.max()[c];
            info.voxel_size[static_cast<std::size_t>(c)] = size[c];
            info.origin[static_cast<std::size_t>(c)] = origin[c];
        }
        if (const auto g = openvdb::gridConstPtrCast<openvdb::FloatGrid>(grid)) Measure(*g, info);
        if (const auto g = openvdb::gridConstPtrCast<openvdb::DoubleGrid>(grid)) Measure(*g, info);
        if (const auto g = openvdb::gridConstPtrCast<openvdb::Int32Grid>(grid)) Measure(*g, info);
        info.bytes = static_cast<Offset>(grid->memUsage());
        for (auto it = grid->beginMeta(); it != grid->endMeta(); ++it) {
            info.metadata.emplace_back(it->first, it->second->str());
        }
        infos.push_back(std::move(info));
    }
    return infos;
}

std::vector<double> Grids::Values(const std::string& name, const std::array<int, 3>& low,
                                  const std::array<int, 3>& high) const {
    return WithGrid<openvdb::FloatGrid, openvdb::DoubleGrid, openvdb::Int32Grid>(
        state_->grids, name, "numbers", [&](const auto& grid) {
            std::vector<double> values;
            const auto accessor = grid.getConstAccessor();
            ForBox(low, high,
                   [&](const openvdb::Coord& v) { values.push_back(static_cast<double>(accessor.getValue(v))); });
            return values;
        });
}

std::vector<double> Grids::Vectors(const std::string& name, const std::array<int, 3>& low,
                                   const std::array<int, 3>& high) const {
    return WithGrid<openvdb::Vec3SGrid, openvdb::Vec3DGrid>(state_->grids, name, "vectors", [&](const auto& grid) {
        std::vector<double> values;
        const auto accessor = grid.getConstAccessor();
        ForBox(low, high, [&](const openvdb::Coord& v) {
            const auto value = accessor.getValue(v);
            for (int c = 0; c < 3; ++c) values.push_back(static_cast<double>(value[c]));
        });
        return values;
    });
}

std::vector<bool> Grids::IsActive(const std::string& name, const std::array<int, 3>& low,
                                  const std::array<int, 3>& high) const {
    return WithAnyGrid(state_->grids, name, [&](const auto& grid) {
        std::vector<bool> active;
        const auto accessor = grid.getConstAccessor();
        ForBox(low, high, [&](const openvdb::Coord& v) { active.push_back(accessor.isValueOn(v)); });
        return active;
    });
}

std::array<double, 3> Grids::ToWorld(const std::string& name, const std::array<int, 3>& voxel) const {
    return WithAnyGrid(state_->grids, name, [&](const auto& grid) {
        const openvdb::Vec3d p = grid.indexToWorld(openvdb::Coord(voxel[0], voxel[1], voxel[2]));
        return std::array{p[0], p[1], p[2]};
    });
}

GridSurface Grids::Surface(const std::string& name, double value) const {
    return WithGrid<openvdb::FloatGrid, openvdb::DoubleGrid>(state_->grids, name, "numbers",
                                                             [&](const auto& grid) { return SurfaceOf(grid, value); });
}

GridSurface Grids::ActiveSurface(const std::string& name) const {
    return WithAnyGrid(state_->grids, name, [](const auto& grid) {
        // 1 where active, 0 elsewhere.
        const auto tree = std::make_shared<openvdb::FloatTree>(grid.tree(), 0.0f, 1.0f, openvdb::TopologyCopy());
        const auto mask = openvdb::FloatGrid::create(tree);
        mask->setTransform(grid.transform().copy());
        return SurfaceOf(*mask, 0.5);
    });
}

void Grids::Write(const std::filesystem::path& path, bool half_float) const {
    std::filesystem::path beside = path;
    beside += ".part";
    std::error_code error;
    try {
        openvdb::io::File file(beside.string());
        file.setCompression(openvdb::io::COMPRESS_ZIP | openvdb::io::COMPRESS_ACTIVE_MASK);
        for (const auto& grid : state_->grids) grid->setSaveFloatAsHalf(half_float);
        file.write(state_->grids);
        file.close();
        std::filesystem::rename(beside, path);
    } catch (const std::exception& problem) {
        std::filesystem::remove(beside, error);
        throw IoError(path.string() + ": can't be written: " + problem.what());
    }
}

}  // namespace SolidSubdiv::Voxel

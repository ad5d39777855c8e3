// SPDX-License-Identifier: Apache-2.0
// Named grids of voxels, as they are in .vdb files: sparse, each with a background value and a voxel size.
//
//     Voxel::Grids grids = Voxel::Voxelize(...);          // voxelize.h
//     grids.Write("part.vdb");
//     const Voxel::Grids again = Voxel::Grids::Read("part.vdb");
//
// OpenVDB's own grids stand behind; an application that wants them reads the file.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Voxel {

/// What is in a grid, for people and programs.
struct GridInfo {
    std::string name;
    std::string type;        ///< OpenVDB's: "float", "vec3s", "int32", ...
    std::string grid_class;  ///< "level set", "fog volume", "unknown"
    Offset active_voxels = 0;
    std::array<int, 3> low{}, high{};  ///< the box of active voxels; low > high where there are none
    std::array<double, 3> voxel_size{};
    std::array<double, 3> origin{};  ///< of voxel (0, 0, 0)'s centre
    double background = 0;           ///< of one number
    double least = 0, greatest = 0;  ///< of active voxels, numbers only
    Offset bytes = 0;                ///< in memory
    std::vector<std::pair<std::string, std::string>> metadata{};
};

struct GridSurface {
    std::vector<double> positions;  ///< (n, 3), world coordinates
    std::vector<Index> triangles, quads;
};

class Grids {
  public:
    Grids();
    ~Grids();
    Grids(Grids&&) noexcept;
    Grids& operator=(Grids&&) noexcept;

    /// Grids in the order that they have in the file. @throws IoError naming the file and what is wrong
    static Grids Read(const std::filesystem::path& path);
    /// Beside and renamed. @param half_float keep numbers in 16 bits. @throws IoError
    void Write(const std::filesystem::path& path, bool half_float = false) const;

    /// A string that every grid carries into files, under a name of its own, instead of what was there.
    void SetMetadata(const std::string& name, const std::string& value);

    std::vector<GridInfo> Describe() const;
    /// Values of a grid of numbers (float, double, int32) at a box of voxels, low to high inclusive, z fastest.
    /// @throws InvalidInput where there is no such grid, or the box is empty or holds more than 2^31 voxels
    std::vector<double> Values(const std::string& name, const std::array<int, 3>& low,
                               const std::array<int, 3>& high) const;
    /// The same of a grid of vectors: three numbers a voxel.
    std::vector<double> Vectors(const std::string& name, const std::array<int, 3>& low,
                                const std::array<int, 3>& high) const;

    /// Which voxels of a box are active; of grids of numbers or vectors.
    std::vector<bool> IsActive(const std::string& name, const std::array<int, 3>& low,
                               const std::array<int, 3>& high) const;
    /// Where a grid has a voxel's centre. @throws InvalidInput where there is no such grid
    std::array<double, 3> ToWorld(const std::string& name, const std::array<int, 3>& voxel) const;

    /// Where a grid of numbers has a value (0: the surface of a level set): quads (n, 4) and triangles (n, 3),
    /// counterclockwise from the larger values. @throws InvalidInput where there is no such grid of numbers
    GridSurface Surface(const std::string& name, double value) const;
    /// The boundary of what is active in a grid of numbers or vectors.
    GridSurface ActiveSurface(const std::string& name) const;

    struct State;
    State& state() { return *state_; }
    const State& state() const { return *state_; }

  private:
    std::unique_ptr<State> state_;
};

}  // namespace SolidSubdiv::Voxel

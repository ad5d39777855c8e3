// SPDX-License-Identifier: Apache-2.0
// A solid by the polyhedral split.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/kit/io/mesh.h>

#include "perf/machine.h"

namespace SolidSubdiv::Perf {

/// A solid, its levels and tables, as one object that races can fill and empty.
class Solid {
  public:
    Solid(std::string name, Io::Mesh mesh, int n_levels) : name_(std::move(name)), mesh_(std::move(mesh)) {
        const double before = ResidentBytes();
        Create();
        bytes_of_level_0_ = ResidentBytes() - before;
        refiner_->RefineUniform({.max_level = n_levels});
        bytes_of_levels_ = ResidentBytes() - before;
        n_levels_ = n_levels;
    }
    const std::string& name() const { return name_; }
    const Io::Mesh& mesh() const { return mesh_; }
    const Far::TopologyRefiner& refiner() const { return *refiner_; }
    double bytes_of_level_0() const { return bytes_of_level_0_; }
    double bytes_of_levels() const { return bytes_of_levels_; }
    double NCells(int level) const { return static_cast<double>(refiner_->n_cells(level)); }

    void Create() { refiner_.emplace(Far::TopologyRefiner::Create(mesh_.topology, Sdc::Split::Polyhedral)); }
    /// Level 0 once more, beside the one that is there.
    void CreateAnother() { another_.emplace(Far::TopologyRefiner::Create(mesh_.topology, Sdc::Split::Polyhedral)); }
    void Refine() { refiner_->RefineUniform({.max_level = n_levels_}); }
    template <class Real>
    void MakeTable(const Sdc::Scheme& scheme) {
        table_ = Far::StencilTableReal<Real>::Create(*refiner_, scheme);
    }
    /// Holds another's table from now on.
    void TakeTable(Solid& other) { table_ = std::exchange(other.table_, {}); }
    /// Positions level by level, in floats.
    void Interpolate() {
        const Far::PrimvarRefiner primvars(*refiner_, Sdc::CatmullClarkSolid{});
        values_[0].assign(mesh_.positions.begin(), mesh_.positions.end());
        for (int l = 1; l <= n_levels_; ++l) {
            Array<float>& fine = values_[l % 2];
            fine.resize(3 * static_cast<std::size_t>(refiner_->n_vertices(l)));
            primvars.Interpolate<float>(l, values_[(l + 1) % 2], fine, 3);
        }
    }
    /// Level 0 is left.
    void Clear() {
        refiner_->RefineUniform({.max_level = 0});
        another_.reset();
        table_ = {};
        for (Array<float>& v : values_) v = {};
    }

    std::string Describe() const {
        const auto& fine = refiner_->polyhedral_level(n_levels_);
        return name_ + ": " + std::to_string(refiner_->n_cells(0)) + " cells, " + std::to_string(n_levels_) +
               (n_levels_ == 1 ? " level: " : " levels: ") + std::to_string(fine.n_hexes) + " hexahedra, " +
               std::to_string(fine.n_polyhedra()) + " other cells and " + std::to_string(fine.n_vertices) +
               " vertices in the last.";
    }

  private:
    std::string name_;
    Io::Mesh mesh_;
    int n_levels_ = 0;
    double bytes_of_level_0_ = 0, bytes_of_levels_ = 0;
    std::optional<Far::TopologyRefiner> refiner_, another_;
    std::variant<std::monostate, Far::StencilTableReal<float>, Far::StencilTableReal<double>> table_;
    Array<float> values_[2];
};

}  // namespace SolidSubdiv::Perf

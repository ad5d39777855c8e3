// SPDX-License-Identifier: Apache-2.0
// Refined values as sums of coarser ones: sparse rows made once, applied to any data at the vertices, again and again.
//
// Cascaded (the default): one sparse table a level, whose columns are the vertices of the level before. Composite, on
// demand and for chosen vertices only: one table whose columns are the control vertices. On a regular solid a cascaded
// row has about 8 weights, a composite one up to 32 and more: nobody gets a full composite table by accident.
//
//     auto cascaded = Far::StencilTable::Create(refiner, Sdc::BoxSpline{});
//     auto samples = Far::StencilTable::CreateComposite(refiner, Sdc::BoxSpline{}, {{.level = 3, .vertices = chosen}});
//
// A row's weights sum to 1. The rows are also the derivative of the refined values by the control values.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/sdc/progress.h>
#include <solidsubdiv/sdc/schemes.h>

namespace SolidSubdiv::Far {

/// One sparse matrix in compressed rows: row i sums weights[k] * source[indices[k]] over k in [offsets[i], offsets[i +
/// 1]). An index may stand twice in a row of level 1 where a complex meets itself; its weights add.
template <class Real>
struct StencilRows {
    Index n_sources = 0;
    Array<Offset> offsets{0};
    Array<Index> indices;
    Array<Real> weights;

    Index n_rows() const { return static_cast<Index>(offsets.size()) - 1; }
    Offset n_weights() const { return offsets.back(); }
    std::span<const Index> Indices(Index row) const { return {indices.data() + offsets[row], Length(row)}; }
    std::span<const Real> Weights(Index row) const { return {weights.data() + offsets[row], Length(row)}; }
    Offset Bytes() const {
        return static_cast<Offset>(offsets.size() * sizeof(Offset) + indices.size() * sizeof(Index) +
                                   weights.size() * sizeof(Real));
    }

  private:
    std::size_t Length(Index row) const { return static_cast<std::size_t>(offsets[row + 1] - offsets[row]); }
};

struct StencilTableOptions {
    int max_level = -1;  ///< -1: the refiner's
    Progress progress{};
};

/// Chosen vertices of one level, for composite rows.
struct CompositeRows {
    int level = 0;                      ///< [0, refiner's max_level]; level 0: the control vertices themselves
    std::span<const Index> vertices{};  ///< in the order of the rows wanted; empty: all of the level
};

template <class Real>
class StencilTableReal {
  public:
    StencilTableReal() = default;

    /// Cascaded table of all levels. @throws InvalidInput if the scheme can't refine the mesh (a surface scheme on
    /// cells) or its options contradict each other. Cost: about 12 (float) or 20 (double) bytes a weight of memory
    /// traffic.
    static StencilTableReal Create(const TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                                   const StencilTableOptions& options = {});

    /// Rows over the control vertices for chosen vertices, one request after another, indices ascending in each row.
    static StencilTableReal CreateComposite(const TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                                            std::span<const CompositeRows> requests, const Progress& progress = {});
    static StencilTableReal CreateComposite(const TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                                            std::initializer_list<CompositeRows> requests,
                                            const Progress& progress = {}) {
        return CreateComposite(refiner, scheme, std::span(requests.begin(), requests.size()), progress);
    }

    /// Tables in the order of application: level i takes values of i - 1 (i from 1). A composite table has one.
    int n_levels() const { return static_cast<int>(levels_.size()); }
    const StencilRows<Real>& level(int i) const { return levels_[static_cast<std::size_t>(i) - 1]; }

    Index n_control_vertices() const { return n_control_vertices_; }
    Offset Bytes() const;

    /// For tools that change or assemble tables of their own (and for tests that plant faults).
    static StencilTableReal FromRows(Index n_control_vertices, std::vector<StencilRows<Real>> levels);

  private:
    Index n_control_vertices_ = 0;
    std::vector<StencilRows<Real>> levels_;
};

using StencilTable = StencilTableReal<double>;

extern template class StencilTableReal<double>;
extern template class StencilTableReal<float>;

}  // namespace SolidSubdiv::Far

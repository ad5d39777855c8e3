// SPDX-License-Identifier: Apache-2.0
// Limits of a scheme as rows over the vertices of a level: at its vertices, or at any places, with derivatives.
//
//     refiner.RefineUniform({.max_level = 2, .full_topology_in_last_level = true});
//     auto limit = Far::LimitStencilTable::Create(refiner, Sdc::BoxSpline{}, {.level = 2});
//
//     const std::vector<Far::Place> places{{.element = 7, .at = {.1, .2, .3}}};
//     auto samples = Far::LimitStencilTable::Create(refiner, Sdc::BoxSpline{}, places, {.level = 0, .order = 1});
//     samples.rows();                // points
//     samples.DerivativeRows(0);     // d point / du
//
// Who asks for places again and again keeps a LimitStencilTableFactory, which keeps what it finds out.
//
// Regular places in closed form: the quintic box spline in tets and octahedra (chang2002boxspline; rules.md section 2),
// tricubic and bicubic B-splines, Loop's quartic. Elsewhere the neighbourhood is refined towards the place until it is
// regular; what never becomes so (an extraordinary vertex, a point on an extraordinary edge) from eigenvectors of the
// matrix that repeats there. docs/limits.md says how.
#pragma once

#include <memory>
#include <vector>

#include <solidsubdiv/far/place.h>
#include <solidsubdiv/far/stencil_table.h>

namespace SolidSubdiv::Far {

struct LimitStencilTableOptions {
    int level = -1;  ///< whose vertices; -1: the last. It must have full topology.
};

struct LimitPlacesOptions {
    int level = 0;  ///< whose elements the places are in; it must have full topology
    Elements elements = Elements::Cells;
    int order = 0;  ///< of derivatives: 0 none, 1 the first, 2 the second as well (at regular places only)
    /// At corners of boundary faces that are in no closed form: two tangents of the surface instead of derivatives,
    /// which vanish or grow beyond bounds at extraordinary vertices. Of any length and direction in the tangent plane,
    /// but their cross product points where that of the derivatives by u and v does around. For normals.
    bool tangents = false;
    Progress progress{};

    /// @throws InvalidInput
    void Validate() const;
};

class LimitStencilTable {
  public:
    /// @throws InvalidInput if the level has no full topology or the scheme can't refine the mesh
    static LimitStencilTable Create(const TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                                    const LimitStencilTableOptions& options = {});

    /// Limits at places, and their derivatives by the places' coordinates, u first (of boundary faces u, v), then uu,
    /// uv, (uw,) vv (, vw, ww). On elements that meet, values agree, derivatives only as far as coordinates do.
    /// Boundary faces are taken as surfaces of their own.
    /// @throws InvalidInput as CheckPlaces, and as the other Create
    static LimitStencilTable Create(const TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                                    std::span<const Place> places, const LimitPlacesOptions& options);

    /// Row v: the limit of vertex v, or of place v. Columns: the vertices of the level.
    const StencilRows<double>& rows() const { return rows_; }

    /// Derivatives in the table; 0 for vertices.
    int n_derivatives() const { return static_cast<int>(derivatives_.size()); }
    /// Weights of derivative k, one for each of rows(): the same vertices.
    std::span<const double> DerivativeWeights(int k) const { return derivatives_[static_cast<std::size_t>(k)]; }
    /// The same as rows of their own.
    StencilRows<double> DerivativeRows(int k) const;

    /// Places with no limit (their row is empty), or without the derivatives asked for (weights of 0), ascending:
    /// NoLimit, NoDerivative; `measure` is the order that is missing.
    const std::vector<Defect>& defects() const { return defects_; }

    /// Bytes of all rows.
    Offset Bytes() const;

    /// Vertices without a row: powers of their local matrix do not settle, or creases there have yet to fade (refine as
    /// often as the sharpest of them says).
    const std::vector<Index>& without_limit() const { return without_limit_; }

  private:
    friend class LimitStencilTableFactory;

    StencilRows<double> rows_;
    std::vector<Array<double>> derivatives_;
    std::vector<Index> without_limit_;
    std::vector<Defect> defects_;
};

/// Makes tables of places in one level under one scheme, and keeps what it finds out about neighbourhoods: those with
/// the same topology, anywhere in the mesh and at any depth, are refined once.
///
/// Cost: products of rows of some tens of weights, one a level until the place is regular. The same bits for any number
/// of threads, and whatever was asked before.
class LimitStencilTableFactory {
  public:
    /// The refiner must outlive this. @throws InvalidInput as LimitStencilTable::Create
    LimitStencilTableFactory(const TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                             const LimitPlacesOptions& options);
    ~LimitStencilTableFactory();
    LimitStencilTableFactory(LimitStencilTableFactory&&) noexcept;
    LimitStencilTableFactory& operator=(LimitStencilTableFactory&&) noexcept;

    /// @throws InvalidInput as CheckPlaces, Cancelled
    LimitStencilTable Create(std::span<const Place> places);

    /// Of neighbourhoods kept: how many, and about the bytes they take (a gigabyte at most: then they are forgotten).
    std::size_t n_neighborhoods() const;
    Offset Bytes() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace SolidSubdiv::Far

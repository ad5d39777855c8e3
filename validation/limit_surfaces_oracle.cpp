// SPDX-License-Identifier: Apache-2.0
// Calls OpenSubdiv's limit masks and limit stencils, and copies their answers out.
#include "limit_surfaces_oracle.h"

#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/ptexIndices.h>
#include <opensubdiv/far/stencilTableFactory.h>

#include <memory>
#include <stdexcept>

#include "osd_position.h"
#include "osd_topology_oracle.h"

namespace SolidSubdiv::Validation {

namespace {

namespace Theirs = OpenSubdiv::Far;

std::vector<double> Sums(const Theirs::LimitStencilTableReal<double>& table, const std::vector<double>& weights,
                         const std::vector<double>& positions) {
    const std::size_t n = static_cast<std::size_t>(table.GetNumStencils());
    std::vector<double> sums(3 * n);
    for (std::size_t r = 0; r < n; ++r) {
        const std::size_t begin = static_cast<std::size_t>(table.GetOffsets()[r]);
        for (std::size_t k = begin; k < begin + static_cast<std::size_t>(table.GetSizes()[r]); ++k) {
            const std::size_t v = static_cast<std::size_t>(table.GetControlIndices()[k]);
            for (std::size_t i = 0; i < 3; ++i) sums[3 * r + i] += weights[k] * positions[3 * v + i];
        }
    }
    return sums;
}

template <class Surface>
SurfaceLimits Limits(const Surface& surface, std::span<const SurfacePlace> places) {
    constexpr int kLevels = 6;  // random tags are no sharper than four levels
    const auto refiner = MakeOpenSubdivRefiner(surface, 0);
    refiner->Unrefine();
    Theirs::PatchTableFactory::Options patch_options(kLevels);
    patch_options.useInfSharpPatch = true;
    patch_options.SetEndCapType(Theirs::PatchTableFactory::Options::ENDCAP_GREGORY_BASIS);
    patch_options.SetPatchPrecision<double>();
    Theirs::TopologyRefiner::AdaptiveOptions adaptive(kLevels);
    adaptive.useInfSharpPatch = true;
    refiner->RefineAdaptive(adaptive);
    const std::unique_ptr<const Theirs::PatchTable> patches(Theirs::PatchTableFactory::Create(*refiner, patch_options));
    if (!patches) throw std::runtime_error("OpenSubdiv makes no patches");
    const Theirs::PatchMap map(*patches);
    const Theirs::PtexIndices ptex(*refiner);

    SurfaceLimits limits;
    std::vector<bool> is_turned;
    using Factory = Theirs::LimitStencilTableFactoryReal<double>;
    typename Factory::LocationArrayVec locations(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const SurfacePlace& place = places[i];
        locations[i].ptexIdx = ptex.GetFaceId(place.face) + place.corner;
        locations[i].numLocations = 1;
        locations[i].s = &place.s;
        locations[i].t = &place.t;
        const auto* patch = map.FindPatch(locations[i].ptexIdx, place.s, place.t);
        if (!patch) throw std::runtime_error("OpenSubdiv finds no patch");
        const auto type = patches->GetPatchDescriptor(*patch).GetType();
        const Theirs::PatchParam param = patches->GetPatchParam(*patch);
        limits.depths.push_back(param.GetDepth());
        limits.is_exact.push_back((type == Theirs::PatchDescriptor::REGULAR || type == Theirs::PatchDescriptor::LOOP) &&
                                  limits.depths.back() < kLevels);
        is_turned.push_back(type == Theirs::PatchDescriptor::LOOP && param.IsTriangleRotated());
    }
    Factory::Options options;
    options.generate1stDerivatives = true;
    options.generate2ndDerivatives = true;
    const std::unique_ptr<const Theirs::LimitStencilTableReal<double>> table(
        Factory::Create(*refiner, locations, nullptr, patches.get(), options));
    if (!table || table->GetNumStencils() != static_cast<int>(places.size())) {
        throw std::runtime_error("OpenSubdiv's limit table has an unexpected length");
    }
    limits.points = Sums(*table, table->GetWeights(), surface.positions);
    limits.derivatives = {Sums(*table, table->GetDuWeights(), surface.positions),
                          Sums(*table, table->GetDvWeights(), surface.positions),
                          Sums(*table, table->GetDuuWeights(), surface.positions),
                          Sums(*table, table->GetDuvWeights(), surface.positions),
                          Sums(*table, table->GetDvvWeights(), surface.positions)};
    for (std::size_t i = 0; i < 3 * places.size(); ++i) {
        if (!is_turned[i / 3]) continue;
        for (std::size_t k = 2; k < 5; ++k) limits.derivatives[k][i] = -limits.derivatives[k][i];
    }
    return limits;
}

template <class Surface>
VertexLimits Vertices(const Surface& surface) {
    // Masks want regular faces around, which one split makes.
    const auto refiner = MakeOpenSubdivRefiner(surface, 1);
    const auto &base = refiner->GetLevel(0), &level = refiner->GetLevel(1);
    for (int v = 0; v < base.GetNumVertices(); ++v) {
        if (base.IsVertexNonManifold(v)) return {};
    }
    std::vector<Position> values(static_cast<std::size_t>(surface.n_vertices));
    for (std::size_t v = 0; v < values.size(); ++v) {
        for (std::size_t i = 0; i < 3; ++i) values[v].x[i] = surface.positions[3 * v + i];
    }
    const std::size_t n = static_cast<std::size_t>(level.GetNumVertices());
    std::vector<Position> finer(n), points(n), first(n), second(n);
    const Theirs::PrimvarRefinerReal<double> primvars(*refiner);
    primvars.Interpolate(1, values, finer);
    primvars.Limit(finer, points, first, second);

    using Rule = OpenSubdiv::Sdc::Crease;
    VertexLimits limits;
    for (int v = 0; v < surface.n_vertices; ++v) {
        const int child = base.GetVertexChildVertex(v);
        const std::size_t c = static_cast<std::size_t>(child);
        const double *a = first[c].x, *b = second[c].x;
        limits.points.insert(limits.points.end(), points[c].x, points[c].x + 3);
        for (int i = 0; i < 3; ++i) {
            limits.normals.push_back(a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);
        }
        const auto rule = level.GetVertexRule(child);
        limits.is_dart.push_back(rule == Rule::RULE_DART);
        limits.is_smooth.push_back(rule == Rule::RULE_SMOOTH);
        limits.is_smooth_border.push_back(rule == Rule::RULE_CREASE && level.IsVertexBoundary(child) &&
                                          level.IsVertexValenceRegular(child) && !level.IsVertexCorner(child));
    }
    return limits;
}

}  // namespace

SurfaceLimits LimitsByOpenSubdiv(const ControlSurface& surface, std::span<const SurfacePlace> places) {
    return Limits(surface, places);
}
SurfaceLimits LimitsByOpenSubdiv(const PolygonSurface& surface, std::span<const SurfacePlace> places) {
    return Limits(surface, places);
}
VertexLimits VertexLimitsByOpenSubdiv(const ControlSurface& surface) { return Vertices(surface); }
VertexLimits VertexLimitsByOpenSubdiv(const PolygonSurface& surface) { return Vertices(surface); }

}  // namespace SolidSubdiv::Validation

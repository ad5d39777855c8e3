// SPDX-License-Identifier: Apache-2.0
// The comparison with OpenSubdiv's limits passes, and catches weights that are off, turned derivatives, normals and
// places, and other rules.
#include <gtest/gtest.h>

#include <algorithm>

#include "validation/limit_shapes.h"
#include "validation/limit_surfaces.h"
#include "validation/or_skip.h"

namespace SolidSubdiv::Validation {
namespace {

constexpr double kTolerance = 1e-9;  // that of the validator

class LimitSurfacesValidator : public testing::TestWithParam<const char*> {
  protected:
    void SetUp() override {
        std::vector<LimitShape> shapes = LimitShapes();
        shape_ = *std::find_if(shapes.begin(), shapes.end(), [](const LimitShape& s) { return s.name == GetParam(); });
        refiner_ = std::make_unique<Far::TopologyRefiner>(
            Far::TopologyRefiner::Create(shape_.mesh.Descriptor(), shape_.split));
        surface_ = std::make_unique<BoundarySurface>(*refiner_, shape_.positions, SurfaceTags{});
        const int n_faces = static_cast<int>(surface_->faces().size());
        for (int f = 0; f < n_faces; ++f) {
            if (!surface_->HasParts(f)) places_.push_back({f, 0, 0.4, 0.15});
        }
        OrSkip([&] { surface_->LimitsAt(places_); });
    }
    LimitRows Rows(std::size_t scheme = 0) const {
        return MakeLimitRows(*refiner_, shape_.schemes[scheme], surface_->OurPlaces(places_),
                             {.elements = Far::Elements::BoundaryFaces, .order = 2});
    }
    LimitRows CornerRows(std::size_t scheme = 0) const {
        return MakeLimitRows(*refiner_, shape_.schemes[scheme], surface_->CornerPlaces(),
                             {.elements = Far::Elements::BoundaryFaces, .order = 1, .tangents = true});
    }
    bool PassesAtPlaces(const LimitRows& rows, const BoundarySurface& surface) const {
        Findings findings;
        CompareAtPlaces(rows, surface, places_, shape_.positions, findings);
        return findings.Passes(kTolerance);
    }
    bool PassesAtPlaces(const LimitRows& rows) const { return PassesAtPlaces(rows, *surface_); }
    bool PassesAtVertices(const LimitRows& rows) const {
        Findings findings;
        CompareAtVertices(rows, *surface_, shape_.positions, findings);
        return findings.Passes(kTolerance);
    }
    /// Some place in a patch that is exact, whose row has derivatives up to the order.
    Index RowToSpoil(const LimitRows& rows, int order) const {
        const SurfaceLimits theirs = surface_->LimitsAt(places_);
        for (std::size_t i = 0; i < places_.size(); ++i) {
            if (theirs.is_exact[i] && rows.orders[i] >= order) return static_cast<Index>(i);
        }
        return kNoIndex;
    }

    LimitShape shape_;
    std::unique_ptr<Far::TopologyRefiner> refiner_;
    std::unique_ptr<BoundarySurface> surface_;
    std::vector<SurfacePlace> places_;
};

TEST_P(LimitSurfacesValidator, PassesAndCatchesWeightsThatAreOff) {
    const LimitRows rows = Rows(), corners = CornerRows();
    EXPECT_TRUE(PassesAtPlaces(rows));
    EXPECT_TRUE(PassesAtVertices(corners));
    const Index row = RowToSpoil(rows, 0);
    ASSERT_NE(row, kNoIndex);
    LimitRows spoilt = rows;
    spoilt.rows.weights[spoilt.rows.offsets[row]] += 1e-6;
    EXPECT_FALSE(PassesAtPlaces(spoilt));
    for (Index v = 0; v < corners.rows.n_rows(); ++v) {
        spoilt = corners;
        spoilt.rows.weights[spoilt.rows.offsets[v]] += 1e-6;
        EXPECT_FALSE(PassesAtVertices(spoilt)) << v;
    }
}

TEST_P(LimitSurfacesValidator, CatchesDerivativesAndNormalsOfTheWrongSign) {
    const LimitRows rows = Rows(), corners = CornerRows();
    for (std::size_t k = 0; k < rows.derivatives.size(); ++k) {
        const Index row = RowToSpoil(rows, k < 2 ? 1 : 2);
        ASSERT_NE(row, kNoIndex);
        LimitRows spoilt = rows;
        auto& weights = spoilt.derivatives[k].weights;
        for (Offset i = spoilt.rows.offsets[row]; i < spoilt.rows.offsets[row + 1]; ++i) weights[i] = -weights[i];
        EXPECT_FALSE(PassesAtPlaces(spoilt)) << k;
    }
    LimitRows turned = corners;
    std::swap(turned.derivatives[0], turned.derivatives[1]);
    EXPECT_FALSE(PassesAtVertices(turned));
    LimitRows tilted = corners;
    for (double& w : tilted.derivatives[0].weights) w += 1e-6;
    EXPECT_FALSE(PassesAtVertices(tilted));
}

TEST_P(LimitSurfacesValidator, CatchesTurnedPlacesAndOtherRules) {
    const LimitRows rows = Rows();
    for (SurfacePlace& place : places_) std::swap(place.s, place.t);
    EXPECT_FALSE(PassesAtPlaces(rows));
    for (SurfacePlace& place : places_) std::swap(place.s, place.t);
    SurfaceTags tags;
    const Polygon& face = surface_->faces()[0];
    const auto of_mesh = [&](int v) { return surface_->mesh_vertices[static_cast<std::size_t>(v)]; };
    tags.creases = {{of_mesh(face[0]), of_mesh(face[1])}, {of_mesh(face[1]), of_mesh(face[2])}};
    tags.crease_sharpness = {10, 10};
    EXPECT_FALSE(PassesAtPlaces(rows, BoundarySurface(*refiner_, shape_.positions, tags)));
    const std::size_t linear = shape_.schemes.size() - 1;
    EXPECT_FALSE(PassesAtPlaces(Rows(linear)));
    EXPECT_FALSE(PassesAtVertices(CornerRows(linear)));
}

INSTANTIATE_TEST_SUITE_P(Shapes, LimitSurfacesValidator,
                         testing::Values("boundary of ring", "sheet", "mixed torus", "quad-disc-5"));

}  // namespace
}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
// The comparison with OpenSubdiv's Catmull-Clark passes, and fails wherever one side follows another rule.
#include <gtest/gtest.h>

#include "validation/or_skip.h"
#include "validation/polygon_compare.h"
#include "validation/polygon_shapes.h"
#include "validation/surface_shapes.h"

namespace SolidSubdiv::Validation {
namespace {

constexpr double kTolerance = 1e-12;  // that of the validators

class CatmarkValidator : public testing::Test {
  protected:
    void SetUp() override {
        for (const PolygonShape& shape : PolygonShapes()) {
            if (shape.name == "mixed sheet") shape_ = shape;
        }
        for (const Polygon& face : shape_.faces) {
            corners_.insert(corners_.end(), face.begin(), face.end());
            offsets_.push_back(static_cast<Offset>(corners_.size()));
        }
        mesh_.n_vertices = static_cast<Index>(shape_.positions.size() / 3);
        mesh_.polygon_offsets = offsets_;
        mesh_.polygon_vertices = corners_;
        OrSkip([&] { Passes(Sdc::CatmullClark{}, {}, {}); });
    }
    bool Passes(const Sdc::Scheme& scheme, const SurfaceTags& ours, const SurfaceTags& theirs,
                bool smooth_triangles = false, bool bilinear = false) const {
        PolygonSurfaceOfMesh surface = TakePolygons(shape_.faces, shape_.positions, theirs);
        surface.surface.has_smooth_triangles = smooth_triangles;
        surface.surface.is_bilinear = bilinear;
        return CompareWithCatmark(mesh_, scheme, surface, shape_.positions, ours, {2, 2}).Passes(kTolerance);
    }

    PolygonShape shape_;
    std::vector<Index> corners_;
    std::vector<Offset> offsets_{0};
    Far::TopologyDescriptor mesh_;
};

TEST_F(CatmarkValidator, PassesAndCatchesEveryOtherRule) {
    const Sdc::CatmullClark plain;
    EXPECT_TRUE(Passes(plain, {}, {}));
    EXPECT_TRUE(Passes(Sdc::CatmullClark{.triangles = Sdc::TriangleWeights::Smooth}, {}, {}, true));
    EXPECT_FALSE(Passes(Sdc::CatmullClark{.triangles = Sdc::TriangleWeights::Smooth}, {}, {}));
    EXPECT_FALSE(Passes(plain, {}, {}, true));
    EXPECT_TRUE(Passes(Sdc::LinearSurface{}, {}, {}, false, true));
    EXPECT_FALSE(Passes(Sdc::LinearSurface{}, {}, {}));
    EXPECT_FALSE(Passes(Sdc::CatmullClark{.features = Sdc::Features::Sharp}, {}, {}));
    SurfaceTags corners;
    corners.has_sharp_corners = true;
    EXPECT_TRUE(Passes(Sdc::CatmullClark{.features = Sdc::Features::Sharp}, {}, corners));
}

TEST_F(CatmarkValidator, CatchesTagsThatAreNotTheSame) {
    SurfaceTags tags = RandomTags(shape_.faces, 3, false);
    const Sdc::CatmullClark uniform, chaikin{.creasing = Sdc::CreasingMethod::Chaikin};
    EXPECT_TRUE(Passes(uniform, tags, tags));
    EXPECT_FALSE(Passes(chaikin, tags, tags));
    EXPECT_FALSE(Passes(uniform, {}, tags));
    SurfaceTags sharper = tags;
    for (float& s : sharper.crease_sharpness) s += 0.25f;
    EXPECT_FALSE(Passes(uniform, sharper, tags));
    tags.is_chaikin = true;
    EXPECT_TRUE(Passes(chaikin, tags, tags));
}

TEST_F(CatmarkValidator, CatchesMovedPointsAndTurnedFaces) {
    PolygonSurfaceOfMesh moved = TakePolygons(shape_.faces, shape_.positions);
    moved.surface.positions[7] += 1e-9;
    EXPECT_FALSE(
        CompareWithCatmark(mesh_, Sdc::CatmullClark{}, moved, shape_.positions, {}, {2, 1}).Passes(kTolerance));
    std::vector<Polygon> turned = shape_.faces;
    for (Polygon& face : turned) std::reverse(face.begin(), face.end());
    const PolygonSurfaceOfMesh other = TakePolygons(turned, shape_.positions);
    EXPECT_FALSE(
        CompareWithCatmark(mesh_, Sdc::CatmullClark{}, other, shape_.positions, {}, {1, 1}).Passes(kTolerance));
}

TEST_F(CatmarkValidator, TheBoundaryOfASolidFollowsItsFeatures) {
    const HexShape shape = HexShapes()[3];
    std::vector<Index> cells;
    for (const auto& cell : shape.cells) cells.insert(cells.end(), cell.begin(), cell.end());
    Far::TopologyDescriptor mesh{.n_vertices = static_cast<Index>(shape.positions.size() / 3)};
    mesh.hexes = cells;
    const auto passes = [&](Sdc::Features features, const SurfaceTags& theirs) {
        return CompareWithCatmark(mesh, Sdc::CatmullClarkSolid{.features = features},
                                  TakePolygons(BoundaryOf(shape), shape.positions, theirs), shape.positions, {}, {2, 2})
            .Passes(kTolerance);
    };
    const SurfaceTags sharp = SharpFeaturesOf(shape);
    EXPECT_TRUE(passes(Sdc::Features::Smooth, {}));
    EXPECT_TRUE(passes(Sdc::Features::Sharp, sharp));
    EXPECT_FALSE(passes(Sdc::Features::Sharp, {}));
    EXPECT_FALSE(passes(Sdc::Features::Smooth, sharp));
    SurfaceTags no_corners = sharp;
    no_corners.corners.clear();
    no_corners.corner_sharpness.clear();
    EXPECT_EQ(passes(Sdc::Features::Sharp, no_corners), true) << "three creases make a corner as well";
}

}  // namespace
}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
// Comparisons of surfaces with creases, and of butterflies: each passes, and fails where one side follows another rule.
#include <gtest/gtest.h>

#include "validation/butterfly_oracle.h"
#include "validation/or_skip.h"
#include "validation/solid_shapes.h"
#include "validation/surface_compare.h"
#include "validation/surface_shapes.h"

namespace SolidSubdiv::Validation {
namespace {

constexpr double kTolerance = 1e-12;  // that of the validators

SurfaceShape Sheet() {
    for (SurfaceShape& shape : OpenSurfaces()) {
        if (shape.name == "sheet") return shape;
    }
    return {};
}

class TaggedSurfaces : public testing::Test {
  protected:
    void SetUp() override {
        for (const Triangle& t : shape_.triangles) corners_.insert(corners_.end(), t.begin(), t.end());
        mesh_.n_vertices = static_cast<Index>(shape_.positions.size() / 3);
        mesh_.triangles = corners_;
        OrSkip([&] { LoopPasses({}, {}); });
    }

    bool LoopPasses(const Sdc::Loop& scheme, const SurfaceTags& tags) const {
        return CompareWithLoop(mesh_, scheme, shape_.triangles, shape_.positions, tags, {3, 2}).Passes(kTolerance);
    }

    /// @param tags ours; the oracle's are `theirs`
    bool ButterflyPasses(const Sdc::Scheme& scheme, const ButterflyRule& rule, const SurfaceTags& tags,
                         const SurfaceTags& theirs) const {
        const TaggedMesh tagged(mesh_, tags);
        auto refiner = Far::TopologyRefiner::Create(tagged.descriptor, Sdc::Split::TetOct);
        refiner.RefineUniform({.max_level = 2});
        const SurfaceOfMesh start = TakeSurface(shape_.triangles, shape_.positions, theirs);
        const auto oracle = RefineByButterflyOracle(start.surface, rule, 2, 2);
        return CompareWithLevels(refiner, scheme, shape_.positions, start, oracle.levels, 2).Passes(kTolerance);
    }

    const SurfaceShape shape_ = Sheet();
    std::vector<Index> corners_;
    Far::TopologyDescriptor mesh_;
};

TEST_F(TaggedSurfaces, LoopPassesAndCatchesEveryOtherRule) {
    SurfaceTags tags = RandomTags(shape_.triangles, 3, false);
    EXPECT_TRUE(LoopPasses({}, tags));
    EXPECT_FALSE(LoopPasses({.creasing = Sdc::CreasingMethod::Chaikin}, tags));
    EXPECT_FALSE(LoopPasses({.features = Sdc::Features::Sharp}, tags));
    tags.is_chaikin = true;
    EXPECT_FALSE(LoopPasses({}, tags));
    tags.has_sharp_corners = true;
    EXPECT_TRUE(LoopPasses({.features = Sdc::Features::Sharp, .creasing = Sdc::CreasingMethod::Chaikin}, tags));
}

TEST_F(TaggedSurfaces, ButterfliesPassAndCatchEveryOtherRule) {
    const SurfaceTags tags = RandomTags(shape_.triangles, 4, true);
    ButterflyRule rule = ButterflyRule::Modified();
    rule.has_regular_corners = false;
    const Sdc::ModifiedButterfly modified;
    EXPECT_TRUE(ButterflyPasses(modified, rule, tags, tags));
    EXPECT_FALSE(ButterflyPasses(Sdc::Butterfly{}, rule, tags, tags));
    EXPECT_FALSE(ButterflyPasses(modified, rule, tags, {})) << "tags that one side does not know";
    EXPECT_TRUE(ButterflyPasses(modified, rule, {}, {}));

    Sdc::Butterfly plain;
    EXPECT_TRUE(ButterflyPasses(plain, ButterflyRule::Plain(), tags, tags));
    plain.tension += 1e-6;
    EXPECT_FALSE(ButterflyPasses(plain, ButterflyRule::Plain(), tags, tags));

    ButterflyRule regular_corners = rule;
    regular_corners.has_regular_corners = true;
    SurfaceTags corner;  // a vertex of three triangles on the border
    for (int v = 0; v < mesh_.n_vertices; ++v) {
        corner.corners.push_back(v);
        corner.corner_sharpness.push_back(10);
    }
    EXPECT_TRUE(ButterflyPasses(modified, rule, corner, corner));
    EXPECT_FALSE(ButterflyPasses(modified, regular_corners, corner, corner));
}

}  // namespace
}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
// The comparison with walks passes, and catches weights that are off, other schemes and other places.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "validation/limit_places.h"
#include "validation/limit_shapes.h"

namespace SolidSubdiv::Validation {
namespace {

constexpr double kTolerance = 1e-9;  // that of the validator
using Far::Elements;

/// A few places inside elements of a shape, what walks find there for its first scheme, and a way to compare.
class WalkedPlaces {
  public:
    WalkedPlaces(const std::string& name, Elements elements) : elements_(elements) {
        std::vector<LimitShape> shapes = LimitShapes();
        shape_ = *std::find_if(shapes.begin(), shapes.end(), [&](const LimitShape& s) { return s.name == name; });
        refiner_ = std::make_unique<Far::TopologyRefiner>(
            Far::TopologyRefiner::Create(shape_.mesh.Descriptor(), shape_.split));
        places_ = RandomLimitPlaces(*refiner_, elements, 4, 3, WhereInElements::Inside);
        walks_ =
            WalkToPlaces(shape_.mesh, shape_.split, {shape_.schemes[0]}, shape_.positions, places_, elements).at(0);
    }
    LimitRows Rows(std::size_t scheme = 0) const {
        return MakeLimitRows(*refiner_, shape_.schemes[scheme], places_, {.elements = elements_, .order = 2});
    }
    LimitRows RowsOf(const std::vector<Far::Place>& places) const {
        return MakeLimitRows(*refiner_, shape_.schemes[0], places, {.elements = elements_, .order = 2});
    }
    bool Passes(const LimitRows& rows, LimitTally* tally = nullptr) const {
        Findings findings;
        const LimitTally found = CompareWithWalks(rows, shape_.positions, walks_, findings);
        if (tally) *tally = found;
        return findings.Passes(kTolerance);
    }
    const std::vector<Far::Place>& places() const { return places_; }
    const Far::TopologyRefiner& refiner() const { return *refiner_; }

  private:
    Elements elements_;
    LimitShape shape_;
    std::unique_ptr<Far::TopologyRefiner> refiner_;
    std::vector<Far::Place> places_;
    std::vector<std::vector<LimitEstimate>> walks_;
};

/// Adds to the largest weight of a row and takes from another, so that the sum stays.
void Shift(Far::StencilRows<double>& rows, Index row, double by) {
    const auto weights = rows.Weights(row);
    const auto k = std::max_element(weights.begin(), weights.end()) - weights.begin();
    rows.weights[rows.offsets[row] + k] += by;
    rows.weights[rows.offsets[row] + (k == 0 ? 1 : 0)] -= by;
}

class LimitPlacesValidator : public testing::TestWithParam<std::pair<const char*, Elements>> {
  protected:
    const WalkedPlaces walked_{GetParam().first, GetParam().second};
};

TEST_P(LimitPlacesValidator, PassesAndCatchesWeightsThatAreOff) {
    LimitTally tally;
    EXPECT_TRUE(walked_.Passes(walked_.Rows(), &tally));
    EXPECT_GE(tally.n_to_tolerance, 2);
    EXPECT_GT(tally.n_slopes, 0);
    // Those that are compared to the tolerance see any weight; all see one that is off by more than their bounds.
    const LimitRows right = walked_.Rows();
    int n_caught = 0;
    for (Index row = 0; row < right.rows.n_rows(); ++row) {
        LimitRows rows = right;
        Shift(rows.rows, row, 1e-6);
        n_caught += !walked_.Passes(rows);
        rows = right;
        rows.rows.weights[rows.rows.offsets[row]] += 1e-6;
        EXPECT_FALSE(walked_.Passes(rows)) << "the sum of row " << row;
    }
    EXPECT_GE(n_caught, tally.n_to_tolerance);
}

TEST_P(LimitPlacesValidator, CatchesDerivativesOfTheWrongSignAndOrder) {
    const LimitRows right = walked_.Rows();
    const std::size_t d = GetParam().second == Elements::Cells ? 3 : 2;
    for (std::size_t k = 0; k < d; ++k) {
        LimitRows rows = right;
        for (double& w : rows.derivatives[k].weights) w = -w;
        EXPECT_FALSE(walked_.Passes(rows)) << "derivative " << k;
    }
    LimitRows rows = right;
    std::swap(rows.derivatives[0], rows.derivatives[1]);
    EXPECT_FALSE(walked_.Passes(rows));
    // One more in a first derivative changes its sum, and a hundredth of it the point that it leads to.
    rows = right;
    Shift(rows.derivatives[0], 0, 0.01);
    EXPECT_FALSE(walked_.Passes(rows));
}

TEST_P(LimitPlacesValidator, CatchesSecondDerivativesOfTheWrongSign) {
    const LimitRows right = walked_.Rows();
    const std::size_t d = GetParam().second == Elements::Cells ? 3 : 2;
    if (std::all_of(right.orders.begin(), right.orders.end(), [](int order) { return order < 2; })) return;
    LimitRows rows = right;
    for (std::size_t k = d; k < rows.derivatives.size(); ++k) {
        for (double& w : rows.derivatives[k].weights) w = -w;
    }
    EXPECT_FALSE(walked_.Passes(rows));
}

TEST_P(LimitPlacesValidator, CatchesPlacesInTheWrongChild) {
    for (std::size_t i = 0; i < walked_.places().size(); ++i) {
        std::vector<Far::Place> places = walked_.places();
        std::swap(places[i].at[0], places[i].at[1]);
        EXPECT_FALSE(walked_.Passes(walked_.RowsOf(places))) << i;
        places = walked_.places();
        for (double& x : places[i].at) x /= 2;
        EXPECT_FALSE(walked_.Passes(walked_.RowsOf(places))) << i;
    }
}

TEST_P(LimitPlacesValidator, CatchesOtherSchemesAndNumbersThatAreNone) {
    EXPECT_FALSE(walked_.Passes(walked_.Rows(walked_.refiner().is_polyhedral() ? 3 : 5)));
    LimitRows rows = walked_.Rows();
    rows.rows.weights[0] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(walked_.Passes(rows));
}

INSTANTIATE_TEST_SUITE_P(Shapes, LimitPlacesValidator,
                         testing::Values(std::pair("octet-truss", Elements::Cells),
                                         std::pair("octet-truss", Elements::BoundaryFaces),
                                         std::pair("5 hexahedra around an edge", Elements::Cells),
                                         std::pair("six pyramids under a cube", Elements::Cells),
                                         std::pair("sheet", Elements::BoundaryFaces),
                                         std::pair("mixed torus", Elements::BoundaryFaces)));

}  // namespace
}  // namespace SolidSubdiv::Validation

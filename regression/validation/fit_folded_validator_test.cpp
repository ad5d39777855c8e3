// SPDX-License-Identifier: Apache-2.0
// Solids at rest have no folds; cells that are turned over are found, and a verdict that denies them is caught.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sanitized.h"
#include "validation/fit_folded.h"
#include "validation/fit_shapes.h"

namespace SolidSubdiv::Validation {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(FitFoldedValidator, CatchesCellsThatAreTurnedOver) {
    SOLIDSUBDIV_LONG_TEST();
    for (const FitCase& c : FitCasesAround(MakeFitBall(6).View(), 64)) {
        if (!c.mesh.is_solid()) continue;
        SCOPED_TRACE(c.name);
        const FitLevels at_rest(c.mesh, c.mesh.positions, c.scheme, 0);
        EXPECT_THAT(FoldedCells(at_rest, 0, 500), IsEmpty());
        // The first control point goes to the far side of everything.
        std::vector<double> moved = c.mesh.positions;
        for (std::size_t k = 0; k < 3; ++k) moved[k] *= -1.5;
        const FitLevels folded(c.mesh, moved, c.scheme, 0);
        const std::vector<Index> cells = FoldedCells(folded, 0, 500);
        EXPECT_FALSE(cells.empty());
        Findings truth, lie;
        CompareVerdicts(Geometry::MeasureQuality(folded.refiner, 0, folded.after[0]), cells, "level 0", truth);
        EXPECT_THAT(truth.faults, IsEmpty());
        CompareVerdicts(Geometry::MeasureQuality(folded.refiner, 0, folded.before[0]), cells, "level 0", lie);
        EXPECT_THAT(lie.faults, Contains(HasSubstr("is folded, and proved not to be")));
        // Seen in a mirror every place is.
        std::vector<double> mirrored = c.mesh.positions;
        for (std::size_t i = 0; i < mirrored.size(); i += 3) mirrored[i] *= -1;
        EXPECT_EQ(FoldedCells(FitLevels(c.mesh, mirrored, c.scheme, 0), 0, 500).size(), 500u);
    }
}

}  // namespace
}  // namespace SolidSubdiv::Validation

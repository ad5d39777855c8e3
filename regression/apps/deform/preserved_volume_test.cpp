// SPDX-License-Identifier: Apache-2.0
// Drags that keep the volume of the model, and the transposed embedding that they take its derivative by.
#include <solidsubdiv/apps/deform/direct_manipulation.h>

#include <gtest/gtest.h>

#include <numeric>

#include <solidsubdiv/apps/deform/internal/transpose.h>
#include <solidsubdiv/sdc/parallel.h>

#include "apps/deform/deform_testing.h"
#include "apps/deform/drag_testing.h"
#include "sanitized.h"

namespace SolidSubdiv::Deform {
namespace {

/// As the sum of cones from the origin.
double VolumeOf(const TestShapes::Sphere& surface, const std::vector<double>& points) {
    double sum = 0;
    for (std::size_t k = 0; k < surface.triangles.size(); k += 3) {
        const auto at = [&](std::size_t i) { return &points[3 * static_cast<std::size_t>(surface.triangles[k + i])]; };
        const double *a = at(0), *b = at(1), *c = at(2);
        sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return sum / 6;
}

TEST(PreservedVolume, IsKeptWithTheOptionAndNotWithout) {
    const Ball ball;
    const double volume = VolumeOf(ball.sphere, ball.sphere.points);
    for (double far : {.05, .3, 1.0}) {  // of a sphere of radius .7
        const std::vector<DragTarget> targets = {TargetBeside(ball.sphere.points, 3, {far, 0, far / 2}),
                                                 TargetBeside(ball.sphere.points, 40, {0, far / 3, -far}, 2)};
        const DragResult kept = Drag(ball.embedding, ball.lattice.positions, targets, ball.KeepVolume());
        const std::vector<double> points = PointsOf(ball.embedding, kept.control_points);
        EXPECT_NEAR(VolumeOf(ball.sphere, points), volume, 1e-10 * volume);  // the tolerance asked for
        EXPECT_NEAR(kept.volume_before, volume, 1e-14);
        EXPECT_NEAR(kept.volume_after, VolumeOf(ball.sphere, points), 1e-14);
        EXPECT_LT(DistanceOf(points, targets[0]), 1e-12);
        EXPECT_TRUE(kept.is_consistent);

        const DragResult free = Drag(ball.embedding, ball.lattice.positions, targets);
        EXPECT_GT(std::abs(VolumeOf(ball.sphere, PointsOf(ball.embedding, free.control_points)) / volume - 1), 1e-3);
    }
}

TEST(PreservedVolume, IsThatOfTheModelAsItIsWithItsCorrection) {
    const Ball ball;
    std::vector<double> correction = Moved(std::vector<double>(ball.sphere.points.size()), .1, 1);
    DragOptions options = ball.KeepVolume();
    options.correction = correction;
    const auto model = [&](const std::vector<double>& control_points) {
        std::vector<double> points = PointsOf(ball.embedding, control_points);
        for (std::size_t i = 0; i < points.size(); ++i) points[i] += correction[i];
        return points;
    };
    const std::vector<double> start = Moved(ball.lattice.positions, .1, 2);
    const DragTarget target = TargetBeside(model(start), 3, {.2, .1, 0});
    const DragResult result = Drag(ball.embedding, start, std::vector{target}, options);
    const double volume = VolumeOf(ball.sphere, model(start));
    EXPECT_NEAR(VolumeOf(ball.sphere, model(result.control_points)), volume, 1e-10 * volume);
    EXPECT_LT(DistanceOf(model(result.control_points), target), 1e-12);
}

TEST(PreservedVolume, LeavesTheChangeInTheSpanOfItsConstraints) {
    // Where the change is the least, it is a sum of the target's row and the volume's gradient.
    const Ball ball;
    const DragTarget target = TargetBeside(ball.sphere.points, 3, {.1, .05, 0});
    const DragResult result = Drag(ball.embedding, ball.lattice.positions, std::vector{target}, ball.KeepVolume());
    const Far::StencilRows<double> row = ball.embedding.ControlRows(std::array{target.point});
    const std::size_t n = ball.lattice.positions.size();
    std::vector<std::vector<double>> span(4, std::vector<double>(n));
    for (std::size_t k = 0; k < row.indices.size(); ++k) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            span[axis][3 * static_cast<std::size_t>(row.indices[k]) + axis] = row.weights[k];
        }
    }
    constexpr double kStep = 1e-5;
    for (std::size_t i = 0; i < n; ++i) {
        std::vector<double> more = result.control_points, less = more;
        more[i] += kStep;
        less[i] -= kStep;
        span[3][i] = (VolumeOf(ball.sphere, PointsOf(ball.embedding, more)) -
                      VolumeOf(ball.sphere, PointsOf(ball.embedding, less))) /
                     (2 * kStep);
    }
    std::vector<double> change = result.control_points;
    for (std::size_t i = 0; i < n; ++i) change[i] -= ball.lattice.positions[i];
    const double length = std::sqrt(std::inner_product(change.begin(), change.end(), change.begin(), 0.0));
    std::vector<std::vector<double>> gram(4, std::vector<double>(4));
    std::vector<double> right(4);
    for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 0; b < 4; ++b) {
            gram[a][b] = std::inner_product(span[a].begin(), span[a].end(), span[b].begin(), 0.0);
        }
        right[a] = std::inner_product(span[a].begin(), span[a].end(), change.begin(), 0.0);
    }
    const std::vector<double> y = SolveDense(gram, right);
    for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t i = 0; i < n; ++i) change[i] -= y[a] * span[a][i];
    }
    // Steps end when the volume holds to 1e-10; changes are then settled to about its square root.
    EXPECT_LT(std::sqrt(std::inner_product(change.begin(), change.end(), change.begin(), 0.0)), 1e-5 * length);
}

TEST(PreservedVolume, LockedControlPointsKeepTheirBits) {
    const Ball ball;
    const std::vector<Index> locked = {0, 1, 2, 3, 4, 5};
    DragOptions options = ball.KeepVolume();
    options.locked = locked;
    const DragTarget target = TargetBeside(ball.sphere.points, 3, {.2, .1, 0});
    const DragResult result = Drag(ball.embedding, ball.lattice.positions, std::vector{target}, options);
    EXPECT_TRUE(result.is_consistent);
    for (std::size_t i = 0; i < 18; ++i) EXPECT_EQ(result.control_points[i], ball.lattice.positions[i]);
}

TEST(PreservedVolume, ThatTargetsLeaveNoWayToKeepIsReported) {
    const Ball ball;
    std::vector<DragTarget> targets;
    for (Index p = 0; p < ball.sphere.n_points(); ++p) {  // the whole sphere twice as large
        const double* x = &ball.sphere.points[3 * static_cast<std::size_t>(p)];
        targets.push_back(TargetBeside(ball.sphere.points, p, {x[0], x[1], x[2]}));
    }
    const DragResult result = Drag(ball.embedding, ball.lattice.positions, targets, ball.KeepVolume());
    EXPECT_FALSE(result.is_consistent);
}

TEST(TransposedEmbedding, IsTheTransposeOfItsRows) {
    for (const LatticeCase& c : LatticeCases()) {
        for (bool limit : {false, true}) {
            const Index n = limit ? FewerIfSanitized(20) : 300;
            const std::vector<double> points = PointsAround(c.lattice, n, 1);
            const auto embedding = Embedding::Create(c.lattice.View(), c.lattice.positions, points,
                                                     {.scheme = c.scheme, .levels = 1, .limit = limit});
            std::vector<Index> all(static_cast<std::size_t>(n));
            std::iota(all.begin(), all.end(), 0);
            const Far::StencilRows<double> rows = embedding.ControlRows(all);
            const std::vector<double> triples = Moved(std::vector<double>(points.size()), 1, 2);
            std::vector<double> expected(c.lattice.positions.size());
            for (Index p : all) {
                for (std::size_t k = 0; k < rows.Indices(p).size(); ++k) {
                    for (std::size_t axis = 0; axis < 3; ++axis) {
                        expected[3 * static_cast<std::size_t>(rows.Indices(p)[k]) + axis] +=
                            rows.Weights(p)[k] * triples[3 * static_cast<std::size_t>(p) + axis];
                    }
                }
            }
            // Sums of hundreds of numbers, some of cells carried on beyond their border by their own size.
            EXPECT_LT(Distance(Internal::ApplyTransposed(embedding.tables(), triples), expected), 1e-12) << c.name;
        }
    }
}

}  // namespace
}  // namespace SolidSubdiv::Deform

// SPDX-License-Identifier: Apache-2.0
// Known answers: what was made from control points is found again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/sdc/parallel.h>

#include "apps/fit/fit_testing.h"
#include "sanitized.h"

namespace SolidSubdiv::Fit {
namespace {

using testing::HasSubstr;

struct Case {
    std::string name;
    ControlMesh mesh;
    Sdc::Scheme scheme;
};

std::vector<Case> Cases() {
    return {{"hexes", BulgedHexes(3), Sdc::CatmullClarkSolid{}},
            {"tets", BulgedTets(3), Sdc::BoxSpline{}},
            {"loop", SphereCage(2), Sdc::Loop{}},
            {"modified butterfly", SphereCage(2), Sdc::ModifiedButterfly{}}};
}

TEST(FitControlPoints, AffineImagesAreMetHoweverFairItMustBe) {
    const auto affine = [](std::array<double, 3> p) {
        return std::array<double, 3>{0.9 * p[0] + 0.1 * p[1] + 0.02, 1.1 * p[1] - 0.05 * p[2],
                                     p[2] + 0.1 * p[0] - 0.03};
    };
    for (const Case& c : Cases()) {
        SCOPED_TRACE(c.name);
        Problem problem = MakeProblem(c.mesh, c.scheme, {}, 4);
        problem.partners = problem.surface.Positions(problem.control);
        Map(problem.partners, affine);
        std::vector<double> wanted = problem.control;
        Map(wanted, affine);
        const Result result = FitControlPoints(
            problem, {.max_rounds = 30, .fairness = 10, .least_fairness = 10, .barrier = 1, .least_change = 0});
        EXPECT_LT(LargestDifference(problem, result.control, wanted), 1e-7);
        // Points inside follow as well: fairness is 0 there too.
        for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(result.control[i], wanted[i], 1e-5);
    }
}

TEST(FitControlPoints, ALatticeCarriesAModelToItsAffineImage) {
    SOLIDSUBDIV_LONG_TEST();
    const ControlMesh model = SphereCage(3);
    const TargetSurface view{.positions = model.positions, .triangles = model.triangles};
    Surface target{model.positions, model.triangles};
    Map(target.positions, [](std::array<double, 3> p) {
        return std::array<double, 3>{1.1 * p[0] + 0.1 * p[1] + 0.05, 0.9 * p[1], p[2] - 0.1 * p[0]};
    });
    const ControlMesh lattice = MakeBoxLattice(model.positions, 300);
    for (const Sdc::Scheme& scheme : {Sdc::Scheme(Sdc::CatmullClarkSolid{}), Sdc::Scheme(Sdc::LinearSolid{})}) {
        SCOPED_TRACE(Sdc::NameOf(scheme));
        Problem problem = MakeLatticeProblem(lattice, scheme, view, target.View());
        // With known partners to round-off, without fairness being in the way.
        Problem with_partners = problem;
        with_partners.partners = target.positions;
        const Result known = FitControlPoints(with_partners, {.fairness = 1, .least_fairness = 1, .least_change = 0});
        EXPECT_LT(known.rounds.back().surface_rms, 1e-9);
        // A sphere slides in itself: only the shape is found without.
        const Result free = FitControlPoints(problem, {.max_rounds = 30});
        EXPECT_LT(free.to_target.rms, 1e-3);
        EXPECT_LT(free.from_target.rms, 1e-3);
        EXPECT_EQ(free.n_folded, 0);
    }
}

TEST(FitControlPoints, ModelsMustLieInTheirLattice) {
    const ControlMesh model = SphereCage(2);
    ControlMesh lattice = MakeBoxLattice(model.positions, 100);
    for (double& x : lattice.positions) x *= 0.25;
    EXPECT_THAT(ErrorOf([&] {
                    MakeLatticeProblem(lattice, Sdc::CatmullClarkSolid{},
                                       {.positions = model.positions, .triangles = model.triangles}, {});
                }),
                HasSubstr("outside the lattice"));
}

TEST(MakeBoxLattice, HasAboutSoManyPointsAndHoldsTheBox) {
    const std::vector<double> points = {0, 0, 0, 3, 1, 2};
    for (Index n : {64, 200, 1000}) {
        const ControlMesh lattice = MakeBoxLattice(points, n);
        EXPECT_LE(lattice.n_vertices(), n);
        EXPECT_GT(lattice.n_vertices(), n / 3);
        const Geometry::Box box = Geometry::BoundingBox(lattice.positions);
        const double size = lattice.positions[3] - lattice.positions[0];
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_LE(box.low[c], points[c] - size + 1e-12);
            EXPECT_GE(box.high[c], points[3 + c] + size - 1e-12);
        }
        Problem problem = MakeProblem(lattice, Sdc::LinearSolid{}, {}, 1);
        problem.partners = problem.surface.Positions(problem.control);  // nothing moves
        EXPECT_EQ(FitControlPoints(problem, {.max_rounds = 1}).n_folded, 0);
    }
    EXPECT_THAT(ErrorOf([] { MakeBoxLattice({}, 100); }), HasSubstr("no points"));
    EXPECT_THAT(ErrorOf([&] { MakeBoxLattice(points, 10); }), HasSubstr("n_control"));
    EXPECT_THAT(ErrorOf([] { MakeBoxLattice(std::vector<double>{1, 1, 1}, 100); }), HasSubstr("all points are one"));
}

TEST(FitControlPoints, FewPointsWithNormalsGiveABetterShape) {
    SOLIDSUBDIV_LONG_TEST();
    // Forty points of an ellipsoid leave much open between them.
    const ControlMesh start = SphereCage(2);
    const std::array<double, 3> axes{1, 0.7, 0.5};
    Surface truth = SurfaceOf(MakeProblem(start, Sdc::LinearSurface{}, {}, 8));
    const std::size_t n = truth.positions.size() / 3, step = n / 40;
    std::vector<double> points, normals;
    for (std::size_t v = 0; v < n; ++v) {
        double* const p = &truth.positions[3 * v];
        const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        std::array<double, 3> normal{};
        double size = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            normal[c] = p[c] / (length * axes[c]);
            p[c] *= axes[c] / length;
            size += normal[c] * normal[c];
        }
        if (v % step != 0) continue;
        points.insert(points.end(), p, p + 3);
        for (double x : normal) normals.push_back(x / std::sqrt(size));
    }
    const Problem problem =
        MakeProblem(start, Sdc::Loop{}, {.positions = points, .triangles = {}, .normals = normals}, 3, 0, true);
    const auto error_with = [&](double weight) {
        const Result result = FitControlPoints(problem, {.normals = weight});
        const Geometry::ClosestPoints on_truth(truth.positions, truth.triangles);
        return MeasureDistance(result.vertices, problem.surface.triangles, on_truth).rms;
    };
    EXPECT_LT(error_with(1e-4), 0.8 * error_with(0));
    EXPECT_THAT(ErrorOf([&] { FitControlPoints(MakeProblem(start, Sdc::Loop{}, truth.View()), {.normals = 1}); }),
                HasSubstr("no tangents"));
}

TEST(FitControlPoints, SpringsPlaceWhatNothingElseReaches) {
    // The middle of eight cells is in no row of the surface.
    ControlMesh start = BulgedHexes(2);
    const Problem good = MakeProblem(start, Sdc::CatmullClarkSolid{}, {}, 2);
    const Surface own = SurfaceOf(good);
    const std::size_t middle = 13;
    ASSERT_FALSE(IsSeen(good)[middle]);
    start.positions[3 * middle] += 0.1;
    Problem problem = MakeProblem(start, Sdc::CatmullClarkSolid{}, own.View(), 2);
    problem.partners = own.positions;
    const Result result = FitControlPoints(problem, {.fairness = 0, .least_fairness = 0, .barrier = 0, .spring = 0.1});
    for (std::size_t c = 0; c < 3; ++c) {
        double mean = 0;
        for (Index p : problem.neighbors[middle])
            mean += result.control[3 * static_cast<std::size_t>(p) + c] /
                    static_cast<double>(problem.neighbors[middle].size());
        // Steps end when the sum changes by 1e-7 of itself: at its flat bottom that is some 1e-4 of the way there.
        EXPECT_NEAR(result.control[3 * middle + c], mean, 1e-4);
    }
}

TEST(FitControlPoints, UnitsDoNotMatter) {
    const Case c = Cases()[0];
    Problem problem = MakeProblem(c.mesh, c.scheme, {}, 3);
    Surface target = SurfaceOf(problem);
    Shake(problem.control, 0.01, 3);
    problem.target = target.View();
    const Options options{.max_rounds = 5};
    const Result once = FitControlPoints(problem, options);
    for (const double unit : {0x1p-30, 0x1p30}) {  // powers of 2: no rounding
        Problem scaled = problem;
        Surface scaled_target = target;
        for (double& x : scaled_target.positions) x *= unit;
        for (double& x : scaled.control) x *= unit;
        scaled.target = scaled_target.View();
        const Result result = FitControlPoints(scaled, options);
        for (std::size_t i = 0; i < once.control.size(); ++i) {
            EXPECT_NEAR(result.control[i] / unit, once.control[i], 1e-9) << unit;
        }
        EXPECT_NEAR(result.to_target.rms / unit, once.to_target.rms, 1e-9);
    }
}

TEST(FitControlPoints, LockedPointsStayAndMirroredOnesMirror) {
    Problem problem = MakeProblem(SphereCage(2), Sdc::Loop{}, {}, 3);
    Surface target = SurfaceOf(problem);
    Map(target.positions, [](std::array<double, 3> p) {
        return std::array<double, 3>{1.2 * p[0], p[1] + 0.1 * p[0] * p[0], 0.9 * p[2]};
    });
    problem.target = target.View();
    problem.locked = {0, 7};
    const std::size_t n = problem.control.size() / 3;
    for (Index a = 0; a < static_cast<Index>(n); ++a) {
        for (Index b = a; b < static_cast<Index>(n); ++b) {
            const double* p = &problem.control[3 * static_cast<std::size_t>(a)];
            const double* q = &problem.control[3 * static_cast<std::size_t>(b)];
            if (std::abs(p[0] + q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]) < 1e-12) {
                problem.mirrored.push_back({a, b});
            }
        }
    }
    ASSERT_GT(problem.mirrored.size(), n / 2);
    const Result result = FitControlPoints(problem, {.max_rounds = 10});
    for (Index p : problem.locked) {
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_EQ(result.control[3 * static_cast<std::size_t>(p) + c],
                      problem.control[3 * static_cast<std::size_t>(p) + c]);
        }
    }
    for (const auto& [a, b] : problem.mirrored) {
        if (a == 0 || b == 0 || a == 7 || b == 7) continue;
        const double* p = &result.control[3 * static_cast<std::size_t>(a)];
        const double* q = &result.control[3 * static_cast<std::size_t>(b)];
        EXPECT_NEAR(p[0], -q[0], 1e-12);
        EXPECT_NEAR(p[1], q[1], 1e-12);
        EXPECT_NEAR(p[2], q[2], 1e-12);
    }
    EXPECT_LT(result.to_target.rms, 0.05);
}

TEST(FitControlPoints, TheBarrierKeepsCellsPositive) {
    // Squeezed to a tenth on one side: without it cells there turn over.
    Problem problem = MakeProblem(BulgedHexes(3), Sdc::CatmullClarkSolid{}, {}, 3);
    Surface target = SurfaceOf(problem);
    Map(target.positions, [](std::array<double, 3> p) {
        return std::array<double, 3>{p[0], p[1], p[2] * (p[0] > 0.5 ? 0.1 : 1.0)};
    });
    problem.target = target.View();
    const Result free = FitControlPoints(problem, {.max_rounds = 20, .least_fairness = 1e-7, .barrier = 0});
    const Result kept = FitControlPoints(problem, {.max_rounds = 100, .least_fairness = 1e-7});
    EXPECT_GT(free.n_folded, 0);
    EXPECT_EQ(kept.n_folded, 0);
}

TEST(FitControlPoints, PlacesOverControlPointsAreKeptFromFolding) {
    // A tet whose apex is drawn through its base; its own corner is no concern of the barrier, but its middles' is.
    ControlMesh tet{.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, .tets = {0, 1, 2, 3}};
    Problem problem = MakeProblem(tet, Sdc::LinearSolid{}, {}, 1);
    problem.partners = problem.surface.Positions(problem.control);
    for (std::size_t v = 0; v < problem.partners.size(); v += 3) problem.partners[v + 2] *= -0.5;
    problem.corners.clear();
    const Options options{.max_rounds = 30, .fairness = 0, .least_fairness = 0, .barrier = 1};
    EXPECT_LT(FitControlPoints(problem, options).control[11], 0);
    // Half-way from the first corner to each of the four.
    problem.fine_places.n_sources = 4;
    for (Index k = 0; k < 4; ++k) {
        for (Index p : {0, k}) {
            problem.fine_places.indices.push_back(p);
            problem.fine_places.weights.push_back(0.5);
        }
        problem.fine_places.offsets.push_back(2 * (k + 1));
    }
    problem.fine_corners = {{0, 1, 2, 3}};
    EXPECT_GT(FitControlPoints(problem, options).control[11], 0);
}

TEST(FitControlPoints, ThreadsChangeNothing) {
    const Case c = Cases()[0];
    Problem problem = MakeProblem(c.mesh, c.scheme, {}, 3);
    const Surface target = SurfaceOf(problem);
    problem.target = target.View();
    Shake(problem.control, 0.01, 4);
    std::vector<std::vector<double>> results;
    for (int n : {1, 1, 2, 3}) {
        const Sdc::ThreadLimit limit(n);
        results.push_back(FitControlPoints(problem, {.max_rounds = 8}).control);
    }
    for (const auto& result : results) EXPECT_EQ(result, results[0]);
}

TEST(FitControlPoints, StopsWhenToldTo) {
    Problem problem = MakeProblem(SphereCage(1), Sdc::Loop{}, {}, 3);
    const Surface target = SurfaceOf(problem);
    problem.target = target.View();
    EXPECT_EQ(FitControlPoints(problem, {.tolerance = 1e-9}).stopped, "tolerance");
    Shake(problem.control, 0.02, 5);
    EXPECT_EQ(FitControlPoints(problem, {.max_rounds = 3}).stopped, "rounds");
    int calls = 0;
    const Result result =
        FitControlPoints(problem, {.progress = [&](std::string_view, double) { return ++calls < 3; }});
    EXPECT_EQ(result.stopped, "cancelled");
    EXPECT_EQ(result.rounds.size(), 2u);
    EXPECT_NE(result.control, problem.control);
}

TEST(FitControlPoints, WhatMakesNoSenseIsRefused) {
    const Problem good = MakeProblem(SphereCage(1), Sdc::Loop{}, {}, 2);
    const auto error_of = [&](auto&& spoil) {
        Problem problem = good;
        const Surface target = SurfaceOf(good);
        problem.target = target.View();
        Options options{.max_rounds = 1};
        spoil(problem, options);
        return ErrorOf([&] { FitControlPoints(problem, options); });
    };
    EXPECT_EQ(error_of([](Problem&, Options&) {}), "no error");
    EXPECT_THAT(error_of([](Problem& p, Options&) { p.target = {}; }), HasSubstr("target is empty"));
    EXPECT_THAT(error_of([](Problem& p, Options&) {
                    static const std::vector<Index> unknown{0, 1, 999};
                    p.target.triangles = unknown;
                }),
                HasSubstr("names point 999"));
    EXPECT_THAT(error_of([](Problem& p, Options&) {
                    static const std::vector<double> one{0, 0, 1};
                    p.target.normals = one;
                }),
                HasSubstr("1 normals for"));
    EXPECT_THAT(error_of([](Problem& p, Options&) { p.control[4] = NAN; }), HasSubstr("not finite"));
    EXPECT_THAT(error_of([](Problem& p, Options&) { p.control.resize(9); }), HasSubstr("control points"));
    EXPECT_THAT(error_of([](Problem& p, Options&) { p.locked = {99}; }), HasSubstr("locked names control point 99"));
    EXPECT_THAT(error_of([](Problem& p, Options&) { p.partners.resize(9); }), HasSubstr("3 partners"));
    EXPECT_THAT(error_of([](Problem& p, Options&) {
                    p.fine_corners = {{0, 1, 2, 3}};
                }),
                HasSubstr("a fine corner names place 0"));
    EXPECT_THAT(error_of([](Problem& p, Options&) { p.mirror_axis = 3; }), HasSubstr("mirror_axis"));
    EXPECT_THAT(error_of([](Problem&, Options& o) { o.fairness = -1; }), HasSubstr("fairness"));
    EXPECT_THAT(error_of([](Problem&, Options& o) { o.across = 2; }), HasSubstr("across"));
    // A target that is inside out has no point that looks the same way.
    EXPECT_THAT(error_of([](Problem& p, Options&) {
                    static std::vector<Index> turned;
                    turned.assign(p.target.triangles.begin(), p.target.triangles.end());
                    for (std::size_t t = 0; t < turned.size(); t += 3) std::swap(turned[t], turned[t + 1]);
                    p.target.triangles = turned;
                }),
                HasSubstr("look away"));
}

}  // namespace
}  // namespace SolidSubdiv::Fit

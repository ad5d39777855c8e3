// SPDX-License-Identifier: Apache-2.0
// Undo and redo restore bits; a lattice that encloses everything carries everything.
#include <solidsubdiv/apps/deform/editing_session.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <numeric>
#include <set>

#include "apps/deform/deform_testing.h"
#include "apps/deform/editing_testing.h"

namespace SolidSubdiv::Deform {
namespace {

using TestShapes::Copy;
using TestShapes::Hierarchy;
using TestShapes::NearSphere;
using TestShapes::Sphere;

/// A sphere in three levels of cells around it, shrunk a little, and a lattice around it all.
struct Scene {
    Hierarchy hierarchy{2, 3, NearSphere{2, .7}};
    Sphere sphere{6, .7};
    ControlLattice box;

    Scene() : box(Hierarchy(2, 1).lattices[0]) {
        for (std::size_t i = 1; i < 3; ++i) {
            hierarchy.lattices[i].positions = Moved(hierarchy.lattices[i].positions, .02, i);
        }
        for (double& x : box.positions) x *= 3;
    }
    EditingSession Session(const SessionOptions& options = {}) const {
        return {hierarchy.Levels(), sphere.points, TestShapes::FacesOf(sphere), options};
    }
};

void MoveSome(EditingSession& session, int n, std::uint64_t seed) {
    TestShapes::Random random(seed);
    std::vector<Index> which;
    std::vector<double> to;
    for (int i = 0; i < n; ++i) {
        which.push_back(random.Below(static_cast<int>(session.control_points().size() / 3)));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            to.push_back(session.control_points()[3 * static_cast<std::size_t>(which.back()) + axis] +
                         .2 * random.Uniform());
        }
    }
    session.Move(which, to);
}

void MoveAll(EditingSession& session, const std::vector<double>& to) {
    std::vector<Index> all(to.size() / 3);
    std::iota(all.begin(), all.end(), 0);
    session.Move(all, to);
}

/// All that can be seen of a session.
struct View {
    int level;
    bool is_enclosed;
    std::vector<double> points, normals, correction, current;
    std::vector<std::vector<double>> control_points;

    explicit View(const EditingSession& session)
        : level(session.level()),
          is_enclosed(session.is_enclosed()),
          points(Copy(session.points())),
          normals(Copy(session.normals())),
          correction(Copy(session.correction())),
          current(Copy(session.control_points())) {
        for (int i = 0; i < session.n_levels(); ++i) control_points.push_back(session.ControlPoints(i));
    }
    bool operator==(const View&) const = default;
};

/// Changes of every kind, a step each.
std::vector<std::function<void(EditingSession&)>> Steps(const Scene& scene) {
    const auto move = [](int n, std::uint64_t seed) { return [=](EditingSession& s) { MoveSome(s, n, seed); }; };
    const auto to = [](int level) { return [=](EditingSession& s) { s.SetLevel(level); }; };
    const auto enclose = [&](EditingSession& s) { s.Enclose(scene.box, {}); };
    const auto drag = [](EditingSession& s) {
        s.BeginStep();
        for (std::uint64_t i = 0; i < 5; ++i) MoveSome(s, 2, i % 3);
        s.EndStep();
    };
    const auto all_at_once = [&](EditingSession& s) {
        s.BeginStep();
        MoveSome(s, 3, 1);
        s.SetLevel(1);
        MoveSome(s, 3, 2);
        s.Enclose(scene.box, {});
        MoveSome(s, 3, 3);
        s.SetLevel(2);
        MoveSome(s, 3, 4);
        s.SetLevel(1);
        MoveSome(s, 3, 5);
        s.EndStep();
    };
    return {move(3, 1), to(2),      move(1, 2),  move(9, 3), drag,        to(0),      move(5, 4),
            enclose,    move(4, 5), drag,        to(1),      move(1, 6),  enclose,    move(2, 7),
            enclose,    move(2, 8), to(2),       drag,       to(0),       move(1, 9), to(1),
            to(2),      move(3, 1), all_at_once, move(2, 2), all_at_once, to(0)};
}

TEST(EditingUndo, UndoAndRedoRestoreBits) {
    const Scene scene;
    EditingSession session = scene.Session();
    std::vector<View> views{View(session)};
    for (const auto& step : Steps(scene)) {
        step(session);
        views.emplace_back(session);
        EXPECT_NE(views.back(), views[views.size() - 2]);
    }
    for (int round = 0; round < 2; ++round) {
        for (std::size_t i = views.size() - 1; i > 0; --i) {
            ASSERT_TRUE(session.CanUndo());
            session.Undo();
            EXPECT_EQ(View(session), views[i - 1]) << "undone step " << i;
        }
        EXPECT_FALSE(session.CanUndo());
        EXPECT_TRUE(session.Undo().points.empty());
        for (std::size_t i = 1; i < views.size(); ++i) {
            ASSERT_TRUE(session.CanRedo());
            session.Redo();
            EXPECT_EQ(View(session), views[i]) << "redone step " << i;
        }
        EXPECT_FALSE(session.CanRedo());
        EXPECT_TRUE(session.Redo().points.empty());
    }
}

TEST(EditingUndo, WhatFollowsAnUndoIsAsIfNothingHadBeenUndone) {
    const Scene scene;
    EditingSession direct = scene.Session(), detour = scene.Session();
    const auto steps = Steps(scene);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        steps[i](direct);
        steps[i](detour);
        const std::size_t n = std::min<std::size_t>(i % 4, i);
        for (std::size_t k = 0; k < n; ++k) detour.Undo();
        for (std::size_t k = 0; k < n; ++k) detour.Redo();
        EXPECT_EQ(View(direct), View(detour));
    }
}

TEST(EditingUndo, ReportsThePointsThatItChanges) {
    const Scene scene;
    EditingSession session = scene.Session();
    session.SetLevel(2);
    MoveSome(session, 1, 3);
    for (int i = 0; i < 4; ++i) {
        const std::vector<double> before = Copy(session.points());
        const SessionChange change = i % 2 == 0 ? session.Undo() : session.Redo();
        const std::set<Index> changed(change.points.begin(), change.points.end());
        EXPECT_GT(changed.size(), 0u);
        EXPECT_LT(changed.size(), static_cast<std::size_t>(session.n_points()) / 2);
        for (std::size_t k = 0; k < before.size(); ++k) {
            EXPECT_TRUE(changed.contains(static_cast<Index>(k / 3)) || session.points()[k] == before[k]) << k / 3;
        }
    }
}

TEST(EditingUndo, ADragIsOneStepOfTheSizeOfItsFirstMove) {
    const Scene scene;
    EditingSession session = scene.Session();
    session.SetLevel(2);
    const View before(session);
    const Offset empty = session.UndoBytes();
    session.Move({5}, {1, 1, 1});
    const Offset one = session.UndoBytes() - empty;
    session.Undo();
    session.BeginStep();
    for (int i = 0; i < 1000; ++i) session.Move({5}, {1, 1, 1 + .001 * i});
    session.EndStep();
    EXPECT_EQ(session.UndoBytes() - empty, one);
    session.Undo();
    EXPECT_EQ(View(session), before);
}

TEST(EditingUndo, AMoveKeepsNoMoreThanTheHeaderSays) {
    const Scene scene;
    EditingSession session = scene.Session();
    session.SetLevel(2);
    const auto bytes_of = [&](int n) {
        const Offset before = session.UndoBytes();
        std::vector<Index> which(static_cast<std::size_t>(n));
        std::iota(which.begin(), which.end(), 0);
        session.Move(which, std::vector<double>(3 * which.size(), 1));
        return session.UndoBytes() - before;
    };
    EXPECT_EQ(bytes_of(101) - bytes_of(1), 100 * 56);
}

TEST(EditingUndo, AChangeForgetsWhatCouldBeRedone) {
    const Scene scene;
    EditingSession session = scene.Session();
    session.Move({0}, {-2, -1, -1});
    session.Undo();
    EXPECT_TRUE(session.CanRedo());
    session.SetLevel(0);  // the level it has: no change
    session.BeginStep();
    session.EndStep();
    EXPECT_TRUE(session.CanRedo());
    session.Move({1}, {0, 0, 0});
    EXPECT_FALSE(session.CanRedo());
}

TEST(EditingUndo, ForgetsOldStepsBeyondItsDepth) {
    const Scene scene;
    EditingSession session = scene.Session({.max_undo_steps = 3});
    for (int i = 0; i < 5; ++i) session.Move({0}, {0, 0, .1 * i});
    for (int i = 0; i < 3; ++i) session.Undo();
    EXPECT_FALSE(session.CanUndo());
    EXPECT_EQ(session.control_points()[2], .1 * 1);
    EditingSession without = scene.Session({.max_undo_steps = 0});
    without.Move({0}, {0, 0, 0});
    EXPECT_FALSE(without.CanUndo());
}

TEST(EditingUndo, OpenStepsAreEndedFirst) {
    const Scene scene;
    EditingSession session = scene.Session();
    EXPECT_THROW(session.EndStep(), InvalidInput);
    session.Move({0}, {0, 0, 0});
    session.BeginStep();
    EXPECT_THROW(session.BeginStep(), InvalidInput);
    EXPECT_THROW(session.Undo(), InvalidInput);
    EXPECT_THROW(session.Redo(), InvalidInput);
    session.EndStep();
    session.Undo();
    EXPECT_EQ(Copy(session.control_points()), scene.hierarchy.lattices[0].positions);
}

TEST(EditingEnclosure, AffineMapsOfTheEnclosingLatticeMapModelAndLatticesAffinely) {
    const Scene scene;
    EditingSession session = scene.Session();
    MoveSome(session, 3, 1);
    session.SetLevel(2);
    MoveSome(session, 9, 2);
    session.SetLevel(0);
    MoveSome(session, 3, 3);  // finer lattices have yet to follow
    const View before(session);
    session.Enclose(scene.box, {});
    EXPECT_TRUE(session.is_enclosed());
    EXPECT_TRUE(session.embedding().outside().empty());
    const auto expect = [&](const View& now, auto&& map) {
        // Sums of some dozens of numbers below 10.
        EXPECT_LT(Distance(now.points, map(before.points)), 1e-13);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_LT(Distance(now.control_points[i], map(before.control_points[i])), 1e-13);
        }
    };
    expect(View(session), [](const auto& x) { return x; });
    MoveAll(session, Affine(scene.box.positions));
    expect(View(session), [](const auto& x) { return Affine(x); });
    const View enclosed(session);
    session.SetLevel(2);
    EXPECT_FALSE(session.is_enclosed());
    EXPECT_EQ(View(session).control_points, enclosed.control_points);
    EXPECT_LT(Distance(View(session).points, enclosed.points), 1e-15 * 8);

    // Editing goes on: fine moves are local, coarse ones carry the fine lattice with its details.
    const SessionChange change = session.Move({0}, {0, 0, 0});
    EXPECT_GT(change.points.size(), 0u);
    EXPECT_LT(change.points.size(), static_cast<std::size_t>(session.n_points()) / 2);
    const View edited(session);
    session.SetLevel(0);
    std::vector<double> shifted = Copy(session.control_points());
    for (double& x : shifted) x += 1;
    MoveAll(session, shifted);
    for (std::size_t i = 0; i < edited.points.size(); ++i) {
        EXPECT_NEAR(session.points()[i], edited.points[i] + 1, 1e-13);
    }
    const std::vector<double> fine = session.ControlPoints(2);
    for (std::size_t i = 0; i < fine.size(); ++i) EXPECT_NEAR(fine[i], edited.control_points[2][i] + 1, 1e-13);
}

TEST(EditingEnclosure, CarriesModelAndLatticesByOneMap) {
    // A control point of the fine lattice that is a point of the model as well stays on it, however the box is moved.
    Scene scene;
    scene.sphere.points.assign(scene.hierarchy.lattices[2].positions.begin(),
                               scene.hierarchy.lattices[2].positions.end());
    EditingSession session(scene.hierarchy.Levels(), scene.sphere.points);
    session.Enclose(scene.box, {});
    MoveSome(session, 20, 1);
    EXPECT_GT(Distance(Copy(session.points()), scene.sphere.points), .05);
    EXPECT_LT(Distance(Copy(session.points()), session.ControlPoints(2)), 1e-15);
    session.SetLevel(2);
    EXPECT_LT(Distance(Copy(session.points()), Copy(session.control_points())), 1e-15);
}

TEST(EditingEnclosure, WhatLiesOutsideFollowsWithAnInfiniteFalloff) {
    const Scene scene;
    EditingSession session = scene.Session();
    ControlLattice small = scene.box;
    for (double& x : small.positions) x /= 4;  // to 3/4: the model is inside, the lattices are not
    const View before(session);
    session.Enclose(small, {.falloff = std::numeric_limits<double>::infinity()});
    ASSERT_FALSE(session.embedding().outside().empty());
    EXPECT_GE(session.embedding().outside().front().point, session.n_points());
    MoveAll(session, Affine(small.positions));
    for (std::size_t i = 0; i < 3; ++i) {
        // Cells carried on beyond their border multiply rounding by about the distance in cells, below 10.
        EXPECT_LT(Distance(session.ControlPoints(static_cast<int>(i)), Affine(before.control_points[i])), 1e-12);
    }
}

TEST(EditingEnclosure, ALatticeThatIsNoneChangesNothing) {
    const Scene scene;
    EditingSession session = scene.Session();
    const View before(session);
    EXPECT_THROW(session.Enclose({}, {}), InvalidInput);
    ControlLattice bad = scene.box;
    bad.positions[0] = NAN;
    EXPECT_THROW(session.Enclose(bad, {}), InvalidInput);
    EXPECT_EQ(View(session), before);
    EXPECT_FALSE(session.CanUndo());
}

}  // namespace
}  // namespace SolidSubdiv::Deform

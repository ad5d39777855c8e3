// SPDX-License-Identifier: Apache-2.0
// Laws of editing sessions: no jumps, details that stay, and what is recomputed is what everything would be.
#include <solidsubdiv/apps/deform/editing_session.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include <solidsubdiv/apps/deform/deformer.h>
#include <solidsubdiv/apps/deform/vertex_normals.h>

#include "apps/deform/deform_testing.h"
#include "apps/deform/editing_testing.h"

namespace SolidSubdiv::Deform {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using TestShapes::Copy;
using TestShapes::Hierarchy;
using TestShapes::NearSphere;
using TestShapes::Sphere;

/// A sphere in three levels of cells around it; `amount` of shrinking makes details from the start.
struct Scene {
    Hierarchy hierarchy{2, 3, NearSphere{2, .7}};
    Sphere sphere{8, .7};
    EditingSession session;

    explicit Scene(double amount = 0) : session(Make(amount)) {}
    EditingSession Make(double amount) {
        for (std::size_t i = 1; i < 3; ++i) {
            hierarchy.lattices[i].positions = Moved(hierarchy.lattices[i].positions, amount, i);
        }
        return {hierarchy.Levels(), sphere.points, TestShapes::FacesOf(sphere)};
    }
    /// Moves some control points of the current lattice.
    SessionChange MoveSome(int n, double amount, std::uint64_t seed) {
        TestShapes::Random random(seed);
        const auto all = session.control_points();
        std::vector<Index> which;
        std::vector<double> to;
        for (int i = 0; i < n; ++i) {
            which.push_back(random.Below(static_cast<int>(all.size() / 3)));
            for (std::size_t axis = 0; axis < 3; ++axis) {
                to.push_back(all[3 * static_cast<std::size_t>(which.back()) + axis] + amount * random.Uniform());
            }
        }
        return session.Move(which, to);
    }
};

/// O(coarse), the plain way.
std::vector<double> ByOctreeRule(const Far::StencilRows<double>& rule, const std::vector<double>& coarse) {
    std::vector<double> fine(3 * static_cast<std::size_t>(rule.n_rows()));
    for (Index row = 0; row < rule.n_rows(); ++row) {
        for (std::size_t k = 0; k < rule.Indices(row).size(); ++k) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                fine[3 * static_cast<std::size_t>(row) + axis] +=
                    rule.Weights(row)[k] * coarse[3 * static_cast<std::size_t>(rule.Indices(row)[k]) + axis];
            }
        }
    }
    return fine;
}

std::vector<double> Difference(std::vector<double> a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
    return a;
}

std::vector<double> MadeAnew(const EditingSession& session) {
    Deformer deformer(session.embedding());
    std::vector<double> points(session.correction().size());
    deformer.Deform(session.control_points(), points);
    for (std::size_t i = 0; i < points.size(); ++i) points[i] += session.correction()[i];
    points.resize(session.points().size());
    return points;
}

TEST(EditingSession, BeginsWithTheModelAsItIs) {
    const Scene scene(.02);
    EXPECT_EQ(scene.session.level(), 0);
    EXPECT_LT(Distance(Copy(scene.session.points()), scene.sphere.points), 1e-15);  // one sum, of numbers below 1
    for (int i = 0; i < 3; ++i) EXPECT_EQ(scene.session.ControlPoints(i), scene.hierarchy.lattices[i].positions);
}

TEST(EditingSession, ChangesOfLevelMoveNoPoint) {
    for (double shrinking : {0.0, .02}) {
        Scene scene(shrinking);
        std::uint64_t seed = 0;
        for (int level : {0, 1, 2, 0, 2, 1, 0, 1}) {
            const std::vector<double> before = Copy(scene.session.points());
            scene.session.SetLevel(level);
            EXPECT_EQ(scene.session.level(), level);
            // The law asks for 1e-10 of the size; a difference and a sum of numbers below 4 leave this.
            EXPECT_LT(Distance(Copy(scene.session.points()), before), 1e-15);
            scene.MoveSome(20, .2, ++seed);
            EXPECT_GT(Distance(Copy(scene.session.points()), before), 1e-3);
        }
    }
}

TEST(EditingSession, ChangesOfLevelWouldMovePointsWithoutTheCorrection) {
    Scene scene;
    scene.MoveSome(20, .3, 1);
    const std::vector<double> before = Copy(scene.session.points());
    scene.session.SetLevel(1);
    const std::vector<double> planted = Difference(Copy(scene.session.points()), Copy(scene.session.correction()));
    EXPECT_GT(Distance(planted, before), 1e-2);  // the octree rule is not that of Catmull and Clark
}

TEST(EditingSession, DownAndUpAgainRestoresControlPoints) {
    Scene scene(.02);
    scene.MoveSome(9, .7, 1);  // far enough for details to be rounded
    scene.session.SetLevel(2);
    scene.MoveSome(90, .7, 2);
    const std::vector<double> fine = Copy(scene.session.control_points());
    const std::vector<double> middle = scene.session.ControlPoints(1), coarse = scene.session.ControlPoints(0);
    for (int level : {0, 1, 0, 2}) scene.session.SetLevel(level);
    EXPECT_EQ(Copy(scene.session.control_points()), fine);
    EXPECT_EQ(scene.session.ControlPoints(1), middle);
    EXPECT_EQ(scene.session.ControlPoints(0), coarse);
}

TEST(EditingSession, CoarseMovesCarryFineDetails) {
    Scene scene(.02);
    scene.session.SetLevel(2);
    scene.MoveSome(30, .1, 1);
    const auto& rules = scene.hierarchy.rules;
    const auto details_of = [&](std::size_t i) {
        const int level = static_cast<int>(i);
        return Difference(scene.session.ControlPoints(level),
                          ByOctreeRule(rules[i], scene.session.ControlPoints(level - 1)));
    };
    const std::vector<double> middle = details_of(1), fine = details_of(2), before = scene.session.ControlPoints(2);
    scene.session.SetLevel(0);
    scene.MoveSome(27, .5, 2);
    // Sums of some numbers below 4.
    EXPECT_LT(Distance(details_of(1), middle), 1e-14);
    EXPECT_LT(Distance(details_of(2), fine), 1e-14);
    EXPECT_GT(Distance(scene.session.ControlPoints(2), before), .1);
    const std::vector<double> announced = scene.session.ControlPoints(2);
    scene.session.SetLevel(2);
    EXPECT_EQ(Copy(scene.session.control_points()), announced);
}

TEST(EditingSession, MovesOfAFineLevelLeaveCoarserOnes) {
    Scene scene;
    scene.session.SetLevel(2);
    const std::vector<double> coarse = scene.session.ControlPoints(0), middle = scene.session.ControlPoints(1);
    scene.MoveSome(30, .1, 1);
    EXPECT_EQ(scene.session.ControlPoints(0), coarse);
    EXPECT_EQ(scene.session.ControlPoints(1), middle);
}

TEST(EditingSession, TranslatedCoarseLatticeTranslatesAll) {
    Scene scene(.02);
    scene.session.SetLevel(2);
    scene.MoveSome(30, .1, 1);
    scene.session.SetLevel(0);
    const auto translated = [](std::vector<double> points) {
        for (std::size_t i = 0; i < points.size(); ++i) points[i] += i % 3 == 1 ? 2 : .5;
        return points;
    };
    const std::vector<double> model = Copy(scene.session.points()), fine = scene.session.ControlPoints(2);
    std::vector<Index> all(scene.session.control_points().size() / 3);
    std::iota(all.begin(), all.end(), 0);
    scene.session.Move(all, translated(Copy(scene.session.control_points())));
    // Sums of some dozens of numbers below 4.
    EXPECT_LT(Distance(Copy(scene.session.points()), translated(model)), 1e-13);
    EXPECT_LT(Distance(scene.session.ControlPoints(2), translated(fine)), 1e-14);
}

TEST(EditingSession, MovesGiveTheBitsOfEverythingMadeAnew) {
    Scene scene(.02);
    std::uint64_t seed = 0;
    for (int level : {0, 2, 1, 2}) {
        scene.session.SetLevel(level);
        for (int n : {1, 1, 3, 20, 1}) {
            scene.MoveSome(n, .2, ++seed);
            EXPECT_EQ(Copy(scene.session.points()), MadeAnew(scene.session));
            VertexNormals normals(scene.sphere.n_points(), scene.sphere.offsets, scene.sphere.triangles);
            normals.Compute(scene.session.points());
            EXPECT_EQ(Copy(scene.session.normals()), Copy(normals.normals()));
        }
    }
}

TEST(EditingSession, MovesReportWhatTheyTouchAndNothingElseChanges) {
    Scene scene;
    scene.session.SetLevel(2);
    const auto n_points = static_cast<std::size_t>(scene.sphere.n_points());
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const std::vector<double> points = Copy(scene.session.points()), normals = Copy(scene.session.normals());
        const auto n_control_points = static_cast<int>(scene.session.control_points().size() / 3);
        const Index moved = TestShapes::Random(seed).Below(n_control_points);
        const SessionChange change = scene.session.Move({moved}, {.1, .2, .3});
        std::vector<Index> touched(change.points.begin(), change.points.end());
        std::sort(touched.begin(), touched.end());
        Deformer deformer(scene.session.embedding());
        EXPECT_EQ(touched, deformer.Affected(std::vector<Index>{moved}));
        EXPECT_LT(touched.size(), n_points / 2);
        const std::set<Index> new_points(touched.begin(), touched.end());
        const std::set<Index> new_normals(change.normals.begin(), change.normals.end());
        for (std::size_t i = 0; i < 3 * n_points; ++i) {
            const auto v = static_cast<Index>(i / 3);
            EXPECT_TRUE(new_points.contains(v) || scene.session.points()[i] == points[i]) << v;
            EXPECT_TRUE(new_normals.contains(v) || scene.session.normals()[i] == normals[i]) << v;
        }
    }
}

TEST(EditingSession, OfAControlPointMovedTwiceAtOnceTheLastPositionCounts) {
    Scene once, twice;
    once.session.Move({3}, {1, 2, 3});
    twice.session.Move({3, 3}, {9, 9, 9, 1, 2, 3});
    EXPECT_EQ(Copy(once.session.points()), Copy(twice.session.points()));
    twice.session.Undo();
    EXPECT_EQ(Copy(twice.session.control_points()), twice.hierarchy.lattices[0].positions);
}

TEST(EditingSession, TakesEmbeddingsThatAreReady) {
    Scene scene;
    std::vector<SessionLevel> levels = scene.hierarchy.Levels();
    for (std::size_t i = 0; i < 3; ++i) {
        const ControlLattice& lattice = scene.hierarchy.lattices[i];
        levels[i].embedding = std::make_shared<const Embedding>(
            Embedding::Create(lattice.View(), lattice.positions, scene.sphere.points, {}));
    }
    EditingSession ready(levels, scene.sphere.points);
    EXPECT_THAT(Copy(ready.normals()), IsEmpty());
    for (int level : {0, 2}) {
        ready.SetLevel(level);
        scene.session.SetLevel(level);
        EXPECT_EQ(&ready.embedding(), levels[static_cast<std::size_t>(level)].embedding.get());
        const SessionChange change = ready.Move({0}, {-2, -2, -2});
        EXPECT_THAT(Copy(ready.normals()), IsEmpty());
        EXPECT_TRUE(change.normals.empty());
        scene.session.Move({0}, {-2, -2, -2});
        EXPECT_EQ(Copy(ready.points()), Copy(scene.session.points()));
    }
}

template <class F>
std::string RefusalOf(F&& act) {
    try {
        act();
    } catch (const InvalidInput& e) {
        return e.what();
    }
    return {};
}

TEST(EditingSession, RefusesBadMovesAndLevelsAndChangesNothing) {
    Scene scene;
    const std::vector<double> before = Copy(scene.session.points());
    EXPECT_THAT(RefusalOf([&] { scene.session.Move({27}, {0, 0, 0}); }), HasSubstr("control point 27, out of 27"));
    EXPECT_THAT(RefusalOf([&] { scene.session.Move({0, -1}, {0, 0, 0, 0, 0, 0}); }), HasSubstr("control point -1"));
    EXPECT_THAT(RefusalOf([&] { scene.session.Move({0, 5}, {0, 0, 0, 0, NAN, 0}); }), HasSubstr("point 5 to nan"));
    EXPECT_THAT(RefusalOf([&] { scene.session.Move({0}, {0, 0, INFINITY}); }), HasSubstr("point 0 to inf"));
    EXPECT_THAT(RefusalOf([&] { scene.session.Move({0}, {0, 0}); }), HasSubstr("2 coordinates"));
    EXPECT_THAT(RefusalOf([&] { scene.session.SetLevel(3); }), HasSubstr("level 3"));
    EXPECT_THAT(RefusalOf([&] { scene.session.SetLevel(-1); }), HasSubstr("level -1"));
    EXPECT_THAT(RefusalOf([&] { (void)scene.session.ControlPoints(3); }), HasSubstr("level 3"));
    EXPECT_EQ(Copy(scene.session.points()), before);
    EXPECT_EQ(Copy(scene.session.control_points()), scene.hierarchy.lattices[0].positions);
    EXPECT_FALSE(scene.session.CanUndo());
}

TEST(EditingSession, RefusesHierarchiesThatDoNotFit) {
    const Scene scene;
    const auto refusal = [&](auto&& spoil) {
        std::vector<SessionLevel> levels = scene.hierarchy.Levels();
        std::vector<double> points = scene.sphere.points;
        ModelFaces faces = TestShapes::FacesOf(scene.sphere);
        std::vector<ControlLattice> lattices = scene.hierarchy.lattices;
        for (std::size_t i = 0; i < levels.size(); ++i) levels[i].lattice = &lattices[i];
        spoil(levels, lattices, points, faces);
        return RefusalOf([&] { EditingSession(levels, points, faces); });
    };
    EXPECT_EQ(refusal([](auto&...) {}), "");
    EXPECT_THAT(refusal([](auto& levels, auto&...) { levels.clear(); }), HasSubstr("needs a lattice"));
    EXPECT_THAT(refusal([](auto& levels, auto&...) { levels[1].lattice = nullptr; }), HasSubstr("level 1"));
    EXPECT_THAT(refusal([](auto& levels, auto&...) { levels.erase(levels.begin() + 1); }), HasSubstr("octree rule"));
    EXPECT_THAT(refusal([](auto& levels, auto&...) { levels[2].octree_rule.indices[7] = 1000; }),
                HasSubstr("weight 7"));
    EXPECT_THAT(refusal([](auto& levels, auto&...) { levels[2].octree_rule.weights[7] = NAN; }), HasSubstr("nan"));
    EXPECT_THAT(refusal([](auto& levels, auto&...) { levels[1].octree_rule.weights.pop_back(); }),
                HasSubstr("do not fit"));
    EXPECT_THAT(refusal([](auto& levels, auto&...) {
                    std::swap(levels[1].octree_rule.offsets[3], levels[1].octree_rule.offsets[7]);
                }),
                HasSubstr("do not fit"));
    EXPECT_THAT(refusal([](auto&, auto& lattices, auto&...) { lattices[2].positions[4] = NAN; }),
                HasSubstr("level 2 of the session: coordinate 1 of point 1 is nan"));
    EXPECT_THAT(refusal([](auto&, auto&, auto& points, auto&) { points[3] = INFINITY; }),
                HasSubstr("model: coordinate 0 of point 1 is inf"));
    EXPECT_THAT(refusal([](auto&, auto&, auto& points, auto&) { points.pop_back(); }), HasSubstr("not three a point"));
    EXPECT_THAT(refusal([](auto&, auto&, auto& points, auto&) { points.resize(9); }), HasSubstr("has the point"));
    EXPECT_THAT(refusal([](auto&, auto&, auto&, auto& faces) { faces.offsets = {}; }), HasSubstr("faces"));
    EXPECT_THAT(refusal([](auto& levels, auto& lattices, auto&, auto&) {
                    levels[1].embedding = std::make_shared<const Embedding>(
                        Embedding::Create(lattices[1].View(), lattices[1].positions, std::vector<double>{0, 0, 0}, {}));
                }),
                HasSubstr("its embedding has 1 points"));
}

}  // namespace
}  // namespace SolidSubdiv::Deform

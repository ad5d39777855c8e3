// SPDX-License-Identifier: Apache-2.0
// The code of docs/editing.md, compiled and run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include <solidsubdiv/apps/deform/direct_manipulation.h>
#include <solidsubdiv/apps/deform/editing_session.h>
#include <solidsubdiv/apps/deform/octree_lattices.h>

#include "apps/deform/sphere_testing.h"
#include "page_code.h"

namespace SolidSubdiv::Deform {
namespace {

TEST(EditingPage, HasTheCodeOfThisTest) {
    const std::string page = CodeWithoutBlanks("/docs/editing.md");
    ASSERT_GT(page.size(), 500u);
    const std::string test = CodeWithoutBlanks("/regression/apps/deform/editing_page_test.cpp");
    const std::size_t second = page.find("conststd::vector<Deform::DragTarget>");
    EXPECT_THAT(test, testing::HasSubstr(page.substr(0, second)));
    EXPECT_THAT(test, testing::HasSubstr(page.substr(second)));
}

TEST(EditingPage, CodeRuns) {
    const TestShapes::Sphere sphere(12, 1);
    const std::vector<double>& points = sphere.points;
    const std::vector<Index>& triangles = sphere.triangles;
    const std::vector<Offset>& offsets = sphere.offsets;
    const std::vector<Index> locked = {0, 1};
    std::size_t n_shown = 0;
    const auto Show = [&](Index v, std::span<const double> values) {
        n_shown += static_cast<std::size_t>(v) < values.size() / 3;
    };

    const auto hierarchy = Deform::MakeOctreeLattices(points, triangles, {.levels = 3, .padding = .1});
    std::vector<Deform::SessionLevel> levels;
    for (const auto& level : hierarchy.levels) {
        levels.push_back({.lattice = &level.lattice, .octree_rule = level.octree_rule});
    }
    Deform::EditingSession session(levels, points, {.offsets = offsets, .corners = triangles});

    session.Move({7}, {1.5, 1, 1});
    session.SetLevel(3);
    const auto change = session.Move({81}, {.3, -.2, .1});
    for (Index v : change.points) Show(v, session.points());
    for (Index v : change.normals) Show(v, session.normals());
    session.SetLevel(0);
    session.Move({7}, {2, 1, 1});
    session.Undo();

    EXPECT_GT(n_shown, 0u);
    EXPECT_EQ(session.control_points()[21], 1.5);

    const std::vector<Deform::DragTarget> targets{{.point = 12, .position = {0, 0, 1}},
                                                  {.point = 99, .position = {1, 0, 0}, .weight = 4}};
    const auto drag = Deform::Drag(
        session.embedding(), session.control_points(), targets,
        {.locked = locked, .preserve_volume = true, .triangles = triangles, .correction = session.correction()});
    std::vector<double> positions;
    for (Index i : drag.moved) {
        for (int axis = 0; axis < 3; ++axis) positions.push_back(drag.control_points[3 * i + axis]);
    }
    session.Move(drag.moved, positions);

    EXPECT_TRUE(drag.is_consistent);
    EXPECT_LT(std::hypot(session.points()[36], session.points()[37], session.points()[38] - 1), 1e-10);
}

}  // namespace
}  // namespace SolidSubdiv::Deform

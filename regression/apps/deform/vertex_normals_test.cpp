// SPDX-License-Identifier: Apache-2.0
// Area-weighted normals: against closed forms, and updates against all from the start.
#include <solidsubdiv/apps/deform/vertex_normals.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include <solidsubdiv/sdc/errors.h>

#include "apps/deform/sphere_testing.h"
#include "test_shapes.h"

namespace SolidSubdiv::Deform {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;
using TestShapes::Copy;
using TestShapes::Sphere;

std::string RefusalOf(Index n_points, std::vector<Offset> offsets, std::vector<Index> corners) {
    try {
        VertexNormals(n_points, offsets, corners);
    } catch (const InvalidInput& e) {
        return e.what();
    }
    return {};
}

TEST(VertexNormals, FacesCountByTheirArea) {
    // Triangles of areas 1/2, 1 and 3/2 in the coordinate planes: the normal at their corner is along (1, 2, 3).
    const std::vector<double> points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 0, 0, 0, 3, 0};
    const std::vector<Offset> offsets = {0, 3, 6, 9};
    const std::vector<Index> corners = {0, 2, 3, 0, 3, 4, 0, 1, 5};
    VertexNormals normals(6, offsets, corners);
    normals.Compute(points);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(normals.normals()[axis], static_cast<double>(axis + 1) / std::sqrt(14.0), 1e-15);
    }
}

TEST(VertexNormals, OfPolygonsAreThoseOfTheirAreaVectors) {
    // An L of six corners, not convex at the origin, in a plane with the normal (0, -1, 0).
    const std::vector<double> points = {0, 0, 0, 1, 0, 0, 1, 0, 1, -1, 0, 1, -1, 0, -1, 0, 0, -1};
    const std::vector<Offset> offsets = {0, 6};
    for (Index first = 0; first < 6; ++first) {  // whichever corner it begins with
        std::vector<Index> corners;
        for (Index k = 0; k < 6; ++k) corners.push_back((first + k) % 6);
        VertexNormals normals(6, offsets, corners);
        normals.Compute(points);
        for (std::size_t v = 0; v < 6; ++v) {
            EXPECT_EQ(normals.normals()[3 * v], 0);
            EXPECT_EQ(normals.normals()[3 * v + 1], -1);
        }
    }
}

TEST(VertexNormals, WithoutFacesAreZero) {
    VertexNormals normals(2, std::vector<Offset>{0}, {});
    normals.Compute(std::vector<double>{1, 2, 3, 4, 5, 6});
    EXPECT_THAT(Copy(normals.normals()), testing::Each(0));
    VertexNormals none;
    none.Compute(std::vector<double>{1, 2, 3});
    EXPECT_THAT(none.Update(std::vector<Index>{0}, std::vector<double>{1, 2, 3}), IsEmpty());
}

TEST(VertexNormals, UpdatesGiveTheBitsOfAllFromTheStart) {
    Sphere sphere(6, 1);
    VertexNormals updated(sphere.n_points(), sphere.offsets, sphere.triangles), scratch = updated;
    updated.Compute(sphere.points);
    TestShapes::Random random(1);
    for (int n_moved : {1, 3, 0, sphere.n_points() - 1, 1}) {  // few and most
        const std::vector<double> before = Copy(updated.normals());
        std::vector<Index> moved;
        for (int i = 0; i < n_moved; ++i) moved.push_back(random.Below(sphere.n_points()));
        for (Index v : moved) sphere.points[3 * static_cast<std::size_t>(v)] += .1 * random.Uniform();
        const auto changed = updated.Update(moved, sphere.points);
        const std::set<Index> listed(changed.begin(), changed.end());
        EXPECT_EQ(listed.size(), changed.size()) << "a point is listed twice";
        scratch.Compute(sphere.points);
        EXPECT_EQ(Copy(updated.normals()), Copy(scratch.normals()));
        for (Index v = 0; v < sphere.n_points(); ++v) {
            for (std::size_t axis = 0; axis < 3 && !listed.contains(v); ++axis) {
                const std::size_t at = 3 * static_cast<std::size_t>(v) + axis;
                EXPECT_EQ(before[at], updated.normals()[at]) << "point " << v << " has changed and is not listed";
            }
        }
    }
}

TEST(VertexNormals, UpdatesTouchTheVerticesOfTheFacesOnly) {
    // Two quadrilaterals side by side and a triangle apart.
    std::vector<double> points = {0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0};
    VertexNormals normals(9, std::vector<Offset>{0, 4, 8, 11}, std::vector<Index>{0, 1, 4, 3, 1, 2, 5, 4, 6, 7, 8});
    normals.Compute(points);
    points[2] = 1;  // z of point 0
    EXPECT_THAT(normals.Update(std::vector<Index>{0}, points), UnorderedElementsAre(0, 1, 3, 4));
}

TEST(VertexNormals, RefuseFacesThatDoNotFit) {
    EXPECT_THAT(RefusalOf(4, {0, 3, 6}, {0, 1, 2, 1, 4, 2}), HasSubstr("face 1 of the model has the point 4"));
    EXPECT_THAT(RefusalOf(4, {0, 3}, {0, -1, 2}), HasSubstr("face 0 of the model has the point -1"));
    EXPECT_THAT(RefusalOf(4, {0, 3}, {0, 1, 2, 3}), HasSubstr("from 0 to its 4 corners"));
    EXPECT_THAT(RefusalOf(4, {}, {0}), HasSubstr("from 0 to its 1 corners"));
    EXPECT_THAT(RefusalOf(4, {0, 5, 3}, {0, 1, 2}), HasSubstr("face 0 of the model has the offsets 0 and 5"));
    EXPECT_THAT(RefusalOf(4, {0, 2, 1, 3}, {0, 1, 2}), HasSubstr("face 1 of the model has the offsets 2 and 1"));
    EXPECT_EQ(RefusalOf(4, {0, 3}, {0, 1, 2}), "");
}

}  // namespace
}  // namespace SolidSubdiv::Deform

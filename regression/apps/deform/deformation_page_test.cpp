// SPDX-License-Identifier: Apache-2.0
// The code of docs/deformation.md, compiled and run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include <solidsubdiv/apps/deform/deformer.h>
#include <solidsubdiv/apps/deform/octree_lattices.h>

#include "apps/deform/sphere_testing.h"
#include "page_code.h"

namespace SolidSubdiv::Deform {
namespace {

TEST(DeformationPage, HasTheCodeOfThisTest) {
    const std::string page = CodeWithoutBlanks("/docs/deformation.md");
    ASSERT_GT(page.size(), 500u);
    EXPECT_THAT(CodeWithoutBlanks("/regression/apps/deform/deformation_page_test.cpp"), testing::HasSubstr(page));
}

TEST(DeformationPage, CodeRuns) {
    const TestShapes::Sphere sphere(12, 1);
    const std::vector<double>& points = sphere.points;
    const std::vector<Index>& triangles = sphere.triangles;
    std::size_t n_told = 0, n_shown = 0;
    const auto Tell = [&](Index, double) { ++n_told; };
    const auto Show = [&](Index, std::span<const double>) { ++n_shown; };

    const auto hierarchy = Deform::MakeOctreeLattices(points, triangles, {.levels = 2, .padding = .02});
    const Deform::ControlLattice& lattice = hierarchy.levels[2].lattice;

    const auto embedding = Deform::Embedding::Create(lattice.View(), lattice.positions, points,
                                                     {.scheme = Sdc::CatmullClarkSolid{}, .levels = 2});
    for (const Deform::OutsidePoint& out : embedding.outside()) Tell(out.point, out.distance);

    Deform::Deformer deformer(embedding);
    std::vector<double> control = lattice.positions, model(points.size());
    for (std::size_t i = 0; i < control.size(); i += 3) control[i] += .1 * control[i + 1];
    deformer.Deform(control, model);

    const Index moved[] = {7};
    control[3 * 7] += .1;
    for (Index v : deformer.Update(moved, control, model)) Show(v, model);

    EXPECT_EQ(n_told, 0u) << "all points lie inside, so the shear is theirs too";
    for (std::size_t i = 0; i < control.size(); i += 3) control[i] = lattice.positions[i] + .1 * control[i + 1];
    deformer.Deform(control, model);
    // Coordinates of about 1, sums of weights: some units of round-off.
    for (std::size_t i = 0; i < points.size(); i += 3) EXPECT_NEAR(model[i], points[i] + .1 * points[i + 1], 1e-14);
    EXPECT_GT(n_shown, 0u);
    EXPECT_LT(n_shown, points.size() / 3);
}

}  // namespace
}  // namespace SolidSubdiv::Deform

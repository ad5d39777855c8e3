// SPDX-License-Identifier: Apache-2.0
// Tets of the inside fit together, face to face, fill what their boundary encloses, and are positive.
#include <gtest/gtest.h>
#include <solidsubdiv/kit/geometry/cell_volume.h>
#include <solidsubdiv/kit/geometry/tessellation_inside.h>
#include <solidsubdiv/osd/evaluator.h>

#include <map>
#include <set>

#include "kit/geometry/tessellation_testing.h"
#include "sanitized.h"

namespace SolidSubdiv::Geometry {
namespace {

using TriangleKey = std::array<Index, 3>;

TriangleKey Sorted(TriangleKey t) {
    std::sort(t.begin(), t.end());
    return t;
}

/// Faces of tets that one tet alone has, as seen from outside; whether no face has more than two, on two sides.
struct Skin {
    std::vector<Index> triangles;
    bool fits = true;
};

Skin SkinOf(const std::vector<Index>& tets) {
    std::map<TriangleKey, std::vector<TriangleKey>> faces;
    for (std::size_t t = 0; t < tets.size(); t += 4) {
        for (const auto& f : Sdc::Tet::faces) {
            const TriangleKey face{tets[t + f[0]], tets[t + f[1]], tets[t + f[2]]};
            faces[Sorted(face)].push_back(face);
        }
    }
    const auto is_turn_of = [](TriangleKey a, const TriangleKey& b) {
        for (int i = 0; i < 3; ++i) {
            if (a == b) return true;
            std::rotate(a.begin(), a.begin() + 1, a.end());
        }
        return false;
    };
    Skin skin;
    for (const auto& [key, sides] : faces) {
        if (sides.size() > 2 || (sides.size() == 2 && is_turn_of(sides[0], sides[1]))) skin.fits = false;
        if (sides.size() == 1) skin.triangles.insert(skin.triangles.end(), sides[0].begin(), sides[0].end());
    }
    return skin;
}

double EnclosedVolume(const std::vector<Index>& triangles, const std::vector<double>& positions) {
    double six = 0;
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        six += Dot(PointOf(positions, triangles[i]),
                   Cross(PointOf(positions, triangles[i + 1]), PointOf(positions, triangles[i + 2])));
    }
    return six / 6;
}

std::vector<double> VolumesOf(const std::vector<Index>& tets, const std::vector<double>& positions) {
    Far::TopologyDescriptor topology{.n_vertices = static_cast<Index>(positions.size() / 3)};
    topology.tets = tets;
    return CellVolumes(topology, positions);
}
double SumOf(const std::vector<double>& values) {
    double sum = 0;
    for (double x : values) sum += x;
    return sum;
}

std::vector<TestComplex> Solids(int levels) {
    std::vector<TestComplex> solids = TestComplexes();
    std::erase_if(solids, [](const TestComplex& c) {
        const auto& defects = c.refiner.defects();
        return c.refiner.n_cells(0) == 0 || std::any_of(defects.begin(), defects.end(), [](const Far::Defect& d) {
                   return d.code == Far::DefectCode::InvertedCell;
               });
    });
    EXPECT_GE(solids.size(), 9u);
    for (TestComplex& c : solids) {
        c.refiner.RefineUniform({.max_level = levels, .full_topology_in_last_level = true});
    }
    return solids;
}

/// The boundary faces of cells of a level, as sets of corners: their triangles, or the two halves of their quads.
std::size_t TrianglesOfBoundary(const Far::TopologyRefiner& refiner, int level) {
    std::size_t n = 0;
    if (refiner.is_polyhedral()) {
        const auto& l = refiner.polyhedral_level(level);
        for (Index b = 0; b < l.n_boundary_faces; ++b) {
            if (l.NCells(l.boundary_faces[b]) == 1) n += l.BoundaryVertices(b).size() - 2;
        }
    } else {
        const auto& l = refiner.level(level);
        for (Index b = 0; b < l.n_boundary_faces; ++b) n += l.face_tags[l.boundary_faces[b]].n_cells() == 1;
    }
    return n;
}

TEST(TessellationInside, TetsFitFaceToFaceAndTheirSkinIsTheBoundary) {
    for (const TestComplex& complex : Solids(2)) {
        for (int level = 0; level <= 2; ++level) {
            const Skin skin = SkinOf(CutIntoTets(complex.refiner, level));
            EXPECT_TRUE(skin.fits) << complex.name << ", level " << level;
            EXPECT_EQ(skin.triangles.size(), 3 * TrianglesOfBoundary(complex.refiner, level))
                << complex.name << ", level " << level;
        }
    }
}

TEST(TessellationInside, PlantedFaultsDoNotFit) {
    const TestComplex block = MakeComplex("block", TestShapes::HexBlock(2), Sdc::Split::Polyhedral);
    const std::vector<Index> good = CutIntoTets(block.refiner, 0);
    ASSERT_TRUE(SkinOf(good).fits);
    const std::size_t n = SkinOf(good).triangles.size();
    std::vector<Index> turned = good;
    std::swap(turned[0], turned[1]);
    EXPECT_FALSE(SkinOf(turned).fits);
    std::vector<Index> twice = good;
    twice.insert(twice.end(), good.begin(), good.begin() + 4);
    EXPECT_FALSE(SkinOf(twice).fits);
    // A cube cut from another corner than its neighbours expect: as if 4 came before 0.
    std::vector<Index> other(good.begin() + 24, good.end()), hex = {4, 1, 0, 3, 9, 10, 13, 12};
    Far::TopologyDescriptor cube{.n_vertices = 27};
    cube.hexes = hex;
    for (Index v : CutIntoTets(Far::TopologyRefiner::Create(cube, Sdc::Split::Polyhedral), 0)) {
        other.push_back(v == 0 || v == 4 ? 4 - v : v);
    }
    EXPECT_NE(SkinOf(other).triangles.size(), n);
}

TEST(TessellationInside, VolumesSumToWhatTheBoundaryEncloses) {
    SOLIDSUBDIV_LONG_TEST();
    const int level = kIsSanitized ? 1 : 2;
    for (const TestComplex& complex : Solids(level)) {
        for (const auto& [name, scheme] : complex.schemes) {
            const InnerTessellation inside = TessellateInside(complex.refiner, scheme, level);
            EXPECT_TRUE(inside.without_limit.empty());
            const auto positions = TestFar::Apply(inside.table, complex.positions);
            const double sum = SumOf(VolumesOf(inside.tets, positions));
            EXPECT_GT(sum, 0);
            const double enclosed = EnclosedVolume(SkinOf(inside.tets).triangles, positions);
            EXPECT_NEAR(sum, enclosed, 1e-12 * 100) << complex.name << ", " << name;  // shapes of volumes up to 50
            if (complex.refiner.is_polyhedral() || complex.name == "mixed dimensions") continue;  // other facets
            const auto boundary = TessellateBoundary(complex.refiner, scheme, {.rate = 1 << level});
            EXPECT_NEAR(sum, EnclosedVolume(boundary.triangles, boundary.Positions(complex.positions)), 1e-12 * 100)
                << complex.name << ", " << name;
        }
    }
}

TEST(TessellationInside, TetsArePositiveWhereCellsAre) {
    // Convex cells: those of the shapes as they are, under schemes that keep them so.
    std::vector<std::pair<TestComplex, Sdc::Scheme>> cases;
    cases.emplace_back(MakeComplex("block", TestShapes::HexBlock(3), Sdc::Split::Polyhedral), Sdc::Mlca{});
    cases.emplace_back(MakeComplex("block", TestShapes::HexBlock(3), Sdc::Split::Polyhedral), Sdc::CatmullClarkSolid{});
    cases.emplace_back(MakeComplex("mixed", TestShapes::MixedCells(), Sdc::Split::Polyhedral), Sdc::LinearSolid{});
    cases.emplace_back(MakeComplex("kuhn", TestShapes::KuhnBlock(2), Sdc::Split::TetOct), Sdc::BoxSpline{});
    cases.emplace_back(MakeComplex("oct", TestShapes::SingleOct(), Sdc::Split::TetOct), Sdc::SmoothTet{});
    for (auto& [complex, scheme] : cases) {
        complex.refiner.RefineUniform({.max_level = 2, .full_topology_in_last_level = true});
        for (int level = 0; level <= 2; ++level) {
            const InnerTessellation inside = TessellateInside(complex.refiner, scheme, level);
            const auto volumes = VolumesOf(inside.tets, TestFar::Apply(inside.table, complex.positions));
            EXPECT_GT(*std::min_element(volumes.begin(), volumes.end()), 0) << complex.name << ", level " << level;
        }
    }
}

TEST(TessellationInside, RefinedHexahedraBecomeSixTetsAroundOneDiagonal) {
    TestComplex block = MakeComplex("block", TestShapes::HexBlock(2), Sdc::Split::Polyhedral);
    block.refiner.RefineUniform({.max_level = 1, .full_topology_in_last_level = true});
    const std::vector<Index> tets = CutIntoTets(block.refiner, 1);
    const auto& level = block.refiner.polyhedral_level(1);
    ASSERT_EQ(tets.size(), 24 * static_cast<std::size_t>(level.n_hexes));
    const Index first_cell_point = level.n_vertices - 8;
    for (std::size_t t = 0; t < tets.size(); t += 4) {
        const std::set<Index> corners(&tets[t], &tets[t] + 4);
        EXPECT_LT(*corners.begin(), 27);                 // a control vertex
        EXPECT_GE(*corners.rbegin(), first_cell_point);  // and a cell's point
    }
}

TEST(TessellationInside, TheTableGoesFromControlPointsToLimits) {
    for (const TestComplex& complex : Solids(2)) {
        for (const auto& [name, scheme] : complex.schemes) {
            for (int level = 0; level <= 2; ++level) {
                const InnerTessellation inside = TessellateInside(complex.refiner, scheme, level);
                const auto refined = TestFar::Apply(
                    Far::StencilTable::Create(complex.refiner, scheme, {.max_level = level}), complex.positions);
                const auto limits =
                    TestFar::Limits(Far::LimitStencilTable::Create(complex.refiner, scheme, {.level = level}), refined);
                Osd::Evaluator evaluator(inside.table, Osd::Backend::Best());
                std::vector<double> evaluated(limits.size());
                evaluator.Evaluate(complex.positions, evaluated);
                TestFar::ExpectNear(evaluated, limits, 1e-13);
            }
        }
    }
}

TEST(TessellationInside, CreasesThatHaveYetToFadeHaveTheLimitsThatTheyFadeTo) {
    const TestShapes::Shape shape = TestShapes::KuhnBlock(1);
    Far::TopologyDescriptor descriptor = TestFar::Describe(shape);
    const std::vector<Index> edge = {0, 1}, corner = {7};
    const std::vector<float> sharpness = {1.5f};
    descriptor.crease_edges = edge;
    descriptor.crease_sharpness = sharpness;
    descriptor.corner_vertices = corner;
    descriptor.corner_sharpness = sharpness;
    auto refiner = Far::TopologyRefiner::Create(descriptor, Sdc::Split::TetOct);
    refiner.RefineUniform({.max_level = 2, .full_topology_in_last_level = true});
    EXPECT_FALSE(Far::LimitStencilTable::Create(refiner, Sdc::BoxSpline{}, {.level = 0}).without_limit().empty());
    const InnerTessellation early = TessellateInside(refiner, Sdc::BoxSpline{}, 0);
    const InnerTessellation late = TessellateInside(refiner, Sdc::BoxSpline{}, 2);
    EXPECT_TRUE(early.without_limit.empty());
    EXPECT_TRUE(late.without_limit.empty());
    auto expected = TestFar::Apply(late.table, shape.positions);
    expected.resize(shape.positions.size());  // vertices come first among the children
    TestFar::ExpectNear(TestFar::Apply(early.table, shape.positions), expected, 1e-14);
}

TEST(TessellationInside, LevelsThatAreNotThereAreRefused) {
    const TestComplex tet = MakeComplex("tet", TestShapes::SingleTet(), Sdc::Split::TetOct);
    EXPECT_THROW(TessellateInside(tet.refiner, Sdc::BoxSpline{}, 1), InvalidInput);
    EXPECT_THROW(TessellateInside(tet.refiner, Sdc::BoxSpline{}, -1), InvalidInput);
}

}  // namespace
}  // namespace SolidSubdiv::Geometry

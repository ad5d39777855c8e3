// SPDX-License-Identifier: Apache-2.0
// The demo's lattice: valid, refined without folds, and its solid the bunny. And the picture that tells it.
#include "kit/picture/picture_testing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/far/choose_diagonals.h>
#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/kit/geometry/cell_volume.h>
#include <solidsubdiv/kit/geometry/surface_components.h>
#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/kit/picture/cut.h>
#include <solidsubdiv/kit/picture/internal/vec3.h>
#include <solidsubdiv/kit/picture/refinement_picture.h>
#include <solidsubdiv/sdc/errors.h>

#include <filesystem>

namespace SolidSubdiv::Picture {
namespace {

using Internal::Vec3d;

const std::filesystem::path kFolder = std::filesystem::path(SOLIDSUBDIV_SHAPES) / "demo";

/// The lattice and its box-spline refinements.
const std::vector<Io::Mesh>& Levels() {
    static const std::vector<Io::Mesh> levels = [] {
        std::vector<Io::Mesh> meshes{Io::ReadSolid(kFolder / "bunny_lattice.vtu")};
        meshes[0].topology.tets = Far::ChooseDiagonals(meshes[0].topology, Far::DiagonalPolicy::Matched).tets;
        auto refiner = Far::TopologyRefiner::Create(meshes[0].topology, Sdc::Split::TetOct);
        refiner.RefineUniform({.max_level = 3});
        const Far::PrimvarRefiner primvars(refiner, Sdc::BoxSpline{});
        for (int l = 1; l <= 3; ++l) {
            const Far::Level& level = refiner.level(l);
            const auto n = static_cast<std::size_t>(level.n_vertices);
            const Io::Mesh& coarse = meshes.back();
            Io::Mesh fine;
            fine.topology.n_vertices = level.n_vertices;
            fine.topology.tets.assign(level.tet_vertices.begin(), level.tet_vertices.end());
            fine.topology.octs.assign(level.oct_vertices.begin(), level.oct_vertices.end());
            fine.positions.resize(3 * n);
            primvars.Interpolate<double>(l, coarse.positions, fine.positions, 3);
            fine.point_data.push_back({"density", 1, std::vector<double>(n)});
            primvars.Interpolate<double>(l, coarse.point_data[0].values, fine.point_data[0].values, 1);
            meshes.push_back(std::move(fine));
        }
        return meshes;
    }();
    return levels;
}

Vec3d Point(const std::vector<double>& positions, Index v) {
    const double* p = &positions[3 * static_cast<std::size_t>(v)];
    return {p[0], p[1], p[2]};
}

/// Squared distance of p from the triangle (a, b, c): its plane if p lies over the triangle, else its sides.
double SquaredDistance(Vec3d p, Vec3d a, Vec3d b, Vec3d c) {
    const Vec3d n = Cross(b - a, c - a);
    const Vec3d corners[3] = {a, b, c};
    bool over = true;
    double nearest = HUGE_VAL;
    for (int i = 0; i < 3; ++i) {
        const Vec3d s = corners[i], side = corners[(i + 1) % 3] - s;
        over = over && Dot(Cross(n, side), p - s) >= 0;
        const double t = std::clamp(Dot(p - s, side) / Dot(side, side), 0.0, 1.0);
        const Vec3d gap = p - s - t * side;
        nearest = std::min(nearest, Dot(gap, gap));
    }
    return over ? Dot(n, p - a) * Dot(n, p - a) / Dot(n, n) : nearest;
}

/// Mean and largest distance of points to triangles, looking at every pair.
std::pair<double, double> Distances(const std::vector<Vec3d>& points, const std::vector<double>& positions,
                                    const std::vector<Index>& triangles) {
    double sum = 0, largest = 0;
    for (const Vec3d& p : points) {
        double nearest = HUGE_VAL;
        for (std::size_t t = 0; t < triangles.size(); t += 3) {
            const Vec3d a = Point(positions, triangles[t]);
            if (Dot(p - a, p - a) > 4 && nearest < 1) continue;  // no triangle has a side of over 1
            nearest = std::min(
                nearest, SquaredDistance(p, a, Point(positions, triangles[t + 1]), Point(positions, triangles[t + 2])));
        }
        sum += std::sqrt(nearest);
        largest = std::max(largest, std::sqrt(nearest));
    }
    return {sum / static_cast<double>(points.size()), largest};
}

TEST(DemoDataTest, LatticeIsOneSphereOfPositiveTetsWithInnerPoints) {
    const Io::Mesh& lattice = Levels()[0];
    EXPECT_EQ(lattice.topology.n_vertices, 695);
    EXPECT_EQ(lattice.topology.n_tets(), 2366);
    EXPECT_EQ(lattice.topology.n_cells(), lattice.topology.n_elements());
    const SolidFaces boundary = SolidBoundary(lattice);
    const auto pieces = Geometry::SurfaceComponents(boundary.triangles, lattice.topology.n_vertices);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_TRUE(pieces[0].IsClosed() && pieces[0].IsManifold());
    EXPECT_EQ(pieces[0].EulerCharacteristic(), 2);
    EXPECT_EQ(pieces[0].n_vertices, 520);
    EXPECT_TRUE(Far::TopologyRefiner::Create(lattice.topology, Sdc::Split::TetOct).defects().empty());
}

TEST(DemoDataTest, NoCellFoldsOnAnyLevel) {
    for (const Io::Mesh& mesh : Levels()) {
        for (double volume : Geometry::CellVolumes(mesh.topology, mesh.positions)) ASSERT_GT(volume, 0);
        // As files carry octahedra: four tets around the major diagonal.
        const std::vector<Index>& octs = mesh.topology.octs;
        for (std::size_t o = 0; o < octs.size(); o += 6) {
            for (const auto& local : Sdc::Oct::tets) {
                const Index tet[4] = {octs[o + local[0]], octs[o + local[1]], octs[o + local[2]], octs[o + local[3]]};
                ASSERT_GT(Geometry::TetVolume(mesh.positions, tet), 0);
            }
        }
    }
}

TEST(DemoDataTest, TheSolidIsTheBunny) {
    const Io::Mesh scan = Io::ReadMesh(kFolder / "bunny.obj");
    const Io::Mesh& fine = Levels()[2];
    const std::vector<Index> skin = SolidBoundary(fine).triangles;
    std::vector<Vec3d> scan_points, skin_points;
    for (Index v = 0; v < scan.topology.n_vertices; v += 2) scan_points.push_back(Point(scan.positions, v));
    for (std::size_t t = 0; t < skin.size(); t += 24) skin_points.push_back(Point(fine.positions, skin[t]));
    // The README says 0.014 and 0.12, back 0.019 and 0.14 for the limit surface; level 2 lies a few thousandths off it.
    const auto [mean, largest] = Distances(skin_points, scan.positions, scan.topology.triangles);
    EXPECT_LT(mean, 0.02);
    EXPECT_LT(largest, 0.15);
    const auto [mean_back, largest_back] = Distances(scan_points, fine.positions, skin);
    EXPECT_LT(mean_back, 0.03);
    EXPECT_LT(largest_back, 0.2);
}

TEST(RefinementPictureTest, ShowsFourPanelsWithTheAttributeInside) {
    std::vector<const Io::Mesh*> levels;
    for (int l = 0; l < 3; ++l) levels.push_back(&Levels()[static_cast<std::size_t>(l)]);
    RefinementPictureOptions options;
    options.render = {.width = 160, .height = 150, .samples = 4};
    options.panels = {.columns = 2, .gap = 0};
    const Image image = RefinementPicture(levels, options);
    ASSERT_EQ(image.width(), 320);
    const int foot = static_cast<int>(std::lround(2.2 * options.panels.caption.size));  // captions of the first row
    ASSERT_GT(image.height(), 300 + 2 * foot);  // and a colour bar in the second
    const auto count = [&](int left, int top, auto is) {
        int n = 0;
        for (int y = top; y < top + 150; ++y) {
            for (int x = left; x < left + 160; ++x) n += is(image.At(x, y)) ? 1 : 0;
        }
        return n;
    };
    const auto red = [](Color c) { return c.r > c.b + 0.15f && c.r > c.g + 0.15f; };
    const auto orange = [](Color c) { return c.r > c.b + 0.15f && c.g > c.b + 0.05f; };
    const auto blue = [](Color c) { return c.b > c.r + 0.2f; };
    const auto green = [](Color c) { return c.g > c.r + 0.1f && c.g > c.b + 0.02f; };
    EXPECT_GT(count(0, 0, red), 500);               // the lattice's tubes
    EXPECT_EQ(count(160, 0, red), 0);               // level 1 has none
    EXPECT_GT(count(0, 150 + foot, orange), 800);   // tets
    EXPECT_GT(count(0, 150 + foot, blue), 800);     // octahedra
    EXPECT_GT(count(160, 150 + foot, green), 800);  // the density's middle values
    EXPECT_EQ(count(0, 0, green), 0);
}

TEST(RefinementPictureTest, UnknownAttributesAndMissingLevelsAreRefused) {
    const Io::Mesh* levels[] = {&Levels()[0]};
    RefinementPictureOptions options;
    options.render = {.width = 16, .height = 16};
    options.attribute = "mass";
    EXPECT_THROW(RefinementPicture(levels, options), InvalidInput);
    EXPECT_THROW(RefinementPicture({}, options), InvalidInput);
}

TEST(RefinementPictureTest, SurfacesAreShownWithReflectionLinesInsteadOfCuts) {
    const Triangles coarse = MakeSphere(1), fine = MakeSphere(3);
    Io::Mesh meshes[3];
    for (int i = 0; i < 3; ++i) {
        const Triangles& t = i == 0 ? coarse : fine;
        meshes[i].positions = t.positions;
        meshes[i].topology.n_vertices = static_cast<Index>(t.positions.size() / 3);
        meshes[i].topology.triangles = t.triangles;
    }
    const Io::Mesh* levels[] = {&meshes[0], &meshes[1], &meshes[2]};
    RefinementPictureOptions options;
    options.render = {.width = 50, .height = 40};
    options.panels = {.gap = 0};
    const Image image = RefinementPicture(levels, options);
    ASSERT_EQ(image.width(), 200);
    const auto n_dark = [&](int left) {
        int n = 0;
        for (int y = 0; y < 40; ++y) {
            for (int x = left; x < left + 50; ++x) n += image.At(x, y).g < 0.4f ? 1 : 0;
        }
        return n;
    };
    EXPECT_EQ(n_dark(100), 0);
    EXPECT_GT(n_dark(150), 100);
    EXPECT_EQ(RefinementPicture(std::span(levels).first(2), options).width(), 100);
}

}  // namespace
}  // namespace SolidSubdiv::Picture

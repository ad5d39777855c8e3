// SPDX-License-Identifier: Apache-2.0
// Surfaces of volumes: closed manifolds that look outwards, where the volume has them, as large as what they bound.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/apps/voxel/volume_surface.h>
#include <solidsubdiv/kit/geometry/surface_components.h>
#include <solidsubdiv/sdc/errors.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace SolidSubdiv::Voxel {
namespace {

using testing::HasSubstr;

Geometry::Volume VolumeOf(std::array<Offset, 3> dims, const std::function<double(double, double, double)>& value) {
    Geometry::Volume volume{.dims = dims, .values = {}};
    for (Offset k = 0; k < dims[2]; ++k) {
        for (Offset j = 0; j < dims[1]; ++j) {
            for (Offset i = 0; i < dims[0]; ++i) {
                volume.values.push_back(value(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)));
            }
        }
    }
    return volume;
}

/// 1 in a ball of voxels, 0 elsewhere.
Geometry::Volume Ball(double radius, Offset n = 40) {
    const double c = static_cast<double>(n - 1) / 2 + 0.3;  // in no symmetric place
    return VolumeOf(
        {n, n, n}, [=](double x, double y, double z) { return std::hypot(x - c, y - c, z - c) <= radius ? 1.0 : 0.0; });
}

/// Any bits, as a hash of the place has them.
double Noise(double x, double y, double z) {
    auto h = static_cast<std::uint32_t>(x) * 73856093u ^ static_cast<std::uint32_t>(y) * 19349663u ^
             static_cast<std::uint32_t>(z) * 83492791u;
    h = (h ^ h >> 13) * 1274126177u;
    return static_cast<double>((h ^ h >> 16) % 1000) / 1000;
}

double Enclosed(const VolumeSurface& s) {
    double sum = 0;
    for (std::size_t t = 0; t < s.triangles.size(); t += 3) {
        const double* const a = &s.positions[3 * static_cast<std::size_t>(s.triangles[t])];
        const double* const b = &s.positions[3 * static_cast<std::size_t>(s.triangles[t + 1])];
        const double* const c = &s.positions[3 * static_cast<std::size_t>(s.triangles[t + 2])];
        sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return sum / 6;
}

/// What keeps a surface from being a closed oriented manifold, in words; empty where nothing does.
std::string Faults(const VolumeSurface& s) {
    std::string faults;
    for (const auto& c : Geometry::SurfaceComponents(s.triangles, static_cast<Index>(s.positions.size() / 3))) {
        if (!c.IsClosed()) faults += " open";
        if (!c.IsManifold()) faults += " not manifold";
        if (c.n_flipped_edges > 0) faults += " flipped";
    }
    return faults;
}

constexpr double kPi = 3.14159265358979323846;

TEST(VolumeSurface, OfABallIsAClosedManifoldOfItsVolume) {
    for (const double smooth : {0.0, 1.0, 2.0}) {
        SCOPED_TRACE(smooth);
        const Geometry::Volume ball = Ball(12);
        const VolumeSurface s = SurfaceOfLabel(ball, 1, {.smooth = smooth});
        EXPECT_EQ(Faults(s), "");
        EXPECT_EQ(s.n_pieces, 1);
        EXPECT_FALSE(s.touches_border);
        const double voxels = std::count(ball.values.begin(), ball.values.end(), 1.0);
        // Without smoothing corners of voxels are cut off: some 3 % at this radius.
        EXPECT_NEAR(Enclosed(s) / voxels, 1, smooth > 0 ? 0.01 : 0.03);
        if (smooth > 0) {
            EXPECT_NEAR(Enclosed(s) / (4 * kPi / 3 * 12 * 12 * 12), 1, 0.01);
        }
    }
}

TEST(VolumeSurface, OfASmoothedBallHasNoStairs) {
    const auto rms_from_ball = [](const VolumeSurface& s) {
        double sum = 0;
        for (std::size_t i = 0; i < s.positions.size(); i += 3) {
            const double* const p = &s.positions[i];
            sum += std::pow(std::hypot(p[0] - 19.8, p[1] - 19.8, p[2] - 19.8) - 12, 2);
        }
        return std::sqrt(3 * sum / static_cast<double>(s.positions.size()));
    };
    // Steps of a voxel, evenly spread, are 1 / sqrt(12) = 0.29 from their middle; a Gaussian of a voxel averages over
    // some ten of them.
    EXPECT_GT(rms_from_ball(SurfaceOfLabel(Ball(12), 1, {.smooth = 0})), 0.25);
    EXPECT_LT(rms_from_ball(SurfaceOfLabel(Ball(12), 1)), 0.1);
}

TEST(VolumeSurface, OfAPlaneLiesOnIt) {
    // Values that are linear are kept by cutting in tetrahedra: to round-off.
    const auto volume = VolumeOf({9, 8, 7}, [](double x, double y, double z) { return 3 * x + 2 * y + z; });
    const VolumeSurface s = SurfaceOfLevel(volume, 19.5);
    EXPECT_TRUE(s.touches_border);
    EXPECT_EQ(Faults(s), "");
    int n = 0;
    for (std::size_t i = 0; i < s.positions.size(); i += 3) {
        const double* p = &s.positions[i];
        const bool is_inner = p[0] >= 0 && p[1] >= 0 && p[2] >= 0 && p[0] <= 8 && p[1] <= 7 && p[2] <= 6;
        if (!is_inner) continue;
        ++n;
        EXPECT_NEAR(3 * p[0] + 2 * p[1] + p[2], 19.5, 1e-12);
    }
    EXPECT_GT(n, 20);
}

TEST(VolumeSurface, IsAManifoldWhateverTheValues) {
    for (const double level : {0.3, 0.5, 0.9}) {
        // Nothing is dropped: single voxels and those that meet in a corner are there.
        const VolumeSurface s = SurfaceOfLevel(VolumeOf({14, 12, 13}, Noise), level, {.least_piece = 0});
        EXPECT_EQ(Faults(s), "") << level;
        EXPECT_GT(s.triangles.size(), 1000u);
    }
    // Zeros at grid points make no triangle without an area.
    const auto bits = [](double x, double y, double z) { return Noise(x, y, z) < 0.5 ? 0.0 : 1.0; };
    EXPECT_EQ(Faults(SurfaceOfLevel(VolumeOf({10, 10, 10}, bits), 1.0, {.least_piece = 0})), "");
}

TEST(VolumeSurface, PlantedFaultsAreSeen) {
    const VolumeSurface good = SurfaceOfLabel(Ball(5, 14), 1);
    VolumeSurface open = good, flipped = good, double_edge = good;
    open.triangles.resize(open.triangles.size() - 3);
    std::swap(flipped.triangles[0], flipped.triangles[1]);
    double_edge.triangles.insert(double_edge.triangles.end(),
                                 {good.triangles[0], good.triangles[1], good.triangles[5]});
    EXPECT_THAT(Faults(open), HasSubstr("open"));
    EXPECT_THAT(Faults(flipped), HasSubstr("flipped"));
    EXPECT_THAT(Faults(double_edge), HasSubstr("not manifold"));
}

TEST(VolumeSurface, LandsInTheWorldAndLooksOutwards) {
    // Voxels of 2 x 1 x 0.5 turned about z and shifted; then the same mirrored.
    const double c = std::cos(0.4), s = std::sin(0.4);
    for (const double mirror : {1.0, -1.0}) {
        SCOPED_TRACE(mirror);
        Geometry::Volume ball = Ball(12);
        ball.voxel_to_world = {2 * c * mirror, -s, 0, 100, 2 * s * mirror, c, 0, -50, 0, 0, 0.5, 7};
        const VolumeSurface made = SurfaceOfLabel(ball, 1);
        EXPECT_EQ(Faults(made), "");
        EXPECT_NEAR(Enclosed(made) / (4 * kPi / 3 * 12 * 12 * 12), 1, 0.01);  // 2 * 1 * 0.5 = 1, and positive
        const auto middle = ball.ToWorld({19.8, 19.8, 19.8});
        std::array<double, 3> low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
        for (std::size_t i = 0; i < made.positions.size(); ++i) {
            low[i % 3] = std::min(low[i % 3], made.positions[i]),
                    high[i % 3] = std::max(high[i % 3], made.positions[i]);
        }
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR((low[k] + high[k]) / 2, middle[k], 0.3);
        EXPECT_NEAR(high[0] - low[0], 2 * 12 * std::hypot(2 * c, s), 0.8);
        EXPECT_NEAR(high[2] - low[2], 12, 0.3);
    }
}

TEST(VolumeSurface, IsClosedOnTheFacesOfTheLastVoxels) {
    const auto full = VolumeOf({4, 5, 6}, [](double x, double, double) { return x < 3 ? 1.0 : 2.0; });
    const VolumeSurface s = SurfaceOfLabel(full, 1, {.smooth = 0});
    EXPECT_TRUE(s.touches_border);
    EXPECT_EQ(Faults(s), "");
    const auto [least, greatest] = std::minmax_element(s.positions.begin(), s.positions.end());
    EXPECT_NEAR(*least, -0.5, 1e-12);
    EXPECT_NEAR(*greatest, 5.5, 1e-12);
    // A box of 3 x 5 x 6 voxels less its edges and corners.
    EXPECT_GT(Enclosed(s), 0.9 * 90);
    EXPECT_LE(Enclosed(s), 90);
    // Where every voxel has the label, it is the whole volume.
    const auto all = VolumeOf({4, 5, 6}, [](double, double, double) { return 7.0; });
    EXPECT_GT(Enclosed(SurfaceOfLabel(all, 7)), 0.9 * 120);
}

TEST(VolumeSurface, DropsSmallPiecesAndCavitiesAndSaysHowMany) {
    Geometry::Volume ball = Ball(12);
    const auto at = [&](Offset i, Offset j, Offset k) -> double& {
        return ball.values[static_cast<std::size_t>(i + 40 * (j + 40 * k))];
    };
    at(1, 1, 1) = at(1, 38, 1) = 1;  // two specks
    at(20, 20, 20) = 0;              // a hole
    const VolumeSurface s = SurfaceOfLabel(ball, 1, {.smooth = 0});
    EXPECT_EQ(s.n_pieces, 1);
    EXPECT_EQ(s.n_dropped_pieces, 2);
    EXPECT_EQ(s.n_filled_cavities, 1);
    EXPECT_EQ(Geometry::SurfaceComponents(s.triangles, static_cast<Index>(s.positions.size() / 3)).size(), 1u);
    const VolumeSurface all = SurfaceOfLabel(ball, 1, {.smooth = 0, .least_piece = 0});
    EXPECT_EQ(all.n_pieces, 3);
    EXPECT_EQ(Geometry::SurfaceComponents(all.triangles, static_cast<Index>(all.positions.size() / 3)).size(), 4u);
}

TEST(VolumeSurface, RefusesWhatBoundsNothing) {
    const auto error_of = [](const auto& make) -> std::string {
        try {
            make();
        } catch (const InvalidInput& error) {
            return error.what();
        }
        return "none";
    };
    const Geometry::Volume ball = Ball(3, 10);
    EXPECT_THAT(error_of([&] { SurfaceOfLabel(ball, 5); }), HasSubstr("no voxel of label 5; its labels are 0, 1"));
    EXPECT_THAT(error_of([&] { SurfaceOfLevel(ball, 2); }),
                HasSubstr("level 2 bounds nothing: values are from 0 to 1"));
    EXPECT_THAT(error_of([&] { SurfaceOfLevel(ball, 0); }), HasSubstr("bounds nothing"));
    EXPECT_THAT(error_of([&] { SurfaceOfLevel(ball, std::nan("")); }), HasSubstr("bounds nothing"));
    EXPECT_THAT(error_of([&] { SurfaceOfLabel(ball, 1, {.smooth = -1}); }), HasSubstr("smooth is -1"));
    EXPECT_THAT(error_of([] { OtsuThreshold(std::vector<double>{3, 3}); }), HasSubstr("all values are 3"));
}

TEST(OtsuThreshold, LiesBetweenTwoHeapsOfValues) {
    std::vector<double> values;
    for (int i = 0; i < 1000; ++i) values.push_back(100 + 10 * Noise(i, 1, 2));
    for (int i = 0; i < 300; ++i) values.push_back(200 + 20 * Noise(i, 3, 4));
    const double level = OtsuThreshold(values);
    EXPECT_GE(level, 110);
    EXPECT_LE(level, 200);
    // A mask is parted anywhere above 0.
    EXPECT_GT(OtsuThreshold(std::vector<double>{0, 0, 1}), 0);
}

}  // namespace
}  // namespace SolidSubdiv::Voxel

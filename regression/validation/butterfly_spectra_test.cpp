// SPDX-License-Identifier: Apache-2.0
// Smoothness at vertices of every valence: the subdivision matrices of the butterfly oracle, inside and at boundaries,
// and those of OpenMesh and VTK there, whose figures docs/butterfly-boundaries.md quotes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "temporary_folder.h"
#include "validation/butterfly_oracle.h"
#include "validation/cone_surfaces.h"
#include "validation/findings.h"
#include "validation/open_mesh_oracle.h"
#include "validation/or_skip.h"
#include "validation/spectrum.h"
#include "validation/vtk_butterfly_oracle.h"

namespace SolidSubdiv::Validation {
namespace {

/// A new point depends on vertices three rings away at most, and three rings of them on three rings.
constexpr int kRadius = 3;
/// So that no vertex of those three rings is on the outer border, nor any of their wings.
constexpr int kRings = 6;

using DenseRows = std::vector<std::vector<double>>;

/// The matrix around the apex, and the positions it acts on.
struct ApexMatrix {
    std::vector<double> entries;
    int n = 0;

    explicit ApexMatrix(std::vector<double> matrix)
        : entries(std::move(matrix)), n(static_cast<int>(std::lround(std::sqrt(entries.size())))) {}

    /// Moduli of the eigenvalues, each as often as it counts, largest first.
    std::vector<double> Moduli() const {
        std::vector<double> moduli;
        for (const Eigenvalue& e : Spectrum(entries, n)) {
            moduli.insert(moduli.end(), static_cast<std::size_t>(e.multiplicity), std::abs(e.value));
        }
        return moduli;
    }
};

ApexMatrix MatrixOfOracle(const Cone& cone, const ButterflyRule& rule, double fault = 0,
                          const std::vector<int>& corners = {}) {
    const auto refined = RefineByButterflyOracle(WithCreases(cone.surface, {}, corners), rule, 1);
    const auto places = PlacesOfChildren(cone, refined.levels[0]);
    const SparseRows& step = refined.steps[0];
    DenseRows rows(static_cast<std::size_t>(step.n_rows()), std::vector<double>(cone.places.size()));
    for (int r = 0; r < step.n_rows(); ++r) {
        for (std::int64_t k = step.offsets[r]; k < step.offsets[r + 1]; ++k) rows[r][step.indices[k]] = step.weights[k];
        if (places[r] == ConePlace{1, 1, 0}) rows[r][2] += fault;  // that of the edge to vertex 2, at the same place
    }
    return ApexMatrix(SubdivisionMatrix(cone, kRadius, places, rows));
}

/// Surfaces with one vertex a coordinate at 1 and all others at 0: what a program makes of them are its rows.
std::vector<ControlSurface> Impulses(const Cone& cone) {
    std::vector<ControlSurface> surfaces;
    for (int v = 0; v < cone.surface.n_vertices; ++v) {
        if (v % 3 == 0) {
            surfaces.push_back(cone.surface);
            std::fill(surfaces.back().positions.begin(), surfaces.back().positions.end(), 0.0);
        }
        surfaces.back().positions[3 * v + v % 3] = 1;
    }
    return surfaces;
}

ApexMatrix MatrixOfImpulses(const Cone& cone, const std::vector<std::vector<SurfaceLevel>>& refined) {
    DenseRows rows(static_cast<std::size_t>(refined.at(0).at(1).n_vertices), std::vector<double>(cone.places.size()));
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (std::size_t v = 0; v < cone.places.size(); ++v) {
            rows[r][v] = refined[v / 3].at(1).positions[3 * r + v % 3];
        }
    }
    return ApexMatrix(SubdivisionMatrix(cone, kRadius, PlacesOfChildren(cone, refined[0][0]), rows));
}

/// How far the new points on the apex's edges, of length 1, are from the middles: 0 where planes are reproduced, as the
/// cone's rays are at equal angles.
double OffMiddles(const Cone& cone, const std::vector<SurfaceLevel>& levels) {
    double largest = 0;
    for (std::size_t e = 0; e < levels.at(0).edges.size(); ++e) {
        const auto [a, b] = levels[0].edges[e];
        if (a != 0 && b != 0) continue;
        const double* end = &cone.surface.positions[3 * std::max(a, b)];
        const double* point = &levels.at(1).positions[3 * levels[0].children_of_edges[e]];
        largest = std::max(largest, std::hypot(point[0] - end[0] / 2, point[1] - end[1] / 2));
    }
    return largest;
}

/// Simple or with a full set of eigenvectors, so exact to 1e-15; the 1/4s of k = 3 and 6 have none: 1e-16 to the power
/// of a quarter for a block of four.
constexpr double kExact = 1e-9, kOfBlocks = 1e-4;

void ExpectSmooth(const std::vector<double>& moduli, const std::string& where) {
    ASSERT_GT(moduli.size(), 4U);
    EXPECT_NEAR(moduli[0], 1, kExact) << where;
    EXPECT_NEAR(moduli[1], 0.5, kExact) << where;
    EXPECT_NEAR(moduli[2], 0.5, kExact) << where;
    EXPECT_NEAR(moduli[3], 0.25, kOfBlocks) << where;
}

class ButterflySpectra : public testing::Test {
  protected:
    void SetUp() override {
        OrSkip([&] { MatrixOfOracle(MakeCone(6, true, kRings), ButterflyRule()).Moduli(); });
    }
};

TEST_F(ButterflySpectra, ModifiedIsSmoothAtEveryValence) {
    for (int n = 3; n <= 12; ++n) {
        ExpectSmooth(MatrixOfOracle(MakeCone(n, true, kRings), {}).Moduli(), "inside, n = " + std::to_string(n));
    }
    for (int k = 2; k <= 12; ++k) {
        ExpectSmooth(MatrixOfOracle(MakeCone(k, false, kRings), {}).Moduli(), "boundary, k = " + std::to_string(k));
    }
}

TEST_F(ButterflySpectra, OneTriangleIsAConvexCorner) {
    const auto moduli = MatrixOfOracle(MakeCone(1, false, kRings), {}).Moduli();
    EXPECT_NEAR(moduli[0], 1, kExact);
    EXPECT_NEAR(moduli[1], 0.5, kExact);
    EXPECT_NEAR(moduli[2], 0.25, kOfBlocks);  // one tangent: the border's
}

TEST_F(ButterflySpectra, CornersHaveATangentForEachBorderAndOneMore) {
    for (int k = 2; k <= 8; ++k) {  // so no tangent plane: the surface is a cone there
        // With three triangles the regular rule holds, and two of the 1/2s share an eigenvector: found to the root of
        // round-off, and slopes grow as the number of levels.
        const double tolerance = k == 3 ? 1e-6 : kExact;
        const auto moduli = MatrixOfOracle(MakeCone(k, false, kRings), {}, 0, {0}).Moduli();
        for (int i : {1, 2, 3}) EXPECT_NEAR(moduli[i], 0.5, tolerance) << k;
        EXPECT_NEAR(moduli[4], 0.25, kOfBlocks) << k;
    }
    ButterflyRule rule;
    rule.has_regular_corners = false;  // the mask has three eigenvectors
    const auto moduli = MatrixOfOracle(MakeCone(3, false, kRings), rule, 0, {0}).Moduli();
    for (int i : {1, 2, 3}) EXPECT_NEAR(moduli[i], 0.5, kExact);
}

TEST_F(ButterflySpectra, PlanesAreReproducedAtBoundaryVertices) {
    for (int k = 2; k <= 12; ++k) {
        const Cone cone = MakeCone(k, false, kRings);
        EXPECT_LT(OffMiddles(cone, RefineByButterflyOracle(cone.surface, {}, 1).levels), 1e-14) << k;
    }
}

TEST_F(ButterflySpectra, CatchAWeightOffByAMillionth) {
    for (const bool is_closed : {true, false}) {
        const auto moduli = MatrixOfOracle(MakeCone(5, is_closed, kRings), {}, 1e-6).Moduli();
        EXPECT_GT(std::abs(moduli[1] - 0.5) + std::abs(moduli[2] - 0.5), 100 * kExact);
    }
}

TEST_F(ButterflySpectra, TrianglesAroundBoundaryVerticesDoNotFlip) {
    for (int k = 2; k <= 12; ++k) {
        const Cone cone = MakeCone(k, false, kRings);
        const ApexMatrix matrix = MatrixOfOracle(cone, {});
        std::vector<double> points;  // tends to the characteristic map's control points
        for (int v = 0; v < matrix.n; ++v) {
            points.insert(points.end(), {cone.surface.positions[3 * v], cone.surface.positions[3 * v + 1]});
        }
        for (int step = 0; step < 30; ++step) {  // (1/4 : 1/2)^30 = 1e-9
            std::vector<double> next(points.size());
            for (int i = 0; i < matrix.n; ++i) {
                for (int j = 0; j < matrix.n; ++j) {
                    for (int c = 0; c < 2; ++c)
                        next[2 * i + c] += 2 * matrix.entries[i * matrix.n + j] * points[2 * j + c];
                }
            }
            points = next;
        }
        for (const Triangle& t : cone.surface.triangles) {
            if (*std::max_element(t.begin(), t.end()) >= matrix.n) continue;  // vertices are numbered ring by ring
            const auto side = [&](int v, int c) { return points[2 * t[v] + c] - points[2 * t[0] + c]; };
            EXPECT_GT(side(1, 0) * side(2, 1) - side(1, 1) * side(2, 0), 0.01) << "k = " << k;
        }
    }
}

TEST_F(ButterflySpectra, WithoutMasksBoundaryVerticesAreNotSmooth) {
    // The two largest after 1, by k = 2 to 8; OpenMesh has the same: reflected wings, no masks for boundary vertices.
    const double quoted[][2] = {{0.5, 0.4690}, {0.5, 0.5},    {0.5, 0.4690}, {0.5067, 0.5},
                                {0.5, 0.5},    {0.5020, 0.5}, {0.5070, 0.5}};
    const double off_plane[] = {0, 0, 0.0366, 0.0625, 0.0792, 0.0903, 0.0979};
    constexpr double kRounding = 5e-5;
    for (int k = 2; k <= 8; ++k) {
        const Cone cone = MakeCone(k, false, kRings);
        const auto moduli = MatrixOfOracle(cone, ButterflyRule::Plain()).Moduli();
        const auto without = RefineByButterflyOracle(cone.surface, ButterflyRule::Plain(), 1);
        EXPECT_NEAR(OffMiddles(cone, without.levels), off_plane[k - 2], kRounding) << k;
        EXPECT_NEAR(moduli[1], quoted[k - 2][0], kRounding) << k;
        EXPECT_NEAR(moduli[2], quoted[k - 2][1], kRounding) << k;
        std::vector<std::vector<SurfaceLevel>> by_open_mesh;
        try {
            for (const ControlSurface& surface : Impulses(cone)) by_open_mesh.push_back(RefineByOpenMesh(surface, 1));
        } catch (const Unavailable&) {
            continue;
        }
        EXPECT_NEAR(OffMiddles(cone, RefineByOpenMesh(cone.surface, 1)), off_plane[k - 2], kRounding) << k;
        const auto theirs = MatrixOfImpulses(cone, by_open_mesh).Moduli();
        for (int i : {1, 2}) EXPECT_NEAR(theirs[i], moduli[i], kExact) << k;
    }
}

TEST_F(ButterflySpectra, VtkIsNotSmoothAtBoundaries) {
    const double quoted[] = {0.3639, 0.3549, 0.4101, 0.3992, 0.4494, 0.4592, 0.4669};  // k = 2 to 8, beside 1/2
    const double off_plane[] = {0.125, 0.125, 0.1338, 0.1343, 0.1331, 0.1318, 0.1306};
    const TemporaryFolder scratch;
    std::vector<ControlSurface> all;
    for (int k = 2; k <= 8; ++k) {
        const Cone cone = MakeCone(k, false, kRings);
        all.push_back(cone.surface);
        for (ControlSurface& surface : Impulses(cone)) all.push_back(std::move(surface));
    }
    std::vector<VtkRefinement> refined;
    OrSkip([&] {
        const std::filesystem::path source = SOLIDSUBDIV_SOURCE;
        refined = RefineByVtk(source / "validation" / "vtk_butterfly.py", scratch.Path(), all, 1);
    });
    if (refined.empty()) return;
    std::size_t next = 0;
    for (int k = 2; k <= 8; ++k) {
        const Cone cone = MakeCone(k, false, kRings);
        EXPECT_NEAR(OffMiddles(cone, refined[next++].levels), off_plane[k - 2], 5e-5) << k;
        std::vector<std::vector<SurfaceLevel>> levels;
        while (levels.size() < Impulses(cone).size()) {
            ASSERT_EQ(refined[next].refused, "");
            levels.push_back(refined[next++].levels);
        }
        const auto moduli = MatrixOfImpulses(cone, levels).Moduli();
        EXPECT_NEAR(moduli[1], 0.5, kExact) << k;
        EXPECT_NEAR(moduli[2], quoted[k - 2], 5e-5) << k;
    }
}

}  // namespace
}  // namespace SolidSubdiv::Validation

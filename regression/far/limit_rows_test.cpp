// SPDX-License-Identifier: Apache-2.0
// Laws of limit rows at places: sums, derivatives against differences, tangents, threads, defects.
#include "limit_places_testing.h"

namespace SolidSubdiv::TestFar {
namespace {

/// Rows sum to one, those of derivatives to zero and to differences.
void ExpectLawsOfRows(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme, Elements elements) {
    const std::vector<Place> places = RandomPlaces(refiner, elements, FewerIfSanitized(12));
    if (places.empty()) return;
    const auto values = RandomValues(refiner.n_vertices(0));
    const int d = elements == Elements::Cells ? 3 : 2;
    const std::string_view kind = Sdc::NameOf(scheme);
    const bool interpolates = kind == "interpolatory" || kind == "butterfly" || kind == "modified-butterfly";
    const auto table = LimitStencilTable::Create(refiner, scheme, places, {.elements = elements, .order = 1});
    ASSERT_EQ(table.n_derivatives(), d);
    std::vector<Place> moved;
    // Slopes of interpolating schemes are continuous but no more: differences come nearer slowly.
    const double wide_step = interpolates ? 1e-3 : 1e-4, narrow_step = interpolates ? 1e-6 : 5e-5;
    const std::array<double, 4> steps{wide_step, -wide_step, narrow_step, -narrow_step};
    for (const Place& place : places) {
        for (int a = 0; a < d; ++a) {
            for (double step : steps) {
                moved.push_back(place);
                moved.back().at[static_cast<std::size_t>(a)] += step;
            }
        }
    }
    const auto around = LimitStencilTable::Create(refiner, scheme, moved, {.elements = elements}).rows();
    for (int a = 0; a < d; ++a) {
        const auto rows = table.DerivativeRows(a);
        for (Index i = 0; i < rows.n_rows(); ++i) {
            double sum = 0, sum_of_derivative = 0;
            for (double w : table.rows().Weights(i)) sum += w;
            for (double w : rows.Weights(i)) sum_of_derivative += w;
            EXPECT_NEAR(sum, 1, 1e-13);
            EXPECT_NEAR(sum_of_derivative, 0, 3e-7);  // with no closed form: round-off of tens of weights times 2^26
            const auto slope = PointOf(rows, i, values);
            std::array<std::array<double, 3>, 4> p;
            for (std::size_t k = 0; k < 4; ++k) {
                p[k] = PointOf(around, 4 * (d * i + a) + static_cast<Index>(k), values);
            }
            for (std::size_t c = 0; c < 3; ++c) {
                const double wide = (p[0][c] - p[1][c]) / (2 * wide_step);
                const double narrow = (p[2][c] - p[3][c]) / (2 * narrow_step);
                // As near as differences are to each other as they get narrower (at a step 1000 times as narrow, a
                // fraction of it); 1e-7: round-off of 1e-12 / 5e-5; 1e-5: slopes that change by step * log(step).
                const double tolerance =
                    interpolates ? 0.3 * std::abs(wide - narrow) + 1e-5 : std::abs(wide - narrow) + 1e-7;
                EXPECT_NEAR(slope[c], narrow, tolerance) << "place " << i << " derivative " << a << " of element "
                                                         << places[static_cast<std::size_t>(i)].element;
            }
        }
    }
}

TEST(LimitRows, Rows_SumToOneAndDerivativesAreDifferences) {
    for (const auto& [name, shape] : TestShapes::AllShapes()) {
        const auto refiner = Refined(shape, 0, true);
        Sdc::ForEachScheme([&, label = std::string(name)](const auto& scheme) {
            using S = std::remove_cvref_t<decltype(scheme)>;
            if (!Sdc::Takes<S>(Sdc::Split::TetOct) || (!S::kSolids && refiner.n_cells(0) > 0)) return;
            SCOPED_TRACE(label + ", " + std::string(S::kName));
            if (S::kSolids) ExpectLawsOfRows(refiner, scheme, Elements::Cells);
            ExpectLawsOfRows(refiner, scheme, Elements::BoundaryFaces);
        });
    }
    for (const auto& [name, shape] : TestShapes::PolyhedralShapes()) {
        const auto refiner = Far::TopologyRefiner::Create(Describe(shape), Sdc::Split::Polyhedral);
        Sdc::ForEachScheme([&, label = std::string(name)](const auto& scheme) {
            using S = std::remove_cvref_t<decltype(scheme)>;
            if (!Sdc::Takes<S>(Sdc::Split::Polyhedral) || (!S::kSolids && refiner.n_cells(0) > 0)) return;
            SCOPED_TRACE(label + ", " + std::string(S::kName));
            if (S::kSolids) ExpectLawsOfRows(refiner, scheme, Elements::Cells);
            ExpectLawsOfRows(refiner, scheme, Elements::BoundaryFaces);
        });
    }
}

TEST(LimitRows, Tables_AreTheSameForAnyNumberOfThreadsAndOrderOfPlaces) {
    const auto refiner = Refined(TestShapes::RandomSubset(TestShapes::KuhnBlock(2), 70, 3), 0, true);
    std::vector<Place> places = RandomPlaces(refiner, Elements::Cells, 2000);
    const LimitPlacesOptions options{.order = 1};
    const auto table = LimitStencilTable::Create(refiner, Sdc::BoxSpline{}, places, options);
    const auto expect_same = [&](const LimitStencilTable& other, auto&& row_of) {
        for (Index i = 0; i < table.rows().n_rows(); ++i) {
            const auto a = table.rows().Indices(i), b = other.rows().Indices(row_of(i));
            const auto v = table.rows().Weights(i), w = other.rows().Weights(row_of(i));
            ASSERT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
            ASSERT_TRUE(std::equal(v.begin(), v.end(), w.begin(), w.end()));
        }
    };
    {
        const Sdc::ThreadLimit one(1);
        expect_same(LimitStencilTable::Create(refiner, Sdc::BoxSpline{}, places, options), [](Index i) { return i; });
    }
    std::reverse(places.begin(), places.end());
    expect_same(LimitStencilTable::Create(refiner, Sdc::BoxSpline{}, places, options),
                [&](Index i) { return table.rows().n_rows() - 1 - i; });
}

// An octahedron's vertices have valence four: eigenvalues there are not 1/2, so derivatives vanish; tangents do not.
TEST(LimitRows, ExtraordinaryVertices_HaveTangents) {
    const auto shape = TestShapes::OctahedronSurface();
    const auto refiner = Refined(shape, 0, true);
    std::vector<Place> corners;
    for (Index f = 0; f < refiner.level(0).n_boundary_faces; ++f) corners.push_back({.element = f});
    const auto derivatives =
        LimitStencilTable::Create(refiner, Sdc::Loop{}, corners, {.elements = Elements::BoundaryFaces, .order = 1});
    const auto table = LimitStencilTable::Create(refiner, Sdc::Loop{}, corners,
                                                 {.elements = Elements::BoundaryFaces, .order = 1, .tangents = true});
    const auto du = table.DerivativeRows(0), dv = table.DerivativeRows(1), vanishing = derivatives.DerivativeRows(0);
    for (Index i = 0; i < du.n_rows(); ++i) {
        for (double w : vanishing.Weights(i)) EXPECT_NEAR(w, 0, 1e-10);
        const auto u = PointOf(du, i, shape.positions), v = PointOf(dv, i, shape.positions);
        const auto p = PointOf(table.rows(), i, shape.positions);
        // Of a centred octahedron: the tangents are orthogonal to the point, and the normal points outwards.
        EXPECT_NEAR(u[0] * p[0] + u[1] * p[1] + u[2] * p[2], 0, 1e-12);
        EXPECT_NEAR(v[0] * p[0] + v[1] * p[1] + v[2] * p[2], 0, 1e-12);
        const std::array<double, 3> normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                           u[0] * v[1] - u[1] * v[0]};
        EXPECT_GT(std::abs(normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2]), 1e-2);
    }
}

TEST(LimitRows, MissingDerivatives_AreDefects) {
    // Five hexahedra around an edge: across it an eigenvalue is .550, and slopes grow without bound.
    std::vector<Index> hexes;
    for (Index i = 0; i < 5; ++i) {
        for (Index layer : {0, 11}) {
            const Index corner = layer + 1 + 2 * i;
            hexes.insert(hexes.end(), {layer, corner, corner + 1, layer + 1 + 2 * ((i + 1) % 5)});
        }
    }
    Far::TopologyDescriptor mesh{.n_vertices = 22};
    mesh.hexes = hexes;
    const auto refiner = Far::TopologyRefiner::Create(mesh, Sdc::Split::Polyhedral);
    const std::vector<Place> places{{0, 0, {0, 0, .5}}, {0, 0, {.3, .3, .2}}};
    const Sdc::CatmullClarkSolid scheme;
    const auto table = LimitStencilTable::Create(refiner, scheme, places, {.order = 1});
    ASSERT_EQ(table.defects().size(), 1u);
    EXPECT_EQ(table.defects()[0].code, Far::DefectCode::NoDerivative);
    EXPECT_EQ(table.defects()[0].element, 0);
    EXPECT_TRUE(table.without_limit().empty());
    const auto du = table.DerivativeRows(0);
    for (double w : du.Weights(0)) EXPECT_EQ(w, 0);

    EXPECT_THROW(LimitStencilTable::Create(refiner, scheme, places, {.order = 3}), InvalidInput);
    EXPECT_THROW(LimitStencilTable::Create(refiner, scheme, places, {.level = 1}), InvalidInput);
    EXPECT_THROW(LimitStencilTable::Create(refiner, Sdc::BoxSpline{}, places, {}), InvalidInput);
}

// Where a place never becomes regular its derivatives settle or are not there: they are never what rounding left.
TEST(LimitRows, DerivativesOnSidesOfElements_SumToZeroOrAreDefects) {
    for (const auto& [name, shape] : TestShapes::AllShapes()) {
        const auto refiner = Refined(shape, 0, true);
        std::vector<Place> places = RandomPlaces(refiner, Elements::Cells, 12);
        for (std::size_t i = 0; i < places.size(); ++i) {
            places[i].at[i % 3] = 0;
            if (i % 2 == 0) places[i].at[(i + 1) % 3] = 0;
        }
        Sdc::ForEachScheme([&, label = std::string(name)](const auto& scheme) {
            using S = std::remove_cvref_t<decltype(scheme)>;
            if (!Sdc::Takes<S>(Sdc::Split::TetOct) || !S::kSolids || places.empty()) return;
            SCOPED_TRACE(label + ", " + std::string(S::kName));
            const auto table = LimitStencilTable::Create(refiner, scheme, places, {.order = 2});
            for (int k = 0; k < table.n_derivatives(); ++k) {
                const auto rows = table.DerivativeRows(k);
                for (Index i = 0; i < rows.n_rows(); ++i) {
                    double sum = 0;
                    for (double w : rows.Weights(i)) sum += w;
                    // First: round-off of tens of weights times 2^26; second: times 4^13.
                    EXPECT_NEAR(sum, 0, 3e-7) << "place " << i << " derivative " << k;
                }
            }
        });
    }
}

// At a border vertex slopes along the border and across it shrink at rates of their own; the plane that they span is
// the surface's all the same, or is listed as missing (where the second and the third rate are all but equal).
TEST(LimitRows, TangentsAtBorders_SpanTheTangentPlane) {
    using Normal = std::optional<std::array<double, 3>>;
    const auto normal_at = [](const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme, const Place& place,
                              const std::vector<double>& positions) -> Normal {
        const auto table = LimitStencilTable::Create(
            refiner, scheme, {&place, 1}, {.elements = Elements::BoundaryFaces, .order = 1, .tangents = true});
        if (!table.defects().empty()) return std::nullopt;
        const auto u = PointOf(table.DerivativeRows(0), 0, positions),
                   v = PointOf(table.DerivativeRows(1), 0, positions);
        std::array<double, 3> n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
        const double length = std::hypot(n[0], n[1], n[2]);
        for (double& x : n) x /= length;
        return n;
    };
    int n_corners = 0, n_missing = 0;
    for (Index k : {2, 3, 4, 5}) {  // faces around a border vertex
        SCOPED_TRACE(k);
        std::vector<double> positions{0, 0, 0};
        std::vector<Index> triangles, quads;
        for (Index i = 0; i <= 2 * k; ++i) {
            const double angle = 3.0 * i / (2 * k);
            positions.insert(positions.end(), {std::cos(angle), std::sin(angle), 0.3 * std::cos(2 * angle)});
        }
        for (Index i = 0; i < k; ++i) {
            triangles.insert(triangles.end(), {0, 1 + 2 * i, 3 + 2 * i});
            quads.insert(quads.end(), {0, 1 + 2 * i, 2 + 2 * i, 3 + 2 * i});
        }
        Far::TopologyDescriptor fan{.n_vertices = 2 * k + 2};
        const auto check = [&](const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme) {
            for (Index f = 0; f < k; ++f) {
                // Listed from the vertex in the middle, as given: its corner has the coordinates 0.
                const Normal corner = normal_at(refiner, scheme, {.element = f}, positions);
                const Normal near = normal_at(refiner, scheme, {f, 0, {1e-7, 1e-7, 0}}, positions);
                ++n_corners;
                n_missing += !corner;
                ASSERT_TRUE(near);
                // Normals turn slowly where rates are near each other.
                const double turned = corner ? Distance(*corner, *near) : 0.0;
                EXPECT_LT(turned, 2e-2) << "face " << f;
            }
        };
        fan.triangles = triangles;
        check(Far::TopologyRefiner::Create(fan, Sdc::Split::TetOct), Sdc::Loop{});
        fan.triangles = {};
        fan.quads = quads;
        check(Far::TopologyRefiner::Create(fan, Sdc::Split::Polyhedral), Sdc::CatmullClark{});
    }
    EXPECT_LE(n_missing, n_corners / 10);
}

}  // namespace
}  // namespace SolidSubdiv::TestFar

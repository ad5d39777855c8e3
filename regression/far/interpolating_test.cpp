// SPDX-License-Identifier: Apache-2.0
// Laws of the schemes that keep every vertex: interpolation, tension, polynomials, what they reduce to.
#include <functional>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/far/stencil_table.h>

#include "far/far_testing.h"

namespace {

using namespace SolidSubdiv;
using namespace SolidSubdiv::TestFar;
using TestShapes::Shape;

std::vector<Sdc::Scheme> InterpolatingSchemes() {
    Sdc::ModifiedButterfly ten_points;
    ten_points.far_weight = 0.02;
    Sdc::Interpolatory plain;
    plain.boundary = Sdc::ButterflyKind::Plain;
    return {Sdc::Interpolatory{}, plain, Sdc::Butterfly{}, Sdc::ModifiedButterfly{}, ten_points};
}

TEST(Interpolation, EveryVertexStaysAtEveryLevel) {
    for (const auto& [name, shape] : TestShapes::AllShapes()) {
        for (const Sdc::Scheme& scheme : InterpolatingSchemes()) {
            if (!IsSolid(scheme) && !(shape.tets.empty() && shape.octs.empty())) continue;
            SCOPED_TRACE(std::string(name) + ", " + std::string(Sdc::NameOf(scheme)));
            auto refined = Apply(Far::StencilTable::Create(Refined(shape, 3), scheme), shape.positions);
            refined.resize(shape.positions.size());
            EXPECT_EQ(refined, shape.positions);
        }
    }
}

TEST(Interpolation, TensionZeroIsLinear) {
    for (const auto& [name, shape] : TestShapes::AllShapes()) {
        if (!shape.octs.empty()) continue;  // their centres: of the major diagonal here, of all six there
        SCOPED_TRACE(name);
        const auto refiner = Refined(shape, 3);
        const auto linear = Apply(Far::StencilTable::Create(refiner, Sdc::LinearSolid{}), shape.positions);
        ExpectNear(Apply(Far::StencilTable::Create(refiner, Sdc::Interpolatory{.tension = 0}), shape.positions), linear,
                   1e-14);
        if (!shape.tets.empty()) continue;
        ExpectNear(Apply(Far::StencilTable::Create(refiner, Sdc::Butterfly{.tension = 0}), shape.positions), linear,
                   1e-14);
        EXPECT_EQ(Apply(Far::StencilTable::Create(refiner, Sdc::LinearSurface{}), shape.positions), linear);
    }
}

TEST(Interpolation, NoVertexStandsTwiceInARow) {
    for (const auto& [name, shape] : TestShapes::AllShapes()) {
        for (const Sdc::Scheme& scheme : InterpolatingSchemes()) {
            if (!IsSolid(scheme) && !(shape.tets.empty() && shape.octs.empty())) continue;
            SCOPED_TRACE(std::string(name) + ", " + std::string(Sdc::NameOf(scheme)));
            const auto table = Far::StencilTable::Create(Refined(shape, 2), scheme);
            for (int l = 1; l <= 2; ++l) {
                for (Index row = 0; row < table.level(l).n_rows(); ++row) {
                    std::vector<Index> indices(table.level(l).Indices(row).begin(), table.level(l).Indices(row).end());
                    std::sort(indices.begin(), indices.end());
                    ASSERT_EQ(std::adjacent_find(indices.begin(), indices.end()), indices.end());
                }
            }
        }
    }
}

using Function = std::function<double(double, double, double)>;

std::vector<double> ValuesAt(const std::vector<double>& positions, const Function& f) {
    std::vector<double> values(positions.size() / 3);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = f(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
    return values;
}

/// The octet truss inside one tet, of edges 1 along u1 = (1,0,0), u2 = (0,1,0), u3 = (0,0,1); u4 = -(u1 + u2 + u3).
Shape OctetTruss(int levels) {
    Shape tet = TestShapes::SingleTet();
    const double n = 1 << levels;
    tet.positions = {0, 0, 0, n, n, 0, n, 0, 0, n, n, n};
    const auto refiner = Refined(tet, levels, true);
    return AsShape(refiner.level(levels), Apply(Far::StencilTable::Create(refiner, Sdc::LinearSolid{}), tet.positions));
}

/// Rows of one refinement that are neither a vertex's nor the mean of two.
struct WideRow {
    Index a, b, child;
};
std::vector<WideRow> WideRows(const Far::StencilRows<double>& rows) {
    std::vector<WideRow> wide;
    for (Index i = 0; i < rows.n_rows(); ++i) {
        if (rows.Indices(i).size() > 2) wide.push_back({rows.Indices(i)[0], rows.Indices(i)[1], i});
    }
    return wide;
}

/// The largest error among wide rows inside the solid or surface where values are those of f.
double ErrorOf(const Shape& shape, const Sdc::Scheme& scheme, const Function& f, int& n_rows, double fault = 0) {
    const auto refiner = Refined(shape, 1, true);
    auto rows = Far::StencilTable::Create(refiner, scheme).level(1);
    const auto linear = Apply(Far::StencilTable::Create(refiner, Sdc::Interpolatory{.tension = 0}), shape.positions);
    const auto wanted = ValuesAt(linear, f);
    const auto wide = WideRows(rows);
    const Vtr::Rule inside = shape.tets.empty() ? Vtr::Rule::Surface : Vtr::Rule::Solid;
    double largest = 0;
    n_rows = 0;
    if (fault != 0) {
        for (Index i = 0; i < rows.n_rows(); ++i) {
            if (rows.Indices(i).size() > 2) rows.weights[rows.offsets[i] + 2] += fault;
        }
    }
    const auto got = Apply(Far::StencilTable::FromRows(shape.n_vertices, {rows}), ValuesAt(shape.positions, f), 1);
    for (const WideRow& row : wide) {
        if (refiner.level(1).vertex_tags[row.child].rule() != inside) continue;
        // On surfaces: only where no wing is reflected across a border.
        if (shape.tets.empty() && rows.Indices(row.child).size() < 8) continue;
        largest = std::max(largest, std::abs(got[row.child] - wanted[row.child]));
        ++n_rows;
    }
    return largest;
}

double Cubic(double x, double y, double z) {
    return x * x * x - 2 * x * x * y + 0.5 * x * y * z + y * z * z - z * z * z + 3 * x * x - y * z + 2 * x - 1;
}

// Values reach 5e3 in the block: 1e-11 is a few units of their round-off (6e-13) times the weights.
TEST(Interpolation, RegularBlocksReproduceCubicsAtOneSixteenth) {
    const Shape truss = OctetTruss(4);
    int n = 0;
    EXPECT_LT(ErrorOf(truss, Sdc::Interpolatory{}, Cubic, n), 1e-11);
    EXPECT_GT(n, 1000);
    EXPECT_GT(ErrorOf(truss, Sdc::Interpolatory{}, Cubic, n, 1e-6), 1e-7) << "a planted fault";
    EXPECT_GT(ErrorOf(truss, Sdc::Interpolatory{.tension = 1.0 / 20}, Cubic, n), 1e-3) << "other tensions don't";
    const auto linear = [](double x, double y, double z) { return 3 * x - y + 2 * z; };
    EXPECT_LT(ErrorOf(truss, Sdc::Interpolatory{.tension = 1.0 / 20}, linear, n), 1e-12) << "but linear functions";
}

TEST(Interpolation, RegularTriangulationsReproduceCubicsAtOneSixteenth) {
    const Shape grid = TestShapes::TriangleGrid(10);
    Sdc::ModifiedButterfly ten_points;
    ten_points.far_weight = 0.02;
    for (const Sdc::Scheme& scheme : {Sdc::Scheme(Sdc::Butterfly{}), Sdc::Scheme(Sdc::ModifiedButterfly{})}) {
        int n = 0;
        EXPECT_LT(ErrorOf(grid, scheme, Cubic, n), 1e-12);
        EXPECT_GT(n, 200);
        EXPECT_GT(ErrorOf(grid, scheme, Cubic, n, 1e-6), 1e-7) << "a planted fault";
    }
    int n = 0;
    EXPECT_GT(ErrorOf(grid, Sdc::Butterfly{.tension = 1.0 / 20}, Cubic, n), 1e-3);
    const auto quadratic = [](double x, double y, double) { return x * x - 3 * x * y + y * y; };
    EXPECT_LT(ErrorOf(grid, ten_points, quadratic, n), 1e-12);
}

/// Plane coordinates of a point of the truss seen along u4: u1 -> (1, 0), u2 -> (0, 1), u3 -> (-1, -1).
std::array<int, 2> SeenAlongU4(const double* x) {
    return {static_cast<int>(std::lround(x[0] - x[2])), static_cast<int>(std::lround(x[1] - x[2]))};
}

// rules.md section 3, oracle: there a link of six is the butterfly's eight points, two of its vertices and wings alike.
TEST(Interpolation, DataConstantAlongADirectionFollowTheButterfly) {
    const Shape truss = OctetTruss(4);
    const double w = 0.05;
    TestShapes::Random random(5);
    std::map<std::array<int, 2>, double> plane;
    const auto value = [&](std::array<int, 2> p) {
        const auto [at, is_new] = plane.emplace(p, 0.0);
        if (is_new) at->second = random.Uniform();
        return at->second;
    };
    std::vector<double> values;
    for (Index v = 0; v < truss.n_vertices; ++v) values.push_back(value(SeenAlongU4(&truss.positions[3 * v])));

    const auto refiner = Refined(truss, 1, true);
    const auto table = Far::StencilTable::Create(refiner, Sdc::Interpolatory{.tension = w});
    const auto refined = Apply(table, values, 1);
    int n = 0;
    for (const WideRow& row : WideRows(table.level(1))) {
        if (refiner.level(1).vertex_tags[row.child].rule() != Vtr::Rule::Solid) continue;
        if (table.level(1).Indices(row.child).size() != 14) continue;  // a link of six
        const auto a = SeenAlongU4(&truss.positions[3 * row.a]), b = SeenAlongU4(&truss.positions[3 * row.b]);
        if (a == b) continue;
        const auto plus = [](auto p, auto q) { return std::array<int, 2>{p[0] + q[0], p[1] + q[1]}; };
        const auto minus = [](auto p, auto q) { return std::array<int, 2>{p[0] - q[0], p[1] - q[1]}; };
        const auto along = minus(b, a);
        double expected = (value(a) + value(b)) / 2;
        int n_opposite = 0;
        for (const std::array<int, 2> side : {std::array<int, 2>{1, 0}, {0, 1}, {-1, -1}, {-1, 0}, {0, -1}, {1, 1}}) {
            // c is a neighbour of both ends: a + side, where b - c is a direction of the lattice too.
            const auto c = plus(a, side), rest = minus(b, c);
            const bool is_direction = (rest[0] == 0) + (rest[1] == 0) + (rest[0] == rest[1]) == 1 &&
                                      std::abs(rest[0]) <= 1 && std::abs(rest[1]) <= 1;
            if (!is_direction || side == along) continue;
            ++n_opposite;
            expected += 2 * w * value(c) - w * value(minus(plus(a, c), b)) - w * value(minus(plus(b, c), a));
        }
        ASSERT_EQ(n_opposite, 2);
        ASSERT_NEAR(refined[row.child], expected, 1e-14);
        ++n;
    }
    EXPECT_GT(n, 300);
}

// A wing across a border is the parallelogram's corner, a border follows the 4-point rule: linear functions stay but
// where the border turns a corner.
TEST(Interpolation, LinearFunctionsStayUpToStraightBorders) {
    constexpr int kSize = 8;
    const Shape grid = TestShapes::TriangleGrid(kSize);
    const auto linear = [](double x, double y, double) { return 3 * x - 2 * y + 1; };
    for (const Sdc::Scheme& scheme : {Sdc::Scheme(Sdc::Butterfly{}), Sdc::Scheme(Sdc::Butterfly{.tension = 0.1})}) {
        const auto refiner = Refined(grid, 2);
        const auto points = Apply(Far::StencilTable::Create(refiner, Sdc::LinearSurface{}), grid.positions);
        const auto wanted = ValuesAt(points, linear);
        const auto got = Apply(Far::StencilTable::Create(refiner, scheme), ValuesAt(grid.positions, linear), 1);
        int n_border = 0;
        for (std::size_t v = 0; v < got.size(); ++v) {
            const double x = points[3 * v], y = points[3 * v + 1];
            const bool in_corner = std::min(x, kSize - x) < 3 && std::min(y, kSize - y) < 3;
            if (in_corner) continue;
            ASSERT_NEAR(got[v], wanted[v], 1e-13) << x << " " << y;
            n_border += x == 0 || y == 0;
        }
        EXPECT_GT(n_border, 10);
    }
}

// Polylines: an open one ends with parabolas, so quadratic functions stay everywhere; a closed one has no end.
TEST(Interpolation, CurvesReproduceQuadraticsUpToTheirEnds) {
    Shape line;
    line.n_vertices = 7;
    for (Index v = 0; v < 7; ++v) line.positions.insert(line.positions.end(), {static_cast<double>(v), 0, 0});
    for (Index v = 0; v < 6; ++v) line.edges.insert(line.edges.end(), {v, v + 1});
    const auto quadratic = [](double x, double, double) { return x * x - 3 * x + 2; };
    const auto refiner = Refined(line, 2);
    const auto points = Apply(Far::StencilTable::Create(refiner, Sdc::LinearSurface{}), line.positions);
    ExpectNear(Apply(Far::StencilTable::Create(refiner, Sdc::Butterfly{}), ValuesAt(line.positions, quadratic), 1),
               ValuesAt(points, quadratic), 1e-13);

    Shape loop = line;
    loop.edges.insert(loop.edges.end(), {6, 0});
    const auto rows = Far::StencilTable::Create(Refined(loop, 1), Sdc::Butterfly{}).level(1);
    for (Index e = 7; e < 14; ++e) {
        EXPECT_THAT(std::vector<double>(rows.Weights(e).begin(), rows.Weights(e).end()),
                    testing::ElementsAre(9.0 / 16, 9.0 / 16, -1.0 / 16, -1.0 / 16));
    }
}

// Boundary triangles are a surface of their own: the same rows, whatever is inside.
TEST(Interpolation, TheBoundaryOfASolidIsTheButterflyOfItsSurface) {
    for (const auto& [name, solid] : TestShapes::AllShapes()) {
        if (solid.tets.empty() || !solid.triangles.empty()) continue;
        SCOPED_TRACE(name);
        const auto refiner = Refined(solid, 3, true);
        Shape surface;
        surface.n_vertices = solid.n_vertices;
        surface.positions = solid.positions;
        surface.triangles.assign(refiner.level(0).boundary_vertices.begin(), refiner.level(0).boundary_vertices.end());
        for (const bool is_plain : {false, true}) {
            Sdc::Interpolatory scheme;
            scheme.boundary = is_plain ? Sdc::ButterflyKind::Plain : Sdc::ButterflyKind::Modified;
            const Sdc::Scheme butterfly =
                is_plain ? Sdc::Scheme(Sdc::Butterfly{}) : Sdc::Scheme(Sdc::ModifiedButterfly{});
            const auto inside = Apply(Far::StencilTable::Create(refiner, scheme), solid.positions);
            const auto alone = Apply(Far::StencilTable::Create(Refined(surface, 3), butterfly), surface.positions);
            std::vector<double> boundary;
            for (Index v = 0; v < refiner.level(3).n_vertices; ++v) {
                if (refiner.level(3).vertex_tags[v].rule() == Vtr::Rule::Solid) continue;
                boundary.insert(boundary.end(), inside.begin() + 3 * v, inside.begin() + 3 * v + 3);
            }
            // Vertices inside the solid are no part of the surface, and stay.
            std::vector<double> of_surface;
            const std::size_t n_control = static_cast<std::size_t>(solid.n_vertices);
            for (std::size_t v = 0; v < alone.size() / 3; ++v) {
                if (v < n_control && refiner.level(0).vertex_tags[v].rule() == Vtr::Rule::Solid) continue;
                of_surface.insert(of_surface.end(), alone.begin() + 3 * v, alone.begin() + 3 * v + 3);
            }
            const auto a = SortedPoints(boundary), b = SortedPoints(of_surface);
            ASSERT_EQ(a.size(), b.size());
            for (std::size_t i = 0; i < a.size(); ++i) {
                for (int k = 0; k < 3; ++k) ASSERT_NEAR(a[i][k], b[i][k], 1e-9);  // rounded to 1e-10 for sorting
            }
        }
    }
}

}  // namespace

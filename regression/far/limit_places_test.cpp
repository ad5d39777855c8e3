// SPDX-License-Identifier: Apache-2.0
// Limits at places are those of vertices of later levels, in cells and on boundaries of every kind.
#include "limit_places_testing.h"

namespace SolidSubdiv::TestFar {
namespace {

// Every scheme on every shape; every option on every third of them, by turns.
TEST(LimitPlaces, Limits_AreThoseOfVerticesOfLaterLevels) {
    std::size_t turn = 0;
    for (const auto& [name, shape] : TestShapes::AllShapes()) {
        constexpr int kLevels = 2;
        const auto refiner = Refined(shape, kLevels, true);
        std::string last_kind;
        for (const auto& [scheme_name, scheme] : AllSchemes()) {
            const std::string kind(Sdc::NameOf(scheme));
            const bool is_first_of_its_kind = std::exchange(last_kind, kind) != kind;
            if (!is_first_of_its_kind && ++turn % 3 != 0) continue;
            if (!IsSolid(scheme) && refiner.n_cells(0) > 0) continue;
            SCOPED_TRACE(std::string(name) + ", " + scheme_name);
            if (IsSolid(scheme)) ExpectLimitsOfVertices(refiner, scheme, Elements::Cells, kLevels);
            ExpectLimitsOfVertices(refiner, scheme, Elements::BoundaryFaces, kLevels);
        }
    }
}

TEST(LimitPlaces, LimitsAmongPolyhedra_AreThoseOfVerticesOfLaterLevels) {
    for (const auto& [name, shape] : TestShapes::PolyhedralShapes()) {
        constexpr int kLevels = 2;
        auto refiner = Far::TopologyRefiner::Create(Describe(shape), Sdc::Split::Polyhedral);
        refiner.RefineUniform({.max_level = kLevels, .full_topology_in_last_level = true});
        for (const auto& [scheme_name, scheme] : AllSchemes(Sdc::Split::Polyhedral)) {
            if (!IsSolid(scheme) && refiner.n_cells(0) > 0) continue;
            SCOPED_TRACE(name + ", " + scheme_name);
            if (IsSolid(scheme)) ExpectLimitsOfVertices(refiner, scheme, Elements::Cells, kLevels);
            ExpectLimitsOfVertices(refiner, scheme, Elements::BoundaryFaces, kLevels);
        }
    }
}

// A polyhedron's parts meet in faces; what is there may be named in either.
TEST(LimitPlaces, PartsOfPolyhedra_MeetInTheirLimits) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    int n_checked = 0;
    for (const auto& [name, shape] : TestShapes::PolyhedralShapes()) {
        auto refiner = Far::TopologyRefiner::Create(Describe(shape), Sdc::Split::Polyhedral);
        refiner.RefineUniform({.max_level = 1, .full_topology_in_last_level = true});
        const auto& level = refiner.polyhedral_level(0);
        std::vector<Place> places, twins, at_points;
        std::vector<Index> points;  // of level 1
        for (Index c = level.n_hexes; c < static_cast<Index>(level.n_cells()); ++c) {
            Index part = 0;
            for (std::size_t i = 0; i < level.CellFaces(c).size(); ++i) {
                const Index f = level.CellFaces(c)[i];
                // Level 0 lists a cell's faces and their corners as CellFaces does, each as seen from outside the cell.
                const auto& cells = level.polyhedra;
                const Offset face = cells.offsets[c - level.n_hexes] + static_cast<Offset>(i);
                const Offset begin = cells.face_vertex_offsets[face], n = cells.face_vertex_offsets[face + 1] - begin;
                for (Index k = 0; k < n; ++k) {
                    const double a = uniform(random), b = uniform(random) * (1 - a);
                    places.push_back({c, part + k, {a, 0, b}});
                    twins.push_back({c, part + (k + 1) % static_cast<Index>(n), {a, b, 0}});
                    const Index v = cells.face_vertices[begin + k], w = cells.face_vertices[begin + (k + 1) % n];
                    const auto add = [&](std::array<double, 3> at, Index point) {
                        at_points.push_back({c, part + k, at});
                        points.push_back(point);
                    };
                    add({0, 1, 0}, v);
                    add({0, .5, .5}, level.n_vertices + level.FindEdge(v, w));
                    add({1, 0, 0}, level.n_vertices + level.n_edges + f);
                    add({0, 0, 0}, level.n_vertices + level.n_edges + level.n_faces + c);
                }
                part += static_cast<Index>(n);
            }
        }
        if (places.empty()) continue;
        const auto values = RandomValues(refiner.n_vertices(0));
        for (const Sdc::Scheme& scheme : SolidSchemes(Sdc::Split::Polyhedral)) {
            SCOPED_TRACE(name + ", " + std::string(Sdc::NameOf(scheme)));
            const auto rows = LimitStencilTable::Create(refiner, scheme, places, {}).rows();
            const auto twin_rows = LimitStencilTable::Create(refiner, scheme, twins, {}).rows();
            const auto point_rows = LimitStencilTable::Create(refiner, scheme, at_points, {}).rows();
            const auto limits = Limits(LimitStencilTable::Create(refiner, scheme, {.level = 1}),
                                       Apply(Far::StencilTable::Create(refiner, scheme), values));
            for (Index i = 0; i < rows.n_rows(); ++i) {
                EXPECT_FALSE(rows.Indices(i).empty());
                EXPECT_LT(Distance(PointOf(rows, i, values), PointOf(twin_rows, i, values)), 1e-12);
            }
            for (Index i = 0; i < point_rows.n_rows(); ++i) {
                const double* limit = limits.data() + 3 * points[static_cast<std::size_t>(i)];
                EXPECT_LT(Distance(PointOf(point_rows, i, values), {limit[0], limit[1], limit[2]}), 1e-12)
                    << "cell " << at_points[static_cast<std::size_t>(i)].element << " part "
                    << at_points[static_cast<std::size_t>(i)].part << " point " << i % 4;
                ++n_checked;
            }
        }
    }
    EXPECT_GT(n_checked, 100);
}

// Semi-sharp creases have a limit at places, although not at vertices before they have faded.
TEST(LimitPlaces, FadingCreases_LeadToTheLimitsOfLaterLevels) {
    constexpr int kLevels = 3;
    const auto check = [&](const auto& shape, Sdc::Split split, const std::vector<Sdc::Scheme>& schemes) {
        Far::TopologyDescriptor mesh = Describe(shape);
        std::vector<Index> edges;
        std::vector<float> sharpness;
        auto smooth = Far::TopologyRefiner::Create(mesh, split);
        const Vtr::EdgeGraph graph = smooth.graph(0);
        for (Index e = 0; e < graph.n_edges; e += 3) {
            if (graph.edge_tags[e].rule() != Vtr::Rule::Surface) continue;
            const auto ends = graph.EdgeVertices(e);
            edges.insert(edges.end(), ends.begin(), ends.end());
            sharpness.push_back(static_cast<float>(e % 5) * 0.6f);
        }
        const std::vector<Index> corners{0, 2};
        const std::vector<float> corner_sharpness{1.3f, 10.0f};
        mesh.crease_edges = edges;
        mesh.crease_sharpness = sharpness;
        mesh.corner_vertices = corners;
        mesh.corner_sharpness = corner_sharpness;
        auto refiner = Far::TopologyRefiner::Create(mesh, split);
        refiner.RefineUniform({.max_level = kLevels, .full_topology_in_last_level = true});
        for (Sdc::Scheme scheme : schemes) {
            for (const char* creasing : {"uniform", "chaikin"}) {
                Sdc::SetOption(scheme, "creasing", creasing);
                SCOPED_TRACE(std::string(Sdc::NameOf(scheme)) + " " + creasing);
                if (IsSolid(scheme)) ExpectLimitsOfVertices(refiner, scheme, Elements::Cells, kLevels);
                ExpectLimitsOfVertices(refiner, scheme, Elements::BoundaryFaces, kLevels);
            }
        }
    };
    check(TestShapes::OctahedronSurface(), Sdc::Split::TetOct, {Sdc::Loop{}});
    check(TestShapes::KuhnBlock(2), Sdc::Split::TetOct, {Sdc::BoxSpline{}});
    check(TestShapes::HexBlock(2), Sdc::Split::Polyhedral, {Sdc::CatmullClarkSolid{}, Sdc::Mlca{}});
}

// A quadrilateral and two triangles that share two edges with it: vertices of two faces.
TEST(LimitPlaces, FacesThatShareTwoEdges_AreToldApart) {
    const std::vector<Offset> offsets{0, 4, 7, 10};
    const std::vector<Index> vertices{0, 1, 2, 3, 0, 3, 2, 0, 2, 1};
    Far::TopologyDescriptor mesh{.n_vertices = 4};
    mesh.polygon_offsets = offsets;
    mesh.polygon_vertices = vertices;
    auto refiner = Far::TopologyRefiner::Create(mesh, Sdc::Split::Polyhedral);
    refiner.RefineUniform({.max_level = 3, .full_topology_in_last_level = true});
    ExpectLimitsOfVertices(refiner, Sdc::CatmullClark{}, Elements::BoundaryFaces, 3);
}

// Of the laws above: a weight off by 1e-6 is seen.
TEST(LimitPlaces, APlantedFaultInAStencil_IsSeenAtPlaces) {
    const auto refiner = Refined(TestShapes::KuhnBlock(2), 1, true);
    const PlacesOfVertices found = FindPlaces(refiner, 1, Elements::Cells, 50);
    const auto values = RandomValues(refiner.n_vertices(0));
    auto rows = Far::StencilTable::Create(refiner, Sdc::BoxSpline{}).level(1);
    for (double& w : rows.weights) w += 1e-6;
    const auto limits = Limits(LimitStencilTable::Create(refiner, Sdc::BoxSpline{}, {.level = 1}),
                               Apply(Far::StencilTable::FromRows(rows.n_sources, {rows}), values));
    const auto points = LimitStencilTable::Create(refiner, Sdc::BoxSpline{}, found.places, {}).rows();
    double largest = 0;
    for (std::size_t i = 0; i < found.places.size(); ++i) {
        const double* limit = limits.data() + 3 * found.vertices[i];
        largest =
            std::max(largest, Distance(PointOf(points, static_cast<Index>(i), values), {limit[0], limit[1], limit[2]}));
    }
    EXPECT_GT(largest, 1e-7);
}

}  // namespace
}  // namespace SolidSubdiv::TestFar

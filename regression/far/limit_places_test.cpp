// SPDX-License-Identifier: Apache-2.0
// Limits at places: those of vertices of later levels, laws of rows, derivatives against differences.
#include <cmath>
#include <random>
#include <unordered_map>

#include <solidsubdiv/far/place.h>
#include <solidsubdiv/sdc/parallel.h>

#include "far_testing.h"

namespace SolidSubdiv::TestFar {
namespace {

using Far::Elements;
using Far::LimitPlacesOptions;
using Far::LimitStencilTable;
using Far::Place;

/// Names of places: sums of numbers of the control vertices, in units of 8^-levels, modulo 2^64.
using PlaceName = std::uint64_t;

std::vector<PlaceName> NamesOfControlVertices(Index n) {
    std::mt19937_64 random(7);
    std::vector<PlaceName> names(static_cast<std::size_t>(n));
    for (PlaceName& name : names) name = random();
    return names;
}

/// Names of a level's vertices from those of the level before.
std::vector<PlaceName> NamesOfChildren(const Far::TopologyRefiner& refiner, int level,
                                       const std::vector<PlaceName>& parents) {
    std::vector<PlaceName> names;
    for (PlaceName p : parents) names.push_back(8 * p);
    const auto sum = [&](auto&& vertices) {
        PlaceName s = 0;
        for (Index v : vertices) s += parents[static_cast<std::size_t>(v)];
        return s;
    };
    const Vtr::EdgeGraph graph = refiner.graph(level - 1);
    for (Index e = 0; e < graph.n_edges; ++e) names.push_back(4 * sum(graph.EdgeVertices(e)));
    if (refiner.is_polyhedral()) {
        const auto& l = refiner.polyhedral_level(level - 1);
        for (Index f = 0; f < l.n_faces; ++f) names.push_back(2 * sum(l.FaceVertices(f)));
        for (Index c = 0; c < static_cast<Index>(l.n_cells()); ++c) names.push_back(sum(l.CellVertices(c)));
    } else {
        const auto& l = refiner.level(level - 1);
        for (Index o = 0; o < l.n_octs; ++o) names.push_back(4 * sum(l.OctVertices(o).first(2)));
    }
    return names;
}

/// Random places that are vertices of level `levels`, each with the vertex.
struct PlacesOfVertices {
    std::vector<Place> places;
    std::vector<Index> vertices;
};

PlacesOfVertices FindPlaces(const Far::TopologyRefiner& refiner, int levels, Elements elements, int n_tries) {
    std::vector<PlaceName> control = NamesOfControlVertices(refiner.n_vertices(0)), names = control;
    for (int l = 1; l <= levels; ++l) names = NamesOfChildren(refiner, l, names);
    std::unordered_map<PlaceName, Index> vertex_of;
    for (std::size_t v = 0; v < names.size(); ++v) vertex_of[names[v]] = static_cast<Index>(v);

    const Index n = elements == Elements::Cells ? static_cast<Index>(refiner.n_cells(0))
                    : refiner.is_polyhedral()   ? refiner.polyhedral_level(0).n_boundary_faces
                                                : refiner.level(0).n_boundary_faces;
    std::mt19937 random(3);
    const int side = 1 << levels;
    PlacesOfVertices found;
    for (int i = 0; i < n_tries && n > 0; ++i) {
        Place place{.element = static_cast<Index>(random() % static_cast<unsigned>(n))};
        if (refiner.is_polyhedral()) {
            const auto& l = refiner.polyhedral_level(0);
            const bool has_parts =
                elements == Elements::Cells ? !l.IsHex(place.element) : l.BoundaryVertices(place.element).size() != 4;
            if (has_parts) continue;
        }
        const bool is_oct =
            elements == Elements::Cells && !refiner.is_polyhedral() && place.element >= refiner.level(0).n_tets;
        for (double& x : place.at) {
            x = static_cast<double>(static_cast<int>(random() % static_cast<unsigned>(side + 1))) / side;
            if (is_oct && random() % 2 == 0) x = -x;
        }
        const auto [u, v, w] = place.at;
        const double sum = std::abs(u) + std::abs(v) + (elements == Elements::Cells ? std::abs(w) : 0.0);
        if (!refiner.is_polyhedral() && sum > 1) continue;
        const auto rows = Far::MakePlaceRows(refiner, 0, {&place, 1}, elements);
        PlaceName name = 0;
        for (std::size_t k = 0; k < rows.Indices(0).size(); ++k) {
            const double units = rows.Weights(0)[k] * std::pow(8.0, levels);
            name += static_cast<PlaceName>(std::llround(units)) * control[static_cast<std::size_t>(rows.Indices(0)[k])];
        }
        const auto vertex = vertex_of.find(name);
        if (vertex == vertex_of.end()) continue;
        found.places.push_back(place);
        found.vertices.push_back(vertex->second);
    }
    return found;
}

std::vector<double> RandomValues(Index n) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<double> values(3 * static_cast<std::size_t>(n));
    for (double& x : values) x = uniform(random);
    return values;
}

/// Limits at places are those of the vertices there.
void ExpectLimitsOfVertices(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme, Elements elements,
                            int levels) {
    const PlacesOfVertices found = FindPlaces(refiner, levels, elements, 80);
    if (found.places.empty()) return;
    const auto values = RandomValues(refiner.n_vertices(0));
    const auto at_vertices = LimitStencilTable::Create(refiner, scheme, {.level = levels});
    const auto refined = Apply(Far::StencilTable::Create(refiner, scheme, {.max_level = levels}), values);
    const auto limits = Limits(at_vertices, refined);
    const auto table =
        LimitStencilTable::Create(refiner, scheme, found.places, {.level = 0, .elements = elements, .order = 0});
    const auto points = Limits(table, values);
    double largest = 0;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < found.places.size(); ++i) {
        const auto& missing = at_vertices.without_limit();
        const bool has_limit = !std::binary_search(missing.begin(), missing.end(), found.vertices[i]);
        const auto& without = table.without_limit();
        EXPECT_EQ(std::binary_search(without.begin(), without.end(), static_cast<Index>(i)), !has_limit);
        if (!has_limit) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            const double d = std::abs(points[3 * i + c] - limits[3 * static_cast<std::size_t>(found.vertices[i]) + c]);
            if (d > largest) worst = i;
            largest = std::max(largest, d);
        }
    }
    // Sums of tens of products, and of eigenvectors to 1e-14.
    EXPECT_LE(largest, 2e-13) << "place " << worst << ": element " << found.places[worst].element << " at "
                              << found.places[worst].at[0] << " " << found.places[worst].at[1] << " "
                              << found.places[worst].at[2];
}

TEST(LimitPlaces, Limits_AreThoseOfVerticesOfLaterLevels) {
    for (const auto& [name, shape] : TestShapes::AllShapes()) {
        constexpr int kLevels = 2;
        const auto refiner = Refined(shape, kLevels, true);
        for (const auto& [scheme_name, scheme] : AllSchemes()) {
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

std::vector<Sdc::Scheme> SolidSchemes(Sdc::Split split) {
    std::vector<Sdc::Scheme> schemes;
    Sdc::ForEachScheme([&](auto scheme) {
        if (scheme.kSolids && Sdc::Takes(scheme, split)) schemes.push_back(scheme);
    });
    return schemes;
}

std::array<double, 3> PointOf(const Far::StencilRows<double>& rows, Index row, const std::vector<double>& values) {
    std::array<double, 3> point{};
    for (std::size_t k = 0; k < rows.Indices(row).size(); ++k) {
        for (std::size_t c = 0; c < 3; ++c) {
            point[c] += rows.Weights(row)[k] * values[3 * static_cast<std::size_t>(rows.Indices(row)[k]) + c];
        }
    }
    return point;
}

double Distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
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

/// Random places strictly inside elements.
std::vector<Place> RandomPlaces(const Far::TopologyRefiner& refiner, Elements elements, int n) {
    std::mt19937 random(17);
    std::uniform_real_distribution<double> uniform(0.01, 0.99);
    const Index n_elements = elements == Elements::Cells ? static_cast<Index>(refiner.n_cells(0))
                             : refiner.is_polyhedral()   ? refiner.polyhedral_level(0).n_boundary_faces
                                                         : refiner.level(0).n_boundary_faces;
    std::vector<Place> places;
    while (n_elements > 0 && static_cast<int>(places.size()) < n) {
        Place place{.element = static_cast<Index>(random() % static_cast<unsigned>(n_elements))};
        for (double& x : place.at) x = uniform(random);
        const bool is_cell = elements == Elements::Cells;
        double sum = place.at[0] + place.at[1] + (is_cell ? place.at[2] : 0.0);
        bool is_simplex = !refiner.is_polyhedral();
        if (refiner.is_polyhedral()) {
            const auto& level = refiner.polyhedral_level(0);
            is_simplex = is_cell ? !level.IsHex(place.element) : level.BoundaryVertices(place.element).size() != 4;
        } else if (is_cell && place.element >= refiner.level(0).n_tets) {
            for (double& x : place.at) x = 2 * x - 1;
            sum = std::abs(place.at[0]) + std::abs(place.at[1]) + std::abs(place.at[2]);
        }
        if (is_simplex && sum > 0.99) continue;
        places.push_back(place);
    }
    return places;
}

/// Rows sum to one, those of derivatives to zero and to differences.
void ExpectLawsOfRows(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme, Elements elements) {
    const std::vector<Place> places = RandomPlaces(refiner, elements, 12);
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

TEST(LimitPlaces, Rows_SumToOneAndDerivativesAreDifferences) {
    for (const auto& [name, shape] : TestShapes::AllShapes()) {
        const auto refiner = Refined(shape, 0, true);
        Sdc::ForEachScheme([&](const auto& scheme) {
            using S = std::remove_cvref_t<decltype(scheme)>;
            if (!Sdc::Takes<S>(Sdc::Split::TetOct) || (!S::kSolids && refiner.n_cells(0) > 0)) return;
            SCOPED_TRACE(std::string(name) + ", " + std::string(S::kName));
            if (S::kSolids) ExpectLawsOfRows(refiner, scheme, Elements::Cells);
            ExpectLawsOfRows(refiner, scheme, Elements::BoundaryFaces);
        });
    }
    for (const auto& [name, shape] : TestShapes::PolyhedralShapes()) {
        const auto refiner = Far::TopologyRefiner::Create(Describe(shape), Sdc::Split::Polyhedral);
        Sdc::ForEachScheme([&](const auto& scheme) {
            using S = std::remove_cvref_t<decltype(scheme)>;
            if (!Sdc::Takes<S>(Sdc::Split::Polyhedral) || (!S::kSolids && refiner.n_cells(0) > 0)) return;
            SCOPED_TRACE(name + ", " + std::string(S::kName));
            if (S::kSolids) ExpectLawsOfRows(refiner, scheme, Elements::Cells);
            ExpectLawsOfRows(refiner, scheme, Elements::BoundaryFaces);
        });
    }
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

TEST(LimitPlaces, Tables_AreTheSameForAnyNumberOfThreadsAndOrderOfPlaces) {
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
TEST(LimitPlaces, ExtraordinaryVertices_HaveTangents) {
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

TEST(LimitPlaces, MissingDerivatives_AreDefects) {
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

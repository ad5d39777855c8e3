// SPDX-License-Identifier: Apache-2.0
// Determinants and scaled Jacobians of cells of every kind.
#include <solidsubdiv/kit/geometry/cell_quality.h>

#include <solidsubdiv/kit/geometry/internal/cell_places.h>
#include <solidsubdiv/kit/geometry/internal/hex_jacobian.h>
#include <solidsubdiv/kit/geometry/internal/usable_positions.h>
#include <solidsubdiv/sdc/parallel.h>

#include <optional>
#include <string>

namespace SolidSubdiv::Geometry {

using namespace Internal;

namespace {

constexpr Offset kGrain = 1024;
constexpr Offset kBlock = Offset{1} << 20;  // between two reports of progress

/// Longer than the vector, and cheaper than its length.
double SumOfSizes(const Vec3& a) { return std::abs(a.x) + std::abs(a.y) + std::abs(a.z); }

/// How far rounding may move a determinant of differences of coordinates, whose sums of sizes are at most a, b, c:
/// three roundings of differences and five of products and sums, each half an epsilon; and four times that for safety.
double RoundingOf(double a, double b, double c) { return 16 * std::numeric_limits<double>::epsilon() * a * b * c; }

MinimumSign SignOf(double lower_bound, double least, double rounding) {
    if (lower_bound > rounding) return MinimumSign::Positive;
    return least < -rounding ? MinimumSign::Negative : MinimumSign::Undecided;
}

/// Source: stimpson2007, tetrahedron scaled Jacobian.
double ScaledJacobianOfTet(const TetCorners& v, double det) {
    double largest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        double product = 1;
        for (std::size_t j = 0; j < 4; ++j) {
            if (j != i) product *= Length(v[j] - v[i]);
        }
        largest = std::max(largest, product);
    }
    return largest > 0 ? std::clamp(std::sqrt(2.0) * det / largest, -1.0, 1.0) : 0;
}

/// Of a cell of tets the least of them; takes in one.
void TakeTet(const TetCorners& v, const Far::Place& place, bool is_first, CellQuality& q) {
    const Vec3 a = v[1] - v[0], b = v[2] - v[0], c = v[3] - v[0];
    const double det = Det(a, b, c), rounding = RoundingOf(SumOfSizes(a), SumOfSizes(b), SumOfSizes(c));
    const double scaled = ScaledJacobianOfTet(v, det);
    const MinimumSign sign = SignOf(det, det, rounding);
    if (is_first || det < q.jacobian_minimum) {
        q.jacobian_minimum = q.lower_bound = det;
        q.place = place;
    }
    q.scaled_jacobian = is_first ? scaled : std::min(q.scaled_jacobian, scaled);
    // One negative tet is enough; where none is, an open one leaves the cell open.
    const bool is_worse = sign == MinimumSign::Negative || q.sign == MinimumSign::Positive;
    if (is_first || is_worse) q.sign = sign;
}

/// Source: stimpson2007, hexahedron scaled Jacobian: corners and, along the axes, the centre.
double ScaledJacobianOfHex(const Trilinear& hex) {
    const auto scaled = [](const std::array<Vec3, 3>& a) {
        const double lengths = Length(a[0]) * Length(a[1]) * Length(a[2]);
        return lengths > 0 ? std::clamp(Det(a[0], a[1], a[2]) / lengths, -1.0, 1.0) : 0;
    };
    double least = scaled(hex.Jacobian({0.5, 0.5, 0.5}));
    for (unsigned corner = 0; corner < 8; ++corner) {
        const Vec3 at{corner & 1 ? 1.0 : 0.0, corner & 2 ? 1.0 : 0.0, corner & 4 ? 1.0 : 0.0};
        least = std::min(least, scaled(hex.Jacobian(at)));
    }
    return least;
}

CellQuality QualityOfHex(const Trilinear& hex, Index cell, const QualityOptions& options) {
    double longest[3] = {};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < 8; ++i) {
            const Vec3 edge = hex.corners[i | std::size_t{1} << axis] - hex.corners[i];
            longest[axis] = std::max(longest[axis], SumOfSizes(edge));
        }
    }
    const double size = longest[0] * longest[1] * longest[2];
    // Halves of halves are means of means: three half epsilons each, some thirty of them one after another.
    const double rounding = 4 * RoundingOf(longest[0], longest[1], longest[2]);
    const JacobianMinimum found = FindJacobianMinimum(hex, options.gap * size, rounding, options.most_parts);
    CellQuality q{.jacobian_minimum = found.least, .lower_bound = found.lower_bound};
    q.place = {.element = cell, .at = {found.at.x, found.at.y, found.at.z}};
    q.scaled_jacobian = ScaledJacobianOfHex(hex);
    q.sign = SignOf(found.lower_bound, found.least, rounding);
    return q;
}

/// The vertices of a polyhedron of four triangles as a tet's, its faces counterclockwise from outside.
std::optional<std::array<Index, 4>> AsTet(const Vtr::Polyhedra& cells, Index cell) {
    const Offset first = cells.offsets[cell];
    if (cells.offsets[cell + 1] - first != 4) return {};
    if (cells.face_vertex_offsets[first + 4] - cells.face_vertex_offsets[first] != 12) return {};
    const Index* v = cells.face_vertices.data() + cells.face_vertex_offsets[first];
    for (int k = 3; k < 12; ++k) {
        if (v[k] != v[0] && v[k] != v[1] && v[k] != v[2]) return std::array{v[0], v[2], v[1], v[k]};
    }
    return {};
}

CellQuality QualityOf(const Far::TopologyRefiner& refiner, int level, std::span<const double> positions, Index cell,
                      const QualityOptions& options) {
    const auto point = [&](Index v) { return PointAt(positions, v); };
    CellQuality q;
    if (!refiner.is_polyhedral()) {
        const Far::Level& l = refiner.level(level);
        if (cell < l.n_tets) {
            const auto v = l.TetVertices(cell);
            TakeTet({point(v[0]), point(v[1]), point(v[2]), point(v[3])}, {cell, 0, {.25, .25, .25}}, true, q);
            return q;
        }
        const auto v = l.OctVertices(cell - l.n_tets);
        for (std::size_t i = 0; i < 4; ++i) {
            const auto& t = Sdc::Oct::tets[i];
            // Its centroid: a quarter of a vertex of the second pair and of one of the third.
            const bool is_v_negative = t[2] == 3 || t[3] == 3, is_w_negative = t[2] == 5 || t[3] == 5;
            TakeTet({point(v[t[0]]), point(v[t[1]]), point(v[t[2]]), point(v[t[3]])},
                    {cell, 0, {0, is_v_negative ? -.25 : .25, is_w_negative ? -.25 : .25}}, i == 0, q);
        }
        return q;
    }
    const Vtr::PolyhedralLevel& l = refiner.polyhedral_level(level);
    if (l.IsHex(cell)) {
        Trilinear hex;
        const Index* const v = l.hex_vertices.data() + 8 * static_cast<std::size_t>(cell);
        for (std::size_t i = 0; i < 8; ++i) hex.corners[i] = point(v[kHexVertexOfCorner[i]]);
        return QualityOfHex(hex, cell, options);
    }
    if (const auto v = AsTet(l.polyhedra, cell - l.n_hexes)) {
        TakeTet({point((*v)[0]), point((*v)[1]), point((*v)[2]), point((*v)[3])}, {cell, 0, {0, 0, 0}}, true, q);
        return q;
    }
    const Vec3 origin =
        point(l.polyhedra.face_vertices[l.polyhedra.face_vertex_offsets[l.polyhedra.offsets[cell - l.n_hexes]]]);
    const PolyhedronParts parts(l.polyhedra, cell - l.n_hexes, positions, origin);
    for (Index part = 0; part < parts.n_parts(); ++part) {
        TakeTet(parts.Part(part), {cell, part, {.25, .25, .25}}, part == 0, q);
    }
    return q;
}

}  // namespace

void QualityOptions::Validate() const {
    if (!(gap > 0 && gap <= 1)) throw InvalidInput("gap is " + std::to_string(gap) + "; must be over 0, at most 1");
    if (most_parts < 1 || most_parts > 1000000) {
        throw InvalidInput("most_parts is " + std::to_string(most_parts) + "; must be from 1 to 1000000");
    }
}

std::vector<CellQuality> MeasureQuality(const Far::TopologyRefiner& refiner, int level,
                                        std::span<const double> positions, const QualityOptions& options) {
    options.Validate();
    RequirePositionsOfLevel(refiner, level, positions);
    std::vector<CellQuality> qualities(static_cast<std::size_t>(refiner.n_cells(level)));
    const auto n = static_cast<Offset>(qualities.size());
    for (Offset first = 0; first < n; first += kBlock) {
        Report(options.progress, "quality", static_cast<double>(first) / static_cast<double>(n));
        Sdc::ParallelFor(std::min(kBlock, n - first), kGrain, [&](Offset begin, Offset end) {
            for (Offset c = first + begin; c < first + end; ++c) {
                qualities[static_cast<std::size_t>(c)] =
                    QualityOf(refiner, level, positions, static_cast<Index>(c), options);
            }
        });
    }
    return qualities;
}

}  // namespace SolidSubdiv::Geometry

// SPDX-License-Identifier: Apache-2.0
// Validator voxel-attributes: what voxels were given against direct evaluation in their cells.
#include "voxel_attributes.h"

#include <algorithm>
#include <cmath>

#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/kit/geometry/locator.h>
#include <solidsubdiv/kit/geometry/tessellation_inside.h>
#include <solidsubdiv/kit/io/formats.h>

#include "points.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

using Point = std::array<double, 3>;

Point Minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double Det(const Point& a, const Point& b, const Point& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Weights of vertices.
struct Weights {
    std::vector<Index> vertices;
    std::vector<double> weights;
    double outside = 0;  ///< how far coordinates are out of their range

    double Sum(std::span<const double> values, int width, int component) const {
        double sum = 0;
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            sum += weights[k] * values[static_cast<std::size_t>(vertices[k] * width + component)];
        }
        return sum;
    }
};

/// Direct evaluation, cell by cell.
class Cells {
  public:
    explicit Cells(const VoxelShape& shape) : shape_(shape), tets_(Geometry::CutIntoTets(shape.refiner, shape.level)) {
        // The tets of a cell follow one another.
        const Offset n_cells = shape.refiner.n_cells(shape.level);
        for (Index cell = 0; cell < n_cells; ++cell) {
            const std::vector<Index> corners = CornersOf(cell);
            const auto has = [&](Index v) { return std::find(corners.begin(), corners.end(), v) != corners.end(); };
            first_.push_back(last_);
            while (4 * last_ < tets_.size() && std::all_of(&tets_[4 * last_], &tets_[4 * last_] + 4, has)) ++last_;
        }
        first_.push_back(last_);
    }
    bool IsComplete() const { return 4 * last_ == tets_.size(); }
    bool IsHex(Index cell) const {
        return shape_.refiner.is_polyhedral() && shape_.refiner.polyhedral_level(shape_.level).IsHex(cell);
    }
    bool HasPlaces(Index cell) const { return !shape_.refiner.is_polyhedral() || IsHex(cell); }

    Weights At(Index cell, const Point& p) const {
        // In the tet that holds it best.
        Weights best{{}, {}, HUGE_VAL};
        for (std::size_t t = first_[static_cast<std::size_t>(cell)]; t < first_[static_cast<std::size_t>(cell) + 1];
             ++t) {
            std::array<Point, 4> v;
            for (std::size_t k = 0; k < 4; ++k) v[k] = PointOf(tets_[4 * t + k]);
            const Point a = Minus(v[1], v[0]), b = Minus(v[2], v[0]), c = Minus(v[3], v[0]), x = Minus(p, v[0]);
            const double det = Det(a, b, c), u = Det(x, b, c) / det, w = Det(a, x, c) / det, z = Det(a, b, x) / det;
            const std::vector<double> weights{1 - u - w - z, u, w, z};
            const double outside = -*std::min_element(weights.begin(), weights.end());
            if (outside < best.outside) best = {{&tets_[4 * t], &tets_[4 * t] + 4}, weights, outside};
        }
        return IsHex(cell) ? InHex(cell, p, best.outside) : best;
    }

  private:
    Point PointOf(Index v) const {
        const double* const p = &shape_.positions[3 * static_cast<std::size_t>(v)];
        return {p[0], p[1], p[2]};
    }
    std::vector<Index> CornersOf(Index cell) const {
        if (!shape_.refiner.is_polyhedral()) {
            const auto& l = shape_.refiner.level(shape_.level);
            if (cell >= l.n_tets) {
                const auto v = l.OctVertices(cell - l.n_tets);
                return {v.begin(), v.end()};
            }
            const auto v = l.TetVertices(cell);
            return {v.begin(), v.end()};
        }
        const auto& l = shape_.refiner.polyhedral_level(shape_.level);
        if (l.IsHex(cell)) return {&l.hex_vertices[8 * cell], &l.hex_vertices[8 * cell] + 8};
        const auto& p = l.polyhedra;
        const Index k = cell - l.n_hexes;
        return {p.face_vertices.data() + p.face_vertex_offsets[p.offsets[k]],
                p.face_vertices.data() + p.face_vertex_offsets[p.offsets[k + 1]]};
    }
    /// Newton's steps from the middle, halved until they come nearer.
    Weights InHex(Index cell, const Point& p, double outside) const {
        const std::vector<Index> v = CornersOf(cell);
        const auto weights_at = [](const Point& at) {
            const auto [x, y, z] = at;
            return std::vector<double>{
                (1 - x) * (1 - y) * (1 - z), x * (1 - y) * (1 - z), x * y * (1 - z), (1 - x) * y * (1 - z),
                (1 - x) * (1 - y) * z,       x * (1 - y) * z,       x * y * z,       (1 - x) * y * z};
        };
        const auto rest_at = [&](const Point& at) {
            const auto w = weights_at(at);
            Point rest = p;
            for (std::size_t i = 0; i < 8; ++i) {
                for (std::size_t c = 0; c < 3; ++c) rest[c] -= w[i] * PointOf(v[i])[c];
            }
            return rest;
        };
        const auto square = [](const Point& a) { return a[0] * a[0] + a[1] * a[1] + a[2] * a[2]; };
        Point at{.5, .5, .5};
        for (int step = 0; step < 40; ++step) {
            const Point rest = rest_at(at);
            std::array<Point, 3> d;  // the map is linear in each coordinate: differences are derivatives
            for (std::size_t c = 0; c < 3; ++c) {
                Point low = at, high = at;
                low[c] = 0;
                high[c] = 1;
                d[c] = Minus(rest_at(low), rest_at(high));
            }
            const double det = Det(d[0], d[1], d[2]);
            const Point move{Det(rest, d[1], d[2]) / det, Det(d[0], rest, d[2]) / det, Det(d[0], d[1], rest) / det};
            double part = 1;
            const auto there = [&] {
                return Point{at[0] + part * move[0], at[1] + part * move[1], at[2] + part * move[2]};
            };
            while (part > 1e-3 && square(rest_at(there())) > square(rest)) part /= 2;
            at = there();
            if (square(move) < 1e-28) break;
        }
        return {v, weights_at(at), outside};
    }

    const VoxelShape& shape_;
    std::vector<Index> tets_;
    std::vector<std::size_t> first_;
    std::size_t last_ = 0;
};

/// By how much a float differs by more than rounding of it and of values of size 1.
double Excess(double value, double direct) { return std::max(0.0, std::abs(value - direct) - 2.4e-7); }

VoxelShape Read(const std::filesystem::path& path, Sdc::Split split, int level, const Sdc::Scheme& scheme) {
    const Io::Mesh mesh = Io::ReadSolid(path);
    VoxelShape shape{path.filename().string(), Far::TopologyRefiner::Create(mesh.topology, split), level,
                     mesh.positions};
    shape.refiner.RefineUniform({.max_level = level});
    for (int l = 1; l <= level; ++l) {
        std::vector<double> fine(3 * static_cast<std::size_t>(shape.refiner.n_vertices(l)));
        Far::PrimvarRefiner(shape.refiner, scheme).Interpolate<double>(l, shape.positions, fine, 3);
        shape.positions = std::move(fine);
    }
    return shape;
}

}  // namespace

std::vector<double> MakeValues(const VoxelShape& shape, int width) {
    std::vector<double> values;
    const double size = SizeOf(shape.positions);
    for (std::size_t i = 0; i < shape.positions.size(); i += 3) {
        for (int k = 0; k < width; ++k) {
            values.push_back(std::sin((7 + 3 * k) * shape.positions[i] / size + 11 * shape.positions[i + 1] / size) *
                             std::cos(13 * shape.positions[i + 2] / size + k));
        }
    }
    return values;
}

void CompareSamples(const VoxelShape& shape, const VoxelSamples& samples, Findings& findings) {
    const auto numbers = MakeValues(shape, 1), vectors = MakeValues(shape, 3);
    const Cells cells(shape);
    if (!cells.IsComplete()) return findings.Fault("tets do not follow one another by cells");
    std::vector<double> centers;
    for (const auto& voxel : samples.voxels) {
        for (int x : voxel) centers.push_back(x * samples.voxel_size);
    }
    const Geometry::Location found = Geometry::Locator(shape.refiner, shape.level, shape.positions).Locate(centers);
    // A warped hexahedron's tets hold some voxels that it does not itself.
    std::vector<bool> is_located(samples.voxels.size(), true);
    for (const Geometry::OutsidePoint& outside : found.outside) {
        is_located[static_cast<std::size_t>(outside.point)] = false;
    }
    const auto& places = found.places;
    const auto rows = Far::MakePlaceRows(shape.refiner, shape.level, places);
    const auto by_rows = [&](std::size_t i, const std::vector<double>& values, std::size_t width, std::size_t k) {
        double sum = 0;
        for (Offset r = rows.offsets[i]; r < rows.offsets[i + 1]; ++r) {
            sum += rows.weights[r] * values[static_cast<std::size_t>(rows.indices[r]) * width + k];
        }
        return sum;
    };
    int n_same = 0, n_with_places = 0;
    for (std::size_t i = 0; i < samples.voxels.size(); ++i) {
        const auto name = [&] { return "sample " + std::to_string(i); };
        const Index cell = samples.cells[i];
        if (cell < 0 || cell >= shape.refiner.n_cells(shape.level)) {
            findings.Fault(name() + ": there is no cell " + std::to_string(cell));
            continue;
        }
        const Weights direct = cells.At(cell, {centers[3 * i], centers[3 * i + 1], centers[3 * i + 2]});
        if (!(direct.outside < 1e-6)) findings.Fault(name() + ": not in cell " + std::to_string(cell));
        n_with_places += cells.HasPlaces(cell);
        const bool is_same = is_located[i] && cells.HasPlaces(cell) && places[i].element == cell;
        n_same += is_same;
        const auto compare = [&](double value, const std::vector<double>& values, int width, int k) {
            findings.Error(Excess(value, direct.Sum(values, width, k)), name);
            if (!is_same) return;
            const double located = by_rows(i, values, static_cast<std::size_t>(width), static_cast<std::size_t>(k));
            findings.Error(Excess(value, located), [&] { return name() + ", located"; });
        };
        compare(samples.numbers[i], numbers, 1, 0);
        for (int k = 0; k < 3; ++k) compare(samples.vectors[3 * i + static_cast<std::size_t>(k)], vectors, 3, k);
    }
    findings.notes.push_back(std::to_string(samples.voxels.size()) + " voxels, the locator finds the same cell for " +
                             std::to_string(n_same) + " of " + std::to_string(n_with_places));
    if (10 * n_same < 9 * n_with_places) findings.Fault("the locator finds other cells");
}

Findings ValidateVoxelAttributes(const Context& context) {
    Findings findings;
    const double fineness = context.is_quick ? 40 : 150;
    const auto check = [&](const VoxelShape& shape, unsigned seed) {
        Findings found;
        CompareSamples(shape,
                       SampleVoxels(shape, SizeOf(shape.positions) / fineness, context.is_quick ? 1000 : 10000, seed),
                       found);
        findings.Merge(found, shape.name);
    };
    check(MakeBall(6), 1);
    check(Read(context.shapes / "demo" / "bunny_lattice.vtu", Sdc::Split::TetOct, 1, Sdc::BoxSpline{}), 2);
    const auto hexes = context.tets.parent_path() / "hexes";
    unsigned seed = 3;
    for (const char* name : {"cino_rockerarm.mesh", "mfem_fichera-mixed.vtk"}) {
        if (!std::filesystem::exists(hexes / name)) {
            findings.skipped.push_back(std::string(name) + ": there is no " + (hexes / name).string());
            continue;
        }
        for (int level : {0, 1})
            check(Read(hexes / name, Sdc::Split::Polyhedral, level, Sdc::CatmullClarkSolid{}), seed++);
    }
    return findings;
}

}  // namespace SolidSubdiv::Validation

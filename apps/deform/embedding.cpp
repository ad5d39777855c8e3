// SPDX-License-Identifier: Apache-2.0
// The lattice is refined, points are placed, and what no point needs of the refinement is dropped.
#include <solidsubdiv/apps/deform/embedding.h>

#include <solidsubdiv/apps/deform/deformer.h>
#include <solidsubdiv/apps/deform/internal/placed_points.h>
#include <solidsubdiv/apps/deform/internal/vector3.h>
#include <solidsubdiv/osd/backends.h>
#include <solidsubdiv/osd/evaluator.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace SolidSubdiv::Deform {

using namespace Internal;

namespace {

Far::TopologyRefiner Refine(const Far::TopologyDescriptor& lattice, const EmbedOptions& options) {
    const bool is_tet_oct = lattice.hexes.empty() && lattice.wedges.empty() && lattice.pyramids.empty() &&
                            lattice.polyhedron_vertices.empty() && lattice.quads.empty() &&
                            lattice.polygon_vertices.empty();
    const bool is_cut_so = is_tet_oct && Sdc::Takes(options.scheme, Sdc::Split::TetOct);
    auto refiner = Far::TopologyRefiner::Create(lattice, is_cut_so ? Sdc::Split::TetOct : Sdc::Split::Polyhedral);
    if (refiner.n_cells(0) == 0) throw InvalidInput("the lattice has no cells to hold points");
    refiner.RefineUniform(
        {.max_level = options.levels, .full_topology_in_last_level = options.limit, .progress = options.progress});
    return refiner;
}

std::vector<double> PositionsOfLastLevel(const Far::StencilTable& table, std::span<const double> control) {
    if (table.n_levels() == 0) return {control.begin(), control.end()};
    Osd::Evaluator evaluator(table, Osd::Backend::Best());
    std::vector<double> positions(3 * static_cast<std::size_t>(evaluator.n_refined_vertices()));
    evaluator.Evaluate(control, positions);
    return positions;
}

double MeanEdge(const Far::TopologyRefiner& refiner, std::span<const double> control) {
    const Vtr::EdgeGraph graph = refiner.graph(0);
    double sum = 0;
    for (Index e = 0; e < refiner.n_edges(0); ++e) {
        const auto ends = graph.EdgeVertices(e);
        sum += Length(Minus(PointAt(control, ends[1]), PointAt(control, ends[0])));
    }
    return sum / std::max<double>(refiner.n_edges(0), 1);
}

/// Marks vertices that are needed, and numbers them anew in their order.
class Needed {
  public:
    explicit Needed(Index n_vertices) : numbers_(static_cast<std::size_t>(n_vertices), kNoIndex) {}

    void Add(Index v) { numbers_[static_cast<std::size_t>(v)] = 0; }
    void Number() {
        for (std::size_t v = 0; v < numbers_.size(); ++v) {
            if (numbers_[v] == kNoIndex) continue;
            numbers_[v] = static_cast<Index>(vertices_.size());
            vertices_.push_back(static_cast<Index>(v));
        }
    }
    const std::vector<Index>& vertices() const { return vertices_; }
    void Renumber(Array<Index>& indices) const {
        for (Index& v : indices) v = numbers_[static_cast<std::size_t>(v)];
    }

  private:
    std::vector<Index> numbers_, vertices_;
};

/// Chosen rows of a table.
Far::StencilRows<double> ChosenRows(const Far::StencilRows<double>& rows, std::span<const Index> chosen) {
    Far::StencilRows<double> result;
    result.n_sources = rows.n_sources;
    for (Index row : chosen) {
        const auto indices = rows.Indices(row);
        const auto weights = rows.Weights(row);
        result.indices.insert(result.indices.end(), indices.begin(), indices.end());
        result.weights.insert(result.weights.end(), weights.begin(), weights.end());
        result.offsets.push_back(static_cast<Offset>(result.indices.size()));
    }
    return result;
}

/// Puts points into their cells. corners(cell) gives the vertices of one.
template <int kCorners, class Corners>
EmbeddedCells<kCorners> Gather(std::span<const InCell> in_cells, Corners&& corners) {
    EmbeddedCells<kCorners> cells;
    for (std::size_t i = 0; i < in_cells.size(); ++i) {
        if (i == 0 || in_cells[i].cell != in_cells[i - 1].cell) {
            const auto v = corners(in_cells[i].cell);
            cells.corners.insert(cells.corners.end(), v.begin(), v.end());
            cells.offsets.push_back(0);
        }
        cells.points.push_back(in_cells[i].point);
        cells.at.insert(cells.at.end(), in_cells[i].at.begin(), in_cells[i].at.end());
        cells.offsets.back() = static_cast<Offset>(i + 1);
    }
    return cells;
}

/// Drops from the cascade, and from what stands on it, what is not needed.
void Trim(const Far::StencilTable& table, EmbeddingTables& t) {
    if (table.n_levels() == 0) return;
    Needed needed(table.level(table.n_levels()).n_rows());
    for (const Array<Index>* indices : {&t.hexes.corners, &t.tets.corners, &t.rows.indices}) {
        for (Index v : *indices) needed.Add(v);
    }
    needed.Number();
    for (Array<Index>* indices : {&t.hexes.corners, &t.tets.corners, &t.rows.indices}) needed.Renumber(*indices);
    t.rows.n_sources = static_cast<Index>(needed.vertices().size());
    for (int l = table.n_levels(); l >= 1; --l) {
        Far::StencilRows<double> rows = ChosenRows(table.level(l), needed.vertices());
        if (l > 1) {
            needed = Needed(rows.n_sources);
            for (Index v : rows.indices) needed.Add(v);
            needed.Number();
            needed.Renumber(rows.indices);
            rows.n_sources = static_cast<Index>(needed.vertices().size());
        }
        t.cascade.insert(t.cascade.begin(), std::move(rows));
    }
}

template <class T>
Offset BytesOf(const Array<T>& array) {
    return static_cast<Offset>(array.size() * sizeof(T));
}
template <int kCorners>
Offset BytesOf(const EmbeddedCells<kCorners>& cells) {
    return BytesOf(cells.corners) + BytesOf(cells.offsets) + BytesOf(cells.points) + BytesOf(cells.at);
}

}  // namespace

Outside OutsideOf(std::string_view name) {
    if (name == "leave") return Outside::Leave;
    if (name == "clamp") return Outside::Clamp;
    if (name == "carry") return Outside::Carry;
    throw InvalidInput("there is no way '" + std::string(name) +
                       "' with points outside; there are leave, clamp, carry");
}

std::string_view NameOf(Outside outside) {
    return outside == Outside::Leave ? "leave" : outside == Outside::Clamp ? "clamp" : "carry";
}

void EmbedOptions::Validate() const {
    const auto require = [](bool is_right, const char* name, double value, const char* range) {
        if (!is_right) throw InvalidInput(std::string(name) + " is " + std::to_string(value) + "; it must be " + range);
    };
    require(levels >= 0 && levels <= 20, "levels", levels, "0 to 20");
    require(falloff >= 0, "falloff", falloff, "0 or more");
    require(tolerance >= 0 && std::isfinite(tolerance), "tolerance", tolerance, "0 or more, and finite");
}

Offset EmbeddingTables::Bytes() const {
    Offset bytes = BytesOf(hexes) + BytesOf(tets) + rows.Bytes() + BytesOf(row_points) +
                   static_cast<Offset>(outside.size() * sizeof(OutsidePoint));
    for (const auto& level : cascade) bytes += level.Bytes();
    return bytes;
}

Embedding Embedding::Create(const Far::TopologyDescriptor& lattice, std::span<const double> lattice_positions,
                            std::span<const double> points, const EmbedOptions& options) {
    options.Validate();
    if (lattice_positions.size() != 3 * static_cast<std::size_t>(lattice.n_vertices)) {
        throw InvalidInput(std::to_string(lattice_positions.size()) + " coordinates are given for " +
                           std::to_string(lattice.n_vertices) + " control points");
    }
    if (points.size() % 3 != 0) {
        throw InvalidInput(std::to_string(points.size()) + " coordinates of points are no multiple of three");
    }
    for (std::size_t i = 0; i < lattice_positions.size(); ++i) {
        if (!std::isfinite(lattice_positions[i])) {
            throw InvalidInput("control point " + std::to_string(i / 3) + " has a coordinate that is not finite");
        }
    }
    const Far::TopologyRefiner refiner = Refine(lattice, options);
    Report(options.progress, "stencils", 0);
    const auto table = Far::StencilTable::Create(refiner, options.scheme, {.progress = options.progress});
    const std::vector<double> positions = PositionsOfLastLevel(table, lattice_positions);
    Report(options.progress, "embed", 0);
    PlacedPoints placed = Place({refiner, positions, MeanEdge(refiner, lattice_positions)}, points, options);

    Embedding embedding;
    EmbeddingTables& t = embedding.tables_;
    t.n_points = static_cast<Index>(points.size() / 3);
    t.n_control_points = lattice.n_vertices;
    t.hexes = Gather<8>(placed.in_hexes, [&](Index hex) {
        return std::span<const Index>(&refiner.polyhedral_level(options.levels).hex_vertices[8 * hex], 8);
    });
    t.tets = Gather<4>(placed.in_tets, [&](Index tet) { return TetCorners(refiner.level(options.levels), tet); });
    t.rows = std::move(placed.rows);
    t.row_points.assign(placed.row_points.begin(), placed.row_points.end());
    Trim(table, t);

    // With factors of 1 and no constants a deformer gives the nearest points themselves.
    t.outside = placed.outside;
    for (OutsidePoint& out : t.outside) out.factor = out.factor > 0 ? 1 : 0;
    std::vector<double> nearest(points.size());
    if (!t.outside.empty()) Deformer(embedding).Deform(lattice_positions, nearest);
    for (std::size_t i = 0; i < t.outside.size(); ++i) {
        OutsidePoint& out = t.outside[i];
        out.factor = placed.outside[i].factor;
        const Vector3 point = PointAt(points, out.point), x = PointAt(nearest, out.point);
        for (std::size_t c = 0; c < 3; ++c) out.constant[c] = point[c] - (out.factor > 0 ? out.factor * x[c] : 0);
    }

    embedding.settings_ = {{"scheme", std::string(Sdc::NameOf(options.scheme))},
                           {"levels", std::to_string(options.levels)},
                           {"limit", options.limit ? "true" : "false"},
                           {"outside", std::string(NameOf(options.outside))}};
    embedding.settings_.insert(embedding.settings_.end(), options.notes.begin(), options.notes.end());
    return embedding;
}

}  // namespace SolidSubdiv::Deform

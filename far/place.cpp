// SPDX-License-Identifier: Apache-2.0
// Linear weights of places.
#include <solidsubdiv/far/place.h>

#include <cmath>
#include <string>

#include <solidsubdiv/far/internal/row_maker.h>

namespace SolidSubdiv::Far {

namespace {

/// Appends weights to a row.
class Row {
  public:
    explicit Row(Internal::RowPart<double>& part) : part_(part) {}
    void Add(Index vertex, double weight) {
        part_.indices.push_back(vertex);
        part_.weights.push_back(weight);
    }
    /// A weight shared by vertices.
    void AddMean(std::span<const Index> vertices, double weight) {
        for (Index v : vertices) Add(v, weight / static_cast<double>(vertices.size()));
    }

  private:
    Internal::RowPart<double>& part_;
};

using At = std::array<double, 3>;

void AddTet(std::span<const Index, 4> v, const At& at, Row& row) {
    row.Add(v[0], 1 - at[0] - at[1] - at[2]);
    for (int i = 0; i < 3; ++i) row.Add(v[i + 1], at[i]);
}

void AddOct(std::span<const Index, 6> v, const At& at, Row& row) {
    const double b = std::abs(at[1]), c = std::abs(at[2]), rest = 1 - b - c;
    row.Add(v[0], (rest + at[0]) / 2);
    row.Add(v[1], (rest - at[0]) / 2);
    row.Add(v[at[1] < 0 ? 3 : 2], b);
    row.Add(v[at[2] < 0 ? 5 : 4], c);
}

void AddQuad(std::span<const Index> v, const At& at, double weight, Row& row) {
    row.Add(v[0], weight * (1 - at[0]) * (1 - at[1]));
    row.Add(v[1], weight * at[0] * (1 - at[1]));
    row.Add(v[2], weight * at[0] * at[1]);
    row.Add(v[3], weight * (1 - at[0]) * at[1]);
}

void AddPolygon(std::span<const Index> v, Index part, const At& at, Row& row) {
    row.AddMean(v, 1 - at[0] - at[1]);
    row.Add(v[part], at[0]);
    row.Add(v[(part + 1) % static_cast<Index>(v.size())], at[1]);
}

/// The face of a polyhedron that has its corner number `part`.
struct FaceOfPart {
    std::span<const Index> vertices;
    Index corner;
};

FaceOfPart FindPart(const Vtr::Polyhedra& cells, Index cell, Index part) {
    const Offset corner = cells.face_vertex_offsets[cells.offsets[cell]] + part;
    Offset face = cells.offsets[cell];
    while (cells.face_vertex_offsets[face + 1] <= corner) ++face;
    const Offset begin = cells.face_vertex_offsets[face], end = cells.face_vertex_offsets[face + 1];
    return {{cells.face_vertices.data() + begin, static_cast<std::size_t>(end - begin)},
            static_cast<Index>(corner - begin)};
}

Offset CountParts(const Vtr::Polyhedra& cells, Index cell) {
    return cells.face_vertex_offsets[cells.offsets[cell + 1]] - cells.face_vertex_offsets[cells.offsets[cell]];
}

/// The centroid of a polyhedron weighs its vertices alike; the faces of a cell have each as often as edges meet there.
void AddCentroid(const Vtr::Polyhedra& cells, Index cell, double weight, Row& row) {
    const Offset begin = cells.face_vertex_offsets[cells.offsets[cell]];
    std::vector<Index> vertices(cells.face_vertices.begin() + begin,
                                cells.face_vertices.begin() + begin + CountParts(cells, cell));
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    row.AddMean(vertices, weight);
}

void AddPolyhedron(const Vtr::Polyhedra& cells, Index cell, Index part, const At& at, Row& row) {
    AddCentroid(cells, cell, 1 - at[0] - at[1] - at[2], row);
    const FaceOfPart face = FindPart(cells, cell, part);
    row.AddMean(face.vertices, at[0]);
    row.Add(face.vertices[face.corner], at[1]);
    row.Add(face.vertices[(face.corner + 1) % static_cast<Index>(face.vertices.size())], at[2]);
}

/// Parts of an element; 0: no such element.
Offset PartsOfCell(const TopologyRefiner& refiner, int level, Index cell) {
    if (cell < 0 || cell >= refiner.n_cells(level)) return 0;
    if (!refiner.is_polyhedral()) return 1;
    const Vtr::PolyhedralLevel& l = refiner.polyhedral_level(level);
    return l.IsHex(cell) ? 1 : CountParts(l.polyhedra, cell - l.n_hexes);
}
Offset PartsOfFace(const TopologyRefiner& refiner, int level, Index face) {
    if (!refiner.is_polyhedral()) return face >= 0 && face < refiner.level(level).n_boundary_faces;
    const Vtr::PolyhedralLevel& l = refiner.polyhedral_level(level);
    if (face < 0 || face >= l.n_boundary_faces) return 0;
    const Offset n = static_cast<Offset>(l.BoundaryVertices(face).size());
    return n == 4 ? 1 : n;
}

void AddCell(const TopologyRefiner& refiner, int level, const Place& place, Row& row) {
    if (refiner.is_polyhedral()) {
        const Vtr::PolyhedralLevel& l = refiner.polyhedral_level(level);
        if (!l.IsHex(place.element)) {
            return AddPolyhedron(l.polyhedra, place.element - l.n_hexes, place.part, place.at, row);
        }
        const std::span<const Index> v(l.hex_vertices.data() + 8 * static_cast<std::size_t>(place.element), 8);
        AddQuad(v.first(4), place.at, 1 - place.at[2], row);
        AddQuad(v.last(4), place.at, place.at[2], row);
        return;
    }
    const Level& l = refiner.level(level);
    if (place.element < l.n_tets) {
        AddTet(l.TetVertices(place.element), place.at, row);
    } else {
        AddOct(l.OctVertices(place.element - l.n_tets), place.at, row);
    }
}

void AddFace(const TopologyRefiner& refiner, int level, const Place& place, Row& row) {
    if (refiner.is_polyhedral()) {
        const auto v = refiner.polyhedral_level(level).BoundaryVertices(place.element);
        if (v.size() == 4) {
            AddQuad(v, place.at, 1, row);
        } else {
            AddPolygon(v, place.part, place.at, row);
        }
        return;
    }
    const auto v = refiner.level(level).BoundaryVertices(place.element);
    row.Add(v[0], 1 - place.at[0] - place.at[1]);
    row.Add(v[1], place.at[0]);
    row.Add(v[2], place.at[1]);
}

}  // namespace

void CheckPlaces(const TopologyRefiner& refiner, int level, std::span<const Place> places, Elements elements) {
    if (level < 0 || level > refiner.max_level()) {
        throw InvalidInput("places of level " + std::to_string(level) + ": the refiner's last is " +
                           std::to_string(refiner.max_level()));
    }
    const char* kind = elements == Elements::Cells ? "cell " : "boundary face ";
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Place& p = places[i];
        const Offset n_parts = elements == Elements::Cells ? PartsOfCell(refiner, level, p.element)
                                                           : PartsOfFace(refiner, level, p.element);
        const auto fail = [&](const std::string& what) {
            throw InvalidInput("place " + std::to_string(i) + ": " + what);
        };
        if (n_parts == 0) {
            fail("there is no " + (kind + std::to_string(p.element)) + " in level " + std::to_string(level));
        }
        if (p.part < 0 || p.part >= n_parts) {
            fail(kind + std::to_string(p.element) + " has " + std::to_string(n_parts) + " parts, no part " +
                 std::to_string(p.part));
        }
        for (double x : p.at) {
            if (!std::isfinite(x)) fail("a coordinate is not finite");
        }
    }
}

StencilRows<double> MakePlaceRows(const TopologyRefiner& refiner, int level, std::span<const Place> places,
                                  Elements elements) {
    CheckPlaces(refiner, level, places, elements);
    struct Nothing {};
    Internal::RowMaker<double, Nothing> maker(static_cast<Index>(places.size()), refiner.n_vertices(level), {});
    return maker.Make([&](Index i, Nothing&, Internal::RowPart<double>& part) {
        Row row(part);
        const Place& place = places[static_cast<std::size_t>(i)];
        if (elements == Elements::Cells) {
            AddCell(refiner, level, place, row);
        } else {
            AddFace(refiner, level, place, row);
        }
    });
}

}  // namespace SolidSubdiv::Far

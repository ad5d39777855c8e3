// SPDX-License-Identifier: Apache-2.0
// Cells around edges and points, by arithmetic.
#include "cell_shapes.h"

#include <cmath>
#include <numbers>

#include "polygon_shapes.h"
#include "solid_shapes.h"

namespace SolidSubdiv::Validation {

namespace {

class Builder {
  public:
    explicit Builder(std::string name) { shape_.name = std::move(name); }
    int Add(double x, double y, double z) {
        for (double c : {x, y, z}) shape_.positions.push_back(c + 0.1 * shaker_.Next());
        return static_cast<int>(shape_.positions.size() / 3) - 1;
    }
    void Hex(const std::array<int, 8>& v) { shape_.hexes.push_back(v); }
    /// Over a polygon, counterclockwise from above, and the one below it.
    void Prism(const Polygon& low, const Polygon& high) {
        std::vector<Polygon> faces = {{low.rbegin(), low.rend()}, high};
        for (std::size_t k = 0; k < low.size(); ++k) {
            const std::size_t next = (k + 1) % low.size();
            faces.push_back({low[k], low[next], high[next], high[k]});
        }
        shape_.cells.push_back(faces);
    }
    /// Over a base counterclockwise as seen from the apex.
    void Pyramid(const Polygon& base, int apex) {
        std::vector<Polygon> faces = {{base.rbegin(), base.rend()}};
        for (std::size_t k = 0; k < base.size(); ++k) faces.push_back({base[k], base[(k + 1) % base.size()], apex});
        shape_.cells.push_back(faces);
    }
    CellShape Take() { return std::move(shape_); }

  private:
    CellShape shape_;
    Shaker shaker_{23};
};

/// A cube of 2 x 2 x 2, cut into pyramids over its faces, with a cube on top.
CellShape SixPyramids() {
    Builder b("six pyramids under a cube");
    std::array<int, 8> low{}, high{};
    const double corners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (std::size_t i = 0; i < 4; ++i) low[i] = b.Add(corners[i][0], corners[i][1], -1);
    for (std::size_t i = 0; i < 4; ++i) low[4 + i] = high[i] = b.Add(corners[i][0], corners[i][1], 1);
    for (std::size_t i = 0; i < 4; ++i) high[4 + i] = b.Add(corners[i][0], corners[i][1], 3);
    const int centre = b.Add(0, 0, 0);
    const int sides[6][4] = {{0, 1, 2, 3}, {7, 6, 5, 4}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};
    for (const auto& side : sides) {
        Polygon base;
        for (int k : side) base.push_back(low[static_cast<std::size_t>(k)]);
        b.Pyramid(base, centre);
    }
    b.Hex(high);
    return b.Take();
}

/// A pentagonal prism with a pyramid on each end: corners of five edges.
CellShape RoofedPrism() {
    Builder b("pentagonal prism with pyramids");
    Polygon low, high;
    for (int i = 0; i < 5; ++i) {
        const double angle = 2 * std::numbers::pi * i / 5;
        low.push_back(b.Add(std::cos(angle), std::sin(angle), 0));
    }
    for (int i = 0; i < 5; ++i) {
        const double angle = 2 * std::numbers::pi * i / 5;
        high.push_back(b.Add(std::cos(angle), std::sin(angle), 1.5));
    }
    b.Prism(low, high);
    b.Pyramid(high, b.Add(0, 0, 3));
    b.Pyramid({low.rbegin(), low.rend()}, b.Add(0, 0, -1.5));
    return b.Take();
}

/// Eight octahedra with tets between them are a block of the octet truss: corners of four edges inside and out.
CellShape TrussOfPolyhedra() {
    CellShape shape;
    for (SolidShape& solid : ManifoldShapes()) {
        if (solid.name != "octet-truss") continue;
        shape = {"octet truss as polyhedra", {}, {}, solid.positions};
        for (const auto& [a, b, c, d] : solid.complex.tets) {
            shape.cells.push_back({{b, c, d}, {a, d, c}, {a, b, d}, {a, c, b}});
        }
        for (const auto& [a, b, c, d, e, f] : solid.complex.octs) {
            shape.cells.push_back(
                {{a, e, c}, {a, c, f}, {a, d, e}, {a, f, d}, {b, c, e}, {b, f, c}, {b, e, d}, {b, d, f}});
        }
    }
    return shape;
}

}  // namespace

CellShape CellsAroundEdge(int n, CellsAround kind) {
    const char* const names[] = {" hexahedra", " wedges", " cells in turn"};
    Builder b(std::to_string(n) + names[static_cast<int>(kind)] + " around an edge");
    const auto is_hex = [&](int i) {
        return kind == CellsAround::Hexes || (kind == CellsAround::InTurn && i % 2 == 0);
    };
    const auto at = [&](double turn, double radius, int z) {
        const double angle = 2 * std::numbers::pi * turn / n;
        return b.Add(radius * std::cos(angle), radius * std::sin(angle), z);
    };
    std::array<std::vector<Polygon>, 3> sectors;  // of each layer: the axis and what is around it
    for (int z = 0; z < 3; ++z) {
        auto& layer = sectors[static_cast<std::size_t>(z)];
        const int axis = at(0, 0, z);
        for (int i = 0; i < n; ++i) layer.push_back({axis, at(i, 1, z)});
        for (int i = 0; i < n; ++i) {
            Polygon& sector = layer[static_cast<std::size_t>(i)];
            if (is_hex(i)) sector.push_back(at(i + 0.5, 1.4, z));
            sector.push_back(layer[static_cast<std::size_t>((i + 1) % n)][1]);
        }
    }
    for (std::size_t z = 0; z < 2; ++z) {
        for (int i = 0; i < n; ++i) {
            const Polygon &low = sectors[z][static_cast<std::size_t>(i)],
                          &high = sectors[z + 1][static_cast<std::size_t>(i)];
            if (is_hex(i)) {
                b.Hex({low[0], low[1], low[2], low[3], high[0], high[1], high[2], high[3]});
            } else {
                b.Prism(low, high);
            }
        }
    }
    return b.Take();
}

DescribedCells::DescribedCells(const CellShape& shape) {
    for (const auto& hex : shape.hexes) hexes_.insert(hexes_.end(), hex.begin(), hex.end());
    for (const auto& cell : shape.cells) {
        for (const Polygon& face : cell) {
            vertices_.insert(vertices_.end(), face.begin(), face.end());
            face_offsets_.push_back(static_cast<Offset>(vertices_.size()));
        }
        offsets_.push_back(static_cast<Offset>(face_offsets_.size()) - 1);
    }
    descriptor.n_vertices = static_cast<Index>(shape.positions.size() / 3);
    descriptor.hexes = hexes_;
    if (shape.cells.empty()) return;
    descriptor.polyhedron_offsets = offsets_;
    descriptor.polyhedron_face_offsets = face_offsets_;
    descriptor.polyhedron_vertices = vertices_;
}

std::vector<CellShape> CellShapes() {
    std::vector<CellShape> shapes;
    for (HexShape& hexes : HexShapes()) shapes.push_back({hexes.name, hexes.cells, {}, hexes.positions});
    for (int n = 3; n <= 8; ++n) {
        shapes.push_back(CellsAroundEdge(n, CellsAround::Hexes));
        shapes.push_back(CellsAroundEdge(n, CellsAround::Wedges));
    }
    shapes.push_back(CellsAroundEdge(6, CellsAround::InTurn));
    shapes.push_back(SixPyramids());
    shapes.push_back(RoofedPrism());
    shapes.push_back(TrussOfPolyhedra());
    return shapes;
}

}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
// A mesh that owns its arrays: what readers return and writers take. Solids, surfaces and curves are all this type.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <solidsubdiv/far/topology_descriptor.h>
#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Io {

/// Owning twin of Far::TopologyDescriptor (same names, same shapes, same vertex orders); converts to it for free.
/// The view is valid while this lives and its arrays are not resized.
struct Topology {
    Index n_vertices = 0;
    std::vector<Index> tets, octs, hexes, wedges, pyramids;
    std::vector<Offset> polyhedron_offsets, polyhedron_face_offsets;
    std::vector<Index> polyhedron_vertices;
    std::vector<Index> triangles, quads;
    std::vector<Offset> polygon_offsets;
    std::vector<Index> polygon_vertices;
    std::vector<Index> edges;
    std::vector<Index> vertices;  ///< (n, 1): elements that are single vertices (tags)

    Far::TopologyDescriptor View() const {
        return {.n_vertices = n_vertices,
                .tets = tets,
                .octs = octs,
                .hexes = hexes,
                .wedges = wedges,
                .pyramids = pyramids,
                .polyhedron_offsets = polyhedron_offsets,
                .polyhedron_face_offsets = polyhedron_face_offsets,
                .polyhedron_vertices = polyhedron_vertices,
                .triangles = triangles,
                .quads = quads,
                .polygon_offsets = polygon_offsets,
                .polygon_vertices = polygon_vertices,
                .edges = edges};
    }
    operator Far::TopologyDescriptor() const { return View(); }

    Offset n_tets() const { return static_cast<Offset>(tets.size() / 4); }
    Offset n_octs() const { return static_cast<Offset>(octs.size() / 6); }
    Offset n_hexes() const { return static_cast<Offset>(hexes.size() / 8); }
    Offset n_wedges() const { return static_cast<Offset>(wedges.size() / 6); }
    Offset n_pyramids() const { return static_cast<Offset>(pyramids.size() / 5); }
    Offset n_polyhedra() const { return CsrRows(polyhedron_offsets); }
    Offset n_triangles() const { return static_cast<Offset>(triangles.size() / 3); }
    Offset n_quads() const { return static_cast<Offset>(quads.size() / 4); }
    Offset n_polygons() const { return CsrRows(polygon_offsets); }
    Offset n_edges() const { return static_cast<Offset>(edges.size() / 2); }
    Offset n_point_elements() const { return static_cast<Offset>(vertices.size()); }

    /// Elements of dimension 3, and of every kind.
    Offset n_cells() const { return n_tets() + n_octs() + n_hexes() + n_wedges() + n_pyramids() + n_polyhedra(); }
    Offset n_elements() const {
        return n_cells() + n_triangles() + n_quads() + n_polygons() + n_edges() + n_point_elements();
    }

  private:
    static Offset CsrRows(const std::vector<Offset>& offsets) {
        return offsets.empty() ? 0 : static_cast<Offset>(offsets.size()) - 1;
    }
};

/// Named values, one row of `width` numbers an element, row-major: values has n * width numbers.
struct Attribute {
    std::string name;
    int width = 1;
    std::vector<double> values;
};

/// A mesh of any dimension with its attributes.
struct Mesh {
    Topology topology;
    std::vector<double> positions;  ///< (n_vertices, 3), in the file's unit

    std::vector<Attribute> point_data;  ///< rows = vertices; refined like positions
    /// Rows = elements, in the order of Topology's arrays: tets, octs, hexes, wedges, pyramids, polyhedra, triangles,
    /// quads, polygons, edges, vertices (elements of one kind keep the file's order). `sharpness` makes edges and
    /// vertices creases and corners, see creases.h, `hole` faces holes, see holes.h.
    std::vector<Attribute> cell_data;

    /// Options of the scheme that the file asks for, as (name, value), a name at most once: ("boundary", "none",
    /// "edge-only" or "edge-and-corner"), ("creasing", "uniform" or "chaikin"). Only OBJ files carry them.
    std::vector<std::pair<std::string, std::string>> scheme_options{};

    std::vector<std::string> notes;  ///< what the reader did that the user should know, a line each

    const Attribute* FindPointData(const std::string& name) const { return Find(point_data, name); }
    const Attribute* FindCellData(const std::string& name) const { return Find(cell_data, name); }

  private:
    static const Attribute* Find(const std::vector<Attribute>& attributes, const std::string& name) {
        for (const Attribute& a : attributes) {
            if (a.name == name) return &a;
        }
        return nullptr;
    }
};

}  // namespace SolidSubdiv::Io

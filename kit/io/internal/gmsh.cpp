// SPDX-License-Identifier: Apache-2.0
// Numbers and collected parts of a .msh file.
#include <solidsubdiv/kit/io/internal/gmsh.h>

#include <algorithm>
#include <array>

#include <solidsubdiv/kit/io/internal/numbers.h>

namespace SolidSubdiv::Io::Internal {

namespace {

struct GmshType {
    std::int64_t type;
    ElementKind kind;
    std::array<std::size_t, 8> order;  // our place i takes the element's node order[i]
};

// VTK's (and our) wedge has its triangles the other way round.
constexpr std::array<GmshType, 8> kTypes = {{{1, ElementKind::Edge, {0, 1}},
                                             {2, ElementKind::Triangle, {0, 1, 2}},
                                             {3, ElementKind::Quad, {0, 1, 2, 3}},
                                             {4, ElementKind::Tet, {0, 1, 2, 3}},
                                             {5, ElementKind::Hex, {0, 1, 2, 3, 4, 5, 6, 7}},
                                             {6, ElementKind::Wedge, {0, 2, 1, 3, 5, 4}},
                                             {7, ElementKind::Pyramid, {0, 1, 2, 3, 4}},
                                             {15, ElementKind::Vertex, {0}}}};

const GmshType* TypeOf(std::int64_t type) {
    const auto found = std::find_if(kTypes.begin(), kTypes.end(), [&](const GmshType& t) { return t.type == type; });
    return found == kTypes.end() ? nullptr : &*found;
}

std::string NameOfType(std::int64_t type) {
    constexpr std::array<std::string_view, 12> second_order = {
        "line",    "triangle", "quadrilateral", "tetrahedron", "hexahedron", "prism",
        "pyramid", "",         "quadrilateral", "hexahedron",  "prism",      "pyramid"};
    if (type >= 8 && type <= 19 && type != 15) {
        return "a " + std::string(second_order[static_cast<std::size_t>(type - 8)]) + " of second order";
    }
    if ((type >= 20 && type <= 33) || (type >= 36 && type <= 66) || (type >= 71 && type <= 133)) {
        return "an element of third or higher order";
    }
    return "of an unknown type";
}

}  // namespace

double GmshNumbers::Real(std::string_view what) {
    if (!binary) return text.Real(what);
    return LoadNumber<double>(text.Bytes(8, what).data(), swap_bytes);
}

std::int64_t GmshNumbers::BinaryInteger(int n_bytes, std::string_view what) {
    const char* bytes = text.Bytes(n_bytes, what).data();
    return n_bytes == 4 ? LoadNumber<std::int32_t>(bytes, swap_bytes) : LoadNumber<std::int64_t>(bytes, swap_bytes);
}

std::int64_t GmshNumbers::Count(std::string_view what, std::int64_t min_bytes) {
    const std::int64_t n = Size(what);
    if (n < 0 || n > (text.remaining() + 1) / min_bytes) {
        text.FailHere(std::to_string(n) + " " + std::string(what) + " are announced, but only " +
                      Counted(text.remaining(), "byte", "bytes") + " follow; is the file complete?");
    }
    return n;
}

void GmshMesh::AddNode(std::int64_t tag, double x, double y, double z) {
    nodes_.Add(tag);
    positions_.insert(positions_.end(), {x, y, z});
}

void GmshMesh::EndNodes() {
    RequireIndexable(static_cast<std::int64_t>(nodes_.size()), "nodes", builder_.file());
    nodes_.Sort();
    std::int64_t tag = 0;
    if (nodes_.FindRepeated(tag)) Fail(builder_.file(), "node " + std::to_string(tag) + " is there twice; remove one");
    if (builder_.n_vertices() > 0) Fail(builder_.file(), "has a second section of nodes; merge them");
    builder_.AddPositions(positions_);
}

int GmshMesh::NodesOfType(std::int64_t type) const {
    if (const GmshType* known = TypeOf(type)) return InfoOf(known->kind).n_vertices;
    Fail(builder_.file(), "element " + std::to_string(builder_.n_rows() + 1) + " of the file is " + NameOfType(type) +
                              " (Gmsh type " + std::to_string(type) +
                              "), which can't be used; save the mesh with elements of first order");
}

void GmshMesh::AddElement(std::int64_t type, std::int64_t tag, std::int64_t physical, std::int64_t elementary,
                          std::span<const std::int64_t> nodes) {
    const GmshType& known = *TypeOf(type);
    std::array<std::int64_t, 8> vertices;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const std::int64_t node = nodes[known.order[i]];
        vertices[i] = nodes_.Find(node);
        if (vertices[i] < 0) {
            Fail(builder_.file(),
                 "element " + std::to_string(tag) + " names node " + std::to_string(node) + ", which is not there");
        }
    }
    builder_.NextRow();
    builder_.AddElement(known.kind, {vertices.data(), nodes.size()});
    elements_.Add(tag);
    physical_.push_back(static_cast<double>(physical));
    elementary_.push_back(static_cast<double>(elementary));
}

void GmshMesh::AddData(bool of_nodes, std::string name, int width, std::span<const std::int64_t> tags,
                       std::span<const double> values) {
    if (!of_nodes && !elements_sorted_) {
        elements_.Sort();
        elements_sorted_ = true;
    }
    const TagMap& map = of_nodes ? nodes_ : elements_;
    Attribute attribute{std::move(name), width, std::vector<double>(map.size() * static_cast<std::size_t>(width), 0.0)};
    for (std::size_t i = 0; i < tags.size(); ++i) {
        const std::int64_t place = map.Find(tags[i]);
        if (place < 0) {
            Fail(builder_.file(), (of_nodes ? "NodeData " : "ElementData ") + Quoted(attribute.name) + " names " +
                                      (of_nodes ? "node " : "element ") + std::to_string(tags[i]) +
                                      ", which is not there");
        }
        std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i) * width, width,
                    attribute.values.begin() + static_cast<std::ptrdiff_t>(place) * width);
    }
    if (tags.size() < map.size()) {
        AddNote((of_nodes ? "NodeData " : "ElementData ") + Quoted(attribute.name) + " has values for " +
                std::to_string(tags.size()) + " of " + std::to_string(map.size()) + "; the others are 0");
    }
    of_nodes ? builder_.AddPointData(std::move(attribute)) : builder_.AddCellData(std::move(attribute));
}

Mesh GmshMesh::Finish() {
    const auto any = [](const std::vector<double>& labels) {
        return std::any_of(labels.begin(), labels.end(), [](double label) { return label != 0; });
    };
    if (any(physical_)) builder_.AddCellData({"physical", 1, std::move(physical_)});
    if (any(elementary_)) builder_.AddCellData({"elementary", 1, std::move(elementary_)});
    return builder_.Finish();
}

}  // namespace SolidSubdiv::Io::Internal

// SPDX-License-Identifier: Apache-2.0
// Creases and corners gathered from a mesh's elements, and put there.
#include <solidsubdiv/kit/io/creases.h>

#include <algorithm>
#include <charconv>
#include <string>

#include <solidsubdiv/kit/io/internal/element_map.h>
#include <solidsubdiv/kit/io/internal/elements.h>
#include <solidsubdiv/kit/io/internal/text.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Io {

namespace {

using Internal::ElementKind;

std::string ToText(double number) {
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof(digits), number).ptr};
}

void RequireSharpness(double sharpness, std::string_view name, std::size_t element) {
    if (sharpness >= 0) return;  // NaN is not
    throw InvalidInput(std::string(name) + " " + std::to_string(element) + " has the sharpness " + ToText(sharpness) +
                       "; it must be 0 (no crease) or greater, 10 for infinitely sharp");
}

void GatherKind(const Topology& topology, ElementKind kind, const double* sharpness, std::vector<Index>& vertices,
                std::vector<float>& values) {
    Internal::ElementMap places;
    const Offset n = Internal::CountOf(topology, kind);
    for (Offset i = 0; i < n; ++i) {
        RequireSharpness(sharpness[i], Internal::InfoOf(kind).name, static_cast<std::size_t>(i));
        const auto value = static_cast<float>(std::min(sharpness[i], static_cast<double>(kInfinitelySharp)));
        if (!(value > 0)) continue;
        const std::span<const Index> element = Internal::ElementVertices(topology, kind, i);
        const auto next = static_cast<std::int64_t>(values.size());
        const auto place = places.FindOrAdd(element, next);
        if (place == next) {
            vertices.insert(vertices.end(), element.begin(), element.end());
            values.push_back(value);
        } else {
            float& there = values[static_cast<std::size_t>(place)];
            there = std::max(there, value);
        }
    }
}

void RequireCreases(const std::vector<Index>& vertices, const std::vector<float>& sharpness, std::size_t n_vertices,
                    Index n_mesh_vertices, const std::string& name) {
    if (vertices.size() != n_vertices * sharpness.size()) {
        throw InvalidInput(
            name + "s to set: " + Internal::Counted(static_cast<Offset>(vertices.size()), "vertex", "vertices") +
            " for " + std::to_string(sharpness.size()) + " values of sharpness");
    }
    for (std::size_t i = 0; i < sharpness.size(); ++i) {
        RequireSharpness(static_cast<double>(sharpness[i]), name, i);
        for (std::size_t k = 0; k < n_vertices; ++k) {
            const Index v = vertices[n_vertices * i + k];
            if (v >= 0 && v < n_mesh_vertices) continue;
            throw InvalidInput(name + " " + std::to_string(i) + " names vertex " + std::to_string(v) +
                               "; the mesh has " + std::to_string(n_mesh_vertices) + " vertices");
        }
    }
}

/// The sharpness of all elements of the kind, behind the mesh's own those that are added to it.
std::vector<double> AddKind(Topology& topology, ElementKind kind, const std::vector<Index>& vertices,
                            const std::vector<float>& sharpness) {
    std::vector<Index>& all = Internal::VerticesOf(topology, kind);
    std::vector<double> values(static_cast<std::size_t>(Internal::CountOf(topology, kind)), 0.0);
    if (sharpness.empty()) return values;
    Internal::ElementMap places;
    for (std::size_t i = 0; i < values.size(); ++i) {
        places.FindOrAdd(Internal::ElementVertices(topology, kind, static_cast<Offset>(i)),
                         static_cast<std::int64_t>(i));
    }
    const std::size_t n = vertices.size() / sharpness.size();
    for (std::size_t i = 0; i < sharpness.size(); ++i) {
        if (!(sharpness[i] > 0)) continue;
        const auto element = std::span(vertices).subspan(n * i, n);
        const auto place =
            static_cast<std::size_t>(places.FindOrAdd(element, static_cast<std::int64_t>(values.size())));
        if (place == values.size()) {
            all.insert(all.end(), element.begin(), element.end());
            values.push_back(0);
        }
        values[place] = std::max(values[place], static_cast<double>(sharpness[i]));
    }
    return values;
}

void RequireRows(const Attribute& attribute, Offset n_rows) {
    if (static_cast<Offset>(attribute.values.size()) == n_rows * attribute.width) return;
    throw InvalidInput("cell data '" + attribute.name + "' has " + std::to_string(attribute.values.size()) +
                       " numbers, in rows of " + std::to_string(attribute.width) + ", for " + std::to_string(n_rows) +
                       " elements");
}

/// Rows of zeros: n_edges of them in front of the row `at`, n_vertices at the end.
void AddRows(Attribute& attribute, Offset at, std::size_t n_edges, std::size_t n_vertices) {
    const auto width = static_cast<std::size_t>(attribute.width);
    const auto where = attribute.values.begin() + static_cast<std::ptrdiff_t>(at) * attribute.width;
    attribute.values.insert(where, n_edges * width, 0.0);
    attribute.values.insert(attribute.values.end(), n_vertices * width, 0.0);
}

}  // namespace

const Attribute* FindSharpness(const Mesh& mesh) {
    const Attribute* const sharpness = mesh.FindCellData(std::string(kSharpness));
    return sharpness && sharpness->width == 1 ? sharpness : nullptr;
}

Creases CreasesOf(const Mesh& mesh) {
    Creases creases;
    const Attribute* const sharpness = mesh.FindCellData(std::string(kSharpness));
    if (!sharpness) return creases;
    const Topology& topology = mesh.topology;
    RequireRows(*sharpness, topology.n_elements());
    if (sharpness->width != 1) {
        throw InvalidInput("cell data 'sharpness' has rows of " + std::to_string(sharpness->width) +
                           " numbers; it needs one number an element");
    }
    const double* const of_vertices = sharpness->values.data() + (topology.n_elements() - topology.n_point_elements());
    GatherKind(topology, ElementKind::Edge, of_vertices - topology.n_edges(), creases.edge_vertices,
               creases.edge_sharpness);
    GatherKind(topology, ElementKind::Vertex, of_vertices, creases.vertices, creases.vertex_sharpness);
    return creases;
}

void SetCreases(Mesh& mesh, const Creases& creases) {
    Topology& topology = mesh.topology;
    RequireCreases(creases.edge_vertices, creases.edge_sharpness, 2, topology.n_vertices, "crease");
    RequireCreases(creases.vertices, creases.vertex_sharpness, 1, topology.n_vertices, "corner");
    std::vector<Attribute>& data = mesh.cell_data;
    for (const Attribute& a : data) {
        if (a.name != kSharpness) RequireRows(a, topology.n_elements());
    }

    const auto n_edges = static_cast<std::size_t>(topology.n_edges());
    const auto n_vertices = static_cast<std::size_t>(topology.n_point_elements());
    const Offset end_of_edges = topology.n_elements() - topology.n_point_elements();
    const std::vector<double> of_edges =
        AddKind(topology, ElementKind::Edge, creases.edge_vertices, creases.edge_sharpness);
    const std::vector<double> of_vertices =
        AddKind(topology, ElementKind::Vertex, creases.vertices, creases.vertex_sharpness);

    std::vector<double> sharpness(static_cast<std::size_t>(end_of_edges) - n_edges, 0.0);
    sharpness.insert(sharpness.end(), of_edges.begin(), of_edges.end());
    sharpness.insert(sharpness.end(), of_vertices.begin(), of_vertices.end());
    const bool smooth = std::none_of(sharpness.begin(), sharpness.end(), [](double s) { return s > 0; });

    if (smooth) {
        std::erase_if(data, [](const Attribute& a) { return a.name == kSharpness; });
    } else if (!mesh.FindCellData(std::string(kSharpness))) {
        data.push_back({std::string(kSharpness), 1, {}});
    }
    for (Attribute& a : data) {
        if (a.name == kSharpness) {
            a = {a.name, 1, std::move(sharpness)};
        } else {
            AddRows(a, end_of_edges, of_edges.size() - n_edges, of_vertices.size() - n_vertices);
        }
    }
}

}  // namespace SolidSubdiv::Io

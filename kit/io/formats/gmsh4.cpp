// SPDX-License-Identifier: Apache-2.0
// Nodes, elements and entities of Gmsh's .msh version 4.1: blocks that belong to the model's entities.
#include <algorithm>
#include <array>

#include <solidsubdiv/kit/io/internal/gmsh.h>

namespace SolidSubdiv::Io::Internal {

std::vector<GmshEntity> ReadGmsh4Entities(GmshNumbers& numbers) {
    numbers.BeginBinary();
    std::array<std::int64_t, 4> n_of_dimension;
    for (std::int64_t& n : n_of_dimension) n = numbers.Count("entities", 1);

    std::vector<GmshEntity> entities;
    for (std::int64_t dimension = 0; dimension < 4; ++dimension) {
        for (std::int64_t i = 0; i < n_of_dimension[static_cast<std::size_t>(dimension)]; ++i) {
            const std::int64_t tag = numbers.Int("the number of an entity");
            // A point has its place, the others their bounding box.
            for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) numbers.Real("a coordinate of an entity");
            std::int64_t physical = 0;
            const std::int64_t n_physical = numbers.Count("physical labels", 1);
            for (std::int64_t k = 0; k < n_physical; ++k) {
                const std::int64_t label = numbers.Int("a physical label");
                if (k == 0) physical = label;
            }
            entities.push_back({dimension, tag, physical});
            if (dimension == 0) continue;
            const std::int64_t n_bounding = numbers.Count("bounding entities", 1);
            for (std::int64_t k = 0; k < n_bounding; ++k) numbers.Int("a bounding entity");
        }
    }
    std::sort(entities.begin(), entities.end());
    return entities;
}

void ReadGmsh4Nodes(GmshNumbers& numbers, GmshMesh& mesh) {
    numbers.BeginBinary();
    const std::int64_t n_blocks = numbers.Count("blocks of nodes", 4);
    const std::int64_t n_nodes = numbers.Count("nodes", 8);
    numbers.Size("the least number of a node");
    numbers.Size("the largest number of a node");
    std::vector<std::int64_t> tags;
    std::int64_t n_seen = 0;
    for (std::int64_t block = 0; block < n_blocks; ++block) {
        const std::int64_t dimension = numbers.Int("the dimension of an entity");
        numbers.Int("the number of an entity");
        const bool parametric = numbers.Int("0 or 1 for parametric nodes") != 0;
        if (dimension < 0 || dimension > 3)
            numbers.text.FailHere("an entity has " + std::to_string(dimension) + " dimensions");
        const std::int64_t n_here = numbers.Count("nodes", 8);
        tags.clear();
        for (std::int64_t i = 0; i < n_here; ++i) tags.push_back(numbers.Size("the number of a node"));
        for (const std::int64_t tag : tags) {
            const double x = numbers.Real("a coordinate"), y = numbers.Real("a coordinate"),
                         z = numbers.Real("a coordinate");
            for (std::int64_t k = 0; parametric && k < dimension; ++k) numbers.Real("a parameter of a node");
            mesh.AddNode(tag, x, y, z);
        }
        n_seen += n_here;
    }
    if (n_seen != n_nodes) {
        numbers.text.FailHere("the blocks have " + std::to_string(n_seen) + " nodes, " + std::to_string(n_nodes) +
                              " are announced");
    }
    mesh.EndNodes();
}

void ReadGmsh4Elements(GmshNumbers& numbers, const std::vector<GmshEntity>& entities, GmshMesh& mesh) {
    numbers.BeginBinary();
    const std::int64_t n_blocks = numbers.Count("blocks of elements", 4);
    const std::int64_t n_elements = numbers.Count("elements", 4);
    numbers.Size("the least number of an element");
    numbers.Size("the largest number of an element");
    std::array<std::int64_t, 8> nodes;
    std::int64_t n_seen = 0;
    for (std::int64_t block = 0; block < n_blocks; ++block) {
        const std::int64_t dimension = numbers.Int("the dimension of an entity");
        const std::int64_t elementary = numbers.Int("the number of an entity");
        const std::int64_t type = numbers.Int("the type of elements");
        const auto n_nodes = static_cast<std::size_t>(mesh.NodesOfType(type));
        const std::int64_t n_here = numbers.Count("elements", 4);
        const GmshEntity wanted = {dimension, elementary, 0};
        const auto entity = std::lower_bound(entities.begin(), entities.end(), wanted);
        const std::int64_t physical = entity == entities.end() || wanted < *entity ? 0 : entity->physical;
        for (std::int64_t i = 0; i < n_here; ++i) {
            const std::int64_t tag = numbers.Size("the number of an element");
            for (std::size_t k = 0; k < n_nodes; ++k) nodes[k] = numbers.Size("a node of an element");
            mesh.AddElement(type, tag, physical, elementary, {nodes.data(), n_nodes});
        }
        n_seen += n_here;
    }
    if (n_seen != n_elements) {
        numbers.text.FailHere("the blocks have " + std::to_string(n_seen) + " elements, " + std::to_string(n_elements) +
                              " are announced");
    }
}

}  // namespace SolidSubdiv::Io::Internal

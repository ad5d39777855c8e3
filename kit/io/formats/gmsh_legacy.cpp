// SPDX-License-Identifier: Apache-2.0
// Nodes and elements of Gmsh's .msh versions 1 and 2: flat lists.
#include <array>

#include <solidsubdiv/kit/io/internal/gmsh.h>

namespace SolidSubdiv::Io::Internal {

namespace {

/// "1 2 3 4", as many as the element type has; 0 < n <= 8.
std::span<const std::int64_t> ReadNodes(GmshNumbers& numbers, int n, std::array<std::int64_t, 8>& nodes) {
    for (int i = 0; i < n; ++i) nodes[static_cast<std::size_t>(i)] = numbers.Int("a node of an element");
    return {nodes.data(), static_cast<std::size_t>(n)};
}

void ReadTextElements(GmshNumbers& numbers, std::int64_t n, GmshMesh& mesh) {
    std::array<std::int64_t, 8> nodes;
    for (std::int64_t i = 0; i < n; ++i) {
        const std::int64_t tag = numbers.Int("the number of an element");
        const std::int64_t type = numbers.Int("the type of an element");
        const int n_nodes = mesh.NodesOfType(type);
        const std::int64_t n_labels = numbers.text.Count("labels of an element");
        std::array<std::int64_t, 2> labels = {0, 0};
        for (std::int64_t label = 0; label < n_labels; ++label) {
            const std::int64_t value = numbers.Int("a label of an element");
            if (label < 2) labels[static_cast<std::size_t>(label)] = value;
        }
        mesh.AddElement(type, tag, labels[0], labels[1], ReadNodes(numbers, n_nodes, nodes));
    }
}

/// Blocks of elements of one type: type, how many, number of labels; then for each its number, labels and nodes.
void ReadBinaryElements(GmshNumbers& numbers, std::int64_t n, GmshMesh& mesh) {
    std::array<std::int64_t, 8> nodes;
    for (std::int64_t i = 0; i < n;) {
        const std::int64_t type = numbers.Int("the type of elements");
        const int n_nodes = mesh.NodesOfType(type);
        const std::int64_t n_here = numbers.Int("the number of elements of one type");
        const std::int64_t n_labels = numbers.Int("the number of labels");
        if (n_here < 1 || n_here > n - i || n_labels < 0)
            numbers.text.FailHere("a block of elements has a wrong header");
        for (std::int64_t element = 0; element < n_here; ++element, ++i) {
            const std::int64_t tag = numbers.Int("the number of an element");
            std::array<std::int64_t, 2> labels = {0, 0};
            for (std::int64_t label = 0; label < n_labels; ++label) {
                const std::int64_t value = numbers.Int("a label of an element");
                if (label < 2) labels[static_cast<std::size_t>(label)] = value;
            }
            mesh.AddElement(type, tag, labels[0], labels[1], ReadNodes(numbers, n_nodes, nodes));
        }
    }
}

}  // namespace

void ReadGmsh2Nodes(GmshNumbers& numbers, GmshMesh& mesh) {
    const std::int64_t n = numbers.text.Count("nodes", 8);
    numbers.BeginBinary();
    for (std::int64_t i = 0; i < n; ++i) {
        const std::int64_t tag = numbers.Int("the number of a node");
        const double x = numbers.Real("a coordinate"), y = numbers.Real("a coordinate"),
                     z = numbers.Real("a coordinate");
        mesh.AddNode(tag, x, y, z);
    }
    mesh.EndNodes();
}

void ReadGmsh2Elements(GmshNumbers& numbers, GmshMesh& mesh) {
    const std::int64_t n = numbers.text.Count("elements", 8);
    numbers.BeginBinary();
    numbers.binary ? ReadBinaryElements(numbers, n, mesh) : ReadTextElements(numbers, n, mesh);
}

void ReadGmsh1Elements(GmshNumbers& numbers, GmshMesh& mesh) {
    const std::int64_t n = numbers.text.Count("elements", 8);
    std::array<std::int64_t, 8> nodes;
    for (std::int64_t i = 0; i < n; ++i) {
        const std::int64_t tag = numbers.Int("the number of an element");
        const std::int64_t type = numbers.Int("the type of an element");
        const std::int64_t physical = numbers.Int("a label of an element");
        const std::int64_t elementary = numbers.Int("a label of an element");
        const std::int64_t n_nodes = numbers.Int("the number of nodes of an element");
        if (n_nodes != mesh.NodesOfType(type)) {
            numbers.text.FailHere("element " + std::to_string(tag) + " has " + std::to_string(n_nodes) +
                                  " nodes; its type needs " + std::to_string(mesh.NodesOfType(type)));
        }
        mesh.AddElement(type, tag, physical, elementary, ReadNodes(numbers, static_cast<int>(n_nodes), nodes));
    }
}

}  // namespace SolidSubdiv::Io::Internal

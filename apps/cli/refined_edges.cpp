// SPDX-License-Identifier: Apache-2.0
// Curves of a refined level: edge e has the edges 2e and 2e + 1, whatever the split.
#include <solidsubdiv/apps/cli/refined_edges.h>

namespace SolidSubdiv::Cli {

RefinedEdges::RefinedEdges(const Io::Topology& control, const Far::TopologyRefiner& refiner) : refiner_(refiner) {
    const Vtr::EdgeGraph base = refiner.graph(0);
    for (Index i = 0; i < control.n_edges(); ++i) {
        const Index e = base.FindEdge(control.edges[2 * i], control.edges[2 * i + 1]);
        if (e != kNoIndex && !base.edge_tags[e].in_face() && !base.edge_tags[e].in_cell()) parts_.push_back({i, e});
    }
}

std::vector<Index> RefinedEdges::At(int level) const {
    struct Piece {
        Index edge, low, high;  // its number in the level, its ends
    };
    std::vector<Piece> pieces;
    for (const Part& part : parts_) {
        const auto ends = refiner_.graph(0).EdgeVertices(part.edge);
        pieces.push_back({part.edge, ends[0], ends[1]});
    }
    for (int i = 0; i < level; ++i) {
        const Index first_point = refiner_.n_vertices(i);
        std::vector<Piece> halves;
        halves.reserve(2 * pieces.size());
        for (const Piece& piece : pieces) {
            const Index point = first_point + piece.edge;  // above every vertex of the parent level
            halves.push_back({2 * piece.edge, piece.low, point});
            halves.push_back({2 * piece.edge + 1, piece.high, point});
        }
        pieces = std::move(halves);
    }
    std::vector<Index> edges;
    edges.reserve(2 * pieces.size());
    for (const Piece& piece : pieces) edges.insert(edges.end(), {piece.low, piece.high});
    return edges;
}

std::vector<Index> RefinedEdges::Origins(int level) const {
    std::vector<Index> origins;
    for (const Part& part : parts_) origins.insert(origins.end(), std::size_t{1} << level, part.element);
    return origins;
}

}  // namespace SolidSubdiv::Cli

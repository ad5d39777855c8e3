// SPDX-License-Identifier: Apache-2.0
// Links of vertices and rings of edges, and codes that are equal where they are the same up to numbering.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace SolidSubdiv::Analysis::Internal {

/// A cell at a vertex as a polygon of the vertex's link: its corners are edges at the vertex.
struct LinkFace {
    std::vector<int> corners;
    std::vector<std::uint8_t> marks;  ///< of the corners, as many: what else matters, such as major diagonals
};

/// Of a closed surface of polygons. The least of the texts that walks over the surface write, one from each corner in
/// either sense; so two links have the same code if and only if one is the other renumbered or mirrored. Empty: not
/// closed or not connected. Cost: the square of the number of corners.
std::u16string CodeOf(const std::vector<LinkFace>& link);

/// A cell at an edge from below to above, between two vertices of the ring around it.
struct RingCell {
    int from = 0, to = 0;
    char16_t mark = 0;
};
/// How marks change where the ring is walked backwards, and where the edge is turned upside down.
struct RingMarks {
    char16_t (*backwards)(char16_t);
    char16_t (*upside_down)(char16_t);
};
/// The marks around the ring from the best start, in the best sense, with the better end above: the least such text.
/// Empty: no ring.
std::u16string CodeOf(std::vector<RingCell> cells, const RingMarks& marks);

}  // namespace SolidSubdiv::Analysis::Internal

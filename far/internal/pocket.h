// SPDX-License-Identifier: Apache-2.0
// What is around one element of a level, as a small complex of its own: all that decides the limit inside it.
//
// Vertices and elements are numbered from the element outwards by how they hang together alone. So two places with the
// same topology give the same pocket, number by number, and what is found out about one of them holds for the other.
// The split of a pocket has the pockets of the element's children (see docs/limits.md).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <solidsubdiv/far/place.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/sdc/schemes.h>
#include <solidsubdiv/vtr/level.h>
#include <solidsubdiv/vtr/polyhedral_level.h>

namespace SolidSubdiv::Far::Internal {

/// How far a scheme looks.
struct Reach {
    /// 0: all cells at the element's vertices, and those at edges of tets opposite to them; each more: all at the
    /// vertices of the cells before.
    int n_rings = 0;
    /// Of edges opposite to an element's vertices those alone matter that are B edges of tets there.
    bool b_edges_only = false;
    /// A new point on an edge depends on what is around both ends, not just on the elements that have the edge.
    bool edges_need_both_ends = false;
    /// Vertices stay, and new points look beyond the elements that have their edge or octahedron.
    bool interpolates = false;

    /// What does nearly everywhere. A place that needs more says so (LimitOutcome::Unknown): then add a ring.
    static Reach Of(const Sdc::Scheme& scheme, Elements elements);
};

enum class RootKind : Index { Tet, Oct, Hex, Polyhedron, Face };

/// Lists of vertices with offsets.
struct VertexLists {
    std::vector<Offset> offsets{0};
    std::vector<Index> vertices;

    void Add(std::span<const Index> list) {
        vertices.insert(vertices.end(), list.begin(), list.end());
        offsets.push_back(static_cast<Offset>(vertices.size()));
    }
    Index size() const { return static_cast<Index>(offsets.size()) - 1; }
    std::span<const Index> operator[](Index i) const {
        return {
            vertices.data() + offsets[static_cast<std::size_t>(i)],
            static_cast<std::size_t>(offsets[static_cast<std::size_t>(i) + 1] - offsets[static_cast<std::size_t>(i)])};
    }
};

/// The element in the middle, the root, is the first of its kind, with its vertices 0, 1, .. in its own order.
struct Pocket {
    RootKind root = RootKind::Tet;
    bool is_tet_oct = true;  ///< how it is split
    Index n_root_vertices = 0;
    std::vector<Index> vertices;  ///< of the level, by the pocket's numbers: not part of what makes pockets equal

    std::vector<Index> tets, octs, hexes;  ///< as in TopologyDescriptor
    std::vector<Offset> cell_offsets{0};   ///< of other cells, their faces
    VertexLists cell_faces;
    VertexLists faces;         ///< in no cell, or all that counts where the root is a face
    std::vector<Index> edges;  ///< (n, 2), in no face

    std::vector<Index> crease_edges;  ///< (n, 2)
    std::vector<float> crease_sharpness;
    std::vector<Index> corner_vertices;
    std::vector<float> corner_sharpness;

    std::vector<char> is_complete;      ///< of each vertex, whether all elements at it are here
    std::vector<Index> complete_edges;  ///< (n, 2), ascending: further edges of which that is so

    Index n_vertices() const { return static_cast<Index>(vertices.size()); }
    bool HasCompleteEdge(Index a, Index b) const;
    /// Equal for pockets that are equal.
    std::vector<std::int32_t> Key() const;
};

class PocketSource;

/// Makes pockets of one level, one after another. A thread needs its own.
class PocketMaker {
  public:
    /// Arguments outlive it; sharpness is the level's. @pre the level is full
    PocketMaker(const Vtr::Level& level, const Sharpness& sharpness, const Reach& reach, Elements elements);
    PocketMaker(const Vtr::PolyhedralLevel& level, const Sharpness& sharpness, const Reach& reach, Elements elements);
    ~PocketMaker();
    PocketMaker(PocketMaker&&) noexcept;

    Pocket Make(Index element);

  private:
    std::unique_ptr<PocketSource> source_;
};

}  // namespace SolidSubdiv::Far::Internal

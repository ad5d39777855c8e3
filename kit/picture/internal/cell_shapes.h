// SPDX-License-Identifier: Apache-2.0
// Cells of every kind as their faces.
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include <solidsubdiv/kit/io/mesh.h>
#include <solidsubdiv/kit/picture/cut.h>
#include <solidsubdiv/sdc/cells.h>

namespace SolidSubdiv::Picture::Internal {

/// One cell, in room that serves for many.
class CellFaces {
  public:
    CellKind kind() const { return kind_; }
    std::span<const Index> vertices() const { return vertices_; }  ///< each once
    std::size_t n_faces() const { return ends_.size(); }
    /// Counterclockwise from outside.
    std::span<const Index> face(std::size_t i) const {
        const std::size_t first = i == 0 ? 0 : ends_[i - 1];
        return std::span(corners_).subspan(first, ends_[i] - first);
    }

    template <class Cell>
    void Set(CellKind kind, std::span<const Index> cell) {
        kind_ = kind;
        vertices_.assign(cell.begin(), cell.end());
        corners_.clear();
        ends_.clear();
        for (const auto& face : Cell::faces) {
            for (Sdc::Local k : face) {
                if (k != Sdc::kNoLocal) corners_.push_back(cell[k]);
            }
            ends_.push_back(corners_.size());
        }
    }
    void SetPolyhedron(const Io::Topology& topology, Offset cell);

  private:
    CellKind kind_ = CellKind::Tet;
    std::vector<Index> vertices_, corners_;
    std::vector<std::size_t> ends_;  // of each face's corners
};

/// Calls visit(cell) for every cell, a CellFaces that is good until the next call.
template <class Visit>
void ForEachCell(const Io::Topology& topology, Visit&& visit) {
    CellFaces cell;
    const auto fixed = [&]<class Cell>(Cell, CellKind kind, const std::vector<Index>& cells) {
        constexpr std::size_t n = Cell::kVertices;
        for (std::size_t c = 0; c + n <= cells.size(); c += n) {
            cell.Set<Cell>(kind, std::span(cells).subspan(c, n));
            visit(std::as_const(cell));
        }
    };
    fixed(Sdc::Tet{}, CellKind::Tet, topology.tets);
    fixed(Sdc::Oct{}, CellKind::Oct, topology.octs);
    fixed(Sdc::Hex{}, CellKind::Hex, topology.hexes);
    fixed(Sdc::Wedge{}, CellKind::Wedge, topology.wedges);
    fixed(Sdc::Pyramid{}, CellKind::Pyramid, topology.pyramids);
    for (Offset c = 0; c < topology.n_polyhedra(); ++c) {
        cell.SetPolyhedron(topology, c);
        visit(std::as_const(cell));
    }
}

/// @throws InvalidInput unless the normal is a direction
void CheckPlane(const Plane& plane);

/// The edges, each once, ordered, as one flat array.
std::vector<Index> UniqueEdges(std::vector<std::array<Index, 2>> edges);

}  // namespace SolidSubdiv::Picture::Internal

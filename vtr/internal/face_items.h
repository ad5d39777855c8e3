// SPDX-License-Identifier: Apache-2.0
// Lists of vertices around faces as a caller's elements have them: sides of hexahedra, faces of other cells, polygons,
// in this order.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include <solidsubdiv/sdc/cells.h>
#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/vtr/polyhedral_base.h>
#include <solidsubdiv/vtr/unique_tuples.h>

namespace SolidSubdiv::Vtr::Internal {

class FaceItems {
  public:
    explicit FaceItems(const PolyhedralElements& in) : in_(in) {
        const auto rows = [](std::span<const Offset> offsets) {
            return offsets.empty() ? Offset{0} : static_cast<Offset>(offsets.size()) - 1;
        };
        n_hexes_ = static_cast<Index>(in.hexes.size() / Sdc::Hex::kVertices);
        n_hex_items_ = Offset{Sdc::Hex::kFaces} * n_hexes_;
        n_cell_items_ = n_hex_items_ + rows(in.face_offsets);
        n_ = n_cell_items_ + rows(in.polygon_offsets);
        cells_.resize(static_cast<std::size_t>(n_cell_items_ - n_hex_items_));
        Sdc::ParallelFor(rows(in.cell_offsets), 1024, [&](Offset begin, Offset end) {
            for (Offset c = begin; c < end; ++c) {
                const auto row = [&](Offset i) {
                    return cells_.begin() + in.cell_offsets[static_cast<std::size_t>(i)];
                };
                std::fill(row(c), row(c + 1), n_hexes_ + static_cast<Index>(c));
            }
        });
    }
    Offset size() const { return n_; }
    Offset n_hex_items() const { return n_hex_items_; }
    Offset n_cell_items() const { return n_cell_items_; }
    bool IsPolygon(Offset i) const { return i >= n_cell_items_; }
    /// The cell that has item i, or kNoIndex.
    Index CellOf(Offset i) const {
        if (i < n_hex_items_) return static_cast<Index>(i / Sdc::Hex::kFaces);
        return IsPolygon(i) ? kNoIndex : cells_[static_cast<std::size_t>(i - n_hex_items_)];
    }
    int Count(Offset i) const { return i < n_hex_items_ ? 4 : static_cast<int>(Row(i).size()); }
    /// Its vertices, as the element has them.
    void Copy(Offset i, std::vector<Index>& out) const {
        if (i < n_hex_items_) {
            const auto side = Side(i);
            out.assign(side.begin(), side.end());
        } else {
            const auto row = Row(i);
            out.assign(row.begin(), row.end());
        }
    }
    /// Ascending; after three of a triangle, none.
    std::array<Index, 4> LowestFour(Offset i) const {
        std::array<Index, 4> lowest{0, 0, 0, kNoIndex};
        if (i < n_hex_items_) {
            lowest = Side(i);
            SortFew(lowest);
        } else if (const auto row = Row(i); row.size() == 4) {
            std::copy(row.begin(), row.end(), lowest.begin());
            SortFew(lowest);
        } else {
            std::partial_sort_copy(row.begin(), row.end(), lowest.begin(), lowest.end());
        }
        return lowest;
    }

  private:
    /// Of a hexahedron.
    std::array<Index, 4> Side(Offset i) const {
        const Index* const vertices = in_.hexes.data() + i / Sdc::Hex::kFaces * Sdc::Hex::kVertices;
        std::array<Index, 4> side;
        for (std::size_t k = 0; k < 4; ++k) side[k] = vertices[Sdc::Hex::faces[i % Sdc::Hex::kFaces][k]];
        return side;
    }
    /// @pre the item is no side of a hexahedron
    std::span<const Index> Row(Offset i) const {
        const auto row = [](std::span<const Offset> offsets, std::span<const Index> vertices, Offset at) {
            const Offset* const here = offsets.data() + at;
            return vertices.subspan(static_cast<std::size_t>(here[0]), static_cast<std::size_t>(here[1] - here[0]));
        };
        return IsPolygon(i) ? row(in_.polygon_offsets, in_.polygon_vertices, i - n_cell_items_)
                            : row(in_.face_offsets, in_.face_vertices, i - n_hex_items_);
    }

    const PolyhedralElements& in_;
    Index n_hexes_;
    Offset n_hex_items_, n_cell_items_, n_;
    Array<Index> cells_;  // of the faces of other cells than hexahedra
};

}  // namespace SolidSubdiv::Vtr::Internal

// SPDX-License-Identifier: Apache-2.0
// An upward relation: for each component the components of higher dimension that have it.
#pragma once

#include <span>

#include <solidsubdiv/sdc/cells.h>
#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Vtr {

/// Compressed rows: row i holds items[offsets[i], offsets[i + 1]), ascending. `locals`, where kept, says which vertex,
/// edge or face of the item the component is. Where there are no items at all there are no offsets either.
struct Relation {
    Array<Offset> offsets;
    Array<Index> items;
    Array<Sdc::Local> locals;

    bool empty() const { return offsets.empty(); }
    Offset n_items() const { return static_cast<Offset>(items.size()); }
    Offset Start(Index i) const { return empty() ? 0 : offsets[i]; }
    int Count(Index i) const { return empty() ? 0 : static_cast<int>(offsets[i + 1] - offsets[i]); }
    std::span<const Index> operator[](Index i) const {
        if (empty()) return {};
        return {items.data() + offsets[i], static_cast<std::size_t>(offsets[i + 1] - offsets[i])};
    }
    std::span<const Sdc::Local> Locals(Index i) const {
        return {locals.data() + Start(i), static_cast<std::size_t>(Count(i))};
    }
    Offset Bytes() const {
        return static_cast<Offset>(offsets.size() * sizeof(Offset) + items.size() * sizeof(Index) + locals.size());
    }
};

/// Turns the downward relation "item -> its `arity` parts" into the upward one, parts in [0, n_parts).
/// Cost: count, scan, fill; the same bits for any number of threads.
Relation Invert(std::span<const Index> parts, int arity, Index n_parts, bool keep_locals);

}  // namespace SolidSubdiv::Vtr

// SPDX-License-Identifier: Apache-2.0
// Inversion of a relation by counting.
#include <solidsubdiv/vtr/relation.h>

#include <solidsubdiv/vtr/grouping.h>

namespace SolidSubdiv::Vtr {

Relation Invert(std::span<const Index> parts, int arity, Index n_parts, bool keep_locals) {
    Relation r;
    if (parts.empty()) return r;
    const auto visit = [&](auto&& add) {
        const Index* part = parts.data();
        const Index n_items = static_cast<Index>(parts.size() / static_cast<std::size_t>(arity));
        for (Index item = 0; item < n_items; ++item) {
            for (int local = 0; local < arity; ++local) add(*part++, item, local);
        }
    };
    r.offsets = CountRows(n_parts, visit);
    r.items.resize(parts.size());
    if (keep_locals) r.locals.resize(parts.size());
    FillRows(r.offsets, visit, [&](Offset place, Index item, int local) {
        r.items[place] = item;
        if (keep_locals) r.locals[place] = static_cast<Sdc::Local>(local);
    });
    return r;
}

}  // namespace SolidSubdiv::Vtr

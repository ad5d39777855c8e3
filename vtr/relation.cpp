// SPDX-License-Identifier: Apache-2.0
// Inversion of a relation by counting.
#include <solidsubdiv/vtr/relation.h>

#include <algorithm>

#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Vtr {

Relation Invert(std::span<const Index> parts, int arity, Index n_parts, bool keep_locals) {
    Relation r;
    if (parts.empty()) return r;
    r.offsets.resize(static_cast<std::size_t>(n_parts) + 1);
    r.items.resize(parts.size());
    if (keep_locals) r.locals.resize(parts.size());
    Offset* const offsets = r.offsets.data();
    Index* const items = r.items.data();
    Sdc::Local* const locals = r.locals.data();

    // Each thread reads all items in their order and handles the parts of its own range: reading in sequence costs
    // little beside the scattered writes, and there is nothing to share, no atomic counter, and rows come out
    // ascending.
    const Offset n_ranges = Sdc::ThreadCount();
    const auto for_each_range = [&](auto&& body) {
        Sdc::ParallelFor(n_ranges, 1, [&](Offset begin, Offset end) {
            for (Offset range = begin; range < end; ++range) {
                body(static_cast<Index>(n_parts * range / n_ranges),
                     static_cast<Index>(n_parts * (range + 1) / n_ranges));
            }
        });
    };
    for_each_range([&](Index first, Index last) {
        std::fill(offsets + first, offsets + last, Offset{0});
        for (Index part : parts) {
            if (part >= first && part < last) ++offsets[part];
        }
    });
    Sdc::ScanLengths(r.offsets);

    // Filling moves each row's start to its end; afterwards starts are the ends of the rows before.
    for_each_range([&](Index first, Index last) {
        std::size_t i = 0;
        const Index n_items = static_cast<Index>(parts.size() / static_cast<std::size_t>(arity));
        for (Index item = 0; item < n_items; ++item) {
            for (int local = 0; local < arity; ++local, ++i) {
                const Index part = parts[i];
                if (part < first || part >= last) continue;
                const Offset place = offsets[part]++;
                items[place] = item;
                if (keep_locals) locals[place] = static_cast<Sdc::Local>(local);
            }
        }
    });
    std::shift_right(r.offsets.begin(), r.offsets.end(), 1);
    offsets[0] = 0;
    return r;
}

}  // namespace SolidSubdiv::Vtr

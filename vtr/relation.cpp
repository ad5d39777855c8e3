// SPDX-License-Identifier: Apache-2.0
// Inversion of a relation by counting.
#include <solidsubdiv/vtr/relation.h>

#include <algorithm>
#include <atomic>

#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Vtr {

Relation Invert(std::span<const Index> parts, int arity, Index n_parts, bool keep_locals) {
    const Offset n = static_cast<Offset>(parts.size());
    const bool alone = Sdc::ThreadCount() == 1;
    constexpr Offset kGrain = 1 << 15;

    Relation r;
    r.offsets.assign(static_cast<std::size_t>(n_parts) + 1, 0);
    r.items.resize(parts.size());
    if (keep_locals) r.locals.resize(parts.size());

    // Several threads share the counters, so they are atomic then; alone, plain additions are several times faster.
    const auto claim = [&](Index part) {
        if (alone) return r.offsets[part]++;
        return std::atomic_ref<Offset>(r.offsets[part]).fetch_add(1, std::memory_order_relaxed);
    };
    Sdc::ParallelFor(n, kGrain, [&](Offset begin, Offset end) {
        for (Offset i = begin; i < end; ++i) claim(parts[i]);
    });
    Sdc::ScanLengths(r.offsets);

    // Filling moves each row's start to its end; afterwards starts are the ends of the rows before.
    Sdc::ParallelFor(n, kGrain, [&](Offset begin, Offset end) {
        for (Offset i = begin; i < end; ++i) {
            const Offset place = claim(parts[i]);
            r.items[place] = static_cast<Index>(i / arity);
            if (keep_locals) r.locals[place] = static_cast<Sdc::Local>(i % arity);
        }
    });
    std::shift_right(r.offsets.begin(), r.offsets.end(), 1);
    r.offsets[0] = 0;

    // Alone, rows came out ascending; otherwise in the order of arrival. Rows are short: insertion sort.
    if (!alone) {
        Sdc::ParallelFor(n_parts, kGrain / 8, [&](Offset begin, Offset end) {
            for (Offset row = begin; row < end; ++row) {
                for (Offset i = r.offsets[row] + 1; i < r.offsets[row + 1]; ++i) {
                    for (Offset j = i; j > r.offsets[row] && r.items[j] < r.items[j - 1]; --j) {
                        std::swap(r.items[j], r.items[j - 1]);
                        if (keep_locals) std::swap(r.locals[j], r.locals[j - 1]);
                    }
                }
            }
        });
    }
    return r;
}

}  // namespace SolidSubdiv::Vtr

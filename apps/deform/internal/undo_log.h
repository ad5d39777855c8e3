// SPDX-License-Identifier: Apache-2.0
// A step of undo: what a change has overwritten in a few arrays of triples. Undone, it holds what to redo, and so on.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Deform::Internal {

/// Mode: what else there is to restore, small; the owner exchanges it.
template <class Mode>
class UndoStep {
  public:
    Mode mode;

    UndoStep(Mode before, std::size_t n_arrays) : mode(std::move(before)), is_kept_(n_arrays), is_whole_(n_arrays) {}

    bool IsEmpty() const { return kept_.empty(); }

    /// A triple of an array is about to be overwritten. What the step has kept of it before counts.
    void Keep(std::size_t array, Index triple, const std::vector<double>& values) {
        if (is_whole_[array]) return;
        std::vector<char>& is_kept = is_kept_[array];
        is_kept.resize(values.size() / 3);
        if (std::exchange(is_kept[static_cast<std::size_t>(triple)], 1) != 0) return;
        auto part = std::find_if(kept_.begin(), kept_.end(), [&](const Values& v) { return v.array == array; });
        if (part == kept_.end()) part = kept_.insert(part, {array, false, {}, {}});
        part->where.push_back(triple);
        const double* value = values.data() + 3 * static_cast<std::size_t>(triple);
        part->values.insert(part->values.end(), value, value + 3);
    }

    /// An array is about to be replaced; takes it.
    void Keep(std::size_t array, std::vector<double>&& values) {
        if (std::exchange(is_whole_[array], 1) == 0) kept_.push_back({array, true, {}, std::move(values)});
    }

    /// No more will be kept.
    void Close() {
        is_kept_.clear();
        is_whole_.clear();
    }

    /// Exchanges what is kept with what is there. Triples of the array `watched` that it exchanges; nothing where
    /// any array was exchanged as a whole.
    std::optional<std::vector<Index>> Exchange(std::vector<std::vector<double>>& arrays, std::size_t watched) {
        std::optional<std::vector<Index>> moved(std::in_place);
        // Backwards, as triples were kept before the whole of their array was. The other way round the next time.
        std::reverse(kept_.begin(), kept_.end());
        for (Values& old : kept_) {
            std::vector<double>& array = arrays[old.array];
            if (old.is_whole) {
                array.swap(old.values);
                moved.reset();
                continue;
            }
            for (std::size_t i = 0; i < old.where.size(); ++i) {
                double* at = array.data() + 3 * static_cast<std::size_t>(old.where[i]);
                std::swap_ranges(at, at + 3, old.values.begin() + static_cast<std::ptrdiff_t>(3 * i));
            }
            if (moved && old.array == watched) moved->insert(moved->end(), old.where.begin(), old.where.end());
        }
        return moved;
    }

    Offset Bytes() const {
        std::size_t bytes = sizeof(*this);
        for (const Values& v : kept_) {
            bytes += sizeof(v) + v.where.size() * sizeof(Index) + v.values.size() * sizeof(double);
        }
        return static_cast<Offset>(bytes);
    }

  private:
    /// Values of one array: of some triples, or of all.
    struct Values {
        std::size_t array;
        bool is_whole;
        std::vector<Index> where;
        std::vector<double> values;
    };

    std::vector<Values> kept_;
    std::vector<std::vector<char>> is_kept_;  ///< by array: of each triple; empty until needed
    std::vector<char> is_whole_;              ///< by array
};

}  // namespace SolidSubdiv::Deform::Internal

// SPDX-License-Identifier: Apache-2.0
// A map of few keys that is filled and forgotten millions of times.
#pragma once

#include <cstdint>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Vtr {

/// Values of keys, both from 0 on, in a table by a hash of the key. Forgetting them all costs nothing.
class ShortMap {
  public:
    /// Forgets all. @param max_size at least how many keys there will be
    void Start(std::size_t max_size) {
        ++round_;
        if (2 * max_size <= slots_.size()) return;
        std::size_t size = 64;
        while (size < 2 * max_size) size *= 2;
        slots_.assign(size, {});
    }
    /// The value that the key has, or this one, which it has from now on.
    Index Note(Index key, Index value) {
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = (static_cast<std::uint32_t>(key) * 0x9E3779B1u >> 16) & mask;
        while (slots_[at].round == round_ && slots_[at].key != key) at = (at + 1) & mask;
        Slot& slot = slots_[at];
        // Without a branch: whether a key is new is anybody's guess.
        slot.value = slot.round == round_ ? slot.value : value;
        slot.round = round_;
        slot.key = key;
        return slot.value;
    }

  private:
    struct Slot {
        std::uint64_t round = 0;  ///< of an earlier round: empty
        Index key = kNoIndex, value = kNoIndex;
    };
    std::vector<Slot> slots_;
    std::uint64_t round_ = 0;
};

}  // namespace SolidSubdiv::Vtr

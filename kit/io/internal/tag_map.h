// SPDX-License-Identifier: Apache-2.0
// Numbers that a file gives its nodes or elements -> their places. The numbers may have gaps and come in any order.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Io::Internal {

class TagMap {
  public:
    void Add(std::int64_t tag) { tags_.push_back({tag, static_cast<Index>(tags_.size())}); }
    std::size_t size() const { return tags_.size(); }

    /// To be called between the last Add and the first Find.
    void Sort() {
        consecutive_ = true;
        for (std::size_t i = 1; i < tags_.size(); ++i) {
            const std::int64_t tag = tags_[i].first, before = tags_[i - 1].first;
            consecutive_ = consecutive_ && tag > before && tag - 1 == before;
        }
        if (!consecutive_) std::sort(tags_.begin(), tags_.end());
    }

    /// The place of a tag, the first one if it is there twice; -1 if there is none.
    std::int64_t Find(std::int64_t tag) const {
        if (tags_.empty()) return -1;
        if (consecutive_) {
            const std::int64_t first = tags_.front().first;
            return tag < first || tag > tags_.back().first ? -1 : tag - first;
        }
        const auto found = std::lower_bound(tags_.begin(), tags_.end(), std::pair(tag, Index{-1}));
        return found == tags_.end() || found->first != tag ? std::int64_t{-1} : found->second;
    }

    /// A tag that is there twice. @returns whether there is one
    bool FindRepeated(std::int64_t& tag) const {
        const auto found = std::adjacent_find(tags_.begin(), tags_.end(),
                                              [](const auto& a, const auto& b) { return a.first == b.first; });
        if (found != tags_.end()) tag = found->first;
        return found != tags_.end();
    }

  private:
    std::vector<std::pair<std::int64_t, Index>> tags_;
    bool consecutive_ = false;
};

}  // namespace SolidSubdiv::Io::Internal

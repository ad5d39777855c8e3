// SPDX-License-Identifier: Apache-2.0
// Limits of places by topology: states are pockets met so far, each with its closed form or with the pockets of its
// children and the rows that lead to them.
//
// Since rules are the same at every level, few different pockets are met however often a place is refined: around an
// extraordinary vertex, edge or face a pocket soon is its own child. What is found out about a state is kept, so that
// the second place in it costs a few products of short rows.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <shared_mutex>
#include <unordered_map>

#include <solidsubdiv/far/internal/limit_state.h>

namespace SolidSubdiv::Far::Internal {

struct LimitState;

struct LimitResult {
    LimitOutcome outcome = LimitOutcome::Unknown;
    int order = 0;     ///< up to which derivatives are there
    LimitBlock block;  ///< of the vertices of the pocket that it was asked of
};

class LimitStates {
  public:
    LimitStates(const Sdc::Scheme& scheme, Elements elements, const Reach& reach);
    ~LimitStates();

    /// The state of a pocket: valid while this lives. Any thread.
    LimitState& Find(const Pocket& pocket);

    /// Room that a thread needs.
    struct Scratch {
        std::vector<const Transition*> path;
        LimitBlock block;
    };
    /// Weights at a place of the root of a state's pocket, and derivatives up to `order`. Any thread.
    /// @param tangents at corners of faces, tangents instead of derivatives
    void Evaluate(LimitState& state, const Place& place, int order, bool tangents, Scratch& scratch,
                  LimitResult& result);

    std::size_t n_states() const;
    /// About the bytes of all that is kept.
    Offset Bytes() const { return bytes_; }

  private:
    friend class LimitExpansion;

    void Expand(LimitState& state);
    const CornerLimit& Corner(LimitState& state, std::size_t corner);
    CornerLimit MakeCorner(LimitState& state, std::size_t corner);

    const Sdc::Scheme scheme_;
    const Elements elements_;
    const Reach reach_;
    const RegularRule regular_;
    struct KeyHash {
        std::size_t operator()(const std::vector<std::int32_t>& key) const;
    };
    std::atomic<Offset> bytes_{0};
    mutable std::shared_mutex mutex_;  // of the list of states; each state has its own for what it holds
    std::unordered_map<std::vector<std::int32_t>, std::unique_ptr<LimitState>, KeyHash> states_;
};

}  // namespace SolidSubdiv::Far::Internal

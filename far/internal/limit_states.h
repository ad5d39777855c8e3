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

#include <solidsubdiv/far/internal/pocket.h>
#include <solidsubdiv/far/internal/regular_patch.h>

namespace SolidSubdiv::Far::Internal {

struct LimitState;

/// Rows of points of a pocket's split over its vertices.
struct RowsOfChildren {
    Array<std::uint32_t> offsets{0};
    Array<std::uint16_t> indices;
    Array<double> weights;

    Offset Bytes() const {
        return static_cast<Offset>(offsets.size() * sizeof(std::uint32_t) +
                                   indices.size() * (sizeof(std::uint16_t) + sizeof(double)));
    }
};

/// From a pocket's vertices to those of a child of its root, and the other way for coordinates.
struct Transition {
    LimitState* state = nullptr;  ///< of the child
    std::vector<Index> children;  ///< local vertices of the root that the child has as well, by its own; else kNoIndex
    std::vector<Index> rows;      ///< of the child's vertices, among RowsOfChildren; kNoIndex: the pocket does not know
    /// The child's coordinates at a place x of the root: matrix x + shift.
    std::array<std::array<double, 3>, 3> matrix{};
    std::array<double, 3> shift{};
};

/// How a part of a polyhedron (see place.h) lies in the child at its corner, and in the one at the next corner.
struct PartHalf {
    int child = -1;  ///< of the root; -1: one that is no hexahedron either
    std::array<std::array<double, 3>, 3> matrix{};
    std::array<double, 3> shift{};
};

enum class LimitOutcome {
    Known,
    None,    ///< there is no limit
    Unknown  ///< the pocket is too small to say
};

/// Limit and derivatives at one vertex of the root.
struct CornerLimit {
    LimitOutcome outcome = LimitOutcome::Unknown;
    bool has_derivatives = false;
    LimitBlock block;  ///< of the pocket's vertices, first derivatives included
};

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
    void Evaluate(LimitState& state, const Place& place, int order, Scratch& scratch, LimitResult& result);

    std::size_t n_states() const;
    /// About the bytes of all that is kept.
    Offset Bytes() const { return bytes_; }

  private:
    class Expander;

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

// SPDX-License-Identifier: Apache-2.0
// The walk from an element towards a place, and back with rows.
#include <solidsubdiv/far/internal/limit_states.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include <solidsubdiv/far/internal/walk_in_parts.h>

namespace SolidSubdiv::Far::Internal {

LimitStates::LimitStates(const Sdc::Scheme& scheme, Elements elements, const Reach& reach)
    : scheme_(scheme), elements_(elements), reach_(reach), regular_(RegularRuleOf(scheme, elements)) {}

LimitStates::~LimitStates() = default;

std::size_t LimitStates::KeyHash::operator()(const std::vector<std::int32_t>& key) const {
    std::uint64_t hash = 0x9E3779B97F4A7C15u;
    for (std::int32_t x : key) {
        hash = (hash ^ static_cast<std::uint32_t>(x)) * 0xBF58476D1CE4E5B9u;
        hash ^= hash >> 31;
    }
    return hash;
}

LimitState& LimitStates::Find(const Pocket& pocket) {
    std::vector<std::int32_t> key = pocket.Key();
    {
        std::shared_lock lock(mutex_);
        if (const auto found = states_.find(key); found != states_.end()) return *found->second;
    }
    auto state = std::make_unique<LimitState>(pocket);
    state->patch = RegularPatch::Find(pocket, regular_);
    bytes_ += static_cast<Offset>(key.size() * 2 * sizeof(std::int32_t) + sizeof(LimitState));
    std::unique_lock lock(mutex_);
    return *states_.emplace(std::move(key), std::move(state)).first->second;
}

std::size_t LimitStates::n_states() const {
    std::shared_lock lock(mutex_);
    return states_.size();
}

const CornerLimit& LimitStates::Corner(LimitState& state, std::size_t corner) {
    std::call_once(state.corner_flags[corner], [&] { state.corners[corner] = MakeCorner(state, corner); });
    return state.corners[corner];
}

namespace {

/// Corners of a state's root with the weights that they have at a place, if there are coordinates for that.
struct NearCorners {
    std::array<double, 8> weights{};
    std::array<Index, 8> numbers{};
    std::size_t n = 0;

    bool IsAtOne() const { return std::find(weights.begin(), weights.end(), 1.0) != weights.end(); }
};

NearCorners CornersAround(const LimitState& state, const Coordinates& at, const std::array<Index, 4>& path,
                          bool is_part) {
    NearCorners corners;
    if (!state.has_parts()) {
        const CornerWeights weights = WeightsOfCorners(state.root, state.n_root_vertices, at);
        corners.weights = weights.weights;
        corners.n = weights.n;
        std::iota(corners.numbers.begin(), corners.numbers.end(), Index{0});
    } else if (!is_part) {
        corners.weights = {1 - at[0], at[0] - at[1], at[1] - at[2], at[2]};
        corners.n = 4;
        std::copy(path.begin(), path.end(), corners.numbers.begin());
    }
    return corners;
}

/// The child that has a place, and the place in it.
std::pair<const Transition*, Coordinates> ChildAround(const LimitState& state, const Coordinates& at) {
    std::pair<const Transition*, Coordinates> deepest{};
    double depth = -std::numeric_limits<double>::infinity();
    for (const Transition& t : state.children) {
        Coordinates x = t.shift;
        for (std::size_t r = 0; r < 3; ++r) {
            for (std::size_t c = 0; c < 3; ++c) x[r] += t.matrix[r][c] * at[c];
        }
        const double d = Depth(t.state->root, t.state->n_root_vertices, x);
        if (d <= depth) continue;
        depth = d;
        deepest = {&t, x};
        if (depth >= 0) break;
    }
    return deepest;
}

}  // namespace

void LimitStates::Evaluate(LimitState& start, const Place& place, int order, bool tangents, Scratch& scratch,
                           LimitResult& result) {
    // Deep enough for linear interpolation between limits of corners to be exact to round-off where these are smooth,
    // and where they are not, as deep as coordinates of doubles go.
    constexpr std::size_t kSmoothDepth = 26, kMaxDepth = 60;
    const int d = elements_ == Elements::Cells ? 3 : 2;
    scratch.path.clear();
    Matrix3 by{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    result.outcome = LimitOutcome::Unknown;
    result.order = 0;
    LimitState* s = &start;
    Coordinates at = place.at;
    bool is_part = start.has_parts();
    std::array<Index, 4> path{};
    LimitBlock& block = scratch.block;
    const auto columns_of = [&](int up_to) { return 1 + NDerivatives(elements_, up_to); };
    while (true) {
        LimitState& state = *s;
        const Index n = state.n_vertices;
        if (state.patch) {
            block.Reset(n, columns_of(order));
            state.patch->Evaluate(at, order, block);
            result.outcome = LimitOutcome::Known;
            // Rounding of coordinates grows twofold a step, and that of second derivatives fourfold; what is so near to
            // an irregular place that nothing is left has no derivatives.
            constexpr std::size_t kSecondDepth = 13;
            result.order = std::min(order, scratch.path.size() <= kSecondDepth   ? 2
                                           : scratch.path.size() <= kSmoothDepth ? 1
                                                                                 : 0);
            block.Keep(columns_of(result.order));
            break;
        }
        if (const NearCorners corners = CornersAround(state, at, path, is_part);
            corners.IsAtOne() || (corners.n > 0 && scratch.path.size() >= kSmoothDepth)) {
            bool has_derivatives = true;
            result.outcome = LimitOutcome::Known;
            for (std::size_t i = 0; i < corners.n; ++i) {
                if (corners.weights[i] == 0) continue;
                const CornerLimit& limit = Corner(state, static_cast<std::size_t>(corners.numbers[i]));
                result.outcome = std::max(result.outcome, limit.outcome);
                has_derivatives =
                    has_derivatives && (limit.has_derivatives || (tangents && corners.IsAtOne() && limit.has_tangents));
            }
            if (result.outcome != LimitOutcome::Known) return;
            if (corners.IsAtOne() || has_derivatives || scratch.path.size() >= kMaxDepth) {
                const bool is_precise = scratch.path.size() <= kSmoothDepth;
                result.order = std::min(order, has_derivatives && is_precise ? 1 : 0);
                block.Reset(n, columns_of(result.order));
                for (std::size_t i = 0; i < corners.n; ++i) {
                    if (corners.weights[i] == 0) continue;
                    const CornerLimit& limit = Corner(state, static_cast<std::size_t>(corners.numbers[i]));
                    const bool takes_tangents = tangents && corners.IsAtOne() && limit.has_tangents;
                    const LimitBlock& rows = takes_tangents ? limit.tangents : limit.block;
                    for (Index v = 0; v < n; ++v) {
                        for (int c = 0; c < block.n_columns; ++c) {
                            block.Row(v)[c] += corners.weights[i] * rows.Row(v)[c];
                        }
                    }
                }
                break;
            }
        }
        Expand(state);
        if (state.has_parts()) {
            const StepInParts step = is_part ? StepFromPart(state, place.part, at) : StepFromPath(state, path, at);
            is_part = false;
            scratch.path.push_back(step.next);
            by = Multiply(step.matrix, by);
            at = step.at;
            path = step.path;
        } else {
            const auto [next, next_at] = ChildAround(state, at);
            scratch.path.push_back(next);
            by = Multiply(next->matrix, by);
            at = next_at;
        }
        s = scratch.path.back()->state;
    }
    ChangeRows(by, d, result.order, block);
    for (std::size_t i = scratch.path.size(); i-- > 0;) {
        const LimitState& parent = i == 0 ? start : *scratch.path[i - 1]->state;
        if (!Pull(parent, *scratch.path[i], block, result.block)) {
            result.outcome = LimitOutcome::Unknown;
            return;
        }
        std::swap(block, result.block);
    }
    std::swap(block, result.block);
}

}  // namespace SolidSubdiv::Far::Internal

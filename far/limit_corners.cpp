// SPDX-License-Identifier: Apache-2.0
// Limits and slopes at the corners of elements: eigenvectors of what leads from a pocket to itself.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <solidsubdiv/far/internal/limit_states.h>

namespace SolidSubdiv::Far::Internal {

namespace {

/// A state on the way to a corner of the one that it is asked of.
struct Step {
    LimitState* state;
    std::size_t corner;
    const Transition* next;
};

double LargestChange(const LimitBlock& a, const LimitBlock& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.weights.size(); ++i) {
        largest = std::max(largest, std::abs(a.weights[i] - b.weights[i]));
    }
    return largest;
}
double LargestOf(const LimitBlock& block) {
    double largest = 0;
    for (double w : block.weights) largest = std::max(largest, std::abs(w));
    return largest;
}

/// The child at a corner, its child there, and so on, until one comes again: what leads around from there has the limit
/// as an eigenvector.
class CornerFinder {
  public:
    /// @param steps end where step `first` comes again
    CornerFinder(std::vector<Step> steps, std::size_t first, int dimension)
        : steps_(std::move(steps)), first_(first), d_(static_cast<std::size_t>(dimension)) {}

    CornerLimit Find() {
        CornerLimit result;
        limit_.Reset(state().n_vertices, 1);
        limit_.Row(corner())[0] = 1;
        result.outcome = Settle(limit_, [](LimitBlock& block) {
            double sum = 0;
            for (double w : block.weights) sum += w;
            for (double& w : block.weights) w /= sum;
        });
        if (result.outcome != LimitOutcome::Known) return result;
        result.block = limit_;
        if (!state().has_parts()) {  // else there are no coordinates to differentiate by
            neighbors_ = NeighborsOf(state().root, state().n_root_vertices, corner());
            if (!FindDerivatives(result) || (d_ == 2 && !FindTangents(result))) return {};
        }
        if (!PullBack(result.block) || (result.has_tangents && !PullBack(result.tangents))) return {};
        return result;
    }

  private:
    const LimitState& state() const { return *steps_[first_].state; }
    Index corner() const { return static_cast<Index>(steps_[first_].corner); }

    /// Rows once around. False where some are not known.
    bool GoAround(const LimitBlock& from, LimitBlock& to) {
        here_ = from;
        for (std::size_t i = steps_.size(); i-- > first_;) {
            if (!Pull(*steps_[i].state, *steps_[i].next, here_, to)) return false;
            std::swap(here_, to);
        }
        std::swap(here_, to);
        return true;
    }
    /// Goes around until nothing changes but by round-off. None: it does not settle.
    template <class After>
    LimitOutcome Settle(LimitBlock& block, After&& after) {
        constexpr int kMaxSteps = 2000;
        double before = std::numeric_limits<double>::infinity();
        for (int i = 0; i < kMaxSteps; ++i) {
            if (!GoAround(block, next_)) return LimitOutcome::Unknown;
            after(next_);
            const double change = LargestChange(block, next_);
            std::swap(block, next_);
            const double round_off = 1e-14 * std::max(1.0, LargestOf(block));
            if (change < 1e-6 * round_off || (change < round_off && change >= before)) return LimitOutcome::Known;
            if (!(change < 1e6)) return LimitOutcome::None;
            before = change;
        }
        return LimitOutcome::None;
    }

    /// Differences along the root's edges at the corner.
    LimitBlock EdgeDifferences() const {
        LimitBlock slopes;
        slopes.Reset(state().n_vertices, static_cast<int>(neighbors_.size()));
        for (std::size_t k = 0; k < neighbors_.size(); ++k) {
            slopes.Row(neighbors_[k])[k] += 1;
            slopes.Row(corner())[k] -= 1;
        }
        return slopes;
    }
    /// Takes out what round-off adds along the limit, which would grow, and scales.
    void Deflate(LimitBlock& block, double scale) const {
        for (int k = 0; k < block.n_columns; ++k) {
            double sum = 0;
            for (Index v = 0; v < state().n_vertices; ++v) sum += block.Row(v)[k];
            for (Index v = 0; v < state().n_vertices; ++v) {
                block.Row(v)[k] = scale * (block.Row(v)[k] - sum * limit_.Row(v)[0]);
            }
        }
    }

    /// False where rows are not known.
    bool FindDerivatives(CornerLimit& result) {
        LimitBlock slopes = EdgeDifferences();
        const double scale = std::ldexp(1.0, static_cast<int>(steps_.size() - first_));
        const LimitOutcome outcome = Settle(slopes, [&](LimitBlock& block) { Deflate(block, scale); });
        if (outcome == LimitOutcome::Unknown) return false;
        result.has_derivatives = outcome == LimitOutcome::Known;
        if (result.has_derivatives) result.has_derivatives = SetGradient(slopes, result.block);
        if (!result.has_derivatives) result.block = limit_;
        return true;
    }

    /// However fast slopes shrink, and along u and v each at its own rate, the plane that they span settles if it has a
    /// limit: in the basis that is the identity at two of the vertices, turned as the slopes are.
    bool FindTangents(CornerLimit& result) {
        LimitBlock slopes = EdgeDifferences();
        for (int i = 0; i < kStepsToPlane; ++i) {  // until the plane is near, for two vertices that tell it well
            if (!GoAround(slopes, next_)) return false;
            std::swap(slopes, next_);
            Deflate(slopes, 1);
            if (!Orthonormalize(slopes)) return true;
        }
        const std::pair<Index, Index> pair = BestPair(slopes);
        bool has_plane = true;
        const LimitOutcome outcome = Settle(slopes, [&](LimitBlock& block) {
            Deflate(block, 1);
            has_plane = has_plane && ReduceTo(pair.first, pair.second, block);
        });
        if (outcome == LimitOutcome::Unknown) return false;
        result.has_tangents = outcome == LimitOutcome::Known && has_plane;
        if (result.has_tangents) SetGradient(slopes, result.tangents);
        return true;
    }

    static double MinorOf(const LimitBlock& block, Index v, Index w) {
        return block.Row(v)[0] * block.Row(w)[1] - block.Row(v)[1] * block.Row(w)[0];
    }
    /// The two columns turned into two that are orthogonal, of length 1. False where they are dependent.
    bool Orthonormalize(LimitBlock& block) const {
        for (int k = 0; k < 2; ++k) {
            double along = 0, length = 0;
            for (Index v = 0; k == 1 && v < state().n_vertices; ++v) along += block.Row(v)[0] * block.Row(v)[1];
            for (Index v = 0; v < state().n_vertices; ++v) {
                if (k == 1) block.Row(v)[1] -= along * block.Row(v)[0];
                length += block.Row(v)[k] * block.Row(v)[k];
            }
            if (!(length > 1e-28)) return false;
            for (Index v = 0; v < state().n_vertices; ++v) block.Row(v)[k] /= std::sqrt(length);
        }
        return true;
    }
    /// The two vertices at which the columns are most independent.
    std::pair<Index, Index> BestPair(const LimitBlock& block) const {
        std::pair<Index, Index> best{0, 0};
        for (Index v = 0; v < state().n_vertices; ++v) {
            for (Index w = 0; w < v; ++w) {
                if (MinorOf(block, v, w) > std::abs(MinorOf(block, best.first, best.second))) best = {v, w};
                if (-MinorOf(block, v, w) > std::abs(MinorOf(block, best.first, best.second))) best = {w, v};
            }
        }
        return best;
    }
    /// Combines the columns so that they are (1, 0) at v and (0, 1) at w; without changing sides, or it would turn the
    /// normal round: MinorOf(v, w) is positive. False where they are dependent there.
    bool ReduceTo(Index v, Index w, LimitBlock& block) const {
        const double minor = MinorOf(block, v, w);
        if (!(std::abs(minor) > 1e-300)) return false;
        const double a = block.Row(v)[0], b = block.Row(v)[1], c = block.Row(w)[0], d = block.Row(w)[1];
        for (Index i = 0; i < state().n_vertices; ++i) {
            double* row = block.Row(i);
            const double x = row[0], y = row[1];
            row[0] = (d * x - c * y) / minor;
            row[1] = (a * y - b * x) / minor;
        }
        return true;
    }

    /// slope_k = step_k . gradient along the first d of the edges. False if the others do not agree: linear around the
    /// corner it is not.
    bool SetGradient(const LimitBlock& slopes, LimitBlock& block) const {
        const std::vector<Coordinates> corners = CornersOf(state().root, state().n_root_vertices);
        const auto step = [&](std::size_t k, std::size_t a) {
            return corners[static_cast<std::size_t>(neighbors_[k])][a] - corners[static_cast<std::size_t>(corner())][a];
        };
        Matrix3 steps{};
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t a = 0; a < 3; ++a) steps[k][a] = k < d_ && a < d_ ? step(k, a) : k == a ? 1.0 : 0.0;
        }
        const Matrix3 inverse = Inverse(steps);
        block.Reset(state().n_vertices, 1 + static_cast<int>(d_));
        bool is_linear = true;
        for (Index v = 0; v < state().n_vertices; ++v) {
            double* row = block.Row(v);
            row[0] = limit_.Row(v)[0];
            for (std::size_t a = 0; a < d_; ++a) {
                for (std::size_t k = 0; k < d_; ++k) row[1 + a] += inverse[a][k] * slopes.Row(v)[k];
            }
            for (std::size_t k = d_; k < neighbors_.size(); ++k) {
                double slope = -slopes.Row(v)[k];
                for (std::size_t a = 0; a < d_; ++a) slope += step(k, a) * row[1 + a];
                is_linear = is_linear && std::abs(slope) <= 1e-11;  // sums of settled slopes
            }
        }
        return is_linear;
    }

    /// From the state that comes again to the one asked of.
    bool PullBack(LimitBlock& block) {
        for (std::size_t i = first_; i-- > 0;) {
            if (!Pull(*steps_[i].state, *steps_[i].next, block, next_)) return false;
            if (block.n_columns > 1) ChangeRows(steps_[i].next->matrix, static_cast<int>(d_), 1, next_);
            std::swap(block, next_);
        }
        return true;
    }

    static constexpr int kStepsToPlane = 20;

    const std::vector<Step> steps_;
    const std::size_t first_, d_;
    std::vector<Index> neighbors_;
    LimitBlock limit_, here_, next_;
};

}  // namespace

CornerLimit LimitStates::MakeCorner(LimitState& asked, std::size_t corner) {
    std::vector<Step> steps;
    for (LimitState* s = &asked;;) {
        const auto met = std::find_if(steps.begin(), steps.end(),
                                      [&](const Step& step) { return step.state == s && step.corner == corner; });
        if (met != steps.end()) {
            const auto first = static_cast<std::size_t>(met - steps.begin());
            return CornerFinder(std::move(steps), first, elements_ == Elements::Cells ? 3 : 2).Find();
        }
        Expand(*s);
        Step step{s, corner, nullptr};
        for (const Transition& t : s->children) {
            const auto found = std::find(t.children.begin(), t.children.end(), static_cast<Index>(step.corner));
            if (found == t.children.end()) continue;
            step.next = &t;
            corner = static_cast<std::size_t>(found - t.children.begin());
        }
        steps.push_back(step);
        s = step.next->state;
    }
}

}  // namespace SolidSubdiv::Far::Internal

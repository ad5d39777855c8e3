// SPDX-License-Identifier: Apache-2.0
// The session's numbers lie in a few arrays; steps of undo are values of these, exchanged.
#include <solidsubdiv/apps/deform/editing_session.h>

#include <algorithm>
#include <cstring>
#include <deque>
#include <optional>
#include <utility>

#include <solidsubdiv/apps/deform/deformer.h>
#include <solidsubdiv/apps/deform/internal/session_input.h>
#include <solidsubdiv/apps/deform/internal/undo_log.h>
#include <solidsubdiv/apps/deform/vertex_normals.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Deform {

namespace {

constexpr Offset kGrain = 16384;

/// A lattice that points are bound to.
struct BoundLattice {
    explicit BoundLattice(std::shared_ptr<const Embedding> made) : embedding(std::move(made)), deformer(*embedding) {}
    std::shared_ptr<const Embedding> embedding;
    Deformer deformer;
};

/// Which lattice is the current one.
struct Mode {
    int level = 0;
    int n_carried = 0;  ///< control points of levels [0, n_carried) are up to date; finer ones follow when needed
    std::shared_ptr<BoundLattice> enclosing{};  ///< if not null, it is
    bool operator==(const Mode&) const = default;
};

}  // namespace

struct EditingSession::State {
    std::vector<SessionLevel> levels;
    std::vector<double> undeformed;  ///< model
    SessionOptions options;
    std::vector<std::shared_ptr<BoundLattice>> bound;  ///< by level; null until needed

    // What steps of undo restore.
    Mode mode;
    std::vector<std::vector<double>> arrays;  ///< see the functions below

    // What follows from that.
    std::vector<double> deformed;  ///< P(Q) of the current lattice
    std::vector<double> points;    ///< deformed + correction: the model; while enclosed, then all control points
    VertexNormals normals;

    std::optional<Internal::UndoStep<Mode>> open;
    std::deque<Internal::UndoStep<Mode>> undo, redo;
    std::vector<Index> changed;  ///< scratch of the last change

    std::size_t n_levels() const { return levels.size(); }
    std::size_t n_values() const { return undeformed.size(); }

    // Places in `arrays`.
    static std::size_t Points(std::size_t level) { return level; }
    std::size_t Details(std::size_t level) const { return n_levels() + level; }
    std::size_t Correction() const { return 2 * n_levels(); }
    std::size_t Enclosing() const { return 2 * n_levels() + 1; }
    std::size_t Current() const { return mode.enclosing ? Enclosing() : Points(static_cast<std::size_t>(mode.level)); }

    std::shared_ptr<BoundLattice> Bound(std::size_t level) {
        if (!bound[level]) {
            auto& made = levels[level].embedding;
            if (!made) {
                const ControlLattice& lattice = *levels[level].lattice;
                made = std::make_shared<const Embedding>(
                    Embedding::Create(lattice.View(), lattice.positions, undeformed, options.embed));
            }
            bound[level] = std::make_shared<BoundLattice>(made);
        }
        return bound[level];
    }
    BoundLattice& CurrentLattice() const {
        return mode.enclosing ? *mode.enclosing : *bound[static_cast<std::size_t>(mode.level)];
    }

    /// By the octree rule from the level before.
    std::array<double, 3> Refined(std::size_t level, Index point, const std::vector<double>& coarser) const {
        const Far::StencilRows<double>& rule = levels[level].octree_rule;
        std::array<double, 3> sum{};
        for (Offset k = rule.offsets[point]; k < rule.offsets[point + 1]; ++k) {
            const double* source = coarser.data() + 3 * static_cast<std::size_t>(rule.indices[k]);
            for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += rule.weights[k] * source[axis];
        }
        return sum;
    }
    /// sign * O(coarser) + rest, of all control points of a level.
    std::vector<double> Refined(std::size_t level, const std::vector<double>& coarser, double sign,
                                const std::vector<double>& rest) const {
        std::vector<double> result(rest.size());
        Sdc::ParallelFor(levels[level].lattice->n_control_points(), kGrain, [&](Offset begin, Offset end) {
            for (Offset i = begin; i < end; ++i) {
                const std::array<double, 3> refined = Refined(level, static_cast<Index>(i), coarser);
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const std::size_t at = 3 * static_cast<std::size_t>(i) + axis;
                    result[at] = sign * refined[axis] + rest[at];
                }
            }
        });
        return result;
    }

    std::vector<double> ControlPoints(std::size_t level) const {
        if (mode.enclosing) {  // carried with the model
            std::size_t first = n_values();
            for (std::size_t i = 0; i < level; ++i) first += levels[i].lattice->positions.size();
            const auto begin = points.begin() + static_cast<std::ptrdiff_t>(first);
            return {begin, begin + static_cast<std::ptrdiff_t>(levels[level].lattice->positions.size())};
        }
        if (level < static_cast<std::size_t>(mode.n_carried)) return arrays[Points(level)];
        return Refined(level, ControlPoints(level - 1), 1, arrays[Details(level)]);
    }

    // Everything that is written goes through these two.

    void Write(std::size_t array, Index point, const std::array<double, 3>& value) {
        if (open) open->Keep(array, point, arrays[array]);
        std::copy(value.begin(), value.end(), arrays[array].begin() + 3 * static_cast<std::ptrdiff_t>(point));
    }
    void Replace(std::size_t array, std::vector<double> values) {
        if (open) open->Keep(array, std::move(arrays[array]));
        arrays[array] = std::move(values);
    }

    void AddCorrection(std::size_t point) {
        for (std::size_t at = 3 * point; at < 3 * point + 3; ++at) points[at] = deformed[at] + arrays[Correction()][at];
    }
    void Deform() {
        deformed.resize(3 * static_cast<std::size_t>(CurrentLattice().deformer.n_points()));
        CurrentLattice().deformer.Deform(arrays[Current()], deformed);
    }

    /// Everything follows from the arrays. Points count as changed where their bits do.
    SessionChange FollowAll() {
        Deform();
        const std::vector<double> before = std::exchange(points, std::vector<double>(deformed.size()));
        Sdc::ParallelFor(static_cast<Offset>(points.size() / 3), kGrain, [&](Offset begin, Offset end) {
            for (Offset v = begin; v < end; ++v) AddCorrection(static_cast<std::size_t>(v));
        });
        changed.clear();
        for (std::size_t at = 0; at < n_values(); at += 3) {
            if (std::memcmp(&points[at], &before[at], 3 * sizeof(double)) != 0) {
                changed.push_back(static_cast<Index>(at / 3));
            }
        }
        return {changed, normals.Update(changed, points)};
    }

    /// The same where only some control points of the current lattice have moved.
    SessionChange Follow(std::span<const Index> moved) {
        changed.clear();
        for (Index v : CurrentLattice().deformer.Update(moved, arrays[Current()], deformed)) {
            AddCorrection(static_cast<std::size_t>(v));
            if (static_cast<std::size_t>(v) < n_values() / 3) changed.push_back(v);
        }
        return {changed, normals.Update(changed, points)};
    }

    /// The lattice that has just become current leaves `kept` where they are.
    SessionChange TakeOver(std::vector<double> kept) {
        Deform();
        for (std::size_t at = 0; at < kept.size(); ++at) kept[at] -= deformed[at];
        Replace(Correction(), std::move(kept));
        return FollowAll();
    }

    /// One change is a step, unless a step is open.
    template <class F>
    SessionChange AsStep(F&& change) {
        const bool is_own = !open;
        if (is_own) BeginStep();
        const SessionChange result = change();
        if (is_own) EndStep();
        return result;
    }
    void BeginStep() { open.emplace(mode, arrays.size()); }
    void EndStep() {
        Internal::UndoStep<Mode> step = std::move(*open);
        open.reset();
        step.Close();
        if (step.IsEmpty() && step.mode == mode) return;
        redo.clear();
        undo.push_back(std::move(step));
        while (undo.size() > options.max_undo_steps) undo.pop_front();
    }
    SessionChange Travel(std::deque<Internal::UndoStep<Mode>>& from, std::deque<Internal::UndoStep<Mode>>& to) {
        if (open) throw InvalidInput("a step of the editing session is open: end it before undo and redo");
        if (from.empty()) return {};
        Internal::UndoStep<Mode> step = std::move(from.back());
        from.pop_back();
        std::swap(mode, step.mode);
        const std::optional<std::vector<Index>> moved = step.Exchange(arrays, Current());
        to.push_back(std::move(step));
        return moved ? Follow(*moved) : FollowAll();  // another lattice comes with another correction, a whole array
    }
};

EditingSession::EditingSession(std::vector<SessionLevel> levels, std::span<const double> points,
                               const ModelFaces& faces, const SessionOptions& options) {
    options.embed.Validate();
    Internal::CheckSessionInput(levels, points);
    state_ = std::make_unique<State>();
    State& s = *state_;
    if (!faces.offsets.empty() || !faces.corners.empty()) {
        s.normals = VertexNormals(static_cast<Index>(points.size() / 3), faces.offsets, faces.corners);
    }
    s.levels = std::move(levels);
    s.undeformed.assign(points.begin(), points.end());
    s.options = options;
    s.bound.resize(s.n_levels());
    s.mode.n_carried = static_cast<int>(s.n_levels());
    s.arrays.resize(2 * s.n_levels() + 2);
    for (std::size_t i = 0; i < s.n_levels(); ++i) {
        s.arrays[State::Points(i)] = s.levels[i].lattice->positions;
        if (i > 0) s.arrays[s.Details(i)] = s.Refined(i, s.arrays[i - 1], -1, s.arrays[i]);
    }
    s.Bound(0);
    s.points = s.undeformed;
    s.TakeOver(s.undeformed);
    s.normals.Compute(s.points);
}

EditingSession::~EditingSession() = default;
EditingSession::EditingSession(EditingSession&&) noexcept = default;
EditingSession& EditingSession::operator=(EditingSession&&) noexcept = default;

int EditingSession::n_levels() const { return static_cast<int>(state_->n_levels()); }
Index EditingSession::n_points() const { return static_cast<Index>(state_->n_values() / 3); }
std::span<const double> EditingSession::points() const {
    return std::span<const double>(state_->points).first(state_->n_values());
}
std::span<const double> EditingSession::normals() const { return state_->normals.normals(); }
int EditingSession::level() const { return state_->mode.level; }
bool EditingSession::is_enclosed() const { return state_->mode.enclosing != nullptr; }
std::span<const double> EditingSession::control_points() const { return state_->arrays[state_->Current()]; }
const Embedding& EditingSession::embedding() const { return *state_->CurrentLattice().embedding; }
std::span<const double> EditingSession::correction() const { return state_->arrays[state_->Correction()]; }

std::vector<double> EditingSession::ControlPoints(int level) const {
    Internal::CheckSessionLevel(level, n_levels());
    return state_->ControlPoints(static_cast<std::size_t>(level));
}

SessionChange EditingSession::Move(std::span<const Index> control_points, std::span<const double> positions) {
    State& s = *state_;
    Internal::CheckMove(control_points, positions, static_cast<Index>(s.arrays[s.Current()].size() / 3));
    if (control_points.empty()) return {};
    return s.AsStep([&] {
        const auto level = static_cast<std::size_t>(s.mode.level);
        for (std::size_t i = 0; i < control_points.size(); ++i) {
            const Index point = control_points[i];
            const std::array<double, 3> to = {positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]};
            s.Write(s.Current(), point, to);
            if (s.mode.enclosing || level == 0) continue;
            std::array<double, 3> details = s.Refined(level, point, s.arrays[State::Points(level - 1)]);
            for (std::size_t axis = 0; axis < 3; ++axis) details[axis] = to[axis] - details[axis];
            s.Write(s.Details(level), point, details);
        }
        if (!s.mode.enclosing) s.mode.n_carried = std::min(s.mode.n_carried, s.mode.level + 1);
        return s.Follow(control_points);
    });
}

SessionChange EditingSession::SetLevel(int level) {
    Internal::CheckSessionLevel(level, n_levels());
    State& s = *state_;
    if (level == s.mode.level && !s.mode.enclosing) return {};
    s.Bound(static_cast<std::size_t>(level));
    return s.AsStep([&] {
        const bool was_enclosed = s.mode.enclosing != nullptr;
        // Control points that are not up to date; while enclosed none is.
        std::vector<std::vector<double>> carried;
        const int first = was_enclosed ? 0 : s.mode.n_carried, end = was_enclosed ? n_levels() : level + 1;
        for (int i = first; i < end; ++i) carried.push_back(s.ControlPoints(static_cast<std::size_t>(i)));
        for (int i = first; i < end; ++i) {
            const auto at = static_cast<std::size_t>(i);
            s.Replace(State::Points(at), std::move(carried[static_cast<std::size_t>(i - first)]));
            if (!was_enclosed || i == 0) continue;
            s.Replace(s.Details(at), s.Refined(at, s.arrays[at - 1], -1, s.arrays[at]));
        }
        s.mode = {.level = level, .n_carried = std::max(end, s.mode.n_carried)};
        return s.TakeOver({s.points.begin(), s.points.begin() + static_cast<std::ptrdiff_t>(s.n_values())});
    });
}

SessionChange EditingSession::Enclose(const ControlLattice& lattice, const EmbedOptions& options) {
    State& s = *state_;
    std::vector<double> all(s.points.begin(), s.points.begin() + static_cast<std::ptrdiff_t>(s.n_values()));
    for (std::size_t i = 0; i < s.n_levels(); ++i) {
        const std::vector<double> control_points = s.ControlPoints(i);
        all.insert(all.end(), control_points.begin(), control_points.end());
    }
    auto enclosing = std::make_shared<BoundLattice>(
        std::make_shared<const Embedding>(Embedding::Create(lattice.View(), lattice.positions, all, options)));
    return s.AsStep([&] {
        s.mode.enclosing = std::move(enclosing);
        s.Replace(s.Enclosing(), lattice.positions);
        return s.TakeOver(std::move(all));
    });
}

void EditingSession::BeginStep() {
    if (state_->open) throw InvalidInput("a step of the editing session is open already");
    state_->BeginStep();
}

void EditingSession::EndStep() {
    if (!state_->open) throw InvalidInput("no step of the editing session is open");
    state_->EndStep();
}

bool EditingSession::CanUndo() const { return !state_->undo.empty(); }
bool EditingSession::CanRedo() const { return !state_->redo.empty(); }
SessionChange EditingSession::Undo() { return state_->Travel(state_->undo, state_->redo); }
SessionChange EditingSession::Redo() { return state_->Travel(state_->redo, state_->undo); }

Offset EditingSession::UndoBytes() const {
    Offset bytes = 0;
    for (const auto* steps : {&state_->undo, &state_->redo}) {
        for (const auto& step : *steps) bytes += step.Bytes();
    }
    return bytes;
}

}  // namespace SolidSubdiv::Deform

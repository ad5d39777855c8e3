// SPDX-License-Identifier: Apache-2.0
// Validator ffd-levels: a change of level, either way, moves no vertex of the model.
#include "ffd_levels.h"

#include <algorithm>
#include <cmath>

#include <solidsubdiv/apps/deform/deformer.h>
#include <solidsubdiv/kit/io/formats.h>

#include "points.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

/// Numbers in [-1, 1) that are the same everywhere: the fractions of multiples of the golden ratio.
class Numbers {
  public:
    double Next() {
        at_ += 0.6180339887498949;
        at_ -= std::floor(at_);
        return 2 * at_ - 1;
    }

  private:
    double at_ = 0;
};

/// Moves every fifth control point of the current lattice by up to a tenth of the size.
void MoveSome(Deform::EditingSession& session, double size, Numbers& numbers) {
    std::vector<Index> moved;
    std::vector<double> positions;
    for (Index i = 0; 3 * static_cast<std::size_t>(i) < session.control_points().size(); i += 5) {
        moved.push_back(i);
        for (std::size_t c = 0; c < 3; ++c) {
            positions.push_back(session.control_points()[3 * static_cast<std::size_t>(i) + c] +
                                0.1 * size * numbers.Next());
        }
    }
    session.Move(moved, positions);
}

/// Eight corners well around everything that a session holds.
Deform::ControlLattice BoxAround(std::span<const double> points, double size) {
    double low[3], high[3];
    for (std::size_t c = 0; c < 3; ++c) {
        low[c] = high[c] = points[c];
        for (std::size_t i = c; i < points.size(); i += 3) {
            low[c] = std::min(low[c], points[i]);
            high[c] = std::max(high[c], points[i]);
        }
    }
    Deform::ControlLattice box;
    for (int i = 0; i < 8; ++i) {
        for (std::size_t c = 0; c < 3; ++c) box.positions.push_back(i >> c & 1 ? high[c] + size : low[c] - size);
    }
    box.hexes = {0, 1, 3, 2, 4, 5, 7, 6};
    return box;
}

void CheckModel(const std::filesystem::path& path, Findings& findings) {
    const std::string name = path.filename().string();
    if (!std::filesystem::exists(path)) {
        findings.skipped.push_back(name + ": there is no " + path.string());
        return;
    }
    const std::vector<double> model = Io::ReadMesh(path).positions;
    for (const bool shrink : {false, true}) {
        Findings found;
        CheckLevels(model, Deform::MakeOctreeLattices(model, {}, {.levels = 4, .shrink = shrink}), found);
        findings.Merge(found, name + (shrink ? ", shrunken" : ""));
    }
}

}  // namespace

void CompareStill(std::span<const double> before, std::span<const double> after, double size, const std::string& what,
                  Findings& findings) {
    if (before.size() != after.size()) {
        findings.Fault(what + ": " + std::to_string(after.size() / 3) + " points of " +
                       std::to_string(before.size() / 3));
        return;
    }
    for (std::size_t i = 0; i < before.size(); i += 3) {
        findings.Error(
            std::hypot(after[i] - before[i], after[i + 1] - before[i + 1], after[i + 2] - before[i + 2]) / size,
            [&] { return what + ", vertex " + std::to_string(i / 3); });
    }
}

void CheckLevels(const std::vector<double>& model, const Deform::LatticeHierarchy& hierarchy, Findings& findings) {
    std::vector<Deform::SessionLevel> levels;
    for (const Deform::LatticeLevel& level : hierarchy.levels) levels.push_back({&level.lattice, level.octree_rule});
    Deform::EditingSession session(std::move(levels), model);
    const double size = SizeOf(model);
    Numbers numbers;
    double largest_gap = 0;
    const auto change_to = [&](int level) {
        MoveSome(session, size / (1 << level), numbers);
        const std::vector<double> before(session.points().begin(), session.points().end());
        session.SetLevel(level);
        CompareStill(before, session.points(), size, "to level " + std::to_string(level), findings);
        Findings without;
        std::vector<double> plain(model.size());
        Deform::Deformer(session.embedding()).Deform(session.control_points(), plain);
        CompareStill(before, plain, size, "", without);
        largest_gap = std::max(largest_gap, without.largest_error);
    };
    const int last = session.n_levels() - 1;
    for (int level = 1; level <= last; ++level) change_to(level);
    for (int level = last - 1; level >= 0; --level) change_to(level);

    std::vector<double> before(session.points().begin(), session.points().end());
    std::vector<double> everything = before;
    for (int level = 0; level <= last; ++level) {
        const std::vector<double> control = session.ControlPoints(level);
        everything.insert(everything.end(), control.begin(), control.end());
    }
    const Deform::ControlLattice box = BoxAround(everything, 0.1 * size);
    session.Enclose(box, {});
    CompareStill(before, session.points(), size, "enclosed", findings);
    change_to(last);
    findings.notes.push_back("without corrections vertices would jump by up to " + std::to_string(largest_gap) +
                             " of the size");
    if (!(largest_gap > 1e-3)) findings.Fault("the moves are too small to tell a correction from none");
}

Findings ValidateFfdLevels(const Context& context) {
    Findings findings;
    const std::filesystem::path surfaces = context.tets.parent_path() / "surfaces";
    for (const auto& path : {context.shapes / "demo" / "bunny.obj", surfaces / "ode_koala.obj",
                             surfaces / "hoppe_mechpart.recon.obj", surfaces / "ode_human_woman.obj"}) {
        CheckModel(path, findings);
    }
    return findings;
}

}  // namespace SolidSubdiv::Validation

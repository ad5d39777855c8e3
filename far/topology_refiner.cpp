// SPDX-License-Identifier: Apache-2.0
// Refinement of topology, level by level, after a check that everything fits.
#include <solidsubdiv/far/topology_refiner.h>

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>

#include <solidsubdiv/far/internal/check.h>
#include <solidsubdiv/far/internal/polyhedral_check.h>
#include <solidsubdiv/far/internal/sharpness.h>

namespace SolidSubdiv::Far {

namespace {

constexpr Index kDefectsPerCode = 100;

/// Memory of the machine, in bytes.
Offset MachineBytes() {
    return static_cast<Offset>(sysconf(_SC_PHYS_PAGES)) * static_cast<Offset>(sysconf(_SC_PAGESIZE));
}

template <class Counts>
void RequireIndexable(const Counts& counts, int level, Offset bytes) {
    constexpr Offset limit = std::numeric_limits<Index>::max();
    if (counts.Largest() <= limit) return;
    throw InvalidInput("level " + std::to_string(level) + " would have " + std::to_string(counts.n_cells()) +
                       " cells and " + std::to_string(counts.Largest()) + " components of one kind, more than the " +
                       std::to_string(limit) + " that indices count, in " + BytesText(bytes) + " (" +
                       std::to_string(bytes) + " bytes); refine fewer times");
}

template <class Counts>
Counts CountsAfter(Counts counts, int level) {
    for (int i = 0; i < level; ++i) {
        // One split makes at most 24 + 4 + 4 times as many of a kind.
        if (counts.Largest() > std::numeric_limits<Offset>::max() / 64) {
            throw InvalidInput("level " + std::to_string(level) + " has more components than 64 bits count");
        }
        counts = Refine(counts);
    }
    return counts;
}

/// Splits the first of levels again and again, after a check that all of them fit.
template <class AnyLevel>
void RefineLevels(std::vector<AnyLevel>& levels, const UniformRefinementOptions& options) {
    const auto is_full = [&](int i) { return i < options.max_level || options.full_topology_in_last_level; };
    const auto base = CountsOf(levels[0]);
    const Offset max_bytes = options.max_bytes > 0 ? options.max_bytes : MachineBytes();
    Offset bytes = levels[0].Bytes();
    auto counts = base;
    for (int i = 1; i <= options.max_level; ++i) {
        counts = Refine(counts);
        bytes += EstimateBytes(counts, is_full(i));
        RequireIndexable(counts, i, bytes);
    }
    if (bytes > max_bytes) {
        throw InvalidInput("refining to level " + std::to_string(options.max_level) + " makes " +
                           std::to_string(counts.n_cells()) + " cells and needs " + BytesText(bytes) + " (" +
                           std::to_string(bytes) + " bytes), more than the " + BytesText(max_bytes) +
                           " allowed; refine fewer times");
    }
    levels.resize(1);
    levels.reserve(static_cast<std::size_t>(options.max_level) + 1);
    const auto work = [](const auto& c) { return static_cast<double>(c.n_cells() + c.n_boundary_faces); };
    for (int i = 1; i <= options.max_level; ++i) {
        Report(options.progress, "refine topology",
               i == 1 ? 0.0 : work(CountsAfter(base, i - 1)) / std::max(1.0, work(counts)));
        levels.push_back(Refine(levels.back(), is_full(i)));
    }
    Report(options.progress, "refine topology", 1.0);
}

}  // namespace

std::string BytesText(Offset bytes) {
    const char* const units[] = {"bytes", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};
    double value = static_cast<double>(bytes);
    int unit = 0;
    while (value >= 1024 && unit < 6) {
        value /= 1024;
        ++unit;
    }
    char text[48];
    std::snprintf(text, sizeof text, unit == 0 ? "%.0f %s" : "%.1f %s", value, units[unit]);
    return text;
}

void UniformRefinementOptions::Validate() const {
    if (max_level < 0 || max_level > 20) {
        throw InvalidInput("max_level is " + std::to_string(max_level) + "; it must be 0 to 20");
    }
    if (max_bytes < 0) throw InvalidInput("max_bytes is negative");
}

TopologyRefiner TopologyRefiner::Create(const TopologyDescriptor& descriptor, Sdc::Split split) {
    TopologyRefiner refiner;
    refiner.split_ = split;
    if (split == Sdc::Split::Polyhedral) {
        refiner.CreatePolyhedral(descriptor);
    } else {
        refiner.CreateTetOct(descriptor);
    }
    const std::vector<Defect>& defects = refiner.defects_;
    if (!defects.empty() && defects.front().IsFatal()) throw InvalidInput(defects.front().text);
    return refiner;
}

void TopologyRefiner::CreateTetOct(const TopologyDescriptor& descriptor) {
    const std::string others = Internal::KindsBeyondTetOct(descriptor);
    if (!others.empty()) {
        throw InvalidInput("the mesh has " + others + "; the tet/oct split takes tets, octs, triangles and edges only");
    }
    // Faces of cells are listed with their sides before they are unique: that list must be indexable.
    const Offset sides = static_cast<Offset>(descriptor.tets.size()) +
                         8 * static_cast<Offset>(descriptor.octs.size() / 6) +
                         static_cast<Offset>(descriptor.triangles.size() / 3);
    if (3 * sides > std::numeric_limits<Index>::max()) {
        throw InvalidInput("the mesh has " + std::to_string(sides) + " sides of cells; level 0 takes at most " +
                           std::to_string(std::numeric_limits<Index>::max() / 3));
    }
    Internal::DefectList defects(kDefectsPerCode);
    Internal::CheckElements(descriptor, defects);
    if (!defects.has_fatal()) {
        Vtr::BaseFindings findings;
        levels_.push_back(Vtr::MakeBaseLevel(Internal::ElementsOf(descriptor), findings));
        Internal::AddFindings(descriptor, levels_[0], findings, defects);
        if (findings.IsUsable()) {
            sharpness_ = Internal::TakeSharpness(descriptor, Vtr::EdgeGraph(levels_[0]), defects);
        }
    }
    defects_ = defects.TakeFatalFirst();
}

void TopologyRefiner::CreatePolyhedral(const TopologyDescriptor& descriptor) {
    Internal::DefectList defects(kDefectsPerCode);
    if (auto level = Internal::MakeCheckedPolyhedralLevel(descriptor, defects)) {
        polyhedral_levels_.push_back(std::move(*level));
        sharpness_ = Internal::TakeSharpness(descriptor, Vtr::EdgeGraph(polyhedral_levels_[0]), defects);
    }
    defects_ = defects.TakeFatalFirst();
}

Vtr::Counts TopologyRefiner::CountsAt(int level) const { return CountsAfter(Vtr::CountsOf(levels_[0]), level); }

Vtr::PolyhedralCounts TopologyRefiner::PolyhedralCountsAt(int level) const {
    return CountsAfter(Vtr::CountsOf(polyhedral_levels_[0]), level);
}

void TopologyRefiner::RefineUniform(const UniformRefinementOptions& options) {
    options.Validate();
    is_polyhedral() ? RefineLevels(polyhedral_levels_, options) : RefineLevels(levels_, options);
}

Offset TopologyRefiner::Bytes() const {
    Offset bytes = 0;
    for (const Level& level : levels_) bytes += level.Bytes();
    for (const Vtr::PolyhedralLevel& level : polyhedral_levels_) bytes += level.Bytes();
    return bytes;
}

}  // namespace SolidSubdiv::Far

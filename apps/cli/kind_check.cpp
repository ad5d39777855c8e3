// SPDX-License-Identifier: Apache-2.0
// Kinds of elements against what schemes say of themselves.
#include <solidsubdiv/apps/cli/kind_check.h>

#include <algorithm>
#include <string>
#include <vector>

#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/apps/cli/mesh_kinds.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Cli {

namespace {

bool IsSolidScheme(const Sdc::Scheme& scheme) {
    return std::visit([](const auto& s) { return s.kSolids; }, scheme);
}

bool Takes(const Sdc::Scheme& scheme, const KindCount& kind) {
    return (kind.dimension < 3 || IsSolidScheme(scheme)) &&
           (kind.is_tet_oct || Sdc::Takes(scheme, Sdc::Split::Polyhedral));
}

/// "a, b and c".
std::string Listed(const std::vector<std::string>& words, const std::string& last_joint) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        text += (i == 0 ? "" : i + 1 < words.size() ? ", " : last_joint) + words[i];
    }
    return text;
}

}  // namespace

void RequireKinds(const Io::Topology& topology, const Sdc::Scheme& scheme) {
    std::vector<std::string> refused, taken, schemes;
    for (const KindCount& kind : KindCounts(topology)) {
        const std::string plural(kind.plural);
        if (Takes(scheme, kind)) {
            if (kind.dimension > 0) taken.push_back(plural);
        } else if (kind.count > 0) {
            refused.push_back(Counted(kind.count, kind.singular, plural));
        }
    }
    if (refused.empty()) return;
    Sdc::ForEachScheme([&](auto other) {
        const auto kinds = KindCounts(topology);
        const bool takes_all = std::all_of(
            kinds.begin(), kinds.end(), [&](const KindCount& kind) { return kind.count == 0 || Takes(other, kind); });
        // For surfaces there are schemes of their own.
        if (takes_all && (topology.n_cells() > 0 || !other.kSolids)) schemes.emplace_back(other.kName);
    });
    const bool has_boundary = topology.n_cells() > 0 && !IsSolidScheme(scheme);
    throw InvalidInput("has " + Listed(refused, " and ") + "; scheme " + std::string(Sdc::NameOf(scheme)) + " takes " +
                       Listed(taken, " and ") + " only: choose " + Listed(schemes, " or ") +
                       (has_boundary ? ", or refine the boundary alone" : ""));
}

Sdc::Split SplitFor(const Io::Topology& topology, const Sdc::Scheme& scheme) {
    RequireKinds(topology, scheme);
    const bool is_cut_so = IsTetOct(topology) && Sdc::Takes(scheme, Sdc::Split::TetOct);
    return is_cut_so || !Sdc::Takes(scheme, Sdc::Split::Polyhedral) ? Sdc::Split::TetOct : Sdc::Split::Polyhedral;
}

}  // namespace SolidSubdiv::Cli

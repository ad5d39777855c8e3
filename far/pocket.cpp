// SPDX-License-Identifier: Apache-2.0
// How far pockets reach, and what makes two of them equal.
#include <solidsubdiv/far/internal/pocket.h>

#include <bit>

#include <solidsubdiv/far/internal/pocket_growth.h>
#include <solidsubdiv/far/internal/with_rows.h>

namespace SolidSubdiv::Far::Internal {

Reach Reach::Of(const Sdc::Scheme& scheme, Elements elements) {
    return std::visit(
        [&]<class S>(const S& s) -> Reach {
            if constexpr (requires { s.surface(); }) {
                if (decltype(s.surface())::kIsWide) {
                    return {.n_rings = 1, .edges_need_both_ends = true, .interpolates = true};
                }
            }
            // Chaikin's means of sharpness are taken at both ends.
            const bool is_chaikin = CreaseOptionsOf(s).method == Sdc::CreasingMethod::Chaikin;
            Reach reach{.n_rings = is_chaikin ? 1 : 0, .edges_need_both_ends = is_chaikin};
            if constexpr (std::is_same_v<S, Sdc::BoxSpline>) {
                reach.b_edges_only = elements == Elements::Cells && s.diagonals == Sdc::Diagonals::Directional;
            }
            return reach;
        },
        scheme);
}

bool Pocket::HasCompleteEdge(Index a, Index b) const {
    if (a > b) std::swap(a, b);
    for (std::size_t i = 0; i + 1 < complete_edges.size(); i += 2) {
        if (complete_edges[i] == a && complete_edges[i + 1] == b) return true;
    }
    return false;
}

std::vector<std::int32_t> Pocket::Key() const {
    std::vector<std::int32_t> key{static_cast<std::int32_t>(root), n_vertices()};
    const auto add = [&](const auto& list) {
        key.push_back(static_cast<std::int32_t>(list.size()));
        for (const auto x : list) key.push_back(static_cast<std::int32_t>(x));
    };
    add(tets), add(octs), add(hexes);
    add(cell_offsets), add(cell_faces.offsets), add(cell_faces.vertices);
    add(faces.offsets), add(faces.vertices), add(edges);
    add(crease_edges), add(corner_vertices);
    for (float s : crease_sharpness) key.push_back(std::bit_cast<std::int32_t>(s));
    for (float s : corner_sharpness) key.push_back(std::bit_cast<std::int32_t>(s));
    add(is_complete), add(complete_edges);
    return key;
}

PocketMaker::PocketMaker(const Level& level, const Sharpness& sharpness, const Reach& reach, Elements elements) {
    if (elements == Elements::Cells) {
        source_ = std::make_unique<PocketGrowth<TetOctCells>>(level, sharpness, reach);
    } else {
        source_ = std::make_unique<PocketGrowth<BoundaryFaces<Level>>>(level, sharpness, reach);
    }
}

PocketMaker::PocketMaker(const Vtr::PolyhedralLevel& level, const Sharpness& sharpness, const Reach& reach,
                         Elements elements) {
    if (elements == Elements::Cells) {
        source_ = std::make_unique<PocketGrowth<PolyhedralCells>>(level, sharpness, reach);
    } else {
        source_ = std::make_unique<PocketGrowth<BoundaryFaces<Vtr::PolyhedralLevel>>>(level, sharpness, reach);
    }
}

PocketMaker::~PocketMaker() = default;
PocketMaker::PocketMaker(PocketMaker&&) noexcept = default;

Pocket PocketMaker::Make(Index element) { return source_->Make(element); }

}  // namespace SolidSubdiv::Far::Internal

// SPDX-License-Identifier: Apache-2.0
// Limit masks of the schemes of the polyhedral split.
#include <solidsubdiv/far/internal/polyhedral_limits.h>

#include <algorithm>
#include <array>

#include <solidsubdiv/far/internal/vertex_star.h>

namespace SolidSubdiv::Far::Internal {

namespace {

/// Entries of a vertex's row: every vertex once.
void AddTo(MaskRow& row, Index v, double weight) {
    const auto found = std::find(row.indices.begin(), row.indices.end(), v);
    if (found == row.indices.end()) {
        row.indices.push_back(v);
        row.weights.push_back(weight);
    } else {
        row.weights[static_cast<std::size_t>(found - row.indices.begin())] += weight;
    }
}

std::ptrdiff_t CornerOf(std::span<const Index> corners, Index v) {
    return std::find(corners.begin(), corners.end(), v) - corners.begin();
}

}  // namespace

PolyhedralLimits::PolyhedralLimits(const Vtr::PolyhedralLevel& level, const Sharpness& sharpness,
                                   const Sdc::PolyhedralRules& rules, Sdc::CreasingMethod creasing)
    : level_(level),
      sharpness_(sharpness),
      rules_(rules),
      creasing_(creasing),
      graph_(level),
      sharp_(graph_, sharpness, creasing) {}

bool PolyhedralLimits::IsRegularInside(Index v) const {
    const Vtr::Tag tag = level_.vertex_tags[v];
    if (tag.rule() != Vtr::Rule::Solid || tag.non_manifold()) return false;
    const auto cells = level_.vertex_cells[v];
    const auto edges = level_.vertex_edges[v];
    return cells.size() == 8 && edges.size() == 6 &&
           std::all_of(cells.begin(), cells.end(), [&](Index c) { return level_.IsHex(c); }) &&
           std::all_of(edges.begin(), edges.end(), [&](Index e) { return level_.edge_faces.Count(e) == 4; });
}

/// The four quadrilaterals around a regular vertex of a smooth surface; otherwise none.
std::vector<Index> PolyhedralLimits::RegularSurfaceFaces(Index v) const {
    const Vtr::Tag tag = level_.vertex_tags[v];
    if (tag.rule() != Vtr::Rule::Surface || tag.non_manifold() || sharp_.ChangesVertex(v)) return {};
    std::vector<Index> faces;
    ForSurfaceEdges(graph_, v, [&](Index e) {
        for (Index f : level_.edge_faces[e]) {
            if (level_.IsBoundary(f)) faces.push_back(f);
        }
    });
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    const bool is_regular = faces.size() == 4 && std::all_of(faces.begin(), faces.end(), [&](Index f) {
                                return level_.FaceVertices(f).size() == 4;
                            });
    return is_regular ? faces : std::vector<Index>{};
}

MaskRow PolyhedralLimits::Of(Index v) const {
    if (sharp_.IsFading(v)) return {};
    if (rules_.is_linear() || level_.vertex_tags[v].rule() == Vtr::Rule::Corner) return {{v}, {1.0}};
    MaskRow row{{v}, {0.0}};
    if (IsRegularInside(v)) {
        // (64, 16, 4, 1)/216 by distance, shared among the 8, 4, 2, 1 cells that have such a vertex.
        constexpr std::array<double, 4> kShares{8.0 / 216, 4.0 / 216, 2.0 / 216, 1.0 / 216};
        for (Index c : level_.vertex_cells[v]) {
            const auto corners = level_.CellVertices(c);
            const int mine = static_cast<int>(CornerOf(corners, v));
            for (int i = 0; i < Sdc::Hex::kVertices; ++i) {
                AddTo(row, corners[static_cast<std::size_t>(i)], kShares[Sdc::Hex::Distance(mine, i)]);
            }
        }
        return row;
    }
    if (const std::vector<Index> faces = RegularSurfaceFaces(v); !faces.empty()) {
        constexpr std::array<double, 4> kShares{4.0 / 36, 2.0 / 36, 1.0 / 36, 2.0 / 36};  // around a face
        for (Index f : faces) {
            const auto corners = level_.FaceVertices(f);
            const std::size_t mine = static_cast<std::size_t>(CornerOf(corners, v));
            for (std::size_t i = 0; i < 4; ++i) AddTo(row, corners[(mine + i) % 4], kShares[i]);
        }
        return row;
    }
    const VertexStar star(level_, sharpness_, v);
    const LocalMatrix matrix = star.Matrix(rules_, creasing_);
    const std::vector<double> mask = LimitMaskOf(matrix);
    row = {};
    if (!mask.empty()) star.Compose(rules_, creasing_, matrix, mask, row.indices, row.weights);
    return row;
}

}  // namespace SolidSubdiv::Far::Internal

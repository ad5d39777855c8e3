// SPDX-License-Identifier: Apache-2.0
// A code for every place; equal codes are one kind.
#include <solidsubdiv/kit/analysis/mesh_places.h>

#include <algorithm>
#include <map>

#include <solidsubdiv/kit/analysis/internal/link.h>
#include <solidsubdiv/kit/analysis/internal/place_codes.h>
#include <solidsubdiv/sdc/creases.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Analysis {

namespace {

using Internal::PlaceCode;

/// Whether edges and vertices of one cell alone are creases and corners.
bool HasSharpFeatures(const Sdc::Scheme& scheme) {
    return std::visit(
        [](const auto& s) {
            if constexpr (requires { s.features; }) return s.features == Sdc::Features::Sharp;
            return false;
        },
        scheme);
}

class Classifier {
  public:
    explicit Classifier(const Progress& progress) : progress_(progress) {}

    /// Sorts the codes of n components, made by code_of(i) in parallel, into kinds.
    template <class CodeFunction>
    void Add(PlaceType type, Index n, CodeFunction&& code_of) {
        std::map<std::u16string, std::size_t> known;
        constexpr Index kBlock = 1 << 16;
        std::vector<PlaceCode> codes;
        for (Index begin = 0; begin < n; begin += kBlock) {
            codes.assign(static_cast<std::size_t>(std::min(kBlock, n - begin)), {});
            Sdc::ParallelFor(static_cast<Offset>(codes.size()), 256, [&](Offset first, Offset last) {
                for (Offset i = first; i < last; ++i) codes[i] = code_of(begin + static_cast<Index>(i));
            });
            for (std::size_t i = 0; i < codes.size(); ++i) {
                if (codes[i].text.empty()) continue;
                const auto [it, is_new] = known.emplace(codes[i].text, kinds_.size());
                if (is_new) kinds_.push_back({type, codes[i].what, 0, begin + static_cast<Index>(i)});
                ++kinds_[it->second].count;
            }
            Report(progress_, "classify", static_cast<double>(begin + static_cast<Index>(codes.size())) / n);
        }
    }

    std::vector<PlaceKind> Take() {
        std::stable_sort(kinds_.begin(), kinds_.end(), [](const PlaceKind& a, const PlaceKind& b) {
            return a.type != b.type ? a.type < b.type : a.count > b.count;
        });
        return std::move(kinds_);
    }

  private:
    const Progress& progress_;
    std::vector<PlaceKind> kinds_;
};

enum class VertexRole { Inner, Surface, Border, Creased, Other };

/// Roles of the vertices of level 0.
std::vector<VertexRole> RolesOf(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme) {
    const Vtr::EdgeGraph graph = refiner.graph(0);
    const bool has_features = HasSharpFeatures(scheme);
    const Far::Sharpness& sharpness = refiner.sharpness();
    const auto is_sharp = [&](Index v) {
        if (!sharpness.empty() && Sdc::IsInfinitelySharp(sharpness.vertices[v])) return true;
        for (Index e : graph.vertex_edges[v]) {
            if (!sharpness.empty() && Sdc::IsInfinitelySharp(sharpness.edges[e])) return true;
            if (has_features && graph.edge_tags[e].one_cell()) return true;
        }
        return false;
    };
    std::vector<VertexRole> roles(static_cast<std::size_t>(graph.n_vertices), VertexRole::Other);
    for (Index v = 0; v < graph.n_vertices; ++v) {
        const Vtr::Tag tag = graph.vertex_tags[v];
        if (tag.rule() == Vtr::Rule::Solid) {
            roles[v] = VertexRole::Inner;
        } else if (tag.non_manifold() || !tag.in_face()) {
            roles[v] = VertexRole::Other;
        } else if (is_sharp(v)) {
            roles[v] = VertexRole::Creased;
        } else if (tag.rule() == Vtr::Rule::Surface) {
            roles[v] = VertexRole::Surface;
        } else if (!tag.in_cell()) {
            roles[v] = VertexRole::Border;
        } else {
            roles[v] = VertexRole::Creased;
        }
    }
    return roles;
}

template <class Codes>
void AddAll(Classifier& classifier, const Codes& codes, const std::vector<VertexRole>& roles) {
    const auto of_role = [&](VertexRole role, auto&& code_of) {
        return [&roles, role, code_of](Index v) { return roles[v] == role ? code_of(v) : PlaceCode{}; };
    };
    const auto n_vertices = static_cast<Index>(roles.size());
    classifier.Add(PlaceType::InnerVertex, n_vertices,
                   of_role(VertexRole::Inner, [&](Index v) { return codes.InnerVertex(v); }));
    classifier.Add(PlaceType::InnerEdge, codes.n_edges(), [&](Index e) { return codes.InnerEdge(e); });
    classifier.Add(PlaceType::InnerFace, codes.n_faces(), [&](Index f) { return codes.InnerFace(f); });
    classifier.Add(PlaceType::InnerCell, codes.n_cells(), [&](Index c) { return codes.InnerCell(c); });
    const auto on_surface = [&](Index v) { return codes.SurfaceVertex(v); };
    classifier.Add(PlaceType::Surface, n_vertices, of_role(VertexRole::Surface, on_surface));
    classifier.Add(PlaceType::Border, n_vertices, of_role(VertexRole::Border, on_surface));
    classifier.Add(PlaceType::SurfaceFace, codes.n_faces(), [&](Index f) { return codes.SurfaceFace(f); });
}

}  // namespace

MeshPlaces PlacesOf(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme, const Progress& progress) {
    const std::vector<VertexRole> roles = RolesOf(refiner, scheme);
    Classifier classifier(progress);
    if (refiner.is_polyhedral()) {
        AddAll(classifier, Internal::PolyhedralCodes(refiner.polyhedral_level(0)), roles);
    } else {
        AddAll(classifier, Internal::TetOctCodes(refiner.level(0), Internal::UsesDiagonals(scheme)), roles);
    }
    MeshPlaces places;
    places.kinds = classifier.Take();
    places.n_creased = static_cast<Index>(std::count(roles.begin(), roles.end(), VertexRole::Creased));
    places.n_others = static_cast<Index>(std::count(roles.begin(), roles.end(), VertexRole::Other));
    return places;
}

Star StarOf(const Far::TopologyRefiner& refiner, const PlaceKind& kind) {
    switch (kind.type) {
        case PlaceType::InnerVertex:
            return StarOf(refiner, 0, kind.example, false);
        case PlaceType::InnerEdge:
            return PointOnEdge(refiner, 0, kind.example);
        case PlaceType::InnerFace:
        case PlaceType::SurfaceFace:
            return PointInFace(refiner, 0, kind.example);
        case PlaceType::InnerCell:
            return PointInCell(refiner, 0, kind.example);
        case PlaceType::Surface:
        case PlaceType::Border:
            break;
    }
    return StarOf(refiner, 0, kind.example, true);
}

}  // namespace SolidSubdiv::Analysis

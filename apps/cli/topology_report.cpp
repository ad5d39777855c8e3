// SPDX-License-Identifier: Apache-2.0
// What there is to say about a mesh's topology, measured on level 0 of a refiner.
#include <solidsubdiv/apps/cli/topology_report.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include <solidsubdiv/apps/cli/diagonal_data.h>
#include <solidsubdiv/apps/cli/mesh_kinds.h>
#include <solidsubdiv/far/choose_diagonals.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/geometry/face_cells.h>
#include <solidsubdiv/kit/geometry/surface_components.h>
#include <solidsubdiv/kit/geometry/touching_cells.h>
#include <solidsubdiv/kit/geometry/valence.h>

namespace SolidSubdiv::Cli {

namespace {

constexpr std::size_t kPiecesListed = 100;
constexpr std::size_t kElementsListed = 100;

/// Faces one after another.
struct Faces {
    std::vector<Offset> offsets{0};
    std::vector<Index> corners;

    void Add(std::span<const Index> vertices) {
        corners.insert(corners.end(), vertices.begin(), vertices.end());
        offsets.push_back(static_cast<Offset>(corners.size()));
    }
};

Json Pieces(const Faces& faces, Index n_vertices) {
    const auto pieces = Geometry::SurfaceComponents(faces.offsets, faces.corners, n_vertices);
    Json list = Json::array();
    for (const auto& piece : pieces) {
        if (list.size() == kPiecesListed) break;
        const auto genus = piece.Genus();
        list.push_back({{"faces", piece.n_faces},
                        {"vertices", piece.n_vertices},
                        {"edges", piece.n_edges},
                        {"euler_characteristic", piece.EulerCharacteristic()},
                        {"genus", genus ? Json(*genus) : Json(nullptr)},
                        {"manifold", piece.IsManifold()},
                        {"closed", piece.IsClosed()},
                        {"border_loops", piece.n_border_loops},
                        {"flipped_edges", piece.n_flipped_edges}});
    }
    return {{"count", pieces.size()}, {"components", list}};
}

/// Pieces of the solids' boundary and of what is surface only.
template <class AnyLevel>
void AddSurfaces(const AnyLevel& level, Json& json) {
    Faces boundary, surface;
    for (Index b = 0; b < level.n_boundary_faces; ++b) {
        const bool is_surface = Geometry::CellsOfFace(level, level.boundary_faces[b]) == 0;
        (is_surface ? surface : boundary).Add(level.BoundaryVertices(b));
    }
    if (!boundary.corners.empty()) json["boundary"] = Pieces(boundary, level.n_vertices);
    if (!surface.corners.empty()) json["surface"] = Pieces(surface, level.n_vertices);
}

/// {"value": how many, ...}
Json HistogramJson(const Geometry::Histogram& histogram) {
    Json json = Json::object();
    for (std::size_t k = 0; k < histogram.size(); ++k) {
        if (histogram[k] > 0) json[std::to_string(k)] = histogram[k];
    }
    return json;
}

template <class AnyLevel>
void AddRegularity(const AnyLevel& level, Json& json) {
    const Geometry::ValenceHistograms h = Geometry::MeasureValences(level);
    json["valence"] = {{"edges_at_vertices", HistogramJson(h.vertex_edges)},
                       {"adjacent_inside_solids", HistogramJson(h.solid_adjacent)},
                       {"edges_on_surfaces", HistogramJson(h.surface_edges)}};
    json["links"] = HistogramJson(h.links);
}

template <class AnyLevel>
void AddTouchingCells(const AnyLevel& level, Json& json) {
    const Geometry::TouchingCells found = Geometry::FindTouchingCells(level);
    Json edges = Json::array(), vertices = Json::array();
    for (std::size_t i = 0; i < std::min(found.edges.size(), kElementsListed); ++i) {
        edges.push_back(level.EdgeVertices(found.edges[i]));
    }
    for (std::size_t i = 0; i < std::min(found.vertices.size(), kElementsListed); ++i) {
        vertices.push_back(found.vertices[i]);
    }
    json["cells_meeting_only_in"] = {{"edges", {{"count", found.edges.size()}, {"first", edges}}},
                                     {"vertices", {{"count", found.vertices.size()}, {"first", vertices}}}};
}

void AddMatching(const Io::Mesh& mesh, Json& json) {
    const auto topology = mesh.topology.View();
    const auto first = Far::ChooseDiagonals(topology, Far::DiagonalPolicy::First);
    const auto matched = Far::ChooseDiagonals(topology, Far::DiagonalPolicy::Matched);
    Json& faces = json["matched_faces"];
    faces = {{"inner_faces", first.n_inner_faces},
             {"as_ordered", first.MatchedShare()},
             {"matched", matched.MatchedShare()}};
    const auto given = FindDiagonalData(mesh);
    if (!given) return;
    faces["given"] = Far::ChooseDiagonals(topology, Far::DiagonalPolicy::Given, {}, *given).MatchedShare();
}

template <class AnyLevel>
void AddLevel(const AnyLevel& level, Json& json) {
    AddSurfaces(level, json);
    AddRegularity(level, json);
    if (level.n_cells() > 0) AddTouchingCells(level, json);
}

}  // namespace

void AddTopology(const Io::Mesh& mesh, Json& json) {
    const Io::Topology& topology = mesh.topology;
    if (!IsTetOct(topology)) {
        const auto refiner = Far::TopologyRefiner::Create(topology.View(), Sdc::Split::Polyhedral);
        AddLevel(refiner.polyhedral_level(0), json);
        json["regular"] = {{"adjacent_inside_solids", {6}}, {"edges_on_surfaces", {4}}, {"links", {4}}};
        return;
    }
    const auto refiner = Far::TopologyRefiner::Create(topology.View(), Sdc::Split::TetOct);
    AddLevel(refiner.level(0), json);
    json["regular"] = {{"adjacent_inside_solids", {14}}, {"edges_on_surfaces", {6}}, {"links", {4, 6}}};
    if (topology.n_cells() > 0) AddMatching(mesh, json);
}

}  // namespace SolidSubdiv::Cli

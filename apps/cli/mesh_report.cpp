// SPDX-License-Identifier: Apache-2.0
// What there is to say about a mesh, measured.
#include <solidsubdiv/apps/cli/mesh_report.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include <solidsubdiv/apps/cli/mesh_kinds.h>
#include <solidsubdiv/apps/cli/topology_report.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/kit/geometry/cell_volume.h>
#include <solidsubdiv/kit/geometry/coincident_vertices.h>
#include <solidsubdiv/kit/geometry/orientation.h>
#include <solidsubdiv/kit/io/creases.h>
#include <solidsubdiv/kit/io/holes.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Cli {

namespace {

constexpr Index kDefectsCounted = 100000;
constexpr Index kDefectsListed = 100;
constexpr std::size_t kElementsListed = 100;

std::string NameOf(Far::DefectCode code) {
    switch (code) {
        case Far::DefectCode::IndexOutOfRange:
            return "index out of range";
        case Far::DefectCode::RepeatedVertex:
            return "repeated vertex";
        case Far::DefectCode::DuplicateElement:
            return "duplicate element";
        case Far::DefectCode::FaceInThreeCells:
            return "face in three cells";
        case Far::DefectCode::OpenCell:
            return "open cell";
        case Far::DefectCode::TwistedFace:
            return "twisted face";
        case Far::DefectCode::BadSharpness:
            return "bad sharpness";
        case Far::DefectCode::BadOffsets:
            return "bad offsets";
        case Far::DefectCode::InvertedCell:
            return "neighbours oriented against each other";
        case Far::DefectCode::NonManifoldEdge:
            return "non-manifold edge";
        case Far::DefectCode::NonManifoldVertex:
            return "non-manifold vertex";
        case Far::DefectCode::IsolatedVertex:
            return "isolated vertex";
        case Far::DefectCode::CoincidentElement:
            return "coincident element";
        case Far::DefectCode::UnusedSharpness:
            return "crease without an edge";
        case Far::DefectCode::NoLimit:
            return "place without a limit";
        case Far::DefectCode::NoDerivative:
            return "place without a derivative";
    }
    return "defect";
}

Json Counts(const Io::Mesh& mesh) {
    Json json;
    json["vertices"] = mesh.topology.n_vertices;
    for (const KindCount& kind : KindCounts(mesh.topology)) {
        if (kind.count > 0) json[std::string(kind.plural)] = kind.count;
    }
    return json;
}

Json Bounds(const Io::Mesh& mesh) {
    const Geometry::Box box = Geometry::BoundingBox(mesh.positions);
    if (box.IsEmpty()) return nullptr;
    return {{"low", box.low}, {"high", box.high}, {"diagonal", box.Diagonal()}};
}

Json Volumes(const Io::Mesh& mesh) {
    const std::vector<double> volumes = Geometry::CellVolumes(mesh.topology.View(), mesh.positions);
    double sum = 0, sum_of_sizes = 0, least = std::numeric_limits<double>::infinity(), greatest = -least;
    Offset n_negative = 0;
    for (double v : volumes) {
        sum += v;
        sum_of_sizes += std::abs(v);
        least = std::min(least, v);
        greatest = std::max(greatest, v);
        n_negative += v < 0;
    }
    return {{"sum", sum},
            {"sum_of_sizes", sum_of_sizes},
            {"least_cell", least},
            {"greatest_cell", greatest},
            {"negative_cells", n_negative}};
}

/// The first elements of a list, and their number.
Json Elements(const std::vector<Index>& elements) {
    const auto n = static_cast<std::ptrdiff_t>(std::min(elements.size(), kElementsListed));
    return {{"count", elements.size()}, {"first", std::vector<Index>(elements.begin(), elements.begin() + n)}};
}

Json Attributes(const std::vector<Io::Attribute>& attributes) {
    Json list = Json::array();
    for (const Io::Attribute& a : attributes) {
        const auto width = static_cast<std::size_t>(a.width);
        std::vector<double> low(width, std::numeric_limits<double>::infinity()), high(width, -low[0]);
        for (std::size_t i = 0; i < a.values.size(); ++i) {
            low[i % width] = std::min(low[i % width], a.values[i]);
            high[i % width] = std::max(high[i % width], a.values[i]);
        }
        Json json = {{"name", a.name}, {"width", a.width}};
        if (!a.values.empty()) {
            json["low"] = low;
            json["high"] = high;
        }
        list.push_back(json);
    }
    return list;
}

}  // namespace

Json DescribeDefects(const std::vector<Far::Defect>& defects, Index at_most, Index listed) {
    std::map<Far::DefectCode, std::vector<const Far::Defect*>> by_code;
    for (const Far::Defect& defect : defects) by_code[defect.code].push_back(&defect);
    Json list = Json::array();
    for (const auto& [code, found] : by_code) {
        Json first = Json::array();
        for (const Far::Defect* defect : found) {
            if (static_cast<Index>(first.size()) == listed) break;
            first.push_back({{"element", defect->element}, {"measure", defect->measure}, {"text", defect->text}});
        }
        list.push_back({{"code", NameOf(code)},
                        {"fatal", found[0]->IsFatal()},
                        {"count", found.size()},
                        {"count_is_complete", static_cast<Index>(found.size()) < at_most},
                        {"first", first}});
    }
    return list;
}

Json DescribeDefects(const Far::TopologyDescriptor& topology, Index at_most, Index listed) {
    return DescribeDefects(Far::Validate(topology, at_most), at_most, listed);
}

Json DescribeMesh(const Io::Mesh& mesh) {
    const Io::Topology& topology = mesh.topology;
    Json json;
    json["counts"] = Counts(mesh);
    json["bounding_box"] = Bounds(mesh);
    if (topology.n_cells() > 0) json["volume"] = Volumes(mesh);
    json["coincident_vertices"] = Elements(Geometry::FindCoincidentVertices(mesh.positions));
    if (topology.n_tets() + topology.n_octs() > 0) {
        const auto found = Geometry::FindInvertedCells(topology.tets, topology.octs, mesh.positions);
        json["inverted"] = {{"tetrahedra", Elements(found.inverted_tets)},
                            {"octahedra", Elements(found.inverted_octs)}};
        json["zero_volume"] = {{"tetrahedra", Elements(found.flat_tets)}, {"octahedra", Elements(found.flat_octs)}};
    }
    Io::Topology copy = topology;
    Geometry::OrientationReport others;
    Geometry::OrientOtherCells(Geometry::OtherCells{.hexes = copy.hexes,
                                                    .wedges = copy.wedges,
                                                    .pyramids = copy.pyramids,
                                                    .polyhedron_offsets = copy.polyhedron_offsets,
                                                    .polyhedron_face_offsets = copy.polyhedron_face_offsets,
                                                    .polyhedron_vertices = copy.polyhedron_vertices},
                               mesh.positions, Geometry::OrientationPolicy::Keep, others);
    json["other_cells"] = {{"inverted", others.n_inverted_others}, {"zero_volume", others.n_flat_others}};
    json["point_data"] = Attributes(mesh.point_data);
    json["cell_data"] = Attributes(mesh.cell_data);

    const Io::Creases creases = Io::CreasesOf(mesh);
    json["creases"] = {{"edges", creases.edge_sharpness.size()}, {"corners", creases.vertices.size()}};
    json["holes"] = Io::HolesOf(mesh).size();
    Far::TopologyDescriptor descriptor = topology.View();
    creases.AddTo(descriptor);
    json["defects"] = DescribeDefects(descriptor, kDefectsCounted, kDefectsListed);
    const Json& defects = json["defects"];
    if (std::any_of(defects.begin(), defects.end(), [](const Json& d) { return d["fatal"].get<bool>(); })) {
        json["analysis"] = "boundary and valences are not found while there are fatal defects";
        return json;
    }
    AddTopology(mesh, json);
    json["analysis"] = "complete";
    return json;
}

}  // namespace SolidSubdiv::Cli

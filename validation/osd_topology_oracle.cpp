// SPDX-License-Identifier: Apache-2.0
// Makes OpenSubdiv's refiner and copies topology out of it.
#include "osd_topology_oracle.h"

#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <stdexcept>

namespace SolidSubdiv::Validation {

namespace Theirs = OpenSubdiv::Far;

namespace {

using SdcOptions = OpenSubdiv::Sdc::Options;

std::unique_ptr<Theirs::TopologyRefiner> Make(int n_vertices, const std::vector<int>& arities,
                                              const std::vector<int>& corners, const SurfaceTags& tags,
                                              OpenSubdiv::Sdc::SchemeType scheme, SdcOptions options, int max_level) {
    Theirs::TopologyDescriptor descriptor;
    descriptor.numVertices = n_vertices;
    descriptor.numFaces = static_cast<int>(arities.size());
    descriptor.numVertsPerFace = arities.data();
    descriptor.vertIndicesPerFace = corners.data();

    std::vector<int> crease_ends;
    for (const auto& ends : tags.creases) crease_ends.insert(crease_ends.end(), ends.begin(), ends.end());
    descriptor.numCreases = static_cast<int>(tags.creases.size());
    descriptor.creaseVertexIndexPairs = crease_ends.data();
    descriptor.creaseWeights = tags.crease_sharpness.data();
    descriptor.numCorners = static_cast<int>(tags.corners.size());
    descriptor.cornerVertexIndices = tags.corners.data();
    descriptor.cornerWeights = tags.corner_sharpness.data();

    options.SetVtxBoundaryInterpolation(tags.has_sharp_corners ? SdcOptions::VTX_BOUNDARY_EDGE_AND_CORNER
                                                               : SdcOptions::VTX_BOUNDARY_EDGE_ONLY);
    options.SetCreasingMethod(tags.is_chaikin ? SdcOptions::CREASE_CHAIKIN : SdcOptions::CREASE_UNIFORM);
    using Factory = Theirs::TopologyRefinerFactory<Theirs::TopologyDescriptor>;
    std::unique_ptr<Theirs::TopologyRefiner> refiner(Factory::Create(descriptor, Factory::Options(scheme, options)));
    if (!refiner) throw std::runtime_error("OpenSubdiv refuses the surface");
    Theirs::TopologyRefiner::UniformOptions uniform(max_level);
    uniform.fullTopologyInLastLevel = true;
    refiner->RefineUniform(uniform);
    return refiner;
}

}  // namespace

std::unique_ptr<Theirs::TopologyRefiner> MakeOpenSubdivRefiner(const ControlSurface& surface, int max_level) {
    std::vector<int> corners;
    for (const Triangle& t : surface.triangles) corners.insert(corners.end(), t.begin(), t.end());
    return Make(surface.n_vertices, std::vector<int>(surface.triangles.size(), 3), corners, surface.tags,
                OpenSubdiv::Sdc::SCHEME_LOOP, {}, max_level);
}

std::unique_ptr<Theirs::TopologyRefiner> MakeOpenSubdivRefiner(const PolygonSurface& surface, int max_level) {
    std::vector<int> arities, corners;
    for (const Polygon& face : surface.faces) {
        arities.push_back(static_cast<int>(face.size()));
        corners.insert(corners.end(), face.begin(), face.end());
    }
    SdcOptions options;
    options.SetTriangleSubdivision(surface.has_smooth_triangles ? SdcOptions::TRI_SUB_SMOOTH
                                                                : SdcOptions::TRI_SUB_CATMARK);
    return Make(surface.n_vertices, arities, corners, surface.tags,
                surface.is_bilinear ? OpenSubdiv::Sdc::SCHEME_BILINEAR : OpenSubdiv::Sdc::SCHEME_CATMARK, options,
                max_level);
}

void CopyTopology(const Theirs::TopologyLevel& from, bool is_last, SurfaceLevel& to, bool has_face_points) {
    to.n_vertices = from.GetNumVertices();
    for (int f = 0; f < from.GetNumFaces(); ++f) {
        const auto v = from.GetFaceVertices(f);
        if (!has_face_points) {
            to.triangles.push_back({v[0], v[1], v[2]});
            continue;
        }
        to.faces.emplace_back(v.begin(), v.end());
        if (!is_last) to.children_of_faces.push_back(from.GetFaceChildVertex(f));
    }
    for (int e = 0; e < from.GetNumEdges(); ++e) {
        const auto v = from.GetEdgeVertices(e);
        to.edges.push_back({v[0], v[1]});
        if (!is_last) to.children_of_edges.push_back(from.GetEdgeChildVertex(e));
    }
    for (int v = 0; v < from.GetNumVertices() && !is_last; ++v) {
        to.children_of_vertices.push_back(from.GetVertexChildVertex(v));
    }
}

}  // namespace SolidSubdiv::Validation

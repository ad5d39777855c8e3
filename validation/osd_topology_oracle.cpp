// SPDX-License-Identifier: Apache-2.0
// Makes OpenSubdiv's refiner and copies topology out of it.
#include "osd_topology_oracle.h"

#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <stdexcept>

namespace SolidSubdiv::Validation {

namespace Theirs = OpenSubdiv::Far;

std::unique_ptr<Theirs::TopologyRefiner> MakeOpenSubdivRefiner(const ControlSurface& surface, int max_level) {
    const std::vector<int> arities(surface.triangles.size(), 3);
    std::vector<int> corners;
    for (const Triangle& t : surface.triangles) corners.insert(corners.end(), t.begin(), t.end());
    Theirs::TopologyDescriptor descriptor;
    descriptor.numVertices = surface.n_vertices;
    descriptor.numFaces = static_cast<int>(surface.triangles.size());
    descriptor.numVertsPerFace = arities.data();
    descriptor.vertIndicesPerFace = corners.data();

    const SurfaceTags& tags = surface.tags;
    std::vector<int> crease_ends;
    for (const auto& ends : tags.creases) crease_ends.insert(crease_ends.end(), ends.begin(), ends.end());
    descriptor.numCreases = static_cast<int>(tags.creases.size());
    descriptor.creaseVertexIndexPairs = crease_ends.data();
    descriptor.creaseWeights = tags.crease_sharpness.data();
    descriptor.numCorners = static_cast<int>(tags.corners.size());
    descriptor.cornerVertexIndices = tags.corners.data();
    descriptor.cornerWeights = tags.corner_sharpness.data();

    using Options = OpenSubdiv::Sdc::Options;
    Options options;
    options.SetVtxBoundaryInterpolation(tags.has_sharp_corners ? Options::VTX_BOUNDARY_EDGE_AND_CORNER
                                                               : Options::VTX_BOUNDARY_EDGE_ONLY);
    options.SetCreasingMethod(tags.is_chaikin ? Options::CREASE_CHAIKIN : Options::CREASE_UNIFORM);
    using Factory = Theirs::TopologyRefinerFactory<Theirs::TopologyDescriptor>;
    std::unique_ptr<Theirs::TopologyRefiner> refiner(
        Factory::Create(descriptor, Factory::Options(OpenSubdiv::Sdc::SCHEME_LOOP, options)));
    if (!refiner) throw std::runtime_error("OpenSubdiv refuses the surface");
    Theirs::TopologyRefiner::UniformOptions uniform(max_level);
    uniform.fullTopologyInLastLevel = true;
    refiner->RefineUniform(uniform);
    return refiner;
}

void CopyTopology(const Theirs::TopologyLevel& from, bool is_last, SurfaceLevel& to) {
    to.n_vertices = from.GetNumVertices();
    for (int f = 0; f < from.GetNumFaces(); ++f) {
        const auto v = from.GetFaceVertices(f);
        to.triangles.push_back({v[0], v[1], v[2]});
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

// SPDX-License-Identifier: Apache-2.0
// OpenSubdiv's limit stencils.
#include "perf/open_subdiv.h"

#if SOLIDSUBDIV_HAS_OPENSUBDIV

#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <map>

namespace SolidSubdiv::Perf {

namespace Theirs = OpenSubdiv::Far;

struct OpenSubdivLimits::State {
    std::vector<int> vertices, sizes;
    std::unique_ptr<Theirs::TopologyRefiner> refiner;
    struct Places {
        std::vector<float> u, v;
    };
    std::map<Index, Places> places;  // by face
};

OpenSubdivLimits::OpenSubdivLimits(std::span<const Index> quads, Index n_vertices) : state_(std::make_unique<State>()) {
    state_->vertices.assign(quads.begin(), quads.end());
    state_->sizes.assign(quads.size() / 4, 4);
    Theirs::TopologyDescriptor mesh;
    mesh.numVertices = n_vertices;
    mesh.numFaces = static_cast<int>(state_->sizes.size());
    mesh.numVertsPerFace = state_->sizes.data();
    mesh.vertIndicesPerFace = state_->vertices.data();
    using Factory = Theirs::TopologyRefinerFactory<Theirs::TopologyDescriptor>;
    state_->refiner.reset(
        Factory::Create(mesh, Factory::Options(OpenSubdiv::Sdc::SCHEME_CATMARK, OpenSubdiv::Sdc::Options())));
}
OpenSubdivLimits::~OpenSubdivLimits() = default;

void OpenSubdivLimits::AddPlace(Index face, double u, double v) {
    state_->places[face].u.push_back(static_cast<float>(u));
    state_->places[face].v.push_back(static_cast<float>(v));
}

void OpenSubdivLimits::Make() {
    constexpr int kIsolation = 6;  // levels: irregular places are approximated beyond
    state_->refiner->Unrefine();
    state_->refiner->RefineAdaptive(Theirs::TopologyRefiner::AdaptiveOptions(kIsolation));
    Theirs::LimitStencilTableFactory::LocationArrayVec locations;
    for (const auto& [face, places] : state_->places) {
        Theirs::LimitStencilTableFactory::LocationArray& at = locations.emplace_back();
        at.ptexIdx = face;
        at.numLocations = static_cast<int>(places.u.size());
        at.s = places.u.data();
        at.t = places.v.data();
    }
    Theirs::LimitStencilTableFactory::Options options;
    options.generate1stDerivatives = true;
    const std::unique_ptr<const Theirs::LimitStencilTable> table(
        Theirs::LimitStencilTableFactory::Create(*state_->refiner, locations, nullptr, nullptr, options));
}

}  // namespace SolidSubdiv::Perf

#endif

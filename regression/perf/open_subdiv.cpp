// SPDX-License-Identifier: Apache-2.0
// The only source that includes OpenSubdiv.
#include "perf/open_subdiv.h"

#if SOLIDSUBDIV_HAS_OPENSUBDIV

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/osd/cpuEvaluator.h>

#include <stdexcept>

namespace SolidSubdiv::Perf {

namespace {

namespace Theirs = OpenSubdiv::Far;
using OpenSubdiv::Sdc::Options;

/// A point as PrimvarRefiner wants it.
struct Point {
    float x, y, z;
    void Clear() { x = y = z = 0; }
    void AddWithWeight(const Point& p, float w) { x += w * p.x, y += w * p.y, z += w * p.z; }
};

}  // namespace

struct OpenSubdivSurface::State {
    std::vector<int> vertices, sizes;
    std::vector<Point> control, points[2];
    OpenSubdiv::Sdc::SchemeType scheme;
    int n_levels;
    std::unique_ptr<Theirs::TopologyRefiner> refiner;
    std::unique_ptr<const Theirs::StencilTable> table;

    void MakeTable(bool cascaded) {
        Theirs::StencilTableFactory::Options options;
        options.generateIntermediateLevels = cascaded;
        options.factorizeIntermediateLevels = !cascaded;
        options.maxLevel = static_cast<unsigned>(n_levels) & 15;
        table.reset(Theirs::StencilTableFactory::Create(*refiner, options));
    }
};

OpenSubdivSurface::OpenSubdivSurface(const Far::TopologyDescriptor& mesh, std::span<const double> positions,
                                     int n_levels)
    : state_(std::make_unique<State>()) {
    const bool has_quads = !mesh.quads.empty();
    const std::span<const Index> faces = has_quads ? mesh.quads : mesh.triangles;
    const int arity = has_quads ? 4 : 3;
    state_->scheme = has_quads ? OpenSubdiv::Sdc::SCHEME_CATMARK : OpenSubdiv::Sdc::SCHEME_LOOP;
    state_->n_levels = n_levels;
    state_->vertices.assign(faces.begin(), faces.end());
    state_->sizes.assign(faces.size() / static_cast<std::size_t>(arity), arity);
    for (std::size_t i = 0; i < positions.size(); i += 3) {
        const auto* p = &positions[i];
        state_->control.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
    }
}
OpenSubdivSurface::~OpenSubdivSurface() = default;

void OpenSubdivSurface::Create() {
    Theirs::TopologyDescriptor descriptor;
    descriptor.numVertices = static_cast<int>(state_->control.size());
    descriptor.numFaces = static_cast<int>(state_->sizes.size());
    descriptor.numVertsPerFace = state_->sizes.data();
    descriptor.vertIndicesPerFace = state_->vertices.data();
    Options options;
    options.SetVtxBoundaryInterpolation(Options::VTX_BOUNDARY_EDGE_ONLY);
    using Factory = Theirs::TopologyRefinerFactory<Theirs::TopologyDescriptor>;
    state_->refiner.reset(Factory::Create(descriptor, Factory::Options(state_->scheme, options)));
    if (!state_->refiner) throw std::runtime_error("OpenSubdiv refuses the mesh");
}

void OpenSubdivSurface::Refine(bool full) {
    Theirs::TopologyRefiner::UniformOptions options(state_->n_levels);
    options.fullTopologyInLastLevel = full;
    state_->refiner->RefineUniform(options);
}

void OpenSubdivSurface::MakeCascaded() { state_->MakeTable(true); }
void OpenSubdivSurface::MakeComposite() { state_->MakeTable(false); }

void OpenSubdivSurface::Interpolate() {
    const Theirs::PrimvarRefiner primvars(*state_->refiner);
    const Point* from = state_->control.data();
    for (int l = 1; l <= state_->n_levels; ++l) {
        std::vector<Point>& to = state_->points[l % 2];
        to.resize(static_cast<std::size_t>(state_->refiner->GetLevel(l).GetNumVertices()));
        Point* const begin = to.data();
        primvars.Interpolate(l, from, begin);
        from = begin;
    }
}

void OpenSubdivSurface::Clear() {
    state_->refiner->Unrefine();
    state_->table.reset();
}

void OpenSubdivSurface::TakeTable(OpenSubdivSurface& other) { state_->table = std::move(other.state_->table); }

std::string OpenSubdivSurface::Describe() {
    std::string text = "Weights in OpenSubdiv's tables:";
    for (const bool cascaded : {true, false}) {
        state_->MakeTable(cascaded);
        text += (cascaded ? " " : ", composite ") + std::to_string(state_->table->GetControlIndices().size()) +
                (cascaded ? " cascaded in " : " in ") + std::to_string(state_->table->GetNumStencils()) + " rows";
        state_->table.reset();
    }
    return text + ".";
}

PointSums OpenSubdivSurface::Sums() const {
    PointSums sums;
    for (const Point& p : state_->points[state_->n_levels % 2]) {
        sums.Add(static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z));
    }
    sums.n_faces = state_->refiner->GetLevel(state_->n_levels).GetNumFaces();
    return sums;
}

void EvaluateByOpenSubdiv(const OpenSubdivRows& rows, const float* source, float* destination, int width) {
    const OpenSubdiv::Osd::BufferDescriptor packed(0, width, width);
    OpenSubdiv::Osd::CpuEvaluator::EvalStencils(source, packed, destination, packed, rows.sizes.data(),
                                                rows.offsets.data(), rows.indices, rows.weights, 0,
                                                static_cast<int>(rows.sizes.size()));
}

}  // namespace SolidSubdiv::Perf

#endif

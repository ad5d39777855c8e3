// SPDX-License-Identifier: Apache-2.0
// OpenSubdiv's limit stencils as rows of Ceres.
#include "perf/open_subdiv_fit.h"

#if SOLIDSUBDIV_HAS_OPENSUBDIV

#include <algorithm>
#include <map>
#include <utility>

#include <ceres/cost_function.h>
#include <ceres/problem.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/geometry/tessellation.h>

#include "perf/fit_peers.h"

namespace SolidSubdiv::Perf {

namespace Theirs = OpenSubdiv::Far;
using Fit::Internal::LinearRow;
using Fit::Internal::Pair;

namespace {

/// A row with its derivatives.
class RowBlock final : public ceres::CostFunction {
  public:
    explicit RowBlock(LinearRow row) : row_(std::move(row)) {
        set_num_residuals(3);
        mutable_parameter_block_sizes()->assign(row_.weights.size(), 3);
    }
    bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
        std::array<double, 3> off{};
        for (std::size_t c = 0; c < 3; ++c) {
            off[c] = -row_.goal[c];
            for (std::size_t j = 0; j < row_.weights.size(); ++j) off[c] += row_.weights[j].second * parameters[j][c];
        }
        for (std::size_t r = 0; r < 3; ++r) {
            residuals[r] = 0;
            for (std::size_t c = 0; c < 3; ++c) residuals[r] += row_.matrix[3 * r + c] * off[c];
        }
        for (std::size_t j = 0; jacobians != nullptr && j < row_.weights.size(); ++j) {
            if (jacobians[j] == nullptr) continue;
            for (std::size_t k = 0; k < 9; ++k) jacobians[j][k] = row_.weights[j].second * row_.matrix[k];
        }
        return true;
    }

  private:
    LinearRow row_;
};

}  // namespace

struct OpenSubdivFit::State {
    Geometry::Tessellation tessellation;
    std::map<std::array<Index, 3>, std::size_t> facets;  // by their vertices
    std::vector<int> vertices, sizes;
    std::unique_ptr<Theirs::TopologyRefiner> refiner;

    /// Where on the cage a pair's point lies.
    Far::Place PlaceOf(const Pair& pair) const {
        if (pair.vertices[0] == pair.vertices[1]) {
            return tessellation.places[static_cast<std::size_t>(pair.vertices[0])];
        }
        return tessellation.domains[facets.at(pair.vertices)].At({pair.weights[0], pair.weights[1], pair.weights[2]});
    }

    /// Weights of control points at each place.
    std::vector<std::vector<std::pair<Index, double>>> Rows(const std::vector<Far::Place>& places) const {
        using Factory = Theirs::LimitStencilTableFactoryReal<double>;
        struct Places {
            std::vector<double> u, v;
            std::vector<std::size_t> numbers;
        };
        std::map<Index, Places> by_face;
        for (std::size_t i = 0; i < places.size(); ++i) {
            Places& p = by_face[places[i].element];
            p.u.push_back(places[i].at[0]);
            p.v.push_back(places[i].at[1]);
            p.numbers.push_back(i);
        }
        Factory::LocationArrayVec locations;
        for (const auto& [face, p] : by_face) {
            Factory::LocationArray& at = locations.emplace_back();
            at.ptexIdx = face;
            at.numLocations = static_cast<int>(p.u.size());
            at.s = p.u.data();
            at.t = p.v.data();
        }
        Factory::Options options;
        options.generate1stDerivatives = false;
        const std::unique_ptr<const Theirs::LimitStencilTableReal<double>> table(
            Factory::Create(*refiner, locations, nullptr, nullptr, options));
        std::vector<std::vector<std::pair<Index, double>>> rows(places.size());
        int row = 0;
        for (const auto& [face, p] : by_face) {
            for (std::size_t number : p.numbers) {
                const auto stencil = table->GetLimitStencil(row++);
                for (int k = 0; k < stencil.GetSize(); ++k) {
                    rows[number].emplace_back(stencil.GetVertexIndices()[k], stencil.GetWeights()[k]);
                }
            }
        }
        return rows;
    }
};

OpenSubdivFit::OpenSubdivFit(const Fit::ControlMesh& cage, int rate) : state_(std::make_unique<State>()) {
    State& s = *state_;
    const auto refiner = Far::TopologyRefiner::Create(cage.View(), SolidSubdiv::Sdc::Split::TetOct);
    s.tessellation = Geometry::TessellateBoundary(refiner, SolidSubdiv::Sdc::Loop{}, {.rate = rate, .normals = false});
    const auto& triangles = s.tessellation.triangles;
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
        s.facets[{triangles[t], triangles[t + 1], triangles[t + 2]}] = t / 3;
    }
    for (Index f = 0; f < refiner.level(0).n_boundary_faces; ++f) {
        for (Index v : refiner.level(0).BoundaryVertices(f)) s.vertices.push_back(v);
        s.sizes.push_back(3);
    }
    Theirs::TopologyDescriptor mesh;
    mesh.numVertices = cage.n_vertices();
    mesh.numFaces = static_cast<int>(s.sizes.size());
    mesh.numVertsPerFace = s.sizes.data();
    mesh.vertIndicesPerFace = s.vertices.data();
    using Factory = Theirs::TopologyRefinerFactory<Theirs::TopologyDescriptor>;
    s.refiner.reset(Factory::Create(mesh, Factory::Options(OpenSubdiv::Sdc::SCHEME_LOOP, OpenSubdiv::Sdc::Options())));
    constexpr int kIsolation = 3;  // levels; irregular places are approximated beyond. More of them cost more
    s.refiner->RefineAdaptive(Theirs::TopologyRefiner::AdaptiveOptions(kIsolation));
}
OpenSubdivFit::~OpenSubdivFit() = default;

void OpenSubdivFit::Solve(const Fit::Internal::StepSettings& settings, std::span<const Pair> pairs, double fairness,
                          std::span<double> control) const {
    std::vector<Far::Place> places;
    for (const Pair& pair : pairs) places.push_back(state_->PlaceOf(pair));
    const auto weights = state_->Rows(places);
    ceres::Problem problem;
    const auto add = [&](const LinearRow& row) {
        std::vector<double*> parameters;
        for (const auto& w : row.weights) parameters.push_back(&control[3 * static_cast<std::size_t>(w.first)]);
        problem.AddResidualBlock(new RowBlock(row), nullptr, parameters);
    };
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        LinearRow row = RowOf(pairs[i], settings.problem.surface, settings.across);
        row.weights = weights[i];
        add(row);
    }
    for (Index i = 0; i < settings.fair_rows.n_rows(); ++i) {
        const LinearRow row = Fit::Internal::FairRowOf(settings.fair_rows, i, fairness);
        if (!row.weights.empty()) add(row);
    }
    SolveByTrustRegion(problem, control.size(), 1e10);
}

}  // namespace SolidSubdiv::Perf

#endif

// SPDX-License-Identifier: Apache-2.0
// What fits what: lattices, octree rules and embeddings of a session; indices and positions of a move.
#include <solidsubdiv/apps/deform/internal/session_input.h>

#include <cmath>
#include <string>

#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Deform::Internal {

namespace {

void CheckPositions(std::span<const double> positions, const std::string& of) {
    if (positions.size() % 3 != 0) {
        throw InvalidInput(of + ": " + std::to_string(positions.size()) + " coordinates, not three a point");
    }
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (!std::isfinite(positions[i])) {
            throw InvalidInput(of + ": coordinate " + std::to_string(i % 3) + " of point " + std::to_string(i / 3) +
                               " is " + std::to_string(positions[i]));
        }
    }
}

void CheckOctreeRule(const Far::StencilRows<double>& rule, Index n_coarse, Index n_fine, const std::string& of) {
    if (rule.n_sources != n_coarse || rule.n_rows() != n_fine) {
        throw InvalidInput(of + ": its octree rule makes " + std::to_string(rule.n_rows()) + " control points from " +
                           std::to_string(rule.n_sources) + "; the lattice has " + std::to_string(n_fine) +
                           ", the one before " + std::to_string(n_coarse));
    }
    bool fits = rule.offsets.front() == 0 && rule.offsets.back() == static_cast<Offset>(rule.indices.size()) &&
                rule.weights.size() == rule.indices.size();
    for (std::size_t i = 0; i + 1 < rule.offsets.size(); ++i) fits = fits && rule.offsets[i] <= rule.offsets[i + 1];
    if (!fits) throw InvalidInput(of + ": the offsets, indices and weights of its octree rule do not fit");
    for (std::size_t k = 0; k < rule.indices.size(); ++k) {
        if (rule.indices[k] < 0 || rule.indices[k] >= n_coarse || !std::isfinite(rule.weights[k])) {
            throw InvalidInput(of + ": weight " + std::to_string(k) + " of its octree rule is " +
                               std::to_string(rule.weights[k]) + " of control point " +
                               std::to_string(rule.indices[k]) + ", out of " + std::to_string(n_coarse));
        }
    }
}

}  // namespace

void CheckSessionInput(const std::vector<SessionLevel>& levels, std::span<const double> points) {
    if (levels.empty()) throw InvalidInput("an editing session needs a lattice");
    CheckPositions(points, "model");
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const std::string of = "level " + std::to_string(i) + " of the session";
        if (levels[i].lattice == nullptr) throw InvalidInput(of + " has no lattice");
        CheckPositions(levels[i].lattice->positions, of);
        const Index n = levels[i].lattice->n_control_points();
        if (i > 0) CheckOctreeRule(levels[i].octree_rule, levels[i - 1].lattice->n_control_points(), n, of);
        const Embedding* embedding = levels[i].embedding.get();
        const auto n_points = static_cast<Index>(points.size() / 3);
        if (embedding && (embedding->n_control_points() != n || embedding->n_points() != n_points)) {
            throw InvalidInput(of + ": its embedding has " + std::to_string(embedding->n_points()) + " points in " +
                               std::to_string(embedding->n_control_points()) + " control points, not " +
                               std::to_string(n_points) + " in " + std::to_string(n));
        }
    }
}

void CheckSessionLevel(int level, int n_levels) {
    if (level < 0 || level >= n_levels) {
        throw InvalidInput("level " + std::to_string(level) + " of an editing session that has " +
                           std::to_string(n_levels));
    }
}

void CheckMove(std::span<const Index> control_points, std::span<const double> positions, Index n_control_points) {
    if (positions.size() != 3 * control_points.size()) {
        throw InvalidInput("a move of " + std::to_string(control_points.size()) + " control points with " +
                           std::to_string(positions.size()) + " coordinates, not three a point");
    }
    for (std::size_t i = 0; i < control_points.size(); ++i) {
        const std::string of = "a move of control point " + std::to_string(control_points[i]);
        if (control_points[i] < 0 || control_points[i] >= n_control_points) {
            throw InvalidInput(of + ", out of " + std::to_string(n_control_points));
        }
        for (double x : positions.subspan(3 * i, 3)) {
            if (!std::isfinite(x)) throw InvalidInput(of + " to " + std::to_string(x));
        }
    }
}

}  // namespace SolidSubdiv::Deform::Internal

// SPDX-License-Identifier: Apache-2.0
// Steps from polyhedra and polygons to their children.
#include <solidsubdiv/far/internal/walk_in_parts.h>

#include <algorithm>
#include <cassert>

namespace SolidSubdiv::Far::Internal {

namespace {

/// Corners of the component in whose middle a point of the split is, ascending.
using Feature = std::vector<Index>;

Feature Sorted(std::span<const Index> corners) {
    Feature feature(corners.begin(), corners.end());
    std::sort(feature.begin(), feature.end());
    return feature;
}

const Transition& ChildAt(const LimitState& state, Index corner) {
    const auto found = std::find_if(state.children.begin(), state.children.end(), [&](const Transition& t) {
        return std::find(t.children.begin(), t.children.end(), corner) != t.children.end();
    });
    assert(found != state.children.end());
    return *found;
}

/// The place among the corners of the child's root of a point of the split.
Index PlaceOf(const Transition& t, const Feature& feature) {
    return static_cast<Index>(std::find(t.features.begin(), t.features.end(), feature) - t.features.begin());
}

/// In the coordinates of a child without parts.
Coordinates PositionOf(const Transition& t, const Feature& feature) {
    const auto corners = CornersOf(t.state->root, t.state->n_root_vertices);
    return corners[static_cast<std::size_t>(PlaceOf(t, feature))];
}

Coordinates Minus(const Coordinates& a, const Coordinates& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// origin + sum of axes[k] x[k], with x of the matrix dx.
void SetPlace(const Coordinates& origin, const std::array<Coordinates, 3>& axes, const Coordinates& x,
              const Matrix3& dx, StepInParts& step) {
    step.at = origin;
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t k = 0; k < 3; ++k) {
            step.at[r] += axes[k][r] * x[k];
            for (std::size_t c = 0; c < 3; ++c) step.matrix[r][c] += axes[k][r] * dx[k][c];
        }
    }
}

/// Enters the child along a path of points of the split, `x` along it, of the matrix dx.
void Enter(const std::array<Feature, 4>& path, std::size_t n, const Coordinates& x, const Matrix3& dx,
           StepInParts& step) {
    const Transition& t = *step.next;
    if (t.state->has_parts()) {
        for (std::size_t i = 0; i < n; ++i) step.path[i] = PlaceOf(t, path[i]);
        step.at = x;
        step.matrix = dx;
        return;
    }
    std::array<Coordinates, 3> axes{};
    for (std::size_t k = 0; k + 1 < n; ++k) axes[k] = Minus(PositionOf(t, path[k + 1]), PositionOf(t, path[k]));
    SetPlace(PositionOf(t, path[0]), axes, x, dx, step);
}

/// The face of the root that has all the corners.
Feature FaceWith(const LimitState& state, std::initializer_list<Index> corners) {
    for (Index f = 0; f < state.root_faces.size(); ++f) {
        Feature face = Sorted(state.root_faces[f]);
        if (std::all_of(corners.begin(), corners.end(),
                        [&](Index v) { return std::binary_search(face.begin(), face.end(), v); })) {
            return face;
        }
    }
    assert(false);
    return {};
}

/// The third neighbour of a corner of three edges.
Index OtherNeighbor(const LimitState& state, Index corner, Index a, Index b) {
    for (Index f = 0; f < state.root_faces.size(); ++f) {
        const auto face = state.root_faces[f];
        const std::size_t n = face.size();
        for (std::size_t i = 0; i < n; ++i) {
            if (face[i] != corner) continue;
            for (Index v : {face[(i + 1) % n], face[(i + n - 1) % n]}) {
                if (v != a && v != b) return v;
            }
        }
    }
    assert(false);
    return kNoIndex;
}

Feature AllCorners(const LimitState& state) {
    Feature all;
    for (Index v = 0; v < state.n_root_vertices; ++v) all.push_back(v);
    return all;
}

}  // namespace

StepInParts StepFromPart(const LimitState& state, Index part, const Coordinates& at) {
    Index face = 0, corner = part;
    while (corner >= static_cast<Index>(state.root_faces[face].size())) {
        corner -= static_cast<Index>(state.root_faces[face].size());
        ++face;
    }
    const auto f = state.root_faces[face];
    Index a = f[static_cast<std::size_t>(corner)], b = f[(static_cast<std::size_t>(corner) + 1) % f.size()];
    const bool is_face = state.root == RootKind::Face;
    // Weights of a and b come last.
    const std::size_t i = is_face ? 0 : 1;
    std::size_t mine = i, other = i + 1;
    if (at[other] > at[mine]) {
        std::swap(a, b);
        std::swap(mine, other);
    }
    StepInParts step;
    step.next = &ChildAt(state, a);
    // Along the path A, middle of AB, (face,) centre these weigh mine - other, 2 other, .., the rest.
    Coordinates x{1 - at[mine] + at[other], 1 - at[mine] - at[other], 0};
    Matrix3 dx{};
    dx[0][mine] = -1;
    dx[0][other] = 1;
    dx[1][mine] = dx[1][other] = -1;
    if (is_face) {
        Enter({Feature{a}, Sorted(std::array{a, b}), Sorted(f), {}}, 3, x, dx, step);
    } else {
        x[2] = 1 - at[0] - at[1] - at[2];
        dx[2] = {-1, -1, -1};
        Enter({Feature{a}, Sorted(std::array{a, b}), Sorted(f), AllCorners(state)}, 4, x, dx, step);
    }
    return step;
}

StepInParts StepFromPath(const LimitState& state, const std::array<Index, 4>& path, const Coordinates& at) {
    const auto [a, m, f, c] = path;
    const auto edge = [](Index v, Index w) { return Sorted(std::array{v, w}); };
    std::size_t n_ones = 0;
    while (n_ones < 3 && at[n_ones] >= 0.5) ++n_ones;
    StepInParts step;
    step.next = &ChildAt(state, path[n_ones]);
    Matrix3 twice{};
    Coordinates x;
    for (std::size_t k = 0; k < 3; ++k) {
        twice[k][k] = 2;
        x[k] = 2 * at[k] - (k < n_ones ? 1 : 0);
    }
    if (n_ones == 0) {
        Enter({Feature{a}, edge(a, m), FaceWith(state, {a, m, f}), AllCorners(state)}, 4, x, twice, step);
    } else if (n_ones == 3) {
        Enter({AllCorners(state), FaceWith(state, {m, f, c}), edge(f, c), Feature{c}}, 4, x, twice, step);
    } else {
        // A hexahedron at a corner of three edges: x, y, z run along them, from 1 where they have reached the corner.
        const Index corner = path[n_ones];
        const std::array<Index, 3> along = n_ones == 1 ? std::array{a, f, OtherNeighbor(state, m, a, f)}
                                                       : std::array{OtherNeighbor(state, f, m, c), m, c};
        const Transition& t = *step.next;
        const Coordinates origin = PositionOf(t, {corner});
        std::array<Coordinates, 3> axes;
        for (std::size_t k = 0; k < 3; ++k) {
            axes[k] = Minus(PositionOf(t, edge(corner, along[k])), origin);
            if (k < n_ones) {
                x[k] = 1 - x[k];
                twice[k][k] = -2;
            }
        }
        SetPlace(origin, axes, x, twice, step);
    }
    return step;
}

}  // namespace SolidSubdiv::Far::Internal

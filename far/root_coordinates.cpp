// SPDX-License-Identifier: Apache-2.0
// Coordinates inside elements.
#include <solidsubdiv/far/internal/root_coordinates.h>

#include <algorithm>
#include <cmath>

#include <solidsubdiv/sdc/cells.h>

namespace SolidSubdiv::Far::Internal {

std::vector<Coordinates> CornersOf(RootKind kind, Index n) {
    switch (kind) {
        case RootKind::Tet:
            return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        case RootKind::Oct:
            return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
        case RootKind::Hex:
            return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
        default:
            if (n == 3) return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
            return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    }
}

double Depth(RootKind kind, Index n, const Coordinates& at) {
    const auto [u, v, w] = at;
    switch (kind) {
        case RootKind::Tet:
            return std::min({u, v, w, 1 - u - v - w});
        case RootKind::Oct:
            return 1 - std::abs(u) - std::abs(v) - std::abs(w);
        case RootKind::Hex:
            return std::min({u, v, w, 1 - u, 1 - v, 1 - w});
        default:
            return n == 3 ? std::min({u, v, 1 - u - v}) : std::min({u, v, 1 - u, 1 - v});
    }
}

std::array<Coordinates, 4> FrameOf(RootKind kind, std::span<const Coordinates> p) {
    const auto minus = [](const Coordinates& a, const Coordinates& b) {
        return Coordinates{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    };
    const Coordinates zero{}, up{0, 0, 1};
    switch (kind) {
        case RootKind::Tet:
            return {p[0], minus(p[1], p[0]), minus(p[2], p[0]), minus(p[3], p[0])};
        case RootKind::Oct: {
            Coordinates c;
            for (std::size_t i = 0; i < 3; ++i) c[i] = (p[0][i] + p[1][i]) / 2;
            return {c, minus(p[0], c), minus(p[2], c), minus(p[4], c)};
        }
        case RootKind::Hex:
            return {p[0], minus(p[1], p[0]), minus(p[3], p[0]), minus(p[4], p[0])};
        default:
            return {p[0], minus(p[1], p[0]), minus(p[p.size() == 3 ? 2 : 3], p[0]), up};
    }
    return {zero, zero, zero, zero};
}

Matrix3 Inverse(const Matrix3& m) {
    Matrix3 inverse;
    const auto minor = [&](std::size_t r, std::size_t c) {
        const std::size_t a = (r + 1) % 3, b = (r + 2) % 3, d = (c + 1) % 3, e = (c + 2) % 3;
        return m[a][d] * m[b][e] - m[a][e] * m[b][d];
    };
    const double det = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) inverse[r][c] = minor(c, r) / det;
    }
    return inverse;
}

CornerWeights WeightsOfCorners(RootKind kind, Index n, const Coordinates& at) {
    const auto [u, v, w] = at;
    switch (kind) {
        case RootKind::Tet:
            return {1 - u - v - w, u, v, w};
        case RootKind::Oct: {
            const double rest = 1 - std::abs(v) - std::abs(w);
            return {(rest + u) / 2,    (rest - u) / 2,   std::max(v, 0.0),
                    std::max(-v, 0.0), std::max(w, 0.0), std::max(-w, 0.0)};
        }
        case RootKind::Hex:
            return {(1 - u) * (1 - v) * (1 - w), u * (1 - v) * (1 - w), u * v * (1 - w), (1 - u) * v * (1 - w),
                    (1 - u) * (1 - v) * w,       u * (1 - v) * w,       u * v * w,       (1 - u) * v * w};
        default:
            if (n == 3) return {1 - u - v, u, v};
            return {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
    }
}

std::vector<Index> NeighborsOf(RootKind kind, Index n, Index corner) {
    std::vector<Index> neighbors;
    const auto add = [&](const auto& edges) {
        for (const auto& e : edges) {
            if (e[0] == corner) neighbors.push_back(e[1]);
            if (e[1] == corner) neighbors.push_back(e[0]);
        }
    };
    switch (kind) {
        case RootKind::Tet:
            add(Sdc::Tet::edges);
            break;
        case RootKind::Oct:
            add(Sdc::Oct::edges);
            // Three that are independent first.
            std::swap(neighbors[1], neighbors[2]);
            break;
        case RootKind::Hex:
            add(Sdc::Hex::edges);
            break;
        default:
            neighbors = {(corner + 1) % n, (corner + n - 1) % n};
    }
    return neighbors;
}

Matrix3 Multiply(const Matrix3& second, const Matrix3& first) {
    Matrix3 product{};
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t k = 0; k < 3; ++k) product[r][c] += second[r][k] * first[k][c];
        }
    }
    return product;
}

}  // namespace SolidSubdiv::Far::Internal

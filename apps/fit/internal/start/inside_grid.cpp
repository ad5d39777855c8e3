// SPDX-License-Identifier: Apache-2.0
// Triangles are drawn into columns of voxels; a sweep along each column counts what was crossed; sums of boxes.
#include <solidsubdiv/apps/fit/internal/start/inside_grid.h>

#include <algorithm>
#include <tuple>

#include <solidsubdiv/kit/geometry/box.h>

namespace SolidSubdiv::Fit::Starting {

struct InsideGrid::Crossing {
    int column;
    double height;
    int sign;

    friend bool operator<(const Crossing& a, const Crossing& b) {
        return std::tie(a.column, a.height, a.sign) < std::tie(b.column, b.height, b.sign);
    }
};

namespace {

struct Point2 {
    double u, v;
    friend bool operator<(const Point2& a, const Point2& b) { return std::tie(a.u, a.v) < std::tie(b.u, b.v); }
};

/// Whether p lies left of the line from a to b. The two triangles at an edge compute the same and take one side each,
/// so that no ray slips through between them.
bool IsLeft(const Point2& a, const Point2& b, const Point2& p) {
    const bool is_swapped = b < a;
    const Point2 &s = is_swapped ? b : a, &e = is_swapped ? a : b;
    const bool is_left = (e.u - s.u) * (p.v - s.v) - (e.v - s.v) * (p.u - s.u) >= 0;
    return is_left != is_swapped;
}

}  // namespace

InsideGrid::InsideGrid(std::span<const double> positions, std::span<const Index> triangles, int n_voxels,
                       bool by_parity)
    : width_(1.0 / n_voxels) {
    const Geometry::Box box = Geometry::BoundingBox(positions);
    for (std::size_t k = 0; k < 3; ++k) n_[k] = static_cast<int>(box.Extent(static_cast<int>(k)) * n_voxels) + 3;
    origin_ = Vec3{.5 * (box.low[0] + box.high[0]), .5 * (box.low[1] + box.high[1]), .5 * (box.low[2] + box.high[2])} -
              .5 * width_ * Vec3{1. * n_[0], 1. * n_[1], 1. * n_[2]};
    inside_.assign(At(0, 0, n_[2]), 0);
    for (std::size_t axis = 0; axis < 3; ++axis) VoteAlong(axis, positions, triangles, by_parity, inside_);
    sums_.assign(
        static_cast<std::size_t>(n_[0] + 1) * static_cast<std::size_t>(n_[1] + 1) * static_cast<std::size_t>(n_[2] + 1),
        0);
    std::array<int, 3> low = n_, high{};
    std::size_t place = 0;
    for (int z = 0; z <= n_[2]; ++z) {
        for (int y = 0; y <= n_[1]; ++y) {
            for (int x = 0; x <= n_[0]; ++x, ++place) {
                if (x == 0 || y == 0 || z == 0) continue;
                std::uint8_t& votes = inside_[At(x - 1, y - 1, z - 1)];
                votes = votes >= 2;
                sums_[place] = votes + Sum(x - 1, y, z) + Sum(x, y - 1, z) + Sum(x, y, z - 1) - Sum(x - 1, y - 1, z) -
                               Sum(x - 1, y, z - 1) - Sum(x, y - 1, z - 1) + Sum(x - 1, y - 1, z - 1);
                if (votes == 0) continue;
                const std::array<int, 3> here{x, y, z};
                for (std::size_t k = 0; k < 3; ++k) {
                    low[k] = std::min(low[k], here[k] - 1);
                    high[k] = std::max(high[k], here[k]);
                }
            }
        }
    }
    low_ = origin_ + width_ * Vec3{1. * low[0], 1. * low[1], 1. * low[2]};
    high_ = origin_ + width_ * Vec3{1. * high[0], 1. * high[1], 1. * high[2]};
}

void InsideGrid::VoteAlong(std::size_t axis, std::span<const double> positions, std::span<const Index> triangles,
                           bool by_parity, std::vector<std::uint8_t>& votes) const {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::vector<Crossing> crossings;
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
        std::array<Vec3, 3> p;  // in units of voxels; middles of voxels are at whole numbers
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = 1 / width_ * (PointAt(positions, triangles[t + k]) - origin_) - Vec3{.5, .5, .5};
        }
        const Point2 a{p[0][u], p[0][v]}, b{p[1][u], p[1][v]}, c{p[2][u], p[2][v]};
        const double area = (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
        if (area == 0) continue;
        const auto [u_low, u_high] = std::minmax({a.u, b.u, c.u});
        const auto [v_low, v_high] = std::minmax({a.v, b.v, c.v});
        for (int i = static_cast<int>(std::ceil(u_low)); i <= u_high; ++i) {
            for (int j = static_cast<int>(std::ceil(v_low)); j <= v_high; ++j) {
                const Point2 at{1. * i, 1. * j};
                const bool ab = IsLeft(a, b, at);
                if (ab != IsLeft(b, c, at) || ab != IsLeft(c, a, at)) continue;
                const double wb = ((at.u - a.u) * (c.v - a.v) - (at.v - a.v) * (c.u - a.u)) / area;
                const double wc = ((b.u - a.u) * (at.v - a.v) - (b.v - a.v) * (at.u - a.u)) / area;
                const double height = p[0][axis] + wb * (p[1][axis] - p[0][axis]) + wc * (p[2][axis] - p[0][axis]);
                crossings.push_back({i + n_[u] * j, height, ab ? -1 : 1});
            }
        }
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t first = 0, last; first < crossings.size(); first = last) {
        for (last = first; last < crossings.size() && crossings[last].column == crossings[first].column;) ++last;
        int winding = 0;
        std::size_t next = first;
        std::array<int, 3> at{};
        at[u] = crossings[first].column % n_[u];
        at[v] = crossings[first].column / n_[u];
        for (int& i = at[axis]; i < n_[axis]; ++i) {
            for (; next < last && crossings[next].height <= i; ++next) {
                winding = by_parity ? 1 - winding : winding + crossings[next].sign;
            }
            votes[At(at[0], at[1], at[2])] += winding != 0;
        }
    }
}

double InsideGrid::Fraction(const Vec3& low, const Vec3& high) const {
    std::array<std::array<int, 2>, 3> range{};
    double n_all = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        const double from = std::round((low[k] - origin_[k]) / width_),
                     to = std::round((high[k] - origin_[k]) / width_);
        n_all *= std::max(1., to - from);
        range[k] = {static_cast<int>(std::clamp(from, 0., 1. * n_[k])),
                    static_cast<int>(std::clamp(to, 0., 1. * n_[k]))};
    }
    std::int32_t n = 0;
    for (std::size_t c = 0; c < 8; ++c) {
        const std::size_t i = c & 1, j = c >> 1 & 1, k = c >> 2;
        n += ((i + j + k) % 2 != 0 ? 1 : -1) * Sum(range[0][i], range[1][j], range[2][k]);
    }
    return n / n_all;
}

double InsideGrid::Volume() const { return sums_.back() * width_ * width_ * width_; }

std::vector<double> InsideGrid::SurfacePoints(std::size_t n) const {
    std::vector<double> all, some;
    for (int z = 0; z < n_[2]; ++z) {
        for (int y = 0; y < n_[1]; ++y) {
            for (int x = 0; x < n_[0]; ++x) {
                const auto is_inside = [&](int i, int j, int k) {
                    return i >= 0 && j >= 0 && k >= 0 && i < n_[0] && j < n_[1] && k < n_[2] &&
                           inside_[At(i, j, k)] != 0;
                };
                if (!is_inside(x, y, z)) continue;
                if (is_inside(x - 1, y, z) && is_inside(x + 1, y, z) && is_inside(x, y - 1, z) &&
                    is_inside(x, y + 1, z) && is_inside(x, y, z - 1) && is_inside(x, y, z + 1)) {
                    continue;
                }
                const Vec3 p = MiddleOf(x, y, z);
                all.insert(all.end(), {p.x, p.y, p.z});
            }
        }
    }
    const std::size_t n_all = all.size() / 3;
    for (std::size_t i = 0; i < std::min(n, n_all); ++i) {
        const double* const p = &all[3 * (i * n_all / std::min(n, n_all))];
        some.insert(some.end(), p, p + 3);
    }
    return some;
}

}  // namespace SolidSubdiv::Fit::Starting

// SPDX-License-Identifier: Apache-2.0
// Blocks of points, coordinate by coordinate, so that the inner loops are short and plain.
#include <solidsubdiv/kit/geometry/internal/extremes.h>

#include <limits>
#include <tuple>

#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Geometry::Internal {

namespace {

constexpr std::size_t kBlock = 512;  // points whose coordinates stay in the first cache
constexpr std::size_t kBlocksATask = 32;

bool Precedes(const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

void Greater(double value, const Vec3& point, double& greatest, Vec3& at) {
    if (value < greatest || (value == greatest && !Precedes(point, at))) return;
    greatest = value;
    at = point;
}
void Less(double value, const Vec3& point, double& least, Vec3& at) {
    if (value > least || (value == least && !Precedes(point, at))) return;
    least = value;
    at = point;
}

struct Block {
    std::array<double, kBlock> x, y, z, values;

    void Load(std::span<const double> points, std::size_t n, const Vec3& origin) {
        for (std::size_t i = 0; i < n; ++i) {
            x[i] = points[3 * i] - origin.x;
            y[i] = points[3 * i + 1] - origin.y;
            z[i] = points[3 * i + 2] - origin.z;
        }
    }
    void Update(std::span<const double> points, std::size_t n, const Vec3& direction, Extremes& extremes) {
        double least = std::numeric_limits<double>::infinity(), greatest = -least;
        for (std::size_t i = 0; i < n; ++i) {
            values[i] = direction.x * x[i] + direction.y * y[i] + direction.z * z[i];
            least = values[i] < least ? values[i] : least;
            greatest = values[i] > greatest ? values[i] : greatest;
        }
        if (greatest < extremes.greatest && least > extremes.least) return;
        for (std::size_t i = 0; i < n; ++i) {
            if (values[i] != least && values[i] != greatest) continue;
            const Vec3 point = PointAt(points, static_cast<Index>(i));
            Greater(values[i], point, extremes.greatest, extremes.at_greatest);
            Less(values[i], point, extremes.least, extremes.at_least);
        }
    }
};

}  // namespace

std::vector<Extremes> FindExtremes(std::span<const double> points, const Vec3& origin,
                                   std::span<const Vec3> directions) {
    const std::size_t n_points = points.size() / 3, task = kBlock * kBlocksATask;
    const std::size_t n_tasks = (n_points + task - 1) / task;
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    std::vector<std::vector<Extremes>> found(n_tasks,
                                             std::vector<Extremes>(directions.size(), {kInfinity, -kInfinity, {}, {}}));
    Sdc::ParallelFor(static_cast<Offset>(n_tasks), 1, [&](Offset begin, Offset end) {
        Block block;
        for (Offset t = begin; t < end; ++t) {
            const std::size_t first = static_cast<std::size_t>(t) * task, last = std::min(first + task, n_points);
            for (std::size_t i = first; i < last; i += kBlock) {
                const std::size_t n = std::min(kBlock, last - i);
                const auto some = points.subspan(3 * i, 3 * n);
                block.Load(some, n, origin);
                for (std::size_t d = 0; d < directions.size(); ++d) {
                    block.Update(some, n, directions[d], found[static_cast<std::size_t>(t)][d]);
                }
            }
        }
    });
    std::vector<Extremes> all = std::move(found[0]);
    for (std::size_t t = 1; t < n_tasks; ++t) {
        for (std::size_t d = 0; d < all.size(); ++d) {
            const Extremes& its = found[t][d];
            Greater(its.greatest, its.at_greatest, all[d].greatest, all[d].at_greatest);
            Less(its.least, its.at_least, all[d].least, all[d].at_least);
        }
    }
    return all;
}

}  // namespace SolidSubdiv::Geometry::Internal

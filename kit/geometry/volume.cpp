// SPDX-License-Identifier: Apache-2.0
// Values between voxels, and where voxels lie.
#include <solidsubdiv/kit/geometry/volume.h>

#include <algorithm>
#include <cmath>

#include <solidsubdiv/kit/geometry/internal/vec3.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Geometry {

namespace {

using Internal::Cross;
using Internal::Det;
using Internal::Dot;
using Internal::Length;
using Internal::Vec3;

Vec3 Column(const AffineMap& map, std::size_t k) { return {map[k], map[4 + k], map[8 + k]}; }

}  // namespace

std::array<double, 3> Apply(const AffineMap& map, const std::array<double, 3>& point) {
    std::array<double, 3> image;
    for (std::size_t r = 0; r < 3; ++r) {
        const double* row = map.data() + 4 * r;
        image[r] = row[0] * point[0] + row[1] * point[1] + row[2] * point[2] + row[3];
    }
    return image;
}

bool IsSingular(const AffineMap& map) {
    if (!std::all_of(map.begin(), map.end(), [](double x) { return std::isfinite(x); })) return true;
    const Vec3 a = Column(map, 0), b = Column(map, 1), c = Column(map, 2);
    const double determinant = Det(a, b, c);
    const double relative = determinant / Length(a) / Length(b) / Length(c);
    return !std::isnormal(determinant) || !(std::abs(relative) > 1e-6);
}

AffineMap Inverse(const AffineMap& map) {
    if (IsSingular(map)) throw InvalidInput("the map of voxels to the world flattens space; it has no inverse");
    const Vec3 a = Column(map, 0), b = Column(map, 1), c = Column(map, 2), origin = Column(map, 3);
    const double determinant = Det(a, b, c);
    const std::array<Vec3, 3> rows = {Cross(b, c), Cross(c, a), Cross(a, b)};
    AffineMap inverse;
    for (std::size_t r = 0; r < 3; ++r) {
        const Vec3 row = (1 / determinant) * rows[r];
        const double numbers[] = {row.x, row.y, row.z, -Dot(row, origin)};
        std::copy_n(numbers, 4, inverse.begin() + static_cast<std::ptrdiff_t>(4 * r));
    }
    return inverse;
}

std::array<double, 3> Volume::Spacing() const {
    return {Length(Column(voxel_to_world, 0)), Length(Column(voxel_to_world, 1)), Length(Column(voxel_to_world, 2))};
}

double Volume::Value(const std::array<double, 3>& voxel) const {
    std::array<Offset, 3> low, high;
    std::array<double, 3> t;
    for (std::size_t k = 0; k < 3; ++k) {
        const double x = std::clamp(voxel[k], 0.0, static_cast<double>(dims[k] - 1));
        low[k] = static_cast<Offset>(x);
        high[k] = std::min(low[k] + 1, dims[k] - 1);
        t[k] = x - static_cast<double>(low[k]);
    }
    const auto along = [](double a, double b, double s) { return a + s * (b - a); };
    const auto on_row = [&](Offset j, Offset k) { return along(At(low[0], j, k), At(high[0], j, k), t[0]); };
    const auto on_slice = [&](Offset k) { return along(on_row(low[1], k), on_row(high[1], k), t[1]); };
    return along(on_slice(low[2]), on_slice(high[2]), t[2]);
}

Box BoundingBox(const Volume& volume) {
    Box box;
    if (volume.n_voxels() == 0) return box;
    for (unsigned corner = 0; corner < 8; ++corner) {
        std::array<double, 3> voxel{};
        for (unsigned k = 0; k < 3; ++k) {
            if (corner >> k & 1) voxel[k] = static_cast<double>(volume.dims[k] - 1);
        }
        box.Include(volume.ToWorld(voxel));
    }
    return box;
}

std::vector<double> LabelsOf(const Volume& volume) {
    // Neighbours mostly have one label: of each run one value is sorted.
    std::vector<double> labels;
    for (const double value : volume.values) {
        if (value != std::floor(value)) return {};
        if (labels.empty() || labels.back() != value) labels.push_back(value);
    }
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
    return labels;
}

}  // namespace SolidSubdiv::Geometry

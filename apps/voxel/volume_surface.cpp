// SPDX-License-Identifier: Apache-2.0
// Values smoothed, small pieces taken away, and the contour put in the world.
#include <solidsubdiv/apps/voxel/volume_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <sstream>
#include <string>

#include <solidsubdiv/apps/voxel/internal/tet_contour.h>
#include <solidsubdiv/sdc/errors.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Voxel {

namespace {

using Internal::SignedGrid;

std::string TextOf(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

/// Weights at distances 0, 1, ... up to three standard deviations; with both sides they sum to 1.
std::vector<double> GaussianWeights(double deviation) {
    std::vector<double> weights;
    for (int d = 0; d <= static_cast<int>(std::ceil(3 * deviation)); ++d) {
        weights.push_back(std::exp(-0.5 * d * d / (deviation * deviation)));
    }
    const double sum = 2 * std::accumulate(weights.begin(), weights.end(), 0.0) - weights[0];
    for (double& w : weights) w /= sum;
    return weights;
}

/// Along the three axes one after another; beyond the border the last value goes on.
void Smooth(std::vector<double>& values, const std::array<Offset, 3>& dims, double deviation) {
    if (!(deviation > 0)) return;
    const std::vector<double> weights = GaussianWeights(deviation);
    Offset stride = 1;
    for (const Offset n : dims) {
        const Offset n_lines = static_cast<Offset>(values.size()) / n;
        Sdc::ParallelFor(n_lines, 64, [&](Offset begin, Offset end) {
            std::vector<double> line(static_cast<std::size_t>(n));
            for (Offset l = begin; l < end; ++l) {
                const Offset start = l / stride * stride * n + l % stride;
                const auto at = [&](Offset i) -> double& {
                    return values[static_cast<std::size_t>(start + i * stride)];
                };
                for (Offset i = 0; i < n; ++i) line[static_cast<std::size_t>(i)] = at(i);
                for (Offset i = 0; i < n; ++i) {
                    double sum = weights[0] * line[static_cast<std::size_t>(i)];
                    for (std::size_t d = 1; d < weights.size(); ++d) {
                        const Offset low = std::max<Offset>(0, i - static_cast<Offset>(d));
                        const Offset high = std::min(n - 1, i + static_cast<Offset>(d));
                        sum +=
                            weights[d] * (line[static_cast<std::size_t>(low)] + line[static_cast<std::size_t>(high)]);
                    }
                    at(i) = sum;
                }
            }
        });
        stride *= n;
    }
}

/// The level that as many values reach as there are voxels of the label: between the last of them and the next.
double LevelOfCount(std::vector<double> values, std::size_t count) {
    if (count >= values.size()) return 0.5;  // all voxels: smoothing left each 1
    const auto next = values.begin() + static_cast<std::ptrdiff_t>(count);
    std::nth_element(values.begin(), next, values.end(), std::greater<>());
    const double last = *std::min_element(values.begin(), next);
    return 0.5 * (last + *next);
}

/// Values less the level, with a layer around them that puts the surface on the outer faces of voxels at the border.
SignedGrid PaddedGrid(const std::vector<double>& values, const std::array<Offset, 3>& dims, double level,
                      bool& touches_border) {
    SignedGrid grid{.dims = {dims[0] + 2, dims[1] + 2, dims[2] + 2}, .values = {}};
    grid.values.resize(static_cast<std::size_t>(grid.dims[0] * grid.dims[1] * grid.dims[2]));
    touches_border = false;
    for (Offset k = 0; k < grid.dims[2]; ++k) {
        for (Offset j = 0; j < grid.dims[1]; ++j) {
            for (Offset i = 0; i < grid.dims[0]; ++i) {
                const std::array<Offset, 3> in = {std::clamp<Offset>(i - 1, 0, dims[0] - 1),
                                                  std::clamp<Offset>(j - 1, 0, dims[1] - 1),
                                                  std::clamp<Offset>(k - 1, 0, dims[2] - 1)};
                const double value =
                    values[static_cast<std::size_t>(in[0] + dims[0] * (in[1] + dims[1] * in[2]))] - level;
                const bool is_beyond = in != std::array{i - 1, j - 1, k - 1};
                if (is_beyond && value >= 0) touches_border = true;
                // A value of 0 has no mirror image that is outside.
                grid.values[grid.At(i, j, k)] = is_beyond ? -std::max(std::abs(value), 1e-300) : value;
            }
        }
    }
    return grid;
}

/// Turns pieces and cavities of few points to the other side.
void DropSmall(SignedGrid& grid, double least_piece, VolumeSurface& made) {
    const Internal::Pieces pieces = Internal::PiecesOf(grid);
    Offset largest = 0;
    for (std::size_t p = 0; p < pieces.sizes.size(); ++p) {
        if (pieces.is_inside[p]) largest = std::max(largest, pieces.sizes[p]);
    }
    const auto outside = static_cast<std::size_t>(pieces.of_point[0]);  // a corner of the layer around
    std::vector<bool> is_small(pieces.sizes.size());
    for (std::size_t p = 0; p < is_small.size(); ++p) {
        is_small[p] = p != outside && static_cast<double>(pieces.sizes[p]) < least_piece * static_cast<double>(largest);
        if (pieces.is_inside[p]) ++(is_small[p] ? made.n_dropped_pieces : made.n_pieces);
        if (!pieces.is_inside[p] && is_small[p]) ++made.n_filled_cavities;
    }
    for (std::size_t at = 0; at < grid.values.size(); ++at) {
        const auto p = static_cast<std::size_t>(pieces.of_point[at]);
        if (!is_small[p]) continue;
        grid.values[at] = pieces.is_inside[p] ? -std::max(grid.values[at], 1e-300) : -grid.values[at];
    }
}

VolumeSurface SurfaceOf(const Geometry::Volume& volume, const std::vector<double>& values, double level,
                        double least_piece) {
    VolumeSurface made;
    SignedGrid grid = PaddedGrid(values, volume.dims, level, made.touches_border);
    DropSmall(grid, least_piece, made);
    Internal::Contour contour = Internal::ContourOf(grid);
    for (std::size_t i = 0; i < contour.positions.size(); i += 3) {
        double* const p = &contour.positions[i];
        const auto world = volume.ToWorld({p[0] - 1, p[1] - 1, p[2] - 1});
        std::copy(world.begin(), world.end(), p);
    }
    const Geometry::AffineMap& m = volume.voxel_to_world;
    const double det =
        m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) + m[2] * (m[4] * m[9] - m[5] * m[8]);
    if (det < 0) {
        for (std::size_t t = 0; t < contour.triangles.size(); t += 3) {
            std::swap(contour.triangles[t + 1], contour.triangles[t + 2]);
        }
    }
    made.positions = std::move(contour.positions);
    made.triangles = std::move(contour.triangles);
    return made;
}

}  // namespace

void VolumeSurfaceOptions::Validate() const {
    if (!(smooth >= 0 && smooth <= 16)) throw InvalidInput("smooth is " + TextOf(smooth) + "; it must be in [0, 16]");
    if (!(least_piece >= 0 && least_piece <= 1)) {
        throw InvalidInput("least_piece is " + TextOf(least_piece) + "; it must be in [0, 1]");
    }
}

VolumeSurface SurfaceOfLevel(const Geometry::Volume& volume, double level, const VolumeSurfaceOptions& options) {
    options.Validate();
    std::vector<double> values = volume.values;
    Smooth(values, volume.dims, options.smooth);
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    if (!(level > *least && level <= *greatest)) {
        throw InvalidInput("level " + TextOf(level) + " bounds nothing: values are from " + TextOf(*least) + " to " +
                           TextOf(*greatest) + (options.smooth > 0 ? " when smoothed" : ""));
    }
    return SurfaceOf(volume, values, level, options.least_piece);
}

VolumeSurface SurfaceOfLabel(const Geometry::Volume& volume, double label, const VolumeSurfaceOptions& options) {
    options.Validate();
    std::vector<double> mask(volume.values.size());
    std::transform(volume.values.begin(), volume.values.end(), mask.begin(),
                   [label](double v) { return v == label ? 1.0 : 0.0; });
    const auto count = static_cast<std::size_t>(std::count(mask.begin(), mask.end(), 1.0));
    if (count == 0) {
        constexpr std::size_t kNamed = 20;
        const std::vector<double> labels = Geometry::LabelsOf(volume);
        std::string named;
        for (std::size_t i = 0; i < std::min(labels.size(), kNamed); ++i)
            named += (i > 0 ? ", " : "") + TextOf(labels[i]);
        if (labels.size() > kNamed) named += ", ...";
        throw InvalidInput("has no voxel of label " + TextOf(label) +
                           (labels.empty() ? "; its values are no whole numbers" : "; its labels are " + named));
    }
    Smooth(mask, volume.dims, options.smooth);
    const double level = options.smooth > 0 ? LevelOfCount(mask, count) : 0.5;
    return SurfaceOf(volume, mask, level, options.least_piece);
}

double OtsuThreshold(std::span<const double> values) {
    if (values.empty()) throw InvalidInput("there are no values to find a level of");
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    if (!(*least < *greatest))
        throw InvalidInput("all values are " + TextOf(*least) + ": there is no level between them");
    constexpr std::size_t kSteps = 256;
    std::array<double, kSteps> counts{};
    const double width = (*greatest - *least) / kSteps;
    for (double v : values) {
        counts[std::min(kSteps - 1, static_cast<std::size_t>((v - *least) / width))] += 1;
    }
    double whole = 0, moment = 0;
    for (std::size_t s = 0; s < kSteps; ++s) whole += counts[s], moment += counts[s] * static_cast<double>(s);
    double below = 0, moment_below = 0, best = -1;
    std::size_t best_step = 0;
    for (std::size_t s = 0; s + 1 < kSteps; ++s) {
        below += counts[s], moment_below += counts[s] * static_cast<double>(s);
        const double above = whole - below;
        if (!(below > 0 && above > 0)) continue;
        const double apart = moment_below / below - (moment - moment_below) / above;
        if (below * above * apart * apart > best) best = below * above * apart * apart, best_step = s;
    }
    return *least + width * static_cast<double>(best_step + 1);
}

}  // namespace SolidSubdiv::Voxel

// SPDX-License-Identifier: Apache-2.0
// Validator ffd-regular: on a block of hexahedra deformation is a tricubic B-spline.
#include "ffd_regular.h"

#include <algorithm>
#include <cmath>

#include <solidsubdiv/apps/deform/deformer.h>

#include "points.h"
#include "solid_shapes.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

using Steps = ControlBlock::Steps;
using Point = ControlBlock::Point;

constexpr int kPlaces = 500;

std::vector<double> Flat(const std::vector<Point>& points) {
    std::vector<double> flat;
    for (const Point& p : points) flat.insert(flat.end(), p.begin(), p.end());
    return flat;
}

template <class Evaluate>
void Compare(const DeformedBlock& block, std::span<const double> deformed, Findings& findings, Evaluate&& evaluate) {
    if (deformed.size() != 3 * block.places.size()) {
        findings.Fault("another number of points");
        return;
    }
    const double size = SizeOf(block.moved_control);
    for (std::size_t i = 0; i < block.places.size(); ++i) {
        const Point expected = evaluate(block.places[i]);
        const double error = std::hypot(deformed[3 * i] - expected[0], deformed[3 * i + 1] - expected[1],
                                        deformed[3 * i + 2] - expected[2]);
        findings.Error(error / size, [&] { return "point " + std::to_string(i); });
    }
}

}  // namespace

DeformedBlock::DeformedBlock(std::array<int, 3> n, std::uint32_t seed) {
    Shaker shaker(seed);
    // Of size 1, and sheared, but not so much that it is nearly flat.
    std::array<Point, 3> axes{};
    Point origin{};
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t c = 0; c < 3; ++c) axes[k][c] = ((k == c) + 0.3 * shaker.Next()) / n[k];
        origin[k] = shaker.Next();
    }
    const auto at_rest = [&](const Point& u) {
        Point p = origin;
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t c = 0; c < 3; ++c) p[c] += u[k] * axes[k][c];
        }
        return p;
    };
    rest.n = moved.n = n;
    Steps at;
    for (at[2] = 0; at[2] <= n[2]; ++at[2]) {
        for (at[1] = 0; at[1] <= n[1]; ++at[1]) {
            for (at[0] = 0; at[0] <= n[0]; ++at[0]) {
                Point p = at_rest({static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2])});
                rest.points.push_back(p);
                for (double& c : p) c += 0.5 * shaker.Next() / std::max({n[0], n[1], n[2]});
                moved.points.push_back(p);
                if (at[0] == n[0] || at[1] == n[1] || at[2] == n[2]) continue;
                for (int top : {0, 1}) {
                    for (const auto& [x, y] : {std::pair{0, 0}, std::pair{1, 0}, std::pair{1, 1}, std::pair{0, 1}}) {
                        hexes.push_back(static_cast<Index>(rest.NumberOf({at[0] + x, at[1] + y, at[2] + top})));
                    }
                }
            }
        }
    }
    control = Flat(rest.points);
    moved_control = Flat(moved.points);
    for (int i = 0; i < kPlaces; ++i) {
        Point u;
        for (std::size_t k = 0; k < 3; ++k) {
            u[k] = n[k] * (0.5 + 0.5 * shaker.Next());
            if (shaker.Below(3) == 0) u[k] = std::round(u[k]);  // on a side or between hexahedra
        }
        places.push_back(u);
        const Point p = at_rest(u);
        points.insert(points.end(), p.begin(), p.end());
    }
}

Far::TopologyDescriptor DeformedBlock::View() const {
    return {.n_vertices = static_cast<Index>(rest.points.size()), .hexes = hexes};
}

std::vector<double> DeformPoints(const DeformedBlock& block, const Deform::EmbedOptions& options) {
    const auto embedding = Deform::Embedding::Create(block.View(), block.control, block.points, options);
    std::vector<double> deformed(block.points.size());
    Deform::Deformer(embedding).Deform(block.moved_control, deformed);
    return deformed;
}

void CompareWithSpline(const DeformedBlock& block, std::span<const double> deformed, Findings& findings) {
    Compare(block, deformed, findings, [&](const Point& u) { return SplineAt(block.moved, u); });
}

void CompareWithPieces(const DeformedBlock& block, int level, std::span<const double> deformed, Findings& findings) {
    ControlBlock fine = block.moved;
    for (int l = 0; l < level; ++l) fine = InsertKnots(fine);
    Compare(block, deformed, findings, [&](Point u) {
        for (double& x : u) x = std::ldexp(x, level);
        return TrilinearAt(fine, u);
    });
}

Findings ValidateFfdRegular(const Context&) {
    constexpr int kLevels = 3;
    Findings findings;
    std::uint32_t seed = 0;
    for (const Steps& n : {Steps{1, 1, 1}, Steps{2, 1, 3}, Steps{4, 5, 3}}) {
        const DeformedBlock block(n, ++seed);
        for (const Sdc::Scheme& scheme : {Sdc::Scheme(Sdc::CatmullClarkSolid{}), Sdc::Scheme(Sdc::Mlca{})}) {
            for (int level = 0; level <= kLevels; ++level) {
                const std::string name = std::string(Sdc::NameOf(scheme)) + ", " +
                                         std::to_string(block.hexes.size() / 8) + " hexahedra, level " +
                                         std::to_string(level);
                const Deform::EmbedOptions options{
                    .scheme = scheme, .levels = level, .outside = Deform::Outside::Clamp};
                Deform::EmbedOptions in_limit = options;
                in_limit.limit = true;
                Findings pieces, spline;
                CompareWithPieces(block, level, DeformPoints(block, options), pieces);
                findings.Merge(pieces, name);
                CompareWithSpline(block, DeformPoints(block, in_limit), spline);
                findings.Merge(spline, name + ", limit");
            }
        }
    }
    findings.notes.push_back("affine blocks of 1, 6 and 60 hexahedra, 500 points in each, levels 0-3 and limits");
    return findings;
}

}  // namespace SolidSubdiv::Validation

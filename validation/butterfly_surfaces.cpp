// SPDX-License-Identifier: Apache-2.0
// Validators of the butterflies: against an independent program, OpenMesh and VTK, and on the boundary of solids.
#include <array>

#include <solidsubdiv/kit/io/formats.h>

#include "butterfly_oracle.h"
#include "meshes.h"
#include "open_mesh_oracle.h"
#include "sharp_features.h"
#include "solid_shapes.h"
#include "surface_compare.h"
#include "surface_shapes.h"
#include "validators.h"
#include "vtk_butterfly_oracle.h"

namespace SolidSubdiv::Validation {

namespace {

/// One of our schemes and the rule that it must follow.
struct Pair {
    std::string name;
    Sdc::Scheme scheme;
    ButterflyRule rule;
};

std::vector<Pair> SurfaceSchemes() {
    Sdc::Butterfly plain, loose;
    loose.tension = 0.04;
    Sdc::ModifiedButterfly modified, ten_points;
    ten_points.far_weight = 0.02;
    std::vector<Pair> pairs{{"butterfly", plain, ButterflyRule::Plain()},
                            {"butterfly of tension 0.04", loose, ButterflyRule::Plain(0.04)},
                            {"modified butterfly", modified, ButterflyRule::Modified()},
                            {"modified butterfly of tension 0.02", ten_points, ButterflyRule::Modified(0.02)}};
    pairs[1].rule.curve_tension = 0.04;                              // one tension for surfaces and their borders
    for (Pair& pair : pairs) pair.rule.has_regular_corners = false;  // docs/decisions/0009
    return pairs;
}

Findings Compare(const Far::TopologyDescriptor& mesh, const Pair& pair, const std::vector<Triangle>& triangles,
                 std::span<const double> positions, const SurfaceTags& tags, const ComparedLevels& levels,
                 const std::optional<SurfaceTags>& oracle_tags = {}) {
    const TaggedMesh tagged(mesh, tags);
    auto refiner = Far::TopologyRefiner::Create(tagged.descriptor, Sdc::Split::TetOct);
    refiner.RefineUniform({.max_level = levels.positions});
    const SurfaceOfMesh start = TakeSurface(triangles, positions, oracle_tags.value_or(tags));
    const auto oracle = RefineByButterflyOracle(start.surface, pair.rule, levels.positions, levels.rows);
    return CompareWithLevels(refiner, pair.scheme, positions, start, oracle.levels, levels.rows);
}

Far::TopologyDescriptor Describe(const SurfaceShape& shape, std::vector<Index>& corners) {
    for (const Triangle& t : shape.triangles) corners.insert(corners.end(), t.begin(), t.end());
    return {.n_vertices = static_cast<Index>(shape.positions.size() / 3), .triangles = corners};
}

}  // namespace

Findings ValidateButterflySurfaces(const Context& context) {
    Findings findings;
    const std::vector<SurfaceShape> shapes = AllSurfaces();
    std::uint32_t seed = 0;
    for (const SurfaceShape& shape : shapes) {
        std::vector<Index> corners;
        const Far::TopologyDescriptor mesh = Describe(shape, corners);
        const SurfaceTags tags = RandomTags(shape.triangles, ++seed, true);
        for (const Pair& pair : SurfaceSchemes()) {
            for (const bool has_tags : {false, true}) {
                findings.Merge(Compare(mesh, pair, shape.triangles, shape.positions, has_tags ? tags : SurfaceTags{},
                                       ComparedLevels{4, has_tags ? 1 : 3}.AtMostTwoIf(context.is_quick)),
                               shape.name + ", " + pair.name + (has_tags ? ", tags" : ""));
            }
        }
    }
    findings.notes.push_back(std::to_string(shapes.size()) +
                             " surfaces, each under four schemes without and with "
                             "random creases and corners");
    return findings;
}

Findings ValidateButterflyBoundary(const Context& context) {
    Findings findings;
    const std::vector<SolidShape> shapes = SolidsOfEveryKind(context.shapes);
    Sdc::Interpolatory modified, plain;
    plain.boundary = Sdc::ButterflyKind::Plain;
    std::array pairs{Pair{"modified butterfly", modified, ButterflyRule::Modified()},
                     Pair{"butterfly", plain, ButterflyRule::Plain()}};
    for (Pair& pair : pairs) pair.rule.has_regular_corners = false;
    std::uint32_t seed = 300;
    for (const SolidShape& shape : shapes) {
        const CellArrays cells(shape.complex);
        const std::vector<Triangle> triangles = BoundaryTriangles(shape.complex);
        const SurfaceTags features = SharpFeaturesOf(shape.complex), tags = RandomTags(triangles, ++seed, true);
        for (Pair pair : pairs) {
            const auto compare = [&](const char* how, const SurfaceTags& ours, const SurfaceTags& theirs,
                                     const ComparedLevels& levels) {
                findings.Merge(Compare(cells.Descriptor(shape.n_vertices()), pair, triangles, shape.positions, ours,
                                       levels.AtMostTwoIf(context.is_quick), theirs),
                               shape.name + ", " + pair.name + how);
            };
            compare("", {}, {}, {3, 2});
            compare(", tags", tags, tags, {2, 1});
            std::get<Sdc::Interpolatory>(pair.scheme).features = Sdc::Features::Sharp;
            compare(", sharp", {}, features, {2, 1});
            compare(", sharp, tags", tags, Merged(tags, features), {2, 1});
        }
    }
    findings.notes.push_back(std::to_string(shapes.size()) +
                             " solids, levels 1-3 plain, 1-2 with sharp features and random creases and corners");
    return findings;
}

Findings ValidateButterflyPrograms(const Context& context) {
    constexpr int kLevels = 3;
    Findings findings;
    std::vector<SurfaceShape> shapes;
    std::vector<SurfaceOfMesh> starts;
    std::vector<ControlSurface> surfaces;
    for (const SolidShape& solid : ManifoldShapes()) {
        shapes.push_back({"boundary of " + solid.name, BoundaryTriangles(solid.complex), solid.positions});
        starts.push_back(TakeSurface(shapes.back().triangles, solid.positions));
        surfaces.push_back(starts.back().surface);
    }
    const auto compare = [&](std::size_t s, const std::vector<SurfaceLevel>& levels, const std::string& program) {
        std::vector<Index> corners;
        auto refiner = Far::TopologyRefiner::Create(Describe(shapes[s], corners), Sdc::Split::TetOct);
        refiner.RefineUniform({.max_level = static_cast<int>(levels.size()) - 1});
        findings.Merge(CompareWithLevels(refiner, Sdc::ModifiedButterfly{}, shapes[s].positions, starts[s], levels, 0),
                       shapes[s].name + " by " + program);
    };
    try {
        for (std::size_t s = 0; s < shapes.size(); ++s) compare(s, RefineByOpenMesh(surfaces[s], kLevels), "OpenMesh");
        findings.notes.push_back("OpenMesh: " + std::to_string(shapes.size()) + " surfaces");
    } catch (const Unavailable& unavailable) {
        findings.skipped.push_back("OpenMesh: " + unavailable.reason);
    }
    try {
        const auto by_vtk = RefineByVtk(context.scripts / "vtk_butterfly.py", context.scratch, surfaces, kLevels);
        for (std::size_t s = 0; s < shapes.size(); ++s) {
            if (!by_vtk[s].refused.empty())
                findings.skipped.push_back("VTK, " + shapes[s].name + ": " + by_vtk[s].refused);
            if (by_vtk[s].levels.size() > 1) compare(s, by_vtk[s].levels, "VTK");
        }
        findings.notes.push_back("VTK: " + std::to_string(shapes.size()) + " surfaces");
    } catch (const Unavailable& unavailable) {
        findings.skipped.push_back("VTK: " + unavailable.reason);
    }
    if (findings.n_compared == 0 && findings.faults.empty())
        throw Unavailable{"neither OpenMesh nor VTK was there: " + findings.skipped.front()};
    return findings;
}

}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
// Validator loop-boundary: box-spline and smooth-tet solids against OpenSubdiv on their boundaries.
#include <solidsubdiv/kit/io/formats.h>

#include "meshes.h"
#include "sharp_features.h"
#include "solid_shapes.h"
#include "surface_compare.h"
#include "surface_shapes.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

Findings ValidateLoopBoundary(const Context& context) {
    Findings findings;
    const std::vector<SolidShape> shapes = SolidsOfEveryKind(context.shapes);
    std::uint32_t seed = 200;
    for (const SolidShape& shape : shapes) {
        const CellArrays cells(shape.complex);
        const std::vector<Triangle> triangles = BoundaryTriangles(shape.complex);
        const SurfaceTags features = SharpFeaturesOf(shape.complex), tags = RandomTags(triangles, ++seed, false);
        const auto compare = [&](const Sdc::Scheme& scheme, const char* how, const SurfaceTags& ours,
                                 const SurfaceTags& theirs, const ComparedLevels& levels) {
            findings.Merge(CompareWithLoop(cells.Descriptor(shape.n_vertices()), scheme, triangles, shape.positions,
                                           ours, levels.AtMostTwoIf(context.is_quick), theirs),
                           shape.name + ", " + std::string(Sdc::NameOf(scheme)) + how);
        };
        for (const Sdc::Features f : {Sdc::Features::Smooth, Sdc::Features::Sharp}) {
            const bool is_sharp = f == Sdc::Features::Sharp;
            Sdc::BoxSpline box_spline;
            box_spline.features = f;
            const Sdc::SmoothTet smooth_tet{.features = f};
            for (const Sdc::Scheme& scheme : {Sdc::Scheme(box_spline), Sdc::Scheme(smooth_tet)}) {
                compare(scheme, is_sharp ? ", sharp" : "", {}, is_sharp ? features : SurfaceTags{},
                        is_sharp ? ComparedLevels{2, 1} : ComparedLevels{4, 3});
                compare(scheme, is_sharp ? ", sharp, tags" : ", tags", tags, is_sharp ? Merged(tags, features) : tags,
                        {3, 2});
            }
        }
    }
    findings.notes.push_back(std::to_string(shapes.size()) +
                             " solids, levels 1-4 plain, 1-2 with sharp features, 1-3 with random creases and corners");
    return findings;
}

}  // namespace SolidSubdiv::Validation

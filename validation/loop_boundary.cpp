// SPDX-License-Identifier: Apache-2.0
// Validator loop-boundary: box-spline and smooth-tet solids against OpenSubdiv on their boundaries.
#include <solidsubdiv/kit/io/formats.h>

#include "meshes.h"
#include "solid_shapes.h"
#include "surface_compare.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

Findings ValidateLoopBoundary(const Context& context) {
    Findings findings;
    const std::vector<SolidShape> shapes = SolidsOfEveryKind(context.shapes);
    for (const SolidShape& shape : shapes) {
        const CellArrays cells(shape.complex);
        for (const Sdc::Scheme& scheme : {Sdc::Scheme(Sdc::BoxSpline{}), Sdc::Scheme(Sdc::SmoothTet{})}) {
            findings.Merge(CompareWithLoop(cells.Descriptor(shape.n_vertices()), scheme,
                                           BoundaryTriangles(shape.complex), shape.positions, {}, {4, 3}),
                           shape.name + ", " + std::string(Sdc::NameOf(scheme)));
        }
    }
    findings.notes.push_back(std::to_string(shapes.size()) + " solids, levels 1-4");
    return findings;
}

}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
// The caller's mesh as the framework takes it: views of index arrays, nothing owned, nothing copied.
//
// A complex may mix dimensions: cells, triangles that bound no cell, edges in no face. A lower-dimensional element that
// coincides with a part of a higher one is a tag of that part, not a part of its own (docs/concepts.md).
//
//     std::vector<Index> tets = {0, 1, 2, 3,   1, 2, 3, 4};
//     Far::TopologyDescriptor descriptor{.n_vertices = 5, .tets = tets};
//     auto refiner = Far::TopologyRefiner::Create(descriptor, Sdc::Split::TetOct);
#pragma once

#include <span>
#include <string>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Far {

/// Vertex order of each kind of cell is that of sdc/cells.h (tets, octs) or of VTK (the others).
/// Arrays are row-major, (number of elements, vertices of one element); vertices count from 0.
struct TopologyDescriptor {
    Index n_vertices = 0;

    std::span<const Index> tets{};   ///< (n, 4). The octahedron inside a tet gets the diagonal mid(v0 v1) - mid(v2 v3).
    std::span<const Index> octs{};   ///< (n, 6): three pairs of opposite vertices, the first pair the major diagonal.
    std::span<const Index> hexes{};  ///< (n, 8)
    std::span<const Index> wedges{};    ///< (n, 6)
    std::span<const Index> pyramids{};  ///< (n, 5)

    /// General cells: cell c has the faces [polyhedron_offsets[c], polyhedron_offsets[c + 1]), face f of them the
    /// vertices polyhedron_vertices[polyhedron_face_offsets[f], polyhedron_face_offsets[f + 1]), seen counterclockwise
    /// from outside.
    std::span<const Offset> polyhedron_offsets{};       ///< (n + 1) or empty
    std::span<const Offset> polyhedron_face_offsets{};  ///< (number of faces + 1) or empty
    std::span<const Index> polyhedron_vertices{};

    std::span<const Index> triangles{};  ///< (n, 3)
    std::span<const Index> quads{};      ///< (n, 4)

    std::span<const Offset> polygon_offsets{};  ///< (n + 1) or empty: faces of five and more vertices
    std::span<const Index> polygon_vertices{};

    std::span<const Index> edges{};  ///< (n, 2)

    /// Sharp edges and vertices of surfaces and of the boundary of solids; how many levels each stays sharp, 10 and
    /// more for ever (sdc/creases.h). Of one that is given twice the larger sharpness counts.
    std::span<const Index> crease_edges{};      ///< (n, 2): ends
    std::span<const float> crease_sharpness{};  ///< (n)
    std::span<const Index> corner_vertices{};   ///< (n)
    std::span<const float> corner_sharpness{};  ///< (n)
};

/// What may be wrong with a mesh. Those marked fatal make it unusable; the others are followed by rule and reported.
enum class DefectCode {
    IndexOutOfRange,    ///< fatal: an element names a vertex that is not there
    RepeatedVertex,     ///< fatal: an element names a vertex twice
    DuplicateElement,   ///< fatal: two elements of one kind have the same vertices
    FaceInThreeCells,   ///< fatal: a face bounds more than two cells
    OpenCell,           ///< fatal: a polyhedron's faces do not close
    TwistedFace,        ///< fatal: two elements have a face's vertices in orders that do not fit
    BadSharpness,       ///< fatal: a sharpness is negative or not a number
    BadOffsets,         ///< fatal: an offset array or an array's length does not fit its kind
    InvertedCell,       ///< a cell whose orientation disagrees with its neighbour's
    NonManifoldEdge,    ///< an edge with a number of surface faces other than 0, 1 or 2, or in cells that do not form a
                        ///< fan
    NonManifoldVertex,  ///< a vertex around which the complex is neither a ball, a half ball nor a surface or curve
    IsolatedVertex,     ///< a vertex in no element
    CoincidentElement,  ///< a lower-dimensional element on a part of a higher one: a tag
    UnusedSharpness,    ///< a crease that is no edge of a surface, and is ignored
    NoLimit,            ///< a place that a scheme gives no limit
    NoDerivative        ///< a place where the limit has no derivative by the place's coordinates
};

/// One imperfection: what, where, how much. `element` counts within the kind that the code speaks of.
struct Defect {
    DefectCode code;
    Index element = kNoIndex;
    double measure = 0;  ///< a size in the code's own unit (a number of cells, a volume), or 0
    std::string text{};  ///< one line for people

    bool IsFatal() const { return code <= DefectCode::BadOffsets; }
};

/// Everything that is wrong with a complex of any elements, fatal defects first; of each code at
/// most max_per_code. Cost: a sort of all faces and edges.
std::vector<Defect> Validate(const TopologyDescriptor& descriptor, Index max_per_code = 100);

}  // namespace SolidSubdiv::Far

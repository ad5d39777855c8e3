// SPDX-License-Identifier: Apache-2.0
// How good the cells of a level are: whether they are folded, with a certificate, and how far from well shaped.
//
//     for (const Geometry::CellQuality& q : Geometry::MeasureQuality(refiner, 2, positions)) {
//         if (q.sign == Geometry::MinimumSign::Negative) ...  // folded or inverted: look at q.place
//     }
//
// A cell is a map from its coordinates (far/place.h) to space; where the determinant of that map's Jacobian is not
// positive it is folded or turned inside out. Determinants of tets are six times their volumes, and constant. Other
// cells have the least of their tets: octahedra of the four around the major diagonal, cells with parts of their
// parts. The determinant of a hexahedron is a polynomial of degree 2 in each coordinate: its 27 Bernstein coefficients
// are bounds, those at corners are values, and halving the cell brings them together. Positive corners do not make a
// hexahedron valid, nor do samples: the sign here is proved, up to rounding of the determinants, or said to be open.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/far/place.h>
#include <solidsubdiv/sdc/progress.h>

namespace SolidSubdiv::Geometry {

struct QualityOptions {
    /// (0, 1]: bounds of a hexahedron's least determinant that are so near, as a part of the largest, are near enough.
    double gap = 1e-3;
    /// [1, 1e6]: a hexahedron is cut into at most so many parts; what is open then stays so.
    int most_parts = 4096;
    Progress progress{};

    /// @throws InvalidInput
    void Validate() const;
};

/// What is proved of the least determinant in a cell.
enum class MinimumSign : unsigned char {
    Positive,
    Negative,  ///< it is negative at CellQuality::place
    Undecided  ///< within rounding of 0, as in flat cells, or cells with too many parts
};

struct CellQuality {
    double jacobian_minimum = 0;  ///< the least determinant that was found: that at `place`
    double lower_bound = 0;       ///< no determinant in the cell is less
    /// Of tets, sqrt(2) times the determinant over the largest product of the lengths of a vertex's three edges; of
    /// hexahedra the least, over the corners and the centre, of the determinant of the directions of the edges (of the
    /// axes): 1 is a regular tet, a cube; as Verdict has it (stimpson2007). Of other cells the least of their
    /// tets; a regular octahedron has sqrt(1/2). In [-1, 1]; 0 where an edge has no length.
    double scaled_jacobian = 0;
    MinimumSign sign = MinimumSign::Undecided;
    Far::Place place{};
};

/// One a cell. Parallel, the same bits for any number of threads. Cost: some 100 operations a tet, a few 1,000 a
/// hexahedron. Among polyhedra those of four triangles are tets.
/// @throws InvalidInput where there is no such level or a position is not finite or beyond 1e75, Cancelled
std::vector<CellQuality> MeasureQuality(const Far::TopologyRefiner& refiner, int level,
                                        std::span<const double> positions, const QualityOptions& options = {});

}  // namespace SolidSubdiv::Geometry

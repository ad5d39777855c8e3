// SPDX-License-Identifier: Apache-2.0
// The characteristic map of a place: the subdominant eigenvectors as control points of the star, refined by the scheme
// itself. Where it is regular (its Jacobian has one sign), so is every limit near the place.
//
// At each split the star around the place shrinks to the half and the map by its eigenvalues, so one ring, between the
// star and its half, tells of all. Its Jacobian is sampled there on the control cells, one or two splits on: in every
// tet, in the four of each octahedron, at the corners and the centre of each hexahedron, at the corners of each face.
// That is a test by samples, not a proof; and one sign around a place says that the map covers it evenly, once where
// the ring's links are spheres or circles.
#pragma once

#include <optional>
#include <vector>

#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/analysis/spectrum.h>
#include <solidsubdiv/kit/analysis/star.h>
#include <solidsubdiv/sdc/schemes.h>

namespace SolidSubdiv::Analysis {

/// Eigenvalues at a place on an edge, sorted by whether their functions change along it. One that does not vary along
/// the edge need only shrink faster than the pair across; so the list as a whole tells less than these four.
struct EdgeEigenvalues {
    double across = 0, next_across = 0;  ///< of functions constant along the edge: the second after 1, the third
    double along = 0, next_along = 0;    ///< of the others: the first, the second
    bool is_separated() const;           ///< the map of the two and the one says it all
};

struct CharacteristicMap {
    double smallest = 0, largest = 0;  ///< Jacobian determinants, signed so that their sum is positive
    int n_samples = 0;
    bool is_defective = false;              ///< there are fewer eigenvectors than eigenvalues, and no map
    std::optional<EdgeEigenvalues> edge{};  ///< where eigenvalues had to be sorted so

    /// One that is flat up to round-off is not.
    bool is_regular() const { return n_samples > 0 && smallest > 1e-9 * largest; }
    double ratio() const { return largest > 0 ? smallest / largest : 0; }
};

/// Where the refiner samples: from the control points at ring_level to cells n_splits on.
struct MapLevels {
    int ring_level = 2, n_splits = 2;
    int max_level() const { return ring_level + n_splits; }
};

/// Around vertex 0 of level 0, the middle of a star (kit/analysis/star.h) that was refined to levels.max_level(), from
/// the eigenvectors after 1 that the star's dimension asks for. None where rows leave the star: for schemes that reach
/// far ring_level 3 is needed. @param sorts_edge on an edge, from the pair across and the one along instead
/// @pre the eigenvalues are real
std::optional<CharacteristicMap> MakeCharacteristicMap(const Far::TopologyRefiner& refiner, const Star& star,
                                                       const Sdc::Scheme& scheme, const Spectrum& spectrum,
                                                       const MapLevels& levels, bool sorts_edge = false);

/// Jacobians of control cells under given points. @param points (n_vertices of the level, dimension), row-major; cells
/// with a vertex that is not finite are left out. What the map does with its ring; and for planted faults.
CharacteristicMap SampleJacobians(const Far::TopologyRefiner& refiner, int level, const std::vector<double>& points,
                                  int dimension);

}  // namespace SolidSubdiv::Analysis

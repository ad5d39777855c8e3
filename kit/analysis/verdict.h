// SPDX-License-Identifier: Apache-2.0
// What eigenvalues and the characteristic map say about smoothness at a place.
//
// A point's neighbourhood shrinks by the subdivision matrix at each split. Where the `dimension` eigenvalues after 1
// are real, positive and above all others, what is left in the end is their eigenfunctions: the characteristic map. If
// it is regular, the limit is C1 in that map's coordinates (reif1995unified; zorin2000smoothness for unequal ones). An
// eigenvalue among the others adds a function that shrinks no faster than one of the three, a crease or a peak there;
// but on an edge, where functions that are constant along it need only shrink faster than the pair across.
#pragma once

#include <optional>
#include <string>

#include <solidsubdiv/kit/analysis/characteristic_map.h>
#include <solidsubdiv/kit/analysis/spectrum.h>

namespace SolidSubdiv::Analysis {

enum class Smoothness {
    Diverges,  ///< an eigenvalue of modulus 1 or more besides the single 1, or rows that do not sum to 1
    C0,        ///< the `dimension` eigenvalues after 1 are not real, positive and above all others, or lack
               ///< eigenvectors, or the characteristic map folds
    Uneven,    ///< they are, but are not equal: C1 in the coordinates of the characteristic map, which shrink at rates
               ///< of their own. In those of the lattice slopes grow or vanish along some of them
    C1,        ///< they are equal too
    C2         ///< and 1/2, the next are at most 1/4, and of that size no more than there are quadratics: what C2 needs
};

struct Verdict {
    Smoothness smoothness = Smoothness::Diverges;
    double subdominant = 0;  ///< modulus of the second eigenvalue
    std::string text;        ///< one line for people
};

/// @param map without it the verdict is about eigenvalues alone, and says so
Verdict VerdictOf(const Spectrum& spectrum, int dimension, const std::optional<CharacteristicMap>& map = {});

/// "C2 spectrum", "C1", "C1 uneven", "C0", "diverges"
std::string NameOf(Smoothness smoothness);

}  // namespace SolidSubdiv::Analysis

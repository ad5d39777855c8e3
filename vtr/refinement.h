// SPDX-License-Identifier: Apache-2.0
// One uniform split of a level into the next. Children are computed from parents by arithmetic on their numbers.
//
// With V, E, F, T, O the parent's counts, the child's components are numbered by the parent component they come from:
//
//   vertices  [0, V)           the parent's
//             V + e            on edge e
//             V + E + o        at the centre of oct o
//   edges     2e, 2e + 1       on edge e, at its lower, higher end
//             2E + 3f + k      on face f, across corner k
//             2E + 3F + 12o+i  in oct o
//   faces     4f + k, 4f + 3   on face f at corner k, in its middle
//             4F + 4t + i      in tet t
//             4F + 4T + 24o+i  in oct o
//   tets      4t + i           in tet t at corner i
//             4T + 8o + i      in oct o at face i
//   octs      t                inside tet t
//             T + 6o + i       in oct o at vertex i
//
// (corners of a face in ascending order of its vertices; i inside cells as in sdc/cell_split.h).
#pragma once

#include <solidsubdiv/vtr/level.h>

namespace SolidSubdiv::Vtr {

/// Counts of a level that need not fit an index.
struct Counts {
    Offset n_vertices = 0, n_edges = 0, n_faces = 0, n_tets = 0, n_octs = 0, n_boundary_faces = 0;

    Offset n_cells() const { return n_tets + n_octs; }
    /// The largest of the counts.
    Offset Largest() const;
    friend bool operator==(const Counts&, const Counts&) = default;
};

Counts CountsOf(const Level& level);

/// Counts after one split: V' = V + E + O, E' = 2E + 3F + 12O, F' = 4F + 4T + 24O, T' = 4T + 8O, O' = T + 6O.
Counts Refine(const Counts& parent);

/// Bytes of the arrays of a level with these counts, full or not.
Offset EstimateBytes(const Counts& counts, bool full);

/// Splits every component of a full level. @pre parent.is_full and the child's counts fit Index
/// Cost: one pass over the parent; parallel, the same bits for any number of threads.
Level Refine(const Level& parent, bool full);

}  // namespace SolidSubdiv::Vtr

// SPDX-License-Identifier: Apache-2.0
// Where a fit starts: a lattice around a target, or a cage, of about as many control points as asked for.
//
//     Fit::StartReport report;
//     const Fit::ControlMesh lattice = Fit::MakeSolidStart(target, {.n_control = 300}, &report);
//     if (!report.has_target_topology) ...   // a handle was too thin for so few control points
//
// A solid start is made of cubes: those of a regular grid that lie in the target, for the most part. Size and place of
// the grid are searched for, until the number of control points is near enough, the boundary has the components and
// handles of the target, and is as near to it as cubes can be. The boundary is then drawn to the target while the cells
// keep their shape. Hexahedra get a layer of cells on the boundary first:
//
//     +---+---+          o---o---o     o: a cube at an edge has two faces in what becomes one smooth surface; with the
//     |   |   |          | +---+ |        layer a cell has one face on the boundary
//     +---+---+    ->    o-| | |-o
//     |   |   |          | +---+ |
//     +---+---+          o---o---o
//
// A cage of triangles is the target with most of its vertices taken away, those first that it needs least.
//
// Everything is done at the size of the target: its unit does not matter, nor where it lies.
//
// Sources: garland1997quadrics (cages), rules.md, section 4 (why layers).
#pragma once

#include <solidsubdiv/apps/fit/control_mesh.h>
#include <solidsubdiv/sdc/progress.h>

namespace SolidSubdiv::Fit {

struct StartOptions {
    Index n_control = 300;  ///< [8, 100000]: about as many control points
    bool tets = false;      ///< of solids: tets and octahedra, not hexahedra
    bool quads = false;     ///< of cages: quadrilaterals, not triangles
    double creases = 0;  ///< [0, 180), of tets: edges of the target that bend by more degrees become creases; 0: none
    Progress progress{};

    /// @throws InvalidInput
    void Validate() const;
};

/// What was made, and whether it is what was asked for.
struct StartReport {
    Offset n_components = 0, target_components = 0;  ///< of the boundary, of the target
    Offset euler = 0, target_euler = 0;              ///< their Euler characteristics (vertices - edges + faces)
    bool has_target_topology = false;                ///< both agree
    double least_quality = 0;  ///< of solids: the least corner, as scaled Jacobian, in (0, 1]; of cages 0
    Offset n_folded = 0;       ///< hexahedra that are folded inside although their corners are not; 0 as a rule
};

/// Whether a target is closed and its largest component encloses less than nothing. Starts turn such targets around for
/// themselves; nearest points of a fit need them turned. @throws InvalidInput as MakeSolidStart, but for open surfaces
bool LooksInwards(const TargetSurface& target);

/// A lattice around a closed surface, or around points. Every corner of every hexahedron, every tet and octahedron is
/// positive; the boundary is a closed manifold. Around points alone it starts from their closing (cloud.h), or from an
/// ellipsoid of their box where nothing seals them.
/// Deterministic, for any number of threads. Cost: some seconds at most for a few thousand control points.
/// @throws InvalidInput where there is nothing, a position is not finite or beyond 1e75, a triangle names a point that
/// is not there, the surface is open or encloses nothing; Cancelled
ControlMesh MakeSolidStart(const TargetSurface& target, const StartOptions& options, StartReport* report = nullptr);

/// The starts that MakeSolidStart chooses from, the first of them its choice: at most n_most, none twice. Cubes do not
/// tell which lattice can follow a shape without folding; a short fit of each does (Fit::FindSolidStart).
/// @throws InvalidInput as MakeSolidStart, and where n_most < 1; Cancelled
std::vector<ControlMesh> MakeSolidStarts(const TargetSurface& target, const StartOptions& options, int n_most,
                                         std::vector<StartReport>* reports = nullptr);

/// A cage around a surface, or around points. Triangles keep the components, handles and borders of the target, which
/// must be a manifold; quadrilaterals are the boundary of a solid start. Positions are on the target, for triangles.
/// @throws InvalidInput as MakeSolidStart, but that triangles may be open; Cancelled
ControlMesh MakeCage(const TargetSurface& target, const StartOptions& options, StartReport* report = nullptr);

}  // namespace SolidSubdiv::Fit

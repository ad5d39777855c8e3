// SPDX-License-Identifier: Apache-2.0
// The list of validators, and running one.
#include "validators.h"

#include <array>
#include <chrono>
#include <exception>

namespace SolidSubdiv::Validation {

namespace {

constexpr std::string_view kSumsOfWeights =
    "sums of positive weights that add up to 1: a few units of round-off (2e-16) a level, and a hundred times that";

constexpr std::string_view kSumsOfSignedWeights =
    "sums of two dozen weights below 1 of both signs that add up to 1: a few units of round-off (2e-16) a level, and a "
    "thousand times that";

constexpr std::array kValidators = {
    Validator{"loop-boundary",
              "boundary of box-spline and smooth-tet solids = OpenSubdiv's Loop refinement of the boundary surface: "
              "positions (levels 1-4) and composite rows (levels 1-3), over the shape's size",
              1e-12, kSumsOfWeights, ValidateLoopBoundary},
    Validator{"loop-surfaces",
              "Loop surfaces, closed and open, with creases and corners = OpenSubdiv's: positions (levels 1-5) and "
              "composite rows (levels 1-3), over the shape's size",
              1e-12, kSumsOfWeights, ValidateLoopSurfaces},
    Validator{
        "catmark-surfaces",
        "Catmull-Clark and linear surfaces of polygons, closed and open, with creases and corners = OpenSubdiv's: "
        "positions (levels 1-4) and composite rows (levels 1-3), over the shape's size",
        1e-12, kSumsOfWeights, ValidateCatmarkSurfaces},
    Validator{"catmark-boundary",
              "boundary of Catmull-Clark solids, and of mlca ones with that surface = OpenSubdiv's refinement of the "
              "boundary surface, with edges in one "
              "cell as creases and vertices in one cell as corners: positions (levels 1-3) and composite rows (levels "
              "1-2), over the shape's size",
              1e-12, kSumsOfWeights, ValidateCatmarkBoundary},
    Validator{"butterfly-surfaces",
              "butterfly and modified butterfly surfaces, closed and open, with creases and corners = an independent "
              "program on OpenSubdiv's topology: positions (levels 1-4) and composite rows (levels 1-3), over the "
              "shape's size",
              1e-12, kSumsOfSignedWeights, ValidateButterflySurfaces},
    Validator{"butterfly-boundary",
              "boundary of interpolatory solids = that program's butterflies of the boundary surface: positions "
              "(levels 1-3) and composite rows (levels 1-2), over the shape's size",
              1e-12, kSumsOfSignedWeights, ValidateButterflyBoundary},
    Validator{
        "butterfly-programs",
        "modified butterfly surfaces, closed = OpenMesh's and VTK's: positions (levels 1-3), over the shape's size",
        1e-12, kSumsOfSignedWeights, ValidateButterflyPrograms},
    Validator{"box-spline-regular",
              "inside regular blocks values and composite rows (levels 1-3) = the convolution "
              "mask; limits = the closed form of N(2,2,2,2); values of size 1",
              1e-12,
              "sums of at most a hundred terms of size 1, the closed form exact to a few units of round-off: 1e-14 at "
              "most, and a hundred times that",
              ValidateBoxSplineRegular},
    Validator{"tricubic-regular",
              "inside regular blocks of hexahedra Catmull-Clark solids and mlca = tensor products of cubic B-splines: "
              "values (levels 1-3) by knot insertion, limits by the closed form; values of size 1",
              1e-12, kSumsOfWeights, ValidateTricubicRegular},
    Validator{"cell-averaging",
              "smooth-tet inside solids of tets and octahedra, mlca on solids of any cells and their boundaries = a "
              "linear split and averages over the new cells, made the plain way: each level (1-2) from the one before, "
              "over the shape's size",
              1e-12, kSumsOfWeights, ValidateCellAveraging},
    Validator{
        "cell-quality",
        "scaled Jacobians of tets and hexahedra, inverted and folded ones too = those of VTK's Verdict; no sampled "
        "determinant is below the bound or of another sign than what is proved",
        1e-12, "products and quotients of numbers of size 1: a few units of rounding, and a thousand times that",
        ValidateCellQuality},
    Validator{"counts",
              "numbers of vertices, edges, faces and cells = those of the refined cells' vertex sets, of the "
              "formulas, and of the paper (28 -> 7280, 20 -> 5200 cells)",
              0, "whole numbers", ValidateCounts},
    Validator{"diagonals",
              "share of matched faces that `matched` reaches: 100 % on shuffled blocks of the lattice, 75 % on "
              "models; errors are what lacks",
              0, "the shares are the aims themselves; counts are whole numbers", ValidateDiagonals},
    Validator{"ffd-laws",
              "free-form deformation in lattices of any cells, under every scheme: affine maps map points affinely, "
              "lattices at rest leave them, over the size (in float times a millionth); embedding again gives the same "
              "bits, and so do updates; control points touch what is in their rows, within N_p,3 of the lattice paper",
              1e-12,
              "sums of weights that add up to 1, and points located to 64 units of round-off (1.4e-14), in the limit "
              "to 1e-13 "
              "of the size; in float a few units of its round-off (6e-8), and some ten times that",
              ValidateFfdLaws},
    Validator{"ffd-regular",
              "free-form deformation with blocks of hexahedra, Catmull-Clark solids and mlca = tricubic B-splines with "
              "linearly extrapolated ends, in the limit, and their trilinear pieces at levels 0-3, over the size",
              1e-12,
              "sums of 64 weights: a few units of round-off (2e-16), and as much again for coordinates found by steps "
              "of Newton's, times how much the deformation stretches (some ten times)",
              ValidateFfdRegular},
    Validator{"ffd-levels",
              "editing sessions on models in octree and shrunken lattices: changes of level, down, up and out, move no "
              "vertex, over the model's size",
              1e-10, "what is asked for; rounding of positions leaves 1e-15", ValidateFfdLevels},
    Validator{"fit-affine",
              "what the fairness of fits has against affine images of control meshes of every kind, over the size",
              1e-12, "weights solved for to a hundred units of rounding (2e-16), and ten times that",
              ValidateFitAffine},
    Validator{"fit-affine-lattice",
              "box lattices carry a model to its affine image, points being known and fairness on, over the size",
              1e-12, "as fit-affine's, whose weights these sums are; steps stop at 1e-13", ValidateFitAffineLattice},
    Validator{
        "fit-distances",
        "largest distances of surfaces fitted to the scan from it, and back = CGAL's Hausdorff distances, over the "
        "diagonal; errors are what exceeds",
        0, "what is allowed is taken off: CGAL's bound (1e-4) and the gaps between points measured",
        ValidateFitDistances},
    Validator{
        "fit-folded",
        "solids fitted to the scan: at random places in levels 0 to 2, cells that are proved not to be folded have "
        "positive determinants, and so have control tets and octahedra where a fit says that no corner is folded",
        0, "signs", ValidateFitFolded},
    Validator{"fit-free-partners",
              "control meshes of every kind fitted to their own limit from a per cent away, by nearest points: RMS "
              "distances both ways over the diagonal",
              1e-6, "what is asked for; rounds stop there", ValidateFitFreePartners},
    Validator{
        "fit-jacobians",
        "slopes of what rounds minimize, of nearest points with and without normals, of partners, of fairness, of the "
        "barrier = central differences, over the largest; the sum of squares = that of the residuals row by row",
        1e-7,
        "sums of size 1: differences have rounding (1e-16) over the step (1e-6), times what the largest slope is below "
        "1",
        ValidateFitJacobians},
    Validator{"fit-known-partners",
              "control meshes of every kind fitted to points of their own limit, regularizers off: control points that "
              "the surface depends on, over the size",
              1e-8, "what is asked for; conjugate gradients stop when a step gains no more", ValidateFitKnownPartners},
    Validator{
        "fit-orders",
        "errors of fits as control meshes are halved fall with order 4 on regular ones (quartic box splines, bicubic "
        "B-splines), with order 3 where six vertices are extraordinary; errors are what an order lacks",
        0.3, "orders are those of the limit: at 10 to 40 points a ring the next terms still take part",
        ValidateFitOrders},
    Validator{"lattice-counts",
              "octree lattices: of one cell 1, 8, .. 32768 cells, as published; of models the cells that a count of "
              "their vertices finds, each once, with as many control points as they have corners",
              0, "whole numbers", ValidateLatticeCounts},
    Validator{"limit-places",
              "limit rows at random places of every scheme, in cells and on boundary faces, and their derivatives = "
              "what refinement alone leads to at level 14, over the shape's size",
              1e-9,
              "fits of third order at level 12 (1e-11); where the last levels are less certain, and for derivatives, "
              "what they say is taken off first",
              ValidateLimitPlaces},
    Validator{
        "limit-surfaces",
        "limits of Loop and Catmull-Clark surfaces and of boundaries of solids with them, plain, with creases and "
        "corners = OpenSubdiv's: points at random places and their derivatives where its patches are exact, "
        "points and normals at vertices, over the shape's size",
        1e-9,
        "second derivatives near borders are those of up to ten levels further on, whose round-off (1e-15) has "
        "grown by 4 a level; what first ones have where there is no closed form (3e-7) is taken off first",
        ValidateLimitSurfaces},
    Validator{"location",
              "evaluate, locate, compare: random places in level 2 of real lattices, 200,000 each; none is lost, and "
              "located ones have the same points, over the largest coordinate",
              3e-14,
              "the locator's own tolerance, 64 units of rounding (1.4e-14), and as much for the sums of both points",
              ValidateLocation},
    Validator{"spectra",
              "eigenvalues of the local subdivision matrices in the regular lattice and inside control faces = "
              "those quoted, less their rounding",
              1e-9,
              "quoted values are simple or have a full set of eigenvectors, so "
              "they are found to about 1e-15; 1e-9 still sees a weight that is off by a millionth",
              ValidateSpectra},
    Validator{
        "voxel-attributes",
        "attributes at 10,000 random voxels of solids of tets, octahedra, hexahedra and other cells = direct "
        "evaluation in the cells named, and rows of places that the locator finds; errors are what floats do not "
        "round",
        1e-12,
        "values of size 1 in floats: two units of rounding are taken off (2.4e-7), coordinates are found to 1e-14",
        ValidateVoxelAttributes},
    Validator{"voxel-level-set",
              "level sets of solids = OpenVDB's of their boundaries (a tenth of a voxel where its are exact, signs of "
              "all), and the distances to a ball, a torus, a box; volumes of negative voxels and of fog = those of the "
              "divergence theorem; errors are what exceeds",
              1e-12,
              "what is allowed is taken off: a tenth of a voxel, the facets' sagitta, a part of a layer of voxels",
              ValidateVoxelLevelSet},
    Validator{"vtk-reader",
              "VTK's own reader finds our counts, arrays, positive volumes and their sum in every form of VTU "
              "that we write",
              1e-12, "sums of up to 1e5 numbers read back exactly, in another order: 1e-14, and a hundred times that",
              ValidateVtkReader},
};

}  // namespace

std::span<const Validator> Validators() { return kValidators; }

std::string_view NameOf(Status status) {
    switch (status) {
        case Status::Pass:
            return "PASS";
        case Status::Fail:
            return "FAIL";
        case Status::Skipped:
            return "SKIPPED";
    }
    return "";
}

Outcome Run(const Validator& validator, const Context& context) {
    Outcome outcome;
    outcome.validator = &validator;
    const auto start = std::chrono::steady_clock::now();
    try {
        outcome.findings = validator.run(context);
        if (context.is_quick)
            outcome.findings.notes.push_back("quick: fewer levels, places and shapes than said above");
        outcome.status = outcome.findings.Passes(validator.tolerance) ? Status::Pass : Status::Fail;
        if (outcome.findings.n_compared == 0) outcome.reason = "nothing was compared";
    } catch (const Unavailable& unavailable) {
        outcome.status = Status::Skipped;
        outcome.reason = unavailable.reason;
    } catch (const std::exception& error) {
        outcome.reason = error.what();
    }
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

}  // namespace SolidSubdiv::Validation

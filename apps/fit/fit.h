// SPDX-License-Identifier: Apache-2.0
// Control points moved until the surface that they carry meets a target.
//
//     Fit::ControlMesh lattice = Fit::MakeSolidStart(target, {.n_control = 400});
//     const Fit::Problem problem = Fit::MakeProblem(lattice, Sdc::CatmullClarkSolid{}, target);
//     const Fit::Result result = Fit::FitControlPoints(problem, {});
//     lattice.positions = result.control;
//
// The surface is linear in the control points: positions = rows * control points. So are its derivatives by them, which
// are the rows themselves: nothing is differentiated by machine. Each round looks for the nearest points both ways (of
// the surface's vertices on the target, so that nothing sticks out, and of the target's points on the surface, so that
// nothing of it is missed), keeps them for a problem that Ceres solves, and begins again.
//
// What is minimized, with lengths measured in diagonals of the target's box:
//     sum over both ways of the mean of |M d|^2, d from a point to its nearest, where M leaves what is along the
//         target's normal and takes most of what is across (points may slide along the surface), and far points, where
//         `robust` is given, count less (Geman and McClure's weights, found anew each round)
//   + normals * mean over the surface's vertices of the squared cosines of the angles between the target's normal there
//         and the surface's tangents: 0 where the surface lies along the target; less as long as fairness is high
//   + fairness * mean over control points of |p - sum of w_j p_j|^2, weights that reproduce the start's neighbourhood:
//         it is 0 for all affine maps of the start
//   + spring * mean over pairs of neighbouring control points of |p - q|^2
//   + barrier * sum over corners of cells of (1 / chi(q) - 1 / chi(e))^2 where q < e: q is a scaled Jacobian, chi(q)
//         the same where it is well above 0, smoothly less, never 0, where cells are flat or folded; e is 1 on the way,
//         and half of what q was at the start when fairness is least
// Fairness begins high and is halved each round: large movements first, then details. The barrier is made ten times
// higher as long as corners are folded where rounds come to an end. Ceres' L-BFGS walks downhill.
//
// Source: distances along normals: chen1991modelling; subdivision surfaces fitted by nearest points and linear
// least-squares in turns, and springs: hoppe1994piecewise.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include <solidsubdiv/apps/fit/control_mesh.h>
#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/kit/geometry/surface_distance.h>
#include <solidsubdiv/sdc/progress.h>
#include <solidsubdiv/sdc/schemes.h>

namespace SolidSubdiv::Fit {

/// What control points carry.
struct MovingSurface {
    Far::StencilRows<double> rows;  ///< (n_vertices) over control points
    std::vector<Index> triangles;   ///< (n, 3) of its vertices, counterclockwise from outside
    /// Two that span the tangent plane of a vertex, over control points; a vertex may have several of them. None: its
    /// normals can't be fitted.
    std::array<Far::StencilRows<double>, 2> tangents{};
    std::vector<Index> tangent_vertices{};  ///< of each row of tangents

    std::vector<double> Positions(std::span<const double> control) const;
};

struct Problem {
    MovingSurface surface;        ///< compared with the target each round
    MovingSurface fine{};         ///< the same with smaller facets, to measure the result on; none: `surface`
    TargetSurface target{};       ///< a view
    std::vector<double> control;  ///< (n, 3): the start
    /// For fairness: the control points around each, itself not among them.
    std::vector<std::vector<Index>> neighbors;
    /// (n): corner a of a cell and its neighbours there, (b - a) x (c - a) . (d - a) positive at the start.
    std::vector<std::array<Index, 4>> corners;
    /// Corners of finer cells that must not fold either, of places over control points: the barrier stands there as
    /// well.
    Far::StencilRows<double> fine_places{};
    std::vector<std::array<Index, 4>> fine_corners{};
    std::vector<Index> locked{};  ///< control points that stay
    /// Pairs of control points that mirror each other in the plane x_axis = offset; (i, i) stays in it.
    std::vector<std::array<Index, 2>> mirrored{};
    int mirror_axis = 0;
    double mirror_offset = 0;
    /// Known partners: for each vertex of the surface a point, (n, 3); empty: nearest points are looked for each round.
    std::vector<double> partners{};

    /// @throws InvalidInput
    void Validate() const;
};

/// The limit of a control mesh's boundary (of a cage: of itself) as the surface, each edge of a face cut in `rate`, and
/// in `fine_rate` for the result (0: in as many). With tangents, so that its normals can be fitted.
/// @throws InvalidInput where the scheme can't refine the mesh
Problem MakeProblem(const ControlMesh& mesh, const Sdc::Scheme& scheme, const TargetSurface& target, int rate = 4,
                    int fine_rate = 0, bool with_tangents = false);

/// A lattice whose deformation carries a model: the surface is the model, embedded in the lattice refined `levels`
/// times.
/// @throws InvalidInput where the lattice has no cells, the scheme can't refine it, or a point of the model lies
/// outside
Problem MakeLatticeProblem(const ControlMesh& lattice, const Sdc::Scheme& scheme, const TargetSurface& model,
                           const TargetSurface& target, int levels = 2);

/// Cubes in rows around the box of points (n, 3), a layer beyond it on every side, of about so many control points.
/// @throws InvalidInput where there is no point, or n_control is not in [64, 100000]
ControlMesh MakeBoxLattice(std::span<const double> points, Index n_control);

struct Options {
    int max_rounds = 40;           ///< [1, 10000]
    double fairness = 1;           ///< >= 0, at the first round
    double least_fairness = 1e-4;  ///< >= 0
    double barrier = 1e-10;        ///< >= 0
    double across = 1e-3;          ///< [0, 1]: how much of a distance across the normal counts; 1: as much as along
    double normals = 0;            ///< >= 0: at 1e-4 ten degrees off count as much as 0.2 % of the diagonal
    double spring = 0;             ///< >= 0
    double robust = 0;             ///< >= 0: distances, in medians, at which points begin to count less; 0: never
    int points_per_control =
        24;                      ///< >= 1: of the target's points so many a control point are paired, if there are more
    double tolerance = 0;        ///< >= 0, unit of the positions: stop as soon as both RMS distances are below
    bool is_measured = true;     ///< whether distances and vertices of the result are wanted
    double least_change = 1e-3;  ///< stop where a round changes the error by less than this part, fairness at least
    Progress progress{};

    /// @throws InvalidInput
    void Validate() const;
};

struct Round {
    double fairness = 0;
    double surface_rms = 0, target_rms = 0;  ///< of the points compared, before the round's step; unit of the positions
    double seconds = 0;
    int steps = 0;  ///< of the solver
};

struct Result {
    std::vector<double> control;
    /// Of the fine surface, or of the surface where there is none: its vertices, the distance of each to the target,
    /// and of each of the target's points to it. `to_target` leaves out what lies over holes of the target, or beyond
    /// its border; the vertices' distances do not.
    std::vector<double> vertices, to_target_distances, from_target_distances;
    std::vector<Round> rounds;
    Geometry::DistanceSummary to_target, from_target;
    double normal_rms = 0;  ///< radians: between normals of the surface's vertices and the target's nearest to them
    int n_folded = 0;       ///< corners of cells of no positive volume
    std::string stopped;    ///< why: "tolerance", "change", "rounds", "cancelled"
};

/// Fills in what Options::is_measured asks for: vertices and distances of a result.
void Measure(const Problem& problem, Result& result);

/// The best so far where progress cancels. Same input, same bits, for any number of threads.
/// @throws InvalidInput, SolverError
Result FitControlPoints(const Problem& problem, const Options& options);

}  // namespace SolidSubdiv::Fit

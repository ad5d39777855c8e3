// SPDX-License-Identifier: Apache-2.0
// The one visible list of reference validators. Each holds the framework to something that was not derived from it:
// another program, a closed form, a published figure. A new validator is a file and a line in validators.cpp.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "findings.h"

namespace SolidSubdiv::Validation {

/// Where a validator finds what it needs.
struct Context {
    std::filesystem::path shapes;      ///< the project's own shapes (regression/shapes): must be there
    std::filesystem::path osd_shapes;  ///< OpenSubdiv's catalogue as OBJ files: may be missing
    std::filesystem::path tets;        ///< tetrahedral meshes from elsewhere: may be missing
    std::filesystem::path programs;    ///< where the program solidsubdiv is, if it was built
    std::filesystem::path scripts;     ///< where the validators' scripts are
    std::filesystem::path scratch;     ///< a folder to write in
    /// Every path through the code, but once or twice: two levels, few places, small shapes. For sanitizers and such.
    bool is_quick = false;
};

struct Validator {
    std::string_view name;
    std::string_view checks;  ///< one line: what is compared with what
    double tolerance;         ///< largest error that passes
    std::string_view tolerance_reason;
    Findings (*run)(const Context&);  ///< throws Unavailable if it can't run at all
};

std::span<const Validator> Validators();

enum class Status { Pass, Fail, Skipped };
std::string_view NameOf(Status status);

struct Outcome {
    const Validator* validator = nullptr;
    Status status = Status::Fail;
    Findings findings;
    std::string reason;  ///< why it was skipped, or the exception that ended it
    double seconds = 0;
};

/// Runs one validator; an exception is a failure.
Outcome Run(const Validator& validator, const Context& context);

/// One line for a terminal.
std::string LineOf(const Outcome& outcome);
/// All outcomes as JSON, and as a page that needs nothing else.
std::string JsonOf(const std::vector<Outcome>& outcomes);
std::string HtmlOf(const std::vector<Outcome>& outcomes);

// The validators, one a file.
Findings ValidateLoopBoundary(const Context& context);
Findings ValidateLoopSurfaces(const Context& context);
Findings ValidateCatmarkSurfaces(const Context& context);
Findings ValidateCatmarkBoundary(const Context& context);
Findings ValidateButterflySurfaces(const Context& context);
Findings ValidateButterflyBoundary(const Context& context);
Findings ValidateButterflyPrograms(const Context& context);
Findings ValidateBoxSplineRegular(const Context& context);
Findings ValidateTricubicRegular(const Context& context);
Findings ValidateCellAveraging(const Context& context);
Findings ValidateCellQuality(const Context& context);
Findings ValidateCounts(const Context& context);
Findings ValidateDiagonals(const Context& context);
Findings ValidateFfdLaws(const Context& context);
Findings ValidateFfdRegular(const Context& context);
Findings ValidateFfdLevels(const Context& context);
Findings ValidateFitAffine(const Context& context);
Findings ValidateFitAffineLattice(const Context& context);
Findings ValidateFitDistances(const Context& context);
Findings ValidateFitFolded(const Context& context);
Findings ValidateFitFreePartners(const Context& context);
Findings ValidateFitJacobians(const Context& context);
Findings ValidateFitKnownPartners(const Context& context);
Findings ValidateFitOrders(const Context& context);
Findings ValidateLatticeCounts(const Context& context);
Findings ValidateLimitPlaces(const Context& context);
Findings ValidateLimitSurfaces(const Context& context);
Findings ValidateLocation(const Context& context);
Findings ValidateSpectra(const Context& context);
Findings ValidateVoxelAttributes(const Context& context);
Findings ValidateVoxelLevelSet(const Context& context);
Findings ValidateVtkReader(const Context& context);

}  // namespace SolidSubdiv::Validation

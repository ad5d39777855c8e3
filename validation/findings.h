// SPDX-License-Identifier: Apache-2.0
// What a comparison found: the largest error and where it was, and what was wrong without being a number.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace SolidSubdiv::Validation {

/// Thrown where an oracle is not there; the text is the reason, and the validator counts as skipped.
struct Unavailable {
    std::string reason;
};

struct Findings {
    double largest_error = 0;
    std::string where;                 ///< of the largest error
    std::int64_t n_compared = 0;       ///< numbers compared
    std::vector<std::string> faults;   ///< what makes the check fail whatever the errors, the first kMostFaults of them
    std::vector<std::string> skipped;  ///< parts of the check that could not be made: which and why
    std::vector<std::string> notes;    ///< figures worth reading

    static constexpr std::size_t kMostFaults = 10;

    /// Takes in one error (at least 0). `place()` tells where, and is only called if the error is the largest so far.
    template <class Place>
    void Error(double error, Place&& place) {
        ++n_compared;
        if (std::isnan(error)) {
            Fault("not a number: " + std::string(place()));
        } else if (error > largest_error) {
            largest_error = error;
            where = place();
        }
    }
    void Fault(std::string what) {
        if (faults.size() < kMostFaults) faults.push_back(std::move(what));
    }

    bool Passes(double tolerance) const { return faults.empty() && n_compared > 0 && largest_error <= tolerance; }

    /// Takes in what another comparison found; `name` says which.
    void Merge(const Findings& other, const std::string& name) {
        n_compared += other.n_compared;
        if (other.largest_error > largest_error) {
            largest_error = other.largest_error;
            where = name + ": " + other.where;
        }
        for (const std::string& text : other.faults) Fault(name + ": " + text);
        for (const std::string& text : other.skipped) skipped.push_back(name + ": " + text);
        for (const std::string& text : other.notes) notes.push_back(name + ": " + text);
    }
};

}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
// Progress of long work, reported to the caller, who can stop it.
#pragma once

#include <functional>
#include <string_view>

#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv {

/// Called with what is being done and the fraction done of the whole, in [0, 1]; returns false to cancel.
/// Called from the thread that started the work, at most a few times a stage.
using Progress = std::function<bool(std::string_view stage, double fraction)>;

/// Reports, and throws Cancelled if the caller asked to stop. An empty callback reports nothing.
inline void Report(const Progress& progress, std::string_view stage, double fraction) {
    if (progress && !progress(stage, fraction)) throw Cancelled();
}

}  // namespace SolidSubdiv

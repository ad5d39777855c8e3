// SPDX-License-Identifier: Apache-2.0
// Programs of their own that are called as sub-commands: what they need stays out of the program that is shipped.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace SolidSubdiv::Cli {

struct Program {
    std::string_view name;     ///< of the sub-command; the program's is solidsubdiv-NAME, and it lies beside this one
    std::string_view summary;  ///< one line of the program's help
    std::string_view option;   ///< of CMake, that builds it
};

inline constexpr std::array kPrograms = {
    Program{"validate", "hold the framework to references; one line each with its largest error",
            "SOLIDSUBDIV_VALIDATION"},
    Program{"bench", "race the framework with its peers", "SOLIDSUBDIV_BENCHMARKS"},
};

/// Whether the program is there.
bool IsThere(const Program& program);

/// Becomes the program, with the arguments after the sub-command's name. @throws Error if it is not there
[[noreturn]] void Become(const Program& program, int argc, char** argv);

}  // namespace SolidSubdiv::Cli

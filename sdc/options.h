// SPDX-License-Identifier: Apache-2.0
// A scheme's options as a table: one source for the command line, the help, the docs and the tests.
#pragma once

#include <string_view>

namespace SolidSubdiv::Sdc {

/// In place of choices where an option is a number ("0.0625" or "1/16"); its help says the range.
inline constexpr std::string_view kNumber = "number";

struct OptionInfo {
    std::string_view name;     ///< as on the command line, without the dashes
    std::string_view unit;     ///< empty where there is none
    std::string_view values;   ///< the choices, separated by |, or kNumber
    std::string_view initial;  ///< the default
    std::string_view help;     ///< one line
};

}  // namespace SolidSubdiv::Sdc

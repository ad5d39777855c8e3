// SPDX-License-Identifier: Apache-2.0
// A scheme's options as a table: one source for the command line, the help, the docs and the tests.
#pragma once

#include <string_view>

namespace SolidSubdiv::Sdc {

struct OptionInfo {
    std::string_view name;     ///< as on the command line, without the dashes
    std::string_view unit;     ///< empty where there is none
    std::string_view values;   ///< the range or the choices, separated by |
    std::string_view initial;  ///< the default
    std::string_view help;     ///< one line
};

}  // namespace SolidSubdiv::Sdc

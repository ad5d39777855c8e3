// SPDX-License-Identifier: Apache-2.0
// Names as one word: blanks and other special characters as %20 and so on, as legacy VTK files have them.
#pragma once

#include <string>
#include <string_view>

namespace SolidSubdiv::Io::Internal {

std::string EncodePercents(std::string_view name);
std::string DecodePercents(std::string_view word);

}  // namespace SolidSubdiv::Io::Internal

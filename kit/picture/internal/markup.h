// SPDX-License-Identifier: Apache-2.0
// Texts and bytes inside of HTML, SVG and JSON.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace SolidSubdiv::Picture::Internal {

/// As text or as a quoted attribute of HTML, SVG or XML.
std::string Escaped(std::string_view text);

/// As a quoted string of JSON that may stand in a script element of HTML: nothing in it ends the element.
std::string JsonString(std::string_view text);

std::string Base64(std::span<const std::uint8_t> bytes);

}  // namespace SolidSubdiv::Picture::Internal

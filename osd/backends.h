// SPDX-License-Identifier: Apache-2.0
// The one visible list of backends. A new one is a folder and a line in backends.cpp; the conformance suite runs on
// each.
#pragma once

#include <span>

#include <solidsubdiv/osd/backend.h>

namespace SolidSubdiv::Osd {

/// Reference first, then others, the fastest last.
std::span<const Backend> Backends();

/// The backend of a name. @throws InvalidInput that lists the known names
const Backend& BackendOf(std::string_view name);

}  // namespace SolidSubdiv::Osd

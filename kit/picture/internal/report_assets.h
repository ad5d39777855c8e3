// SPDX-License-Identifier: Apache-2.0
// The files that go into every report page with a 3-D view, compiled into the library (cmake/Embed.cmake), in pieces.
#pragma once

#include <span>
#include <string_view>

namespace SolidSubdiv::Picture::Internal {

extern const std::span<const std::string_view> kThreeScript;  ///< three/three.min.js
extern const std::span<const std::string_view> kViewScript;   ///< report_view.js
extern const std::span<const std::string_view> kPageStyle;    ///< report_page.css

}  // namespace SolidSubdiv::Picture::Internal

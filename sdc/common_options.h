// SPDX-License-Identifier: Apache-2.0
// Entries of option tables that several schemes share.
#pragma once

#include <solidsubdiv/sdc/options.h>

namespace SolidSubdiv::Sdc {

inline constexpr OptionInfo kCreasingOption{"creasing", "", "uniform|chaikin", "uniform",
                                            "how semi-sharp creases pass their sharpness on"};
inline constexpr OptionInfo kLoopWeightsOption{"loop-weights", "", "loop|warren", "loop",
                                               "weights of vertices on surfaces"};
/// Of tet/oct solids, whose edges in one cell depend on how the solid was cut into tets: tags are better.
inline constexpr OptionInfo kSmoothSolidOption{"features", "", "smooth|sharp", "smooth",
                                               "sharp: edges in one cell are creases, vertices in one cell corners"};
/// Of solids of any cells.
inline constexpr OptionInfo kSharpSolidOption{"features", "", "smooth|sharp", "sharp",
                                              "sharp: edges in one cell are creases, vertices in one cell corners"};

}  // namespace SolidSubdiv::Sdc

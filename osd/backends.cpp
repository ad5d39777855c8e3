// SPDX-License-Identifier: Apache-2.0
// The list of backends.
#include <solidsubdiv/osd/backends.h>

#include <solidsubdiv/osd/reference/reference.h>

namespace SolidSubdiv::Osd {

namespace {
constexpr Backend kBackends[] = {
    {"reference", &EvalStencilsReference<float>, &EvalStencilsReference<double>},
};
}

std::span<const Backend> Backends() { return kBackends; }
const Backend& Backend::Reference() { return kBackends[0]; }
const Backend& Backend::Best() { return Backends().back(); }

}  // namespace SolidSubdiv::Osd

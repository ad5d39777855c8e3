// SPDX-License-Identifier: Apache-2.0
// The list of backends.
#include <solidsubdiv/osd/backends.h>

#include <string>

#include <solidsubdiv/osd/cpu/cpu.h>
#include <solidsubdiv/osd/reference/reference.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Osd {

namespace {
constexpr Backend kBackends[] = {
    {"reference", &EvalStencilsReference<float>, &EvalStencilsReference<double>},
    {"cpu", &EvalStencilsCpu<float>, &EvalStencilsCpu<double>},
};
}

std::span<const Backend> Backends() { return kBackends; }

const Backend& BackendOf(std::string_view name) {
    std::string known;
    for (const Backend& backend : kBackends) {
        if (backend.name() == name) return backend;
        known += (known.empty() ? "" : ", ") + std::string(backend.name());
    }
    throw InvalidInput("there is no backend '" + std::string(name) + "'; there are " + known);
}

const Backend& Backend::Reference() { return kBackends[0]; }
const Backend& Backend::Best() { return Backends().back(); }

}  // namespace SolidSubdiv::Osd

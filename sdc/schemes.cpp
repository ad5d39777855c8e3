// SPDX-License-Identifier: Apache-2.0
// Options by name, from each scheme's own table.
#include <solidsubdiv/sdc/schemes.h>

#include <charconv>
#include <cmath>
#include <optional>

namespace SolidSubdiv::Sdc {

namespace {

/// Sets `field` to the choice that `value` names: choices are separated by | and stand in the enum's order.
template <class Enum>
void SetChoice(std::string_view scheme, const OptionInfo& option, std::string_view value, Enum& field) {
    std::string_view rest = option.values;
    for (int i = 0; !rest.empty(); ++i) {
        const std::size_t bar = rest.find('|');
        if (rest.substr(0, bar) == value) {
            field = static_cast<Enum>(i);
            return;
        }
        rest = bar == std::string_view::npos ? std::string_view{} : rest.substr(bar + 1);
    }
    throw InvalidInput(std::string(scheme) + ": option " + std::string(option.name) + " can't be '" +
                       std::string(value) + "'; one of " + std::string(option.values));
}

/// Sets `field` to a number: "0.0625" or "1/16".
void SetNumber(std::string_view scheme, const OptionInfo& option, std::string_view value, double& field) {
    double top = 0, bottom = 1;
    const char* const end = value.data() + value.size();
    auto read = std::from_chars(value.data(), end, top);
    if (read.ec == std::errc() && read.ptr != end && *read.ptr == '/') {
        read = std::from_chars(read.ptr + 1, end, bottom);
    }
    if (read.ec != std::errc() || read.ptr != end) {
        throw InvalidInput(std::string(scheme) + ": option " + std::string(option.name) + " can't be '" +
                           std::string(value) + "'; it is a number such as 0.05 or 1/16");
    }
    field = top / bottom;
}

void RequireRange(std::string_view scheme, const OptionInfo& option, double value, bool is_in_range,
                  std::string_view range) {
    if (is_in_range) return;
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    throw InvalidInput(std::string(scheme) + ": " + std::string(option.name) + " is " + text + "; it must be " +
                       std::string(range));
}
/// Butterflies and solids converge below 1/8.
void RequireTension(std::string_view scheme, const OptionInfo& option, double tension) {
    RequireRange(scheme, option, tension, tension >= 0 && tension < 1.0 / 8.0, "from 0 to below 1/8");
}

[[noreturn]] void UnknownOption(std::string_view scheme, std::string_view name) {
    throw InvalidInput("scheme " + std::string(scheme) + " has no option '" + std::string(name) + "'");
}

}  // namespace

void BoxSpline::SetOption(std::string_view name, std::string_view value) {
    if (name == kOptions[0].name) return SetChoice(kName, kOptions[0], value, edge_rule);
    if (name == kOptions[1].name) return SetChoice(kName, kOptions[1], value, diagonals);
    if (name == kOptions[2].name) return SetChoice(kName, kOptions[2], value, loop_weights);
    if (name == kOptions[3].name) return SetChoice(kName, kOptions[3], value, features);
    if (name == kOptions[4].name) return SetChoice(kName, kOptions[4], value, creasing);
    UnknownOption(kName, name);
}

void BoxSpline::Validate() const {
    if (diagonals == Diagonals::Averaged && edge_rule != EdgeRule::BoxSpline) {
        throw InvalidInput("box-spline: diagonals averaged goes with edge-rule box-spline only");
    }
}

void Interpolatory::SetOption(std::string_view name, std::string_view value) {
    if (name == kOptions[0].name) return SetNumber(kName, kOptions[0], value, tension);
    if (name == kOptions[1].name) return SetChoice(kName, kOptions[1], value, boundary);
    if (name == kOptions[2].name) return SetChoice(kName, kOptions[2], value, features);
    if (name == kOptions[3].name) return SetChoice(kName, kOptions[3], value, two_neighbors);
    UnknownOption(kName, name);
}
void Interpolatory::Validate() const { RequireTension(kName, kOptions[0], tension); }

void LinearSolid::SetOption(std::string_view name, std::string_view) { UnknownOption(kName, name); }
void LinearSurface::SetOption(std::string_view name, std::string_view) { UnknownOption(kName, name); }

void Butterfly::SetOption(std::string_view name, std::string_view value) {
    if (name == kOptions[0].name) return SetNumber(kName, kOptions[0], value, tension);
    UnknownOption(kName, name);
}
void Butterfly::Validate() const { RequireTension(kName, kOptions[0], tension); }

void ModifiedButterfly::SetOption(std::string_view name, std::string_view value) {
    if (name == kOptions[0].name) return SetNumber(kName, kOptions[0], value, far_weight);
    UnknownOption(kName, name);
}
void ModifiedButterfly::Validate() const {
    RequireRange(kName, kOptions[0], far_weight, std::abs(far_weight) <= 1.0 / 16.0, "from -1/16 to 1/16");
}

void CatmullClark::SetOption(std::string_view name, std::string_view value) {
    if (name == kOptions[0].name) return SetChoice(kName, kOptions[0], value, features);
    if (name == kOptions[1].name) return SetChoice(kName, kOptions[1], value, creasing);
    if (name == kOptions[2].name) return SetChoice(kName, kOptions[2], value, triangles);
    UnknownOption(kName, name);
}

void CatmullClarkSolid::SetOption(std::string_view name, std::string_view value) {
    if (name == kOptions[0].name) return SetChoice(kName, kOptions[0], value, features);
    if (name == kOptions[1].name) return SetChoice(kName, kOptions[1], value, creasing);
    UnknownOption(kName, name);
}

void SmoothTet::SetOption(std::string_view name, std::string_view value) {
    if (name == kOptions[0].name) return SetChoice(kName, kOptions[0], value, loop_weights);
    if (name == kOptions[1].name) return SetChoice(kName, kOptions[1], value, features);
    if (name == kOptions[2].name) return SetChoice(kName, kOptions[2], value, creasing);
    UnknownOption(kName, name);
}

void Mlca::SetOption(std::string_view name, std::string_view value) {
    if (name == kOptions[0].name) return SetChoice(kName, kOptions[0], value, features);
    if (name == kOptions[1].name) return SetChoice(kName, kOptions[1], value, creasing);
    if (name == kOptions[2].name) return SetChoice(kName, kOptions[2], value, surface);
    UnknownOption(kName, name);
}

void Loop::SetOption(std::string_view name, std::string_view value) {
    if (name == kOptions[0].name) return SetChoice(kName, kOptions[0], value, loop_weights);
    if (name == kOptions[1].name) return SetChoice(kName, kOptions[1], value, features);
    if (name == kOptions[2].name) return SetChoice(kName, kOptions[2], value, creasing);
    UnknownOption(kName, name);
}

Scheme SchemeOf(std::string_view name) {
    std::optional<Scheme> found;
    std::string known;
    ForEachScheme([&](auto scheme) {
        if (scheme.kName == name) found = scheme;
        known += (known.empty() ? "" : ", ") + std::string(scheme.kName);
    });
    if (!found) throw InvalidInput("no scheme '" + std::string(name) + "'; there are " + known);
    return *found;
}

}  // namespace SolidSubdiv::Sdc

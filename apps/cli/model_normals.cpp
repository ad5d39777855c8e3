// SPDX-License-Identifier: Apache-2.0
// A deformed normal is the cross product of two deformed tangents.
#include <solidsubdiv/apps/cli/model_normals.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace SolidSubdiv::Cli {

namespace {

using Vector = std::array<double, 3>;

Vector Cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Of length 1; of length 0 where it was.
Vector Unit(const Vector& a) {
    const double length = std::hypot(a[0], a[1], a[2]);
    if (!(length > 0)) return {};
    return {a[0] / length, a[1] / length, a[2] / length};
}

Vector At(std::span<const double> rows, std::size_t i) { return {rows[3 * i], rows[3 * i + 1], rows[3 * i + 2]}; }

std::string LowerCase(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

/// A unit vector at right angles to a unit normal.
Vector FirstTangent(const Vector& normal) {
    const auto least =
        std::min_element(normal.begin(), normal.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    Vector axis{};
    axis[static_cast<std::size_t>(least - normal.begin())] = 1;
    return Unit(Cross(axis, normal));
}

}  // namespace

ModelNormals::ModelNormals(const Io::Mesh& model, double step) : model_(model), step_(step) {
    const auto& data = model.point_data;
    const auto place = [&](const char* name, int width) {
        return static_cast<std::size_t>(
            std::find_if(data.begin(), data.end(),
                         [&](const Io::Attribute& a) { return LowerCase(a.name) == name && a.width == width; }) -
            data.begin());
    };
    if (const std::size_t normals = place("normals", 3); normals < data.size()) {
        attributes_ = {normals};
        normals_ = data[normals].values;
        return;
    }
    attributes_ = {place("nx", 1), place("ny", 1), place("nz", 1)};
    if (*std::max_element(attributes_.begin(), attributes_.end()) >= data.size()) return;
    for (std::size_t i = 0; i < model.positions.size(); ++i) {
        normals_.push_back(data[attributes_[i % 3]].values[i / 3]);
    }
}

std::vector<double> ModelNormals::WithTangents() const {
    std::vector<double> points = model_.positions;
    for (std::size_t i = 0; 3 * i < normals_.size(); ++i) {
        const Vector normal = Unit(At(normals_, i)), a = FirstTangent(normal), b = Cross(normal, a);
        for (const Vector& tangent : {a, b}) {
            for (std::size_t c = 0; c < 3; ++c) points.push_back(model_.positions[3 * i + c] + step_ * tangent[c]);
        }
    }
    return points;
}

Io::Mesh ModelNormals::Deformed(std::span<const double> points) const {
    Io::Mesh mesh = model_;
    const std::size_t n = mesh.positions.size() / 3;
    mesh.positions.assign(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(3 * n));
    for (std::size_t i = 0; i < n && !empty(); ++i) {
        const Vector x = At(points, i), a = At(points, n + 2 * i), b = At(points, n + 2 * i + 1);
        const Vector normal =
            Unit(Cross({a[0] - x[0], a[1] - x[1], a[2] - x[2]}, {b[0] - x[0], b[1] - x[1], b[2] - x[2]}));
        for (std::size_t c = 0; c < 3; ++c) {
            if (attributes_.size() == 1) {
                mesh.point_data[attributes_[0]].values[3 * i + c] = normal[c];
            } else {
                mesh.point_data[attributes_[c]].values[i] = normal[c];
            }
        }
    }
    return mesh;
}

}  // namespace SolidSubdiv::Cli

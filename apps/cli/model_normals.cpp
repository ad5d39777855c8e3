// SPDX-License-Identifier: Apache-2.0
// A deformed normal is the cross product of two deformed tangents.
#include <solidsubdiv/apps/cli/model_normals.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>

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

/// Places of the attributes that hold normals: one of width 3, three of width 1, or none.
std::vector<std::size_t> FindNormals(const Io::Mesh& model) {
    const auto& data = model.point_data;
    const auto place = [&](const char* name, int width) {
        return static_cast<std::size_t>(
            std::find_if(data.begin(), data.end(),
                         [&](const Io::Attribute& a) { return LowerCase(a.name) == name && a.width == width; }) -
            data.begin());
    };
    if (const std::size_t normals = place("normals", 3); normals < data.size()) return {normals};
    const std::vector<std::size_t> found = {place("nx", 1), place("ny", 1), place("nz", 1)};
    return *std::max_element(found.begin(), found.end()) < data.size() ? found : std::vector<std::size_t>();
}

}  // namespace

ModelNormals NormalsOf(const Io::Mesh& model) {
    const std::vector<std::size_t> found = FindNormals(model);
    ModelNormals normals;
    for (Index v = 0; v < model.topology.n_vertices && !found.empty(); ++v) {
        const auto row = static_cast<std::size_t>(v);
        normals.vertices.push_back(v);
        for (std::size_t c = 0; c < 3; ++c) {
            normals.normals.push_back(found.size() == 1 ? model.point_data[found[0]].values[3 * row + c]
                                                        : model.point_data[found[c]].values[row]);
        }
    }
    return normals;
}

void SetNormals(Io::Mesh& model, std::span<const double> normals) {
    const std::vector<std::size_t> found = FindNormals(model);
    for (std::size_t i = 0; i < normals.size() && !found.empty(); ++i) {
        if (found.size() == 1) {
            model.point_data[found[0]].values[i] = normals[i];
        } else {
            model.point_data[found[i % 3]].values[i / 3] = normals[i];
        }
    }
}

std::vector<double> WithTangents(std::span<const double> positions, const ModelNormals& normals, double step) {
    std::vector<double> points(positions.begin(), positions.end());
    for (std::size_t i = 0; i < normals.vertices.size(); ++i) {
        const Vector x = At(positions, static_cast<std::size_t>(normals.vertices[i]));
        const Vector normal = Unit(At(normals.normals, i)), a = FirstTangent(normal), b = Cross(normal, a);
        for (const Vector& tangent : {a, b}) {
            for (std::size_t c = 0; c < 3; ++c) points.push_back(x[c] + step * tangent[c]);
        }
    }
    return points;
}

std::vector<double> TurnedNormals(std::span<const double> points, const ModelNormals& normals) {
    std::vector<double> turned;
    const std::size_t n_vertices = points.size() / 3 - 2 * normals.vertices.size();
    for (std::size_t i = 0; i < normals.vertices.size(); ++i) {
        const Vector x = At(points, static_cast<std::size_t>(normals.vertices[i]));
        const Vector a = At(points, n_vertices + 2 * i), b = At(points, n_vertices + 2 * i + 1);
        const Vector normal =
            Unit(Cross({a[0] - x[0], a[1] - x[1], a[2] - x[2]}, {b[0] - x[0], b[1] - x[1], b[2] - x[2]}));
        turned.insert(turned.end(), normal.begin(), normal.end());
    }
    return turned;
}

}  // namespace SolidSubdiv::Cli

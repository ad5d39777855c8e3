// SPDX-License-Identifier: Apache-2.0
// Validator loop-surfaces: triangle meshes refined by the scheme `loop` against OpenSubdiv, on surfaces of ours and on
// OpenSubdiv's own catalogue where it is present.
#include <algorithm>
#include <map>
#include <set>

#include "catalogue.h"
#include "solid_shapes.h"
#include "surface_compare.h"
#include "surface_shapes.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

Findings CompareSurface(const std::vector<Triangle>& triangles, const std::vector<double>& positions, bool is_quick,
                        const SurfaceTags& tags = {}) {
    std::vector<Index> corners;
    for (const Triangle& t : triangles) corners.insert(corners.end(), t.begin(), t.end());
    Far::TopologyDescriptor descriptor;
    descriptor.n_vertices = static_cast<Index>(positions.size() / 3);
    descriptor.triangles = corners;
    Sdc::Loop scheme;
    scheme.features = tags.has_sharp_corners ? Sdc::Features::Sharp : Sdc::Features::Smooth;
    scheme.creasing = tags.is_chaikin ? Sdc::CreasingMethod::Chaikin : Sdc::CreasingMethod::Uniform;
    return CompareWithLoop(descriptor, scheme, triangles, positions, tags, ComparedLevels().AtMostTwoIf(is_quick));
}

/// The surface with tags of every kind, under both creasing methods.
void CompareTagged(const std::string& name, const std::vector<Triangle>& triangles,
                   const std::vector<double>& positions, std::uint32_t seed, bool is_quick, Findings& findings) {
    for (bool infinite : {false, true}) {
        SurfaceTags tags = RandomTags(triangles, seed, infinite);
        tags.has_sharp_corners = seed % 2 == 1;
        for (bool is_chaikin : {false, true}) {
            tags.is_chaikin = is_chaikin;
            findings.Merge(CompareSurface(triangles, positions, is_quick, tags),
                           name + (infinite ? ", infinite tags" : ", tags") + (is_chaikin ? ", Chaikin" : ""));
        }
    }
}

/// A vertex where closed and open fans meet and two border edges end, or -1. There the rules differ on purpose:
/// OpenSubdiv fixes every such vertex, ours lets the two borders run through it as a crease (docs/concepts.md).
int FindMixedFan(const std::vector<Triangle>& triangles) {
    std::map<std::array<int, 2>, int> faces_of_edge;
    std::map<int, std::vector<std::array<int, 2>>> links;
    for (const Triangle& t : triangles) {
        for (int i = 0; i < 3; ++i) {
            const int a = t[(i + 1) % 3], b = t[(i + 2) % 3];
            ++faces_of_edge[{std::min(a, b), std::max(a, b)}];
            links[t[i]].push_back({a, b});
        }
    }
    for (const auto& [v, link] : links) {
        std::map<int, int> component;  // of the link's vertices
        for (const auto& [a, b] : link) {
            component.emplace(a, a);
            component.emplace(b, b);
        }
        for (std::size_t pass = 0; pass < link.size(); ++pass) {
            for (const auto& [a, b] : link) component[a] = component[b] = std::min(component[a], component[b]);
        }
        std::set<int> fans;
        int n_borders = 0;
        for (const auto& [neighbor, fan] : component) {
            fans.insert(fan);
            n_borders += faces_of_edge[{std::min(v, neighbor), std::max(v, neighbor)}] != 2;
        }
        if (fans.size() > 1 && n_borders == 2) return v;
    }
    return -1;
}

/// Why a shape of OpenSubdiv's catalogue can't be compared, or an empty text.
std::string ReasonToSkip(const std::vector<Triangle>& triangles) {
    std::set<std::set<int>> sets;
    for (const Triangle& t : triangles) {
        const std::set<int> set(t.begin(), t.end());
        if (set.size() < 3) return "a triangle with a vertex twice, which is refused";
        if (!sets.insert(set).second) return "two triangles with the same vertices, which are refused";
    }
    if (const int v = FindMixedFan(triangles); v >= 0) {
        return "closed and open fans meet in vertex " + std::to_string(v) +
               ", which OpenSubdiv fixes and our rule treats as a crease's";
    }
    return "";
}

std::vector<Triangle> TrianglesOf(const Io::Mesh& mesh) {
    std::vector<Triangle> triangles(static_cast<std::size_t>(mesh.topology.n_triangles()));
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        std::copy_n(&mesh.topology.triangles[3 * t], 3, triangles[t].begin());
    }
    return triangles;
}

}  // namespace

Findings ValidateLoopSurfaces(const Context& context) {
    Findings findings;
    const std::vector<SurfaceShape> shapes = AllSurfaces();
    std::uint32_t seed = 0;
    for (const SurfaceShape& shape : shapes) {
        findings.Merge(CompareSurface(shape.triangles, shape.positions, context.is_quick), shape.name);
        CompareTagged(shape.name, shape.triangles, shape.positions, seed++, context.is_quick, findings);
    }
    findings.notes.push_back(std::to_string(shapes.size()) +
                             " surfaces of ours, levels 1-5, each also with four sets of "
                             "random creases and corners");
    CompareCatalogue(
        context.osd_shapes, {"loop_"}, [](const Io::Mesh& mesh) { return ReasonToSkip(TrianglesOf(mesh)); },
        [&](const std::string&, const Io::Mesh& mesh) {
            return CompareSurface(TrianglesOf(mesh), mesh.positions, context.is_quick, TagsOf(mesh));
        },
        findings);
    return findings;
}

}  // namespace SolidSubdiv::Validation

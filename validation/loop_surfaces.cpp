// SPDX-License-Identifier: Apache-2.0
// Validator loop-surfaces: triangle meshes refined by the scheme `loop` against OpenSubdiv, on surfaces of ours and on
// OpenSubdiv's own catalogue where it is present.
#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/sdc/errors.h>

#include "loop_compare.h"
#include "solid_shapes.h"
#include "surface_shapes.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

Findings CompareSurface(const std::vector<Triangle>& triangles, const std::vector<double>& positions) {
    std::vector<Index> corners;
    for (const Triangle& t : triangles) corners.insert(corners.end(), t.begin(), t.end());
    Far::TopologyDescriptor descriptor;
    descriptor.n_vertices = static_cast<Index>(positions.size() / 3);
    descriptor.triangles = corners;
    return CompareWithLoop(descriptor, Sdc::Loop{}, triangles, positions);
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
std::string ReasonToSkip(const std::filesystem::path& path, const std::vector<Triangle>& triangles) {
    std::ifstream file(path);
    int n_tags = 0;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string keyword, tag;
        words >> keyword >> tag;
        // `interpolateboundary` chooses a rule for the whole surface: here both sides take the smooth one instead.
        n_tags += keyword == "t" && tag != "interpolateboundary" && tag != "creasemethod";
    }
    if (n_tags > 0) return std::to_string(n_tags) + " creases or corners, which are not supported yet";
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

void CompareCatalogue(const std::filesystem::path& folder, Findings& findings) {
    if (!std::filesystem::is_directory(folder)) {
        findings.skipped.push_back("OpenSubdiv's catalogue: there is no " + folder.string());
        return;
    }
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with("loop_") && name.ends_with(".obj")) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    int n_compared = 0;
    for (const std::filesystem::path& path : files) {
        const std::string name = path.filename().string();
        const Io::Mesh mesh = Io::ReadMesh(path);
        std::vector<Triangle> triangles(static_cast<std::size_t>(mesh.topology.n_triangles()));
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            std::copy_n(&mesh.topology.triangles[3 * t], 3, triangles[t].begin());
        }
        if (const std::string reason = ReasonToSkip(path, triangles); !reason.empty()) {
            findings.skipped.push_back(name + ": " + reason);
            continue;
        }
        try {
            findings.Merge(CompareSurface(triangles, mesh.positions), name);
        } catch (const Error& error) {
            findings.Fault(name + ": " + error.what());
        }
        ++n_compared;
    }
    findings.notes.push_back(std::to_string(n_compared) + " of " + std::to_string(files.size()) +
                             " shapes of OpenSubdiv's catalogue compared");
}

}  // namespace

Findings ValidateLoopSurfaces(const Context& context) {
    Findings findings;
    int n_shapes = 0;
    for (const SolidShape& solid : ManifoldShapes()) {  // their boundaries are closed surfaces of every kind
        findings.Merge(CompareSurface(BoundaryTriangles(solid.complex), solid.positions), "boundary of " + solid.name);
        ++n_shapes;
    }
    for (const SurfaceShape& shape : OpenSurfaces()) {
        findings.Merge(CompareSurface(shape.triangles, shape.positions), shape.name);
        ++n_shapes;
    }
    findings.notes.push_back(std::to_string(n_shapes) + " surfaces of ours, levels 1-4");
    CompareCatalogue(context.osd_shapes, findings);
    return findings;
}

}  // namespace SolidSubdiv::Validation

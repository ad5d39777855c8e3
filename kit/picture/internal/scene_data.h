// SPDX-License-Identifier: Apache-2.0
// A scene's own copies of what was added to it.
#pragma once

#include <vector>

#include <solidsubdiv/kit/picture/internal/vec3.h>
#include <solidsubdiv/kit/picture/scene.h>

namespace SolidSubdiv::Picture::Internal {

struct SurfaceData {
    std::vector<Vec3d> positions;
    std::vector<Index> triangles;
    Material material;
    std::vector<Color> triangle_colors;
    std::vector<float> values;  ///< place on the colour map, 0 to 1 between low and high
    ColorMap map;
};

struct LinesData {
    std::vector<Vec3d> positions;
    std::vector<Index> edges;
    Color color;
    double width;
    bool shaded;
};

struct PointsData {
    std::vector<Vec3d> positions;
    Color color;
    double diameter;
    bool shaded;
};

struct SceneData {
    std::vector<SurfaceData> surfaces;
    std::vector<LinesData> lines;
    std::vector<PointsData> points;

    /// Calls visit(p) for every point that is part of something drawn.
    template <class Visit>
    void ForEachUsedPoint(Visit&& visit) const {
        for (const SurfaceData& s : surfaces) {
            for (Index v : s.triangles) visit(s.positions[static_cast<std::size_t>(v)]);
        }
        for (const LinesData& l : lines) {
            for (Index v : l.edges) visit(l.positions[static_cast<std::size_t>(v)]);
        }
        for (const PointsData& p : points) {
            for (const Vec3d& v : p.positions) visit(v);
        }
    }
};

}  // namespace SolidSubdiv::Picture::Internal

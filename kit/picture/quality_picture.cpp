// SPDX-License-Identifier: Apache-2.0
// Three panels: outside, cut open, and the worst cells; see quality_picture.h.
#include <solidsubdiv/kit/picture/internal/cell_shapes.h>
#include <solidsubdiv/kit/picture/internal/picture_parts.h>
#include <solidsubdiv/kit/picture/quality_picture.h>
#include <solidsubdiv/sdc/errors.h>

#include <cstdio>
#include <string>

namespace SolidSubdiv::Picture {
namespace {

using Internal::CutPlane;
using Internal::LineWidth;
using Internal::VisibleEdges;

constexpr Color kBad = Color::Hex(0xe3122b);
constexpr Color kFaint = Color::Hex(0xb4bcc6);
constexpr double kWorstShare = 0.05;

Color ColorOfQuality(double quality) { return quality > 0 ? Lookup(ColorMap::Sequential, quality) : kBad; }

Scene FacesScene(const Io::Mesh& mesh, const SolidFaces& faces, const std::vector<Index>& edges,
                 std::span<const double> quality, const RenderOptions& render) {
    std::vector<Color> colors;
    for (Index cell : faces.cells) colors.push_back(ColorOfQuality(quality[static_cast<std::size_t>(cell)]));
    Scene scene;
    scene.Add(Surface{.positions = mesh.positions,
                      .triangles = faces.triangles,
                      .material = {.smooth = false, .gloss = 0},
                      .triangle_colors = colors});
    scene.Add(Lines{.positions = mesh.positions, .edges = edges, .width = LineWidth(edges.size() / 2, render, 1.2)});
    return scene;
}

/// Faces of the cells of at most `most`.
SolidFaces FacesOfCells(const Io::Mesh& mesh, std::span<const double> quality, double most) {
    SolidFaces faces;
    std::vector<std::array<Index, 2>> edges;
    std::size_t number = 0;
    Internal::ForEachCell(mesh.topology, [&](const Internal::CellFaces& cell) {
        const std::size_t c = number++;
        if (quality[c] > most) return;
        for (std::size_t f = 0; f < cell.n_faces(); ++f) {
            const auto v = cell.face(f);
            for (std::size_t k = 0; k < v.size(); ++k) {
                const Index a = v[k], b = v[(k + 1) % v.size()];
                edges.push_back({std::min(a, b), std::max(a, b)});
                if (k < 2) continue;
                faces.triangles.insert(faces.triangles.end(), {v[0], v[k - 1], v[k]});
                faces.cells.push_back(static_cast<Index>(c));
            }
        }
    });
    faces.edges = Internal::UniqueEdges(std::move(edges));
    return faces;
}

/// The quality that a share of the cells does not pass.
double Quantile(std::span<const double> quality, double share) {
    std::vector<double> sorted(quality.begin(), quality.end());
    const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), at, sorted.end());
    return *at;
}

}  // namespace

Image QualityPicture(const Io::Mesh& mesh, std::span<const double> quality, const QualityPictureOptions& options,
                     const Progress& progress) {
    if (mesh.topology.n_cells() == 0) throw InvalidInput("picture: there are no cells to show");
    if (static_cast<Offset>(quality.size()) != mesh.topology.n_cells()) {
        throw InvalidInput("picture: " + std::to_string(quality.size()) + " qualities of " +
                           std::to_string(mesh.topology.n_cells()) + " cells");
    }
    const SolidFaces skin = SolidBoundary(mesh);
    const SolidFaces cut = CutSolid(mesh, options.plane.value_or(CutPlane(mesh, options.view)));
    const double most = Quantile(quality, kWorstShare);
    const SolidFaces worst = FacesOfCells(mesh, quality, most);
    const std::vector<Index> sides = VisibleEdges(mesh, skin.triangles);

    Scene scenes[3];
    scenes[0] = FacesScene(mesh, skin, sides, quality, options.render);
    scenes[1] = FacesScene(mesh, cut, VisibleEdges(mesh, cut.triangles), quality, options.render);
    scenes[2] = FacesScene(mesh, worst, worst.edges, quality, options.render);
    scenes[2].Add(Lines{.positions = mesh.positions,
                        .edges = sides,
                        .color = kFaint,
                        .width = 0.6 * LineWidth(sides.size() / 2, options.render, 1.2)});

    char worst_caption[80];
    std::snprintf(worst_caption, sizeof worst_caption, "the worst %.0f %%: up to %.2g", 100 * kWorstShare, most);
    const ColorBar bar{.low = 0, .high = 1, .title = options.title};
    const bool has_bad = std::any_of(quality.begin(), quality.end(), [](double q) { return !(q > 0); });
    const ScenePanel panels[] = {{&scenes[0], "outside", {}},
                                 {&scenes[1], has_bad ? "cut open (red: not positive)" : "cut open", bar},
                                 {&scenes[2], worst_caption, {}}};
    return RenderPanels(panels, options.view, options.render, {.columns = 3}, progress);
}

}  // namespace SolidSubdiv::Picture

// SPDX-License-Identifier: Apache-2.0
// A scene a state; see deformation_picture.h.
#include <solidsubdiv/kit/picture/deformation_picture.h>
#include <solidsubdiv/kit/picture/internal/picture_parts.h>
#include <solidsubdiv/sdc/errors.h>

#include <string>
#include <vector>

namespace SolidSubdiv::Picture {
namespace {

/// More edges inside a lattice than these hide the model.
constexpr std::size_t kMostInside = 400;

/// All edges of a coarse lattice: its faces are not drawn, and what moved inside is to be seen. Of others the outside.
std::vector<Index> LatticeEdges(const Io::Mesh& lattice) {
    const std::vector<Index> all = ElementEdges(lattice.topology);
    return all.size() / 2 <= kMostInside ? all : Internal::VisibleEdges(lattice, Internal::VisibleTriangles(lattice));
}

Scene StateScene(const DeformationState& state, const RenderOptions& render) {
    const Io::Mesh& model = *state.model;
    const std::vector<Index> skin = Internal::VisibleTriangles(model);
    Scene scene;
    if (skin.empty()) {
        const double diameter = 3 * Internal::LineWidth(model.positions.size() / 3, render, 2);
        scene.Add(Points{.positions = model.positions, .color = Palette::kSkin, .diameter = diameter});
    } else {
        scene.Add(Surface{.positions = model.positions, .triangles = skin});
    }
    if (state.lattice != nullptr) {
        Internal::AddLattice(scene, *state.lattice, LatticeEdges(*state.lattice), render);
    }
    return scene;
}

}  // namespace

Image DeformationPicture(std::span<const DeformationState> states, const DeformationPictureOptions& options,
                         const Progress& progress) {
    if (states.empty()) throw InvalidInput("picture: there is no state to show");
    std::vector<Scene> scenes;
    for (const DeformationState& state : states) {
        if (state.model == nullptr) {
            throw InvalidInput("picture: state " + std::to_string(scenes.size()) + " has no model");
        }
        scenes.push_back(StateScene(state, options.render));
    }
    std::vector<ScenePanel> panels;
    for (std::size_t i = 0; i < scenes.size(); ++i) panels.push_back({&scenes[i], states[i].caption, {}});
    return RenderPanels(panels, options.view, options.render, options.panels, progress);
}

}  // namespace SolidSubdiv::Picture

// SPDX-License-Identifier: Apache-2.0
// The picture that tells a deformation: a model in its control lattice, before and after, as often as it was moved.
//
//     const Picture::DeformationState states[] = {{&model, &lattice, "at rest"}, {&bent, &bent_lattice, "bent"}};
//     Picture::WritePng("deformed.png", Picture::DeformationPicture(states));
#pragma once

#include <span>
#include <string>

#include <solidsubdiv/kit/io/mesh.h>
#include <solidsubdiv/kit/picture/panels.h>

namespace SolidSubdiv::Picture {

/// A model, and the lattice that it is in then.
struct DeformationState {
    const Io::Mesh* model = nullptr;    ///< smooth; without faces, its points as small balls
    const Io::Mesh* lattice = nullptr;  ///< its edges, those inside too if they are few; null: the model alone
    std::string caption{};
};

struct DeformationPictureOptions {
    View view{.azimuth = 20, .elevation = 14};
    RenderOptions render{.width = 640, .height = 600};  ///< of one panel
    PanelOptions panels{};                              ///< side by side
};

/// One panel a state, all with one camera. @throws InvalidInput if there is no state, or one without a model
Image DeformationPicture(std::span<const DeformationState> states, const DeformationPictureOptions& options = {},
                         const Progress& progress = {});

}  // namespace SolidSubdiv::Picture

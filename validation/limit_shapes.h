// SPDX-License-Identifier: Apache-2.0
// What limit-places walks on: shapes of every kind, plain and creased, each with all schemes that take it.
#pragma once

#include <string>
#include <vector>

#include "limit_walk.h"

namespace SolidSubdiv::Validation {

struct LimitShape {
    std::string name;
    OwnedMesh mesh;
    std::vector<double> positions;
    Sdc::Split split = Sdc::Split::TetOct;
    std::vector<Sdc::Scheme> schemes{};  ///< one creasing method
    int n_in_cells = 0, n_on_faces = 0;  ///< places
};

std::vector<LimitShape> LimitShapes();

}  // namespace SolidSubdiv::Validation

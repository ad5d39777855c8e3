// SPDX-License-Identifier: Apache-2.0
// Writes surfaces for vtk_butterfly.py and reads what it prints.
#include "vtk_butterfly_oracle.h"

#include <fstream>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "python_script.h"
#include "split_levels_oracle.h"

namespace SolidSubdiv::Validation {

namespace {

void WriteSurfaces(const std::filesystem::path& path, std::span<const ControlSurface> surfaces) {
    std::ofstream file(path);
    file << std::setprecision(std::numeric_limits<double>::max_digits10);
    for (const ControlSurface& surface : surfaces) {
        file << surface.n_vertices << ' ' << surface.triangles.size() << '\n';
        for (std::size_t i = 0; i < surface.positions.size(); ++i) {
            file << surface.positions[i] << (i % 3 == 2 ? '\n' : ' ');
        }
        for (const Triangle& t : surface.triangles) file << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
    }
    if (!file.flush()) throw std::runtime_error(path.string() + ": can't be written");
}

SurfaceLevel ReadLevel(std::istream& input) {
    SurfaceLevel level;
    std::size_t n_triangles = 0;
    input >> level.n_vertices >> n_triangles;
    if (!input) return level;
    level.positions.resize(3 * static_cast<std::size_t>(level.n_vertices));
    level.triangles.resize(n_triangles);
    for (double& x : level.positions) input >> x;
    for (Triangle& t : level.triangles) input >> t[0] >> t[1] >> t[2];
    return level;
}

}  // namespace

std::vector<VtkRefinement> RefineByVtk(const std::filesystem::path& script, const std::filesystem::path& scratch,
                                       std::span<const ControlSurface> surfaces, int max_level) {
    const auto path = scratch / "surfaces.txt";
    WriteSurfaces(path, surfaces);
    std::istringstream output(RunVtkScript(script, {path, std::to_string(max_level)}));
    std::vector<VtkRefinement> result;
    for (std::string keyword; output >> keyword;) {
        std::size_t number = 0;
        if (keyword == "surface" && output >> number && number == result.size() && number < surfaces.size()) {
            const ControlSurface& surface = surfaces[number];
            result.emplace_back().levels.resize(1);
            SurfaceLevel& control = result.back().levels[0];
            control.n_vertices = surface.n_vertices;
            control.triangles = surface.triangles;
            control.positions = surface.positions;
        } else if (keyword == "level" && !result.empty() && output >> number) {
            SurfaceLevel level = ReadLevel(output);
            VtkRefinement& refinement = result.back();
            if (!refinement.refused.empty()) continue;
            try {
                FindChildren(refinement.levels.back(), level);
                refinement.levels.push_back(std::move(level));
            } catch (const std::runtime_error& error) {
                refinement.refused = error.what();
            }
        } else if (keyword == "refused" && !result.empty()) {
            std::getline(output >> std::ws, result.back().refused);
        } else {
            output.setstate(std::ios::failbit);
        }
        if (!output) throw std::runtime_error("vtk_butterfly.py prints something unexpected at '" + keyword + "'");
    }
    if (result.size() != surfaces.size()) throw std::runtime_error("vtk_butterfly.py says too little");
    return result;
}

}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
// Reads lines of a vertex, a place and a weight.
#include <solidsubdiv/apps/cli/drag_targets.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace SolidSubdiv::Cli {

std::vector<Deform::DragTarget> ReadDragTargets(const std::string& file, Index n_vertices) {
    std::ifstream stream(file);
    if (!stream || std::filesystem::is_directory(file)) throw IoError(file + ": there is no such file");
    std::vector<Deform::DragTarget> targets;
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        const auto fail = [&](const std::string& what) {
            throw IoError(file + ": line " + std::to_string(number) + ": " + what);
        };
        std::istringstream words(line.substr(0, line.find('#')));
        if ((words >> std::ws).eof()) continue;
        Deform::DragTarget target;
        auto& [x, y, z] = target.position;
        if (!(words >> target.point >> x >> y >> z)) fail("a vertex and three coordinates are expected: 12 0.5 0 1");
        if (!(words >> std::ws).eof() && !(words >> target.weight)) fail("the weight is no number");
        if (!(words >> std::ws).eof()) fail("nothing may follow the weight");
        if (target.point < 0 || target.point >= n_vertices) {
            fail("there is no vertex " + std::to_string(target.point) + "; the model has " +
                 std::to_string(n_vertices) + ", counted from 0");
        }
        if (!(target.weight > 0)) fail("the weight must be above 0");
        targets.push_back(target);
    }
    if (targets.empty()) throw IoError(file + ": has no targets; a line is a vertex and where it goes: 12 0.5 0 1");
    return targets;
}

}  // namespace SolidSubdiv::Cli

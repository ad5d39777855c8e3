// SPDX-License-Identifier: Apache-2.0
// The cell data `diagonal`.
#include <solidsubdiv/apps/cli/diagonal_data.h>

#include <solidsubdiv/apps/cli/common.h>

namespace SolidSubdiv::Cli {

std::vector<std::uint8_t> RequireDiagonalData(const Io::Mesh& mesh) {
    const Io::Attribute* data = mesh.FindCellData(std::string(kDiagonalName));
    if (!data) throw InvalidInput("has no cell data 'diagonal'; choose other --diagonals");
    if (data->width != 1) {
        throw InvalidInput("cell data 'diagonal' has " + std::to_string(data->width) +
                           " numbers a cell; one is needed");
    }
    const auto n = static_cast<std::size_t>(mesh.topology.n_tets() + mesh.topology.n_octs());
    std::vector<std::uint8_t> diagonals(n);
    for (std::size_t c = 0; c < n; ++c) {
        const double value = data->values[c];
        if (value != 0 && value != 1 && value != 2) {
            throw InvalidInput("cell data 'diagonal' of cell " + std::to_string(c) + " is " + Text(value) +
                               "; it must be 0, 1 or 2");
        }
        diagonals[c] = static_cast<std::uint8_t>(value);
    }
    return diagonals;
}

std::optional<std::vector<std::uint8_t>> FindDiagonalData(const Io::Mesh& mesh) {
    try {
        return RequireDiagonalData(mesh);
    } catch (const InvalidInput&) {
        return std::nullopt;
    }
}

}  // namespace SolidSubdiv::Cli

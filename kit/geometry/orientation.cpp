// SPDX-License-Identifier: Apache-2.0
// Cells of negative volume: found, and turned, refused or left.
#include <solidsubdiv/kit/geometry/orientation.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include <solidsubdiv/kit/geometry/cell_volume.h>
#include <solidsubdiv/sdc/errors.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Geometry {

namespace {

enum class Sign : signed char { Negative, Flat, Positive };

template <std::size_t N, class Volume>
void Classify(std::span<const Index> cells, std::span<const double> positions, Volume&& volume,
              std::vector<Index>& inverted, std::vector<Index>& flat) {
    const Offset n = static_cast<Offset>(cells.size() / N);
    std::vector<Sign> signs(static_cast<std::size_t>(n));
    Sdc::ParallelFor(n, 4096, [&](Offset begin, Offset end) {
        for (Offset c = begin; c < end; ++c) {
            const auto cell = cells.subspan(c * static_cast<Offset>(N)).template first<N>();
            const double v = volume(positions, cell);
            const bool is_flat = std::abs(v) <= VolumeRoundoff(positions, cell);
            signs[c] = is_flat ? Sign::Flat : v < 0 ? Sign::Negative : Sign::Positive;
        }
    });
    for (Offset c = 0; c < n; ++c) {
        if (signs[c] == Sign::Negative) inverted.push_back(static_cast<Index>(c));
        if (signs[c] == Sign::Flat) flat.push_back(static_cast<Index>(c));
    }
}

[[noreturn]] void Refuse(const OrientationReport& report, std::span<const Index> tets, std::span<const Index> octs,
                         std::span<const double> positions) {
    const bool is_tet = !report.inverted_tets.empty();
    const Index c = is_tet ? report.inverted_tets[0] : report.inverted_octs[0];
    const double volume = is_tet ? TetVolume(positions, tets.subspan(4 * static_cast<std::size_t>(c)).first<4>())
                                 : OctVolume(positions, octs.subspan(6 * static_cast<std::size_t>(c)).first<6>());
    char volume_text[32];
    std::snprintf(volume_text, sizeof volume_text, "%.6g", volume);
    const Offset others = report.n_inverted() - 1;
    const std::string more =
        others == 0 ? "" : " (and " + std::to_string(others) + (others == 1 ? " other is)" : " others are)");
    throw InvalidInput((is_tet ? "tet " : "oct ") + std::to_string(c) + " is inverted, its volume is " + volume_text +
                       more + "; repair its orientation");
}

}  // namespace

OrientationReport FindInvertedCells(std::span<const Index> tets, std::span<const Index> octs,
                                    std::span<const double> positions) {
    OrientationReport report;
    Classify<4>(tets, positions, TetVolume, report.inverted_tets, report.flat_tets);
    Classify<6>(octs, positions, OctVolume, report.inverted_octs, report.flat_octs);
    return report;
}

OrientationReport OrientCells(std::span<Index> tets, std::span<Index> octs, std::span<const double> positions,
                              OrientationPolicy policy) {
    OrientationReport report = FindInvertedCells(tets, octs, positions);
    if (policy == OrientationPolicy::Keep || report.n_inverted() == 0) return report;
    if (policy == OrientationPolicy::Refuse) Refuse(report, tets, octs, positions);
    for (Index c : report.inverted_tets) {
        const auto tet = tets.subspan(4 * static_cast<std::size_t>(c), 4);
        std::swap(tet[2], tet[3]);
    }
    for (Index c : report.inverted_octs) {
        const auto oct = octs.subspan(6 * static_cast<std::size_t>(c), 6);
        std::swap(oct[4], oct[5]);
    }
    return report;
}

void OrientOtherCells(const OtherCells& cells, std::span<const double> positions, OrientationPolicy policy,
                      OrientationReport& report) {
    Far::TopologyDescriptor d{.n_vertices = static_cast<Index>(positions.size() / 3)};
    d.hexes = cells.hexes, d.wedges = cells.wedges, d.pyramids = cells.pyramids;
    d.polyhedron_offsets = cells.polyhedron_offsets, d.polyhedron_face_offsets = cells.polyhedron_face_offsets;
    d.polyhedron_vertices = cells.polyhedron_vertices;
    const std::vector<double> volumes = CellVolumes(d, positions);
    std::size_t next = 0;
    // Looks at the n cells of a kind that come next among the volumes.
    const auto look = [&](const char* name, std::size_t n, auto&& vertices, auto&& turn) {
        for (std::size_t c = 0; c < n; ++c) {
            const double volume = volumes[next++];
            if (std::abs(volume) <= VolumeRoundoff(positions, vertices(c))) {
                ++report.n_flat_others;
            } else if (volume < 0) {
                ++report.n_inverted_others;
                if (policy == OrientationPolicy::Refuse) {
                    char volume_text[32];
                    std::snprintf(volume_text, sizeof volume_text, "%.6g", volume);
                    throw InvalidInput(std::string(name) + " " + std::to_string(c) + " is inverted, its volume is " +
                                       volume_text + "; repair its orientation");
                }
                if (policy == OrientationPolicy::Repair) turn(c);
            }
        }
    };
    const auto rows = [](std::span<Index> all, std::size_t arity) {
        return [=](std::size_t c) { return all.subspan(arity * c, arity); };
    };
    const auto exchange = [](std::span<Index> cell) {
        std::swap_ranges(cell.begin(), cell.begin() + static_cast<std::ptrdiff_t>(cell.size() / 2),
                         cell.begin() + static_cast<std::ptrdiff_t>(cell.size() / 2));
    };
    const auto hex = rows(cells.hexes, 8), wedge = rows(cells.wedges, 6), pyramid = rows(cells.pyramids, 5);
    look("hexahedron", cells.hexes.size() / 8, hex, [&](std::size_t c) { exchange(hex(c)); });
    look("wedge", cells.wedges.size() / 6, wedge, [&](std::size_t c) { exchange(wedge(c)); });
    look("pyramid", cells.pyramids.size() / 5, pyramid,
         [&](std::size_t c) { std::swap(pyramid(c)[1], pyramid(c)[3]); });
    const auto face = [&](Offset f) {
        const Offset begin = cells.polyhedron_face_offsets[f];
        return cells.polyhedron_vertices.subspan(begin, cells.polyhedron_face_offsets[f + 1] - begin);
    };
    const auto polyhedron = [&](std::size_t c) {
        const Offset begin = cells.polyhedron_face_offsets[cells.polyhedron_offsets[c]];
        return cells.polyhedron_vertices.subspan(
            begin, cells.polyhedron_face_offsets[cells.polyhedron_offsets[c + 1]] - begin);
    };
    look("polyhedron", cells.polyhedron_offsets.empty() ? 0 : cells.polyhedron_offsets.size() - 1, polyhedron,
         [&](std::size_t c) {
             for (Offset f = cells.polyhedron_offsets[c]; f < cells.polyhedron_offsets[c + 1]; ++f) {
                 std::reverse(face(f).begin(), face(f).end());
             }
         });
}

OrientationPolicy OrientationPolicyOf(std::string_view name) {
    if (name == "repair") return OrientationPolicy::Repair;
    if (name == "keep") return OrientationPolicy::Keep;
    if (name == "refuse") return OrientationPolicy::Refuse;
    throw InvalidInput("there is no orientation policy '" + std::string(name) + "'; there are repair, keep and refuse");
}

}  // namespace SolidSubdiv::Geometry

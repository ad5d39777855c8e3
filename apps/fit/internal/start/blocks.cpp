// SPDX-License-Identifier: Apache-2.0
// Corners are looked at with the eight cubes around them, again and again while cubes change.
#include <solidsubdiv/apps/fit/internal/start/blocks.h>

#include <algorithm>
#include <map>
#include <tuple>

#include <solidsubdiv/sdc/cells.h>
#include <solidsubdiv/sdc/disjoint_sets.h>

namespace SolidSubdiv::Fit::Starting {

namespace {

/// Corners of a hexahedron in VTK's order.
constexpr int kHexCorners[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                   {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

}  // namespace

template <class Function>
void Blocks::ForEachCorner(Function&& function) const {
    for (int z = 1; z < n_[2]; ++z) {
        for (int y = 1; y < n_[1]; ++y) {
            for (int x = 1; x < n_[0]; ++x) function(x, y, z);
        }
    }
}

Blocks::Blocks(const InsideGrid& grid, const BlockChoice& choice) : size_(choice.size), threshold_(choice.threshold) {
    const auto [low, high] = grid.Bounds();
    std::array<double, 3> origin{};
    for (std::size_t k = 0; k < 3; ++k) {
        // A rounding more or less makes no cube.
        const double half = .5 * (high[k] - low[k]) / size_ - 1e-6;
        const double before = std::ceil(half - choice.phase[k]) + 2, after = std::ceil(half + choice.phase[k]) + 2;
        n_[k] = static_cast<int>(before + after);
        origin[k] = .5 * (low[k] + high[k]) - size_ * (before + choice.phase[k]);
    }
    origin_ = {origin[0], origin[1], origin[2]};
    in_.assign(At(0, 0, n_[2]), 0);
    parts_.assign(in_.size(), 0);
    for (int z = 2; z < n_[2] - 2; ++z) {
        for (int y = 2; y < n_[1] - 2; ++y) {
            for (int x = 2; x < n_[0] - 2; ++x) {
                const Vec3 corner = origin_ + size_ * Vec3{1. * x, 1. * y, 1. * z};
                const double part = grid.Fraction(corner, corner + Vec3{size_, size_, size_});
                parts_[At(x, y, z)] = part;
                in_[At(x, y, z)] = part >= threshold_;
            }
        }
    }
    if (choice.growth < 1) Grow(grid, choice.growth);
}

void Blocks::Grow(const InsideGrid& grid, double growth) {
    struct Beside {
        double part;
        int x, y, z;
    };
    const auto part_beyond = [&](int x, int y, int z) {
        const bool in[3][2] = {{IsIn(x - 1, y, z), IsIn(x + 1, y, z)},
                               {IsIn(x, y - 1, z), IsIn(x, y + 1, z)},
                               {IsIn(x, y, z - 1), IsIn(x, y, z + 1)}};
        double low[3], high[3];
        bool is_beside = false, is_empty = false;
        const int place[3] = {x, y, z};
        for (std::size_t k = 0; k < 3; ++k) {
            is_beside |= in[k][0] || in[k][1];
            is_empty |= in[k][0] && in[k][1];
            low[k] = origin_[k] + size_ * (place[k] + (in[k][0] ? .5 : 0));
            high[k] = origin_[k] + size_ * (place[k] + (in[k][1] ? .5 : 1));
        }
        if (!is_beside || is_empty) return 0.;
        return grid.Fraction({low[0], low[1], low[2]}, {high[0], high[1], high[2]});
    };
    // Those with most of it first; what they leave over is asked again.
    for (bool is_done = false; !is_done;) {
        std::vector<Beside> found;
        ForEachCorner([&](int x, int y, int z) {
            if (IsIn(x, y, z) || parts_[At(x, y, z)] == 0) return;
            const double part = part_beyond(x, y, z);
            if (part >= growth) found.push_back({part, x, y, z});
        });
        std::stable_sort(found.begin(), found.end(), [](const Beside& a, const Beside& b) { return a.part > b.part; });
        for (const Beside& b : found) {
            if (part_beyond(b.x, b.y, b.z) >= growth) in_[At(b.x, b.y, b.z)] = 1;
        }
        is_done = found.empty();
    }
}

std::array<int, 3> Blocks::Outward(int x, int y, int z) const {
    bool in[2][2][2];
    for (int c = 0; c < 8; ++c) {
        const int i = c & 1, j = c >> 1 & 1, k = c >> 2;
        in[i][j][k] = IsIn(x - 1 + i, y - 1 + j, z - 1 + k);
    }
    std::array<int, 3> seen{};  // bit 0: up, bit 1: down
    for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) {
            const bool pairs[3][2] = {
                {in[0][i][j], in[1][i][j]}, {in[i][0][j], in[i][1][j]}, {in[i][j][0], in[i][j][1]}};
            for (std::size_t k = 0; k < 3; ++k) {
                if (pairs[k][0] != pairs[k][1]) seen[k] |= pairs[k][0] ? 1 : 2;
            }
        }
    }
    for (int& s : seen) s = s == 3 ? 2 : s == 2 ? -1 : s;
    return seen;
}

bool Blocks::IsCritical(int x, int y, int z) const {
    const auto outward = Outward(x, y, z);
    return std::count(outward.begin(), outward.end(), 2) > 0;
}

int Blocks::CountCritical(int x, int y, int z) const {
    int n = 0;
    for (const auto& c : kHexCorners) n += IsCritical(x + c[0], y + c[1], z + c[2]);
    return n;
}

void Blocks::MendCorner(int x, int y, int z, std::vector<std::uint8_t>& is_final) {
    std::tuple<int, double, std::size_t> best{1000, 0, 0};
    for (const auto& c : kHexCorners) {
        const int i = x - 1 + c[0], j = y - 1 + c[1], k = z - 1 + c[2];
        const std::size_t cube = At(i, j, k);
        if (is_final[cube] != 0) continue;
        const int before = CountCritical(i, j, k);
        in_[cube] ^= 1;
        best = std::min(best, {CountCritical(i, j, k) - before, std::abs(parts_[cube] - threshold_), cube});
        in_[cube] ^= 1;
    }
    if (std::get<0>(best) == 1000) return;
    in_[std::get<2>(best)] ^= 1;
    is_final[std::get<2>(best)] = 1;  // so that there is an end
}

bool Blocks::Repair() {
    std::vector<std::uint8_t> is_final(in_.size(), 0);
    for (int z = 0; z < n_[2]; ++z) {
        for (int y = 0; y < n_[1]; ++y) {
            for (int x = 0; x < n_[0]; ++x) {
                // The outermost stay empty: what is outside hangs together.
                is_final[At(x, y, z)] =
                    x == 0 || y == 0 || z == 0 || x == n_[0] - 1 || y == n_[1] - 1 || z == n_[2] - 1;
            }
        }
    }
    constexpr int kMostRounds = 20;
    for (int round = 0; round < kMostRounds; ++round) {
        int n_critical = 0;
        ForEachCorner([&](int x, int y, int z) {
            if (!IsCritical(x, y, z)) return;
            ++n_critical;
            MendCorner(x, y, z, is_final);
        });
        if (n_critical == 0) return true;
    }
    return false;
}

/// Of each cube of the kind the lowest that it hangs together with, by faces; of others their number.
std::vector<std::size_t> Blocks::Pieces(std::uint8_t kind) const {
    Sdc::DisjointSets sets(in_.size());
    const std::size_t steps[3] = {1, static_cast<std::size_t>(n_[0]), static_cast<std::size_t>(n_[0] * n_[1])};
    for (int z = 0; z < n_[2]; ++z) {
        for (int y = 0; y < n_[1]; ++y) {
            for (int x = 0; x < n_[0]; ++x) {
                const std::size_t cube = At(x, y, z);
                const int place[3] = {x, y, z};
                for (std::size_t k = 0; k < 3; ++k) {
                    if (place[k] + 1 < n_[k] && in_[cube] == kind && in_[cube + steps[k]] == kind) {
                        sets.Unite(cube, cube + steps[k]);
                    }
                }
            }
        }
    }
    std::vector<std::size_t> pieces(in_.size());
    for (std::size_t cube = 0; cube < pieces.size(); ++cube) pieces[cube] = sets.Find(cube);
    return pieces;
}

void Blocks::Trim(Offset n_solids, Offset n_cavities) {
    // Solids first: what goes opens the cavities in it. The largest piece of what is empty is the outside, cube 0.
    for (const std::uint8_t kind : {std::uint8_t{1}, std::uint8_t{0}}) {
        const std::vector<std::size_t> pieces = Pieces(kind);
        std::map<std::size_t, Offset> sizes;
        for (std::size_t cube = 0; cube < pieces.size(); ++cube) {
            if (in_[cube] == kind && pieces[cube] != 0) ++sizes[pieces[cube]];
        }
        std::vector<std::pair<Offset, std::size_t>> largest;
        for (const auto& [piece, size] : sizes) largest.push_back({-size, piece});
        std::sort(largest.begin(), largest.end());
        std::vector<bool> stays(in_.size(), false);
        const auto n_stay = static_cast<std::size_t>(kind == 1 ? n_solids : n_cavities);
        for (std::size_t i = 0; i < std::min(n_stay, largest.size()); ++i) stays[largest[i].second] = true;
        for (std::size_t cube = 0; cube < pieces.size(); ++cube) {
            if (in_[cube] == kind && pieces[cube] != 0 && !stays[pieces[cube]]) in_[cube] ^= 1;
        }
    }
}

SolidTopology Blocks::Topology() const {
    SolidTopology topology{0, 0, 0};
    for (const std::uint8_t kind : {std::uint8_t{0}, std::uint8_t{1}}) {
        const std::vector<std::size_t> pieces = Pieces(kind);
        for (std::size_t cube = 1; cube < pieces.size(); ++cube) {
            if (in_[cube] == kind && pieces[cube] == cube) ++(kind == 1 ? topology.n_solids : topology.n_cavities);
        }
    }
    // A closed surface of quads has two edges a face.
    topology.euler = Count().boundary_corners;
    const std::size_t steps[3] = {1, static_cast<std::size_t>(n_[0]), static_cast<std::size_t>(n_[0] * n_[1])};
    for (std::size_t cube = 0; cube < in_.size(); ++cube) {
        for (std::size_t k = 0; in_[cube] != 0 && k < 3; ++k) {
            topology.euler -= (in_[cube - steps[k]] == 0) + (in_[cube + steps[k]] == 0);
        }
    }
    return topology;
}

Blocks::Counts Blocks::Count() const {
    Counts counts;
    ForEachCorner([&](int x, int y, int z) {
        int n = 0;
        for (const auto& c : kHexCorners) n += IsIn(x - c[0], y - c[1], z - c[2]);
        counts.corners += n > 0;
        counts.boundary_corners += n > 0 && n < 8;
    });
    counts.cubes = static_cast<Index>(std::count(in_.begin(), in_.end(), 1));
    return counts;
}

Blocks::Mesh Blocks::MakeMesh() const {
    Mesh mesh;
    std::vector<Index> numbers(in_.size(), kNoIndex);
    ForEachCorner([&](int x, int y, int z) {
        int n = 0;
        for (const auto& c : kHexCorners) n += IsIn(x - c[0], y - c[1], z - c[2]);
        if (n == 0) return;
        numbers[At(x, y, z)] = static_cast<Index>(mesh.outward.size());
        const Vec3 p = origin_ + size_ * Vec3{1. * x, 1. * y, 1. * z};
        mesh.positions.insert(mesh.positions.end(), {p.x, p.y, p.z});
        mesh.outward.push_back(Outward(x, y, z));
    });
    ForEachCorner([&](int x, int y, int z) {
        if (!IsIn(x, y, z)) return;
        std::array<Index, 8> corners{};
        for (std::size_t j = 0; j < 8; ++j) {
            corners[j] = numbers[At(x + kHexCorners[j][0], y + kHexCorners[j][1], z + kHexCorners[j][2])];
        }
        mesh.hexes.insert(mesh.hexes.end(), corners.begin(), corners.end());
        mesh.cells.push_back({x, y, z});
        for (std::size_t f = 0; f < 6; ++f) {
            std::array<int, 3> next{x, y, z};
            next[f / 2] += f % 2 == 0 ? -1 : 1;
            if (IsIn(next[0], next[1], next[2])) continue;
            for (std::size_t j : Sdc::Hex::faces[f]) mesh.quads.push_back(corners[j]);
        }
    });
    return mesh;
}

}  // namespace SolidSubdiv::Fit::Starting

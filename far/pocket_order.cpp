// SPDX-License-Identifier: Apache-2.0
// Orders of vertices.
#include <solidsubdiv/far/internal/pocket_order.h>

#include <algorithm>
#include <array>
#include <utility>

#include <solidsubdiv/sdc/cells.h>

namespace SolidSubdiv::Far::Internal {

namespace {

/// The rotations of a hexahedron, as orders of its vertices.
const std::vector<std::array<Sdc::Local, 8>>& HexRotations() {
    static const auto rotations = [] {
        using Order = std::array<Sdc::Local, 8>;
        const Order about_z{1, 2, 3, 0, 5, 6, 7, 4}, about_x{3, 2, 6, 7, 0, 1, 5, 4};
        std::vector<Order> all{{0, 1, 2, 3, 4, 5, 6, 7}};
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (const Order& turn : {about_z, about_x}) {
                Order next;
                for (std::size_t k = 0; k < 8; ++k) next[k] = all[i][turn[k]];
                if (std::find(all.begin(), all.end(), next) == all.end()) all.push_back(next);
            }
        }
        return all;
    }();
    return rotations;
}

}  // namespace

std::uint64_t Pack(std::span<const Index> numbers) {
    std::array<Index, 16> sorted;
    const std::size_t n = std::min(numbers.size(), sorted.size());
    std::copy(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(n), sorted.begin());
    std::sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(n));
    std::uint64_t packed = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        packed = packed << 16 | (i < n ? static_cast<std::uint64_t>(sorted[i]) & 0xFFFF : 0xFFFF);
    }
    return packed;
}

void Rotate(std::vector<Index>& cycle) {
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
}

void SortPairs(std::vector<Index>& v) {
    for (std::size_t i = 0; i < v.size(); i += 2) {
        if (v[i] > v[i + 1]) std::swap(v[i], v[i + 1]);
    }
    const std::size_t first = v.size() == 6 ? 2 : 0;
    if (v[first] > v[first + 2]) {
        std::swap(v[first], v[first + 2]);
        std::swap(v[first + 1], v[first + 3]);
    }
}
void SortHex(std::vector<Index>& v) {
    std::array<Index, 8> best{}, turned;
    bool is_first = true;
    for (const auto& rotation : HexRotations()) {
        for (std::size_t k = 0; k < 8; ++k) turned[k] = v[rotation[k]];
        if (std::exchange(is_first, false) || turned < best) best = turned;
    }
    v.assign(best.begin(), best.end());
}
}  // namespace SolidSubdiv::Far::Internal

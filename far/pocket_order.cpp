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
    // The four least, padded; nearly always there are no more.
    std::array<std::uint64_t, 4> least{0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF};
    if (numbers.size() <= least.size()) {
        for (std::size_t i = 0; i < numbers.size(); ++i) least[i] = static_cast<std::uint64_t>(numbers[i]) & 0xFFFF;
        const auto order = [&](std::size_t i, std::size_t k) {
            const std::uint64_t low = std::min(least[i], least[k]);
            least[k] = std::max(least[i], least[k]);
            least[i] = low;
        };
        order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
    } else {
        std::vector<Index> sorted(numbers.begin(), numbers.end());
        std::partial_sort(sorted.begin(), sorted.begin() + 4, sorted.end());
        for (std::size_t i = 0; i < 4; ++i) least[i] = static_cast<std::uint64_t>(sorted[i]) & 0xFFFF;
    }
    return least[0] << 48 | least[1] << 32 | least[2] << 16 | least[3];
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

// SPDX-License-Identifier: Apache-2.0
// Counts by collecting, for every face, the edges that its cells choose.
#include "diagonals_oracle.h"

#include <algorithm>
#include <map>
#include <vector>

namespace SolidSubdiv::Validation {

namespace {

using Edge = std::array<int, 2>;

Edge MakeEdge(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

}  // namespace

MatchedFaces CountMatchedFaces(const Complex& complex) {
    std::map<Triangle, std::vector<Edge>> choices;
    const auto add = [&](Triangle face, const Edge& edge) {
        std::sort(face.begin(), face.end());
        choices[face].push_back(edge);
    };
    for (const auto& t : complex.tets) {
        add({t[0], t[1], t[2]}, MakeEdge(t[0], t[1]));
        add({t[0], t[1], t[3]}, MakeEdge(t[0], t[1]));
        add({t[0], t[2], t[3]}, MakeEdge(t[2], t[3]));
        add({t[1], t[2], t[3]}, MakeEdge(t[2], t[3]));
    }
    for (const auto& o : complex.octs) {
        for (int corner = 0; corner < 8; ++corner) {
            const int a = o[corner & 1], b = o[2 + ((corner >> 1) & 1)], d = o[4 + ((corner >> 2) & 1)];
            add({a, b, d}, MakeEdge(b, d));
        }
    }
    MatchedFaces count;
    for (const auto& [face, edges] : choices) {
        if (edges.size() != 2) continue;
        ++count.n_inner;
        count.n_matched += edges[0] == edges[1];
    }
    return count;
}

bool IsSameCell(const std::array<int, 4>& a, const std::array<int, 4>& b) {
    bool odd = false;
    for (int i = 0; i < 4; ++i) {
        if (std::count(b.begin(), b.end(), a[i]) != 1) return false;
        for (int j = i + 1; j < 4; ++j) {
            odd ^= std::find(b.begin(), b.end(), a[i]) > std::find(b.begin(), b.end(), a[j]);
        }
    }
    return !odd;
}

bool IsSameCell(const std::array<int, 6>& a, const std::array<int, 6>& b) {
    std::array<int, 6> turned = a;
    for (int turn = 0; turn < 3; ++turn) {
        if (turned == b) return true;
        std::rotate(turned.begin(), turned.begin() + 2, turned.end());
    }
    return false;
}

}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
// Octahedra to and from polyhedra and tetrahedra.
//
//            v4
//          / |  .
//        /   |    .
//      v0---v2----v1      v0 v1, v2 v3 and v4 v5 are opposite; v3 is behind. Seen from outside, the face a b d with
//        .   |   /        a of v0 v1, b of v2 v3, d of v4 v5 turns a b d if an odd number of them is second in its
//        pair,
//          . | /          a d b otherwise, when det(v0 - c, v2 - c, v4 - c) < 0 at the centre c.
//            v5
#include <solidsubdiv/kit/io/internal/octahedra.h>

#include <algorithm>

namespace SolidSubdiv::Io::Internal {

std::array<std::array<Index, 3>, 8> OctahedronFaces(std::span<const Index> oct) {
    std::array<std::array<Index, 3>, 8> faces;
    for (std::size_t face = 0; face < 8; ++face) {
        const std::size_t choice = face ^ 1;  // bit 2, 1, 0: second vertex of pair 0, 1, 2
        const Index a = oct[choice >> 2], b = oct[2 + (choice >> 1 & 1)], d = oct[4 + (choice & 1)];
        const bool odd = ((choice >> 2) + (choice >> 1) + choice) & 1;
        faces[face] = odd ? std::array{a, b, d} : std::array{a, d, b};
    }
    return faces;
}

namespace {

/// Place of a vertex among the six, or 6.
std::size_t PlaceOf(const std::array<Index, 6>& six, Index vertex) {
    return static_cast<std::size_t>(std::find(six.begin(), six.end(), vertex) - six.begin());
}

/// The six different vertices in the order of their first appearance; false if there are more or less.
bool SixVertices(std::span<const Index> listed, std::span<const Index> triangles, std::array<Index, 6>& six) {
    std::size_t n = 0;
    for (const std::span<const Index> list : {listed, triangles}) {
        for (const Index v : list) {
            if (std::find(six.begin(), six.begin() + n, v) != six.begin() + n) continue;
            if (n == 6) return false;
            six[n++] = v;
        }
    }
    return n == 6;
}

}  // namespace

bool RecognizeOctahedron(std::span<const Index> listed, std::span<const Index> triangles, std::array<Index, 6>& oct) {
    std::array<Index, 6> six;
    if (triangles.size() != 24 || !SixVertices(listed, triangles, six)) return false;

    // Opposite vertices share no triangle.
    bool adjacent[6][6] = {};
    for (std::size_t corner = 0; corner < 24; ++corner) {
        const std::size_t face = corner / 3 * 3;
        const std::size_t from = PlaceOf(six, triangles[corner]), to = PlaceOf(six, triangles[face + (corner + 1) % 3]);
        adjacent[from][to] = adjacent[to][from] = true;
    }
    std::size_t n = 0;
    for (std::size_t i = 0; i < 6; ++i) {
        std::size_t opposite = 6;
        for (std::size_t j = 0; j < 6; ++j) {
            if (j == i || adjacent[i][j]) continue;
            if (opposite != 6) return false;
            opposite = j;
        }
        if (opposite == 6) return false;
        if (opposite < i) continue;
        if (n == 6) return false;  // several have the same opposite: it will have several
        oct[n++] = six[i];
        oct[n++] = six[opposite];
    }
    if (n != 6) return false;

    // The eight triangles are the eight choices of one vertex a pair; each votes for an orientation.
    unsigned seen = 0;
    int votes = 0;
    for (std::size_t face = 0; face < 8; ++face) {
        std::array<std::size_t, 3> place;
        for (std::size_t i = 0; i < 3; ++i) place[i] = PlaceOf(oct, triangles[3 * face + i]);
        const auto first = static_cast<std::size_t>(std::min_element(place.begin(), place.end()) - place.begin());
        std::rotate(place.begin(), place.begin() + static_cast<std::ptrdiff_t>(first), place.end());
        const bool abd = place[1] < place[2];
        if (place[0] > 1 || std::min(place[1], place[2]) / 2 != 1 || std::max(place[1], place[2]) / 2 != 2)
            return false;
        const std::size_t seconds = (place[0] & 1) + (place[1] & 1) + (place[2] & 1);
        seen |=
            1u << ((place[0] & 1) * 4 + (std::min(place[1], place[2]) & 1) * 2 + (std::max(place[1], place[2]) & 1));
        votes += abd == (seconds % 2 == 1) ? 1 : -1;
    }
    if (seen != 0xff) return false;
    if (votes < 0) std::swap(oct[4], oct[5]);
    return true;
}

Mesh CutOctahedra(const Mesh& mesh) {
    const std::vector<Index>& octs = mesh.topology.octs;
    Mesh cut = mesh;
    if (octs.empty()) return cut;
    cut.topology.octs.clear();
    for (std::size_t at = 0; at < octs.size(); at += 6) {
        const Index* v = octs.data() + at;
        const std::array<Index, 4> ring = {v[2], v[4], v[3], v[5]};
        for (std::size_t i = 0; i < 4; ++i) {
            cut.topology.tets.insert(cut.topology.tets.end(), {v[0], v[1], ring[i], ring[(i + 1) % 4]});
        }
    }
    const auto n_tets = static_cast<std::size_t>(mesh.topology.n_tets());
    const auto n_octs = static_cast<std::size_t>(mesh.topology.n_octs());
    for (Attribute& attribute : cut.cell_data) {
        const auto width = static_cast<std::size_t>(attribute.width);
        const std::vector<double> before = std::move(attribute.values);
        const auto row = [&](std::size_t i) { return before.begin() + static_cast<std::ptrdiff_t>(i * width); };
        std::vector<double> values;
        values.reserve(before.size() + 3 * n_octs * width);
        values.insert(values.end(), before.begin(), row(n_tets));
        for (std::size_t oct = n_tets; oct < n_tets + n_octs; ++oct) {
            for (int i = 0; i < 4; ++i) values.insert(values.end(), row(oct), row(oct + 1));
        }
        values.insert(values.end(), row(n_tets + n_octs), before.end());
        attribute.values = std::move(values);
    }
    return cut;
}

}  // namespace SolidSubdiv::Io::Internal

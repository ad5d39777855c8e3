// SPDX-License-Identifier: Apache-2.0
// Matching by children, and comparing.
#include "split_levels_oracle.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include "points.h"

namespace SolidSubdiv::Validation {

namespace {

using Pair = std::array<int, 2>;

Pair Sorted(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// Edges of a level by their ends; the values are their numbers.
std::map<Pair, int> NumberOfEdge(const SurfaceLevel& level) {
    std::map<Pair, int> numbers;
    for (std::size_t e = 0; e < level.edges.size(); ++e) {
        numbers[Sorted(level.edges[e][0], level.edges[e][1])] = static_cast<int>(e);
    }
    return numbers;
}

/// Triangles under a match, each with its least vertex first, in order.
std::vector<Triangle> Renumbered(const std::vector<Triangle>& triangles, const std::vector<int>& match) {
    std::vector<Triangle> result;
    for (Triangle t : triangles) {
        for (int& v : t) v = match[v];
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        result.push_back(t);
    }
    std::sort(result.begin(), result.end());
    return result;
}

std::vector<int> Identity(int n) {
    std::vector<int> match(static_cast<std::size_t>(n));
    for (int v = 0; v < n; ++v) match[v] = v;
    return match;
}

/// The oracle's vertex of the next level for each of ours. @throws std::runtime_error if an edge is not the oracle's
std::vector<int> MatchNext(const SurfaceLevel& ours, const SurfaceLevel& theirs, const std::vector<int>& match) {
    std::vector<int> next(ours.children_of_vertices.size() + ours.children_of_edges.size(), -1);
    for (std::size_t v = 0; v < match.size(); ++v) {
        next.at(ours.children_of_vertices[v]) = theirs.children_of_vertices[match[v]];
    }
    const auto numbers = NumberOfEdge(theirs);
    for (std::size_t e = 0; e < ours.edges.size(); ++e) {
        const Pair ends = Sorted(match[ours.edges[e][0]], match[ours.edges[e][1]]);
        const auto found = numbers.find(ends);
        if (found == numbers.end()) throw std::runtime_error("edge " + std::to_string(e) + " is not the oracle's");
        next.at(ours.children_of_edges[e]) = theirs.children_of_edges[found->second];
    }
    return next;
}

}  // namespace

void FindChildren(SurfaceLevel& coarse, const SurfaceLevel& fine) {
    const int n = coarse.n_vertices;
    std::set<Pair> edges;
    for (const Triangle& t : coarse.triangles) {
        for (std::size_t i = 0; i < 3; ++i) edges.insert(Sorted(t[i], t[(i + 1) % 3]));
    }
    std::map<int, std::set<int>> parents;  // of new vertices
    for (const Triangle& t : fine.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const int a = t[i], b = t[(i + 1) % 3];
            if ((a < n) == (b < n)) continue;
            parents[std::max(a, b)].insert(std::min(a, b));
        }
    }
    std::map<Pair, int> child_of_edge;
    for (const auto& [v, ends] : parents) {
        const bool is_child = ends.size() == 2 && edges.count({*ends.begin(), *ends.rbegin()}) > 0 &&
                              child_of_edge.emplace(Pair{*ends.begin(), *ends.rbegin()}, v).second;
        if (!is_child) throw std::runtime_error("new vertex " + std::to_string(v) + " is not an edge's only child");
    }
    if (child_of_edge.size() != edges.size() || fine.n_vertices != n + static_cast<int>(edges.size())) {
        throw std::runtime_error(std::to_string(edges.size()) + " edges, " + std::to_string(child_of_edge.size()) +
                                 " with children, " + std::to_string(fine.n_vertices - n) + " new vertices");
    }
    coarse.edges.assign(edges.begin(), edges.end());
    coarse.children_of_edges.clear();
    for (const Pair& edge : coarse.edges) coarse.children_of_edges.push_back(child_of_edge[edge]);
    coarse.children_of_vertices = Identity(n);

    std::vector<Triangle> expected;
    for (const Triangle& t : coarse.triangles) {
        Triangle middle;
        for (std::size_t i = 0; i < 3; ++i) middle[i] = child_of_edge[Sorted(t[i], t[(i + 1) % 3])];
        for (std::size_t i = 0; i < 3; ++i) expected.push_back({t[i], middle[i], middle[(i + 2) % 3]});
        expected.push_back(middle);
    }
    const std::vector<int> same = Identity(fine.n_vertices);
    if (Renumbered(expected, same) != Renumbered(fine.triangles, same)) {
        throw std::runtime_error("the triangles are not those of the level before, split in four");
    }
}

Findings CompareLevels(const std::vector<SurfaceLevel>& levels, const std::vector<SurfaceLevel>& oracle) {
    Findings findings;
    if (levels.size() != oracle.size() || levels.empty() || levels[0].n_vertices != oracle[0].n_vertices) {
        findings.Fault("other levels than the oracle's");
        return findings;
    }
    const double size = SizeOf(oracle[0].positions);
    std::vector<int> match = Identity(levels[0].n_vertices);
    for (std::size_t l = 0; l < levels.size(); ++l) {
        const std::string level = "level " + std::to_string(l);
        const SurfaceLevel &ours = levels[l], &theirs = oracle[l];
        if (l > 0) {
            try {
                match = MatchNext(levels[l - 1], oracle[l - 1], match);
            } catch (const std::exception& error) {
                findings.Fault(level + ": " + error.what());
                return findings;
            }
        }
        if (std::set<int>(match.begin(), match.end()).size() != static_cast<std::size_t>(theirs.n_vertices) ||
            Renumbered(ours.triangles, match) != Renumbered(theirs.triangles, Identity(theirs.n_vertices))) {
            findings.Fault(level + ": other vertices or triangles than the oracle's");
            return findings;
        }
        for (std::size_t v = 0; v < match.size(); ++v) {
            double distance = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const double d = ours.positions[3 * v + i] - theirs.positions[3 * match[v] + i];
                distance += d * d;
            }
            findings.Error(std::sqrt(distance) / size,
                           [&] { return "position of vertex " + std::to_string(v) + " of " + level; });
        }
    }
    return findings;
}

}  // namespace SolidSubdiv::Validation
